#!/bin/sh
# Builds the page: inkcell.html, one file that needs no server, and the folder
# site, the same for a web server. Beside both lies the library, which the page
# links, with its interface for C as it is made: inkcell-<version>.tar.gz.
#
#   sh host_tools/playground/build.sh [FOLDER]     # build/web
#
# The first time it compiles the generator and its libraries to WebAssembly, which
# takes four minutes of processor time.
set -eu
cd "$(dirname "$0")/../.."
folder=${1:-build/web}
sh fonts_gen/web/build.sh "$folder"
sh port/web/build.sh "$folder/core"
folder=$(cd "$folder" && pwd)
version=$(sed -n 's/^project(inkcell VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
library=$folder/inkcell-$version.tar.gz
tar --create --use-compress-program='gzip -n' --file "$library" --sort=name --owner=0 \
  --group=0 --numeric-owner --mode=u=rwX,go=rX --mtime="@${SOURCE_DATE_EPOCH:-0}" \
  --exclude=__pycache__ --exclude=docs/img --transform 's,^,inkcell/,' \
  CMakeLists.txt LICENSE README.md core docs fonts_gen idf_component.yml library.json \
  meson.build meson_options.txt port zephyr -C "$folder/core" port/c/include port/c/src
node host_tools/playground/build.mjs "$folder/core/inkcell.wasm" \
  "$folder/generator" "$folder/sources/versions.txt" \
  /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$folder/inkcell.html" "$folder/site"
cp "$library" "$folder/site/"
