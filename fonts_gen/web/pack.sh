#!/bin/sh
# Makes the folder of the npm package inkcell-fontgen, for `npm pack` or `npm publish`.
#
#   sh fonts_gen/web/pack.sh [FOLDER]     # build/web
#
# Builds the generator first, if need be (build.sh).
set -eu
cd "$(dirname "$0")/../.."
folder=${1:-build/web}
sh fonts_gen/web/build.sh "$folder"
node fonts_gen/web/npm/pack.mjs "$folder/generator" "$folder/sources/versions.txt" \
  "$folder/inkcell-fontgen"
