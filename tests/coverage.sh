#!/bin/sh
# Lines and branches of the core that the tests run, counted by Clang:
#
#   sh tests/coverage.sh [FOLDER...]    # of tests/; none: all that look at the core
#
# Fails below 99 % of lines or 95 % of branches, and names the lines that no test
# runs. Everything is built below build/coverage.
set -eu
cd "$(dirname "$0")/.."
folder=build/coverage
parts=${*:-unit golden layout seams hostile icons strings}
export PATH="/usr/lib/ccache:$PATH" CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
fontgen=
if [ -x build/host/fonts_gen/inkcell-fontgen ]; then
  fontgen=-DINKCELL_FONTGEN=$PWD/build/host/fonts_gen/inkcell-fontgen
fi
flags='-fprofile-instr-generate -fcoverage-mapping'
. host_tools/setup.sh
inkcell_setup packages clang llvm
cmake -S . -B $folder -G Ninja -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  "-DCMAKE_CXX_FLAGS=-O1 $flags" "-DCMAKE_C_FLAGS=-O1 $flags" \
  -DINKCELL_JOIN_FOLDERS=ON \
  -DINKCELL_SECOND_LANE=ON $fontgen >/dev/null
for part in $parts; do
  targets="${targets-} tests/$part/all"
done
# shellcheck disable=SC2086  # names of targets
cmake --build $folder --target $targets
rm -rf $folder/raw
LLVM_PROFILE_FILE=$PWD/$folder/raw/%m.profraw ctest --test-dir $folder \
  -j "$(nproc)" --no-tests=error --output-on-failure \
  -R "^($(echo $parts | tr ' ' '|'))\."
python3 -B tests/coverage.py $folder
