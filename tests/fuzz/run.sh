#!/usr/bin/env bash
# What `deploy/reproduce fuzz` does.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../deploy/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../deploy/common.sh"

usage() {
  cat <<'END'
usage: deploy/reproduce fuzz [--minutes N] [TARGET...]

Builds the fuzzers with Clang (which it installs) under the address and undefined-behaviour sanitizers and runs each
target, or those named, for N minutes (10), beginning with its corpus in tests/fuzz/corpus. What is new is kept in
build/fuzz/corpus, and what ends a target in build/fuzz/findings. Exit code 1 if there is any.
END
}

minutes=10
targets=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --help | -h) usage && exit ;;
    --minutes) minutes=${2:?a number} && shift 2 ;;
    -*) usage >&2 && exit 2 ;;
    *) targets+=("$1") && shift ;;
  esac
done
known=$(find "$repository/tests/fuzz/corpus" -mindepth 1 -maxdepth 1 -printf '%f\n' | sort)
[[ ${#targets[@]} -gt 0 ]] || mapfile -t targets <<<"$known"
for target in "${targets[@]}"; do
  grep -qx "$target" <<<"$known" || fail "no target is called $target; there are: ${known//$'\n'/, }"
done

stage "packages"
"$repository/deploy/install"
if ! dpkg-query -W clang-16 libclang-rt-16-dev >/dev/null 2>&1; then
  root=()
  [[ $(id -u) -eq 0 ]] || root=(sudo)
  "${root[@]}" apt-get install --yes --no-install-recommends clang-16 libclang-rt-16-dev
fi
stage "build"
build fuzz "${targets[*]/#/fuzz_}"

out=$repository/build/fuzz
mkdir -p "$out/findings"
failed=0
for target in "${targets[@]}"; do
  stage "$target"
  mkdir -p "$out/corpus/$target"
  UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 "$out/bin/fuzz_$target" -max_total_time=$((60 * minutes)) \
    -max_len=4096 -timeout=30 -rss_limit_mb=4096 -verbosity=0 -print_funcs=0 -print_final_stats=1 \
    -artifact_prefix="$out/findings/$target-" "$out/corpus/$target" "$repository/tests/fuzz/corpus/$target" ||
    failed=1
done
stage
[[ $failed -eq 0 ]] || fail "there are findings in $out/findings"
