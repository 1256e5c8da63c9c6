# shellcheck shell=bash
# What the scripts beside it share; sourced, never run.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# stage [NAME]: says how long the stage before took, and which one begins.
stage() {
  [[ -z ${stage_name-} ]] || say "== $stage_name: $((SECONDS - stage_started)) s"
  stage_name=${1-}
  stage_started=$SECONDS
  [[ -z $stage_name ]] || say "== $stage_name"
}

# build PRESET TARGETS OPTION...: configures with these options, and builds.
build() {
  local preset=$1 targets=$2
  shift 2
  cmake --preset "$preset" -S "$repository" "$@" >/dev/null
  # shellcheck disable=SC2086
  cmake --build "$repository/build/$preset" --parallel "$(nproc)" --target $targets
}
