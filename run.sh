#!/usr/bin/env bash
# Sets up, builds and runs lumenshop with the given arguments. Without any: the demo, in a window or as a picture.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$root/cmake/setup.sh"

install_packages build
build lumenshop lumenshop-helper lumen-plugins

program=$root/build/bin/lumenshop
[ $# -gt 0 ] && exec "$program" "$@"
[ -n "${DISPLAY:-}" ] && exec "$program" "$root/sessions/demo.json"
"$program" render "$root/sessions/demo.json" -o "$root/build/demo.png"
echo "$root/build/demo.png"
