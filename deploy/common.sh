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

# build PRESET OPTION...: configures and builds.
build() {
  local preset=$1
  shift
  cmake --preset "$preset" -S "$repository" "$@" >/dev/null
  cmake --build "$repository/build/$preset" --parallel "$(nproc)"
}
