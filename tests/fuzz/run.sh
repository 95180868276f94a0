#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS: gives every fuzzer of build/dev that long, as many at once as there are processors. What they
# find new goes to build/dev/fuzz/found; what breaks the program is left in build/dev/fuzz/broken and ends this with an error.
set -euo pipefail
cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

fuzz() {
  local seconds=$1 input=$2 found=build/dev/fuzz/found/$2 log=build/dev/fuzz/$2.log
  mkdir -p "$found" build/dev/fuzz/broken
  export TMPDIR=/dev/shm OMP_WAIT_POLICY=passive ASAN_OPTIONS=detect_leaks=0  # leaks are for the tests
  if "build/dev/tests/fuzz/sphlab_${input}_fuzz" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=8192 \
      -artifact_prefix="build/dev/fuzz/broken/$input-" "$found" "tests/fuzz/corpus/$input" >"$log" 2>&1; then
    echo "fuzzing $input: $(grep -a '^Done' "$log")"
  else
    tail -n 60 "$log"
    return 1
  fi
}
export -f fuzz

printf '%s\n' scenes settings keys checkpoints | xargs -P "$(nproc)" -I{} bash -c 'fuzz "$@"' _ "${1:-20}" {}
