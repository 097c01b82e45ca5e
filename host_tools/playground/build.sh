#!/bin/sh
# Builds the page: inkcell.html, one file that needs no server, and the folder
# site, the same for a web server.
#
#   sh host_tools/playground/build.sh [FOLDER]     # build/web
#
# The first time it compiles the generator and its libraries to WebAssembly, which
# takes five minutes of processor time.
set -eu
cd "$(dirname "$0")/../.."
folder=${1:-build/web}
sh fonts_gen/web/build.sh "$folder"
sh port/web/build.sh "$folder/core"
folder=$(cd "$folder" && pwd)
node host_tools/playground/build.mjs "$folder/core/inkcell.wasm" \
  "$folder/generator" "$folder/sources/versions.txt" \
  /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$folder/inkcell.html" "$folder/site"
