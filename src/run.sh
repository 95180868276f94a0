#!/usr/bin/env bash
# Installs what is missing, builds what is stale, then runs sphlab with the same arguments, in the caller's directory.
# Without arguments it opens a window; without a display, too, it renders the dam break to PNG frames in ./frames.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
source "$root/src/setup.sh"

set_up() {
  install_packages build
  build release sphlab
}
(cd -P "$root" && only_one_at_a_time set_up)

sphlab=$root/build/release/sphlab
# freeglut's window is an X11 one: Wayland sets DISPLAY as well, where it can show it.
if [[ $# != 0 || ${DISPLAY-} ]]; then exec "$sphlab" "$@"; fi
"$sphlab" render dam-break --out "$PWD/frames" --keys 4:d --until 6
echo "No display here, so the dam break is in PNG frames: $PWD/frames/frame_000000.png and so on"
