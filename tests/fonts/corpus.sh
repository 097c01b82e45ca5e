#!/bin/sh
# Fonts of many Latin faces: whether they are made, how exactly they are drawn,
# their bytes and the time. See --help. Not a part of tests/run.sh: it takes an
# hour or more, and needs the network for its fonts.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
case " $* " in
  *" --help "* | *" -h "*) exec python3 tests/fonts/corpus.py --help ;;
esac
. host_tools/setup.sh
inkcell_setup packages fontconfig \
  $(sed -e 's/#.*//' -e 's/ .*//' tests/fonts/packages.txt | sort -u)
[ -f build/host/build.ninja ] || cmake --preset host >/dev/null
cmake --build build/host --target inkcell-fontgen inkcell-accuracy >/dev/null
exec python3 tests/fonts/corpus.py "$@"
