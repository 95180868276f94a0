# What src/run.sh and tests/run.sh share: packages that are there, and a build that is up to date. Sourced, in bash.
# For Debian 12 and 13. Works in the current directory, the checkout. All that it says goes to stderr: stdout is the program's.

say() { printf 'sphlab: %s\n' "$*" >&2; }
die() { say "$@"; exit 1; }

# only_one_at_a_time COMMAND...: others who set up in the same checkout wait for their turn. Descriptor 9 holds the lock.
only_one_at_a_time() {
  mkdir -p build
  exec 9>build/.lock
  flock -n 9 || { say 'another set-up is under way here; waiting for it'; flock 9; }
  "$@"
  exec 9>&-
}

# quietly COMMAND...: its output on a terminal; elsewhere only if it fails.
quietly() {
  if [[ -t 2 ]]; then "$@" >&2 </dev/null 9>&-; return; fi
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null 9>&- || { status=$?; cat "$log" >&2; }
  rm -f "$log"
  return "$status"
}

# packages GROUP...: the names that src/packages.txt lists under these groups.
packages() {
  local group name _
  while read -r group name _; do
    [[ " $* " != *" $group "* ]] || echo "$name"
  done <src/packages.txt
}

# missing_packages GROUP...: those of them that are not installed; none on a machine without dpkg, where CMake is to say it.
missing_packages() {
  command -v dpkg-query >/dev/null || return 0
  # dpkg-query fails for a name that it has never heard of: that one is missing, too.
  LC_ALL=C comm -13 \
    <({ LC_ALL=C dpkg-query -W -f '${db:Status-Status} ${Package}\n' $(packages "$@") 2>/dev/null || true; } |
      sed -n 's/^installed //p' | LC_ALL=C sort -u) \
    <(packages "$@" | LC_ALL=C sort -u)
}

# install_packages GROUP...: what is missing, by apt. No apt call if nothing is.
install_packages() {
  local missing become_root='' pause
  missing=$(missing_packages "$@" | paste -sd ' ')
  [[ $missing ]] || return 0
  if [[ $EUID != 0 ]]; then
    become_root=sudo
    if ! command -v sudo >/dev/null || ! sudo -v </dev/null; then
      die "Debian packages are missing, and installing them takes root or sudo: apt-get install $missing"
    fi
  fi
  say "installing $missing"
  local apt="$become_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0"
  for pause in 0 5 20; do  # mirrors have their moments
    sleep "$pause"
    quietly $apt update || true  # an old list may do; if it does not, installing says so
    if quietly $apt install -y --no-install-recommends $missing; then return; fi
  done
  die "apt-get could not install, in three tries: $missing"
}

# build PRESET TARGET [tests]: configured if it has to be, compiled if stale. Once configured with tests, it stays so until the
# presets change.
build() {
  local dir=build/$1 target=$2 tests=OFF cmake=(cmake --preset "$1")
  if [[ -e $dir/build.ninja && ! CMakePresets.json -nt $dir/build.ninja ]] &&
      grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$dir/CMakeCache.txt"; then
    tests=$(sed -n 's/^SPHLAB_TESTS:BOOL=//p' "$dir/CMakeCache.txt")
    [[ ${3-} && $tests != ON ]] || cmake=()
  else
    # Nothing there, half a configuration, one of a checkout that has moved, or older presets: with another compiler in them CMake
    # would take that and forget the rest.
    cmake+=(--fresh)
  fi
  [[ ! ${3-} ]] || tests=ON
  if [[ ${#cmake[@]} != 0 ]]; then
    quietly "${cmake[@]}" "-DSPHLAB_TESTS=$tests" || die "configuring failed; the packages it needs: src/packages.txt"
  fi
  if [[ $(ninja -C "$dir" -n "$target" 2>&1 9>&-) == *'no work to do'* ]]; then return; fi
  say "building $dir"
  quietly ninja -C "$dir" "$target" || die "building $dir failed"
}
