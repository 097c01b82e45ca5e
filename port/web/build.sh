#!/bin/sh
# Builds the device's library as WebAssembly, by Clang and wasm-ld alone.
#
#   sh port/web/build.sh [FOLDER]     # build/web/core
#
# Writes FOLDER/inkcell.wasm.
set -eu
cd "$(dirname "$0")/../.."
folder=${1:-build/web/core}
cmake -S . -B "$folder" -G Ninja -DCMAKE_TOOLCHAIN_FILE=port/web/toolchain.cmake \
  -DCMAKE_BUILD_TYPE=Release -DINKCELL_TESTS=OFF -DINKCELL_JOIN_FOLDERS=ON \
  "-DCMAKE_C_FLAGS_RELEASE=-Os" "-DCMAKE_CXX_FLAGS_RELEASE=-Os"
nice -n 10 cmake --build "$folder" --target inkcell_web
