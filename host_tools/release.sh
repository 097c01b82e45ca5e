#!/bin/sh
# Makes the files of a release in build/release:
#
#   sh host_tools/release.sh VERSION [--draft] [--only NAME...]
#   sh host_tools/release.sh --help      # the pieces
#
# VERSION is that of CMakeLists.txt. The files are made of a checkout without
# changes, or with --draft of whatever lies there. sh tests/release.sh tries them.
set -eu
. "$(dirname "$0")/setup.sh"
inkcell_setup site
inkcell_setup packages git
exec python3 -B "$(dirname "$0")/release/release.py" "$@"
