#!/bin/sh
# Spacing of fitted text in faces of Debian: whether faces of fixed pitch have
# one advance, gaps that close, and how long lines get. See --help. Not a part
# of tests/run.sh: it takes half an hour, and needs the network for its fonts.
#
#   sh tests/fonts/spacing.sh [--faces GLOB] [--first PX] [--last PX]
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
case " $* " in
  *" --help "* | *" -h "*) exec python3 tests/fonts/spacing.py --help ;;
esac
. host_tools/setup.sh
inkcell_setup packages \
  $(python3 tests/fonts/spacing.py --packages)
[ -f build/host/build.ninja ] || cmake --preset host >/dev/null
cmake --build build/host --target inkcell-fontgen inkcell_spacing >/dev/null
exec python3 tests/fonts/spacing.py "$@"
