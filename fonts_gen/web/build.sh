#!/bin/sh
# Builds inkcell-fontgen as WebAssembly by Debian's emscripten.
#
#   sh fonts_gen/web/build.sh [FOLDER]     # build/web
#
# Writes FOLDER/generator/inkcell-fontgen.js and .wasm. Libraries are compiled
# once, from Debian's sources (sources.sh), which takes 3 minutes, or seconds where
# ccache is installed and has compiled them before.
set -eu
cd "$(dirname "$0")/../.."
. host_tools/setup.sh
inkcell_setup web
mkdir -p "${1:-build/web}"
folder=$(cd "${1:-build/web}" && pwd)
sh fonts_gen/web/sources.sh "$folder/sources"
# Where node is not Debian's, emcc does not find Debian's modules.
export NODE_PATH=/usr/share/nodejs
if command -v ccache >/dev/null; then
  export EM_COMPILER_WRAPPER="${EM_COMPILER_WRAPPER-ccache}"
  export CCACHE_BASEDIR="${CCACHE_BASEDIR-$PWD}" CCACHE_NOHASHDIR=1
fi
emcmake cmake -S fonts_gen/web -B "$folder/generator" -G Ninja \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" \
  -DCMAKE_C_FLAGS_RELEASE="-Os -DNDEBUG" "-DINKCELL_SOURCES=$folder/sources"
nice -n 10 cmake --build "$folder/generator" --target inkcell-fontgen
