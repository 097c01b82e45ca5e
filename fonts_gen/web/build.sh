#!/bin/sh
# Builds inkcell-fontgen with the libraries that it needs, from Debian's sources.
#
#   sh fonts_gen/web/build.sh [FOLDER]             # build/web
#   sh fonts_gen/web/build.sh --windows|--linux [FOLDER]
#
# As WebAssembly by Debian's emscripten it writes inkcell-fontgen.js and .wasm to
# FOLDER/generator; for Windows by mingw-w64 inkcell-fontgen.exe, to FOLDER/windows;
# for Linux, of this processor, inkcell-fontgen to FOLDER/linux. These two need no
# other file. The libraries (sources.sh) are compiled once, which takes 3 minutes, or
# seconds where ccache is installed and has compiled them before.
set -eu
cd "$(dirname "$0")/../.."
. host_tools/setup.sh
kind=web
case ${1:-} in
  --windows) kind=exe ;;
  --linux) kind=static ;;
esac
[ $kind = web ] || shift
inkcell_setup $kind
mkdir -p "${1:-build/web}"
folder=$(cd "${1:-build/web}" && pwd)
sh fonts_gen/web/sources.sh "$folder/sources"
of=$folder/sources
if [ $kind = exe ]; then
  to=$folder/windows
  cmake -S fonts_gen/web -B "$to" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc-posix \
    -DCMAKE_CXX_COMPILER=x86_64-w64-mingw32-g++-posix "-DINKCELL_SOURCES=$of"
elif [ $kind = static ]; then
  to=$folder/linux
  cmake -S fonts_gen/web -B "$to" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    "-DINKCELL_SOURCES=$of"
else
  to=$folder/generator
  # Where node is not Debian's, emcc does not find Debian's modules.
  export NODE_PATH=/usr/share/nodejs
  if command -v ccache >/dev/null; then
    export EM_COMPILER_WRAPPER="${EM_COMPILER_WRAPPER-ccache}"
    export CCACHE_BASEDIR="${CCACHE_BASEDIR-$PWD}" CCACHE_NOHASHDIR=1
  fi
  emcmake cmake -S fonts_gen/web -B "$to" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" \
    -DCMAKE_C_FLAGS_RELEASE="-Os -DNDEBUG" "-DINKCELL_SOURCES=$of"
fi
nice -n 10 cmake --build "$to" --target inkcell-fontgen
