#!/usr/bin/env bash
# Whether every C++ file is as clang-format 14 lays it out, which is Debian 12's: other versions lay the same lines out otherwise.
# Where only those are (Debian 13 has 19), it says so and exits with 77, which ctest shows as skipped.
set -euo pipefail
cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

for tool in clang-format-14 clang-format; do
  if [[ $("$tool" --version 2>&1) == *'version 14.'* ]]; then
    find src tests -name '*.[ch]pp' -print0 | xargs -0 "$tool" --dry-run -Werror
    exit
  fi
done
echo "not checked: the style is clang-format 14's (Debian 12), and here is $(clang-format --version 2>&1)"
exit 77
