#!/usr/bin/env bash
# Installs what is missing, builds with tests, runs them all as users have them (preset release), then the quick ones again
# under AddressSanitizer and UndefinedBehaviorSanitizer (preset dev), the fuzzers for a short while, and the tests of threads under
# ThreadSanitizer (preset tsan). Arguments go to ctest; with any, the last two are left out. Stops where something fails.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
cd -P "$root"
source src/setup.sh

export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}  # test programs run side by side: no spinning on each other's cores
if [[ -e tests/lsan.supp ]]; then
  export LSAN_OPTIONS="${LSAN_OPTIONS:+$LSAN_OPTIONS:}suppressions='$PWD/tests/lsan.supp':print_suppressions=0"
fi

set_up() {
  install_packages build tests
  build release all tests
}
run() { ctest --test-dir "build/$1" --output-on-failure --parallel "$(nproc)" --no-tests=error "${@:2}"; }

only_one_at_a_time set_up
run release "$@"

# The arguments may have chosen slow tests only.
if [[ $(ctest --test-dir build/release -N -L quick "$@") == *'Total Tests: 0'* ]]; then exit; fi
only_one_at_a_time build dev all tests
run dev -L quick "$@"

# Who asks for certain tests has asked for neither of these.
[[ $# == 0 ]] || exit 0
tests/fuzz/run.sh 15
only_one_at_a_time build tsan threads tests
# OpenMP's own library is not instrumented: it tells ThreadSanitizer itself what waits for what.
TSAN_OPTIONS=ignore_noninstrumented_modules=1 run tsan -L quick \
  -R '^(Determinism\.(ADrop|EverySolver)|(DoubleBuffer|FrameRecorder|HandOver|Session|Simulation)\.)'
