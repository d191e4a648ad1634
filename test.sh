#!/usr/bin/env bash
# Sets up, builds and runs the tests: the quick ones, or all with --all. Other arguments go to ctest.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$root/cmake/setup.sh"

selection=(-L quick)
groups=(build test)
if [ "${1:-}" = --all ]; then
  selection=()
  groups+=(bench)
  shift
fi

install_packages "${groups[@]}"
build

# Programs compiled by one run must not hide what another would have to compile.
export MESA_SHADER_CACHE_DIR=$root/build/test-shader-cache
rm -rf "$MESA_SHADER_CACHE_DIR"
exec ctest --test-dir "$root/build" --output-on-failure --parallel 2 "${selection[@]}" "$@"
