#!/bin/sh
# Tests the generator as WebAssembly and the page of host_tools/playground, in node
# and in headless Chromium.
#
#   sh tests/web.sh
#
# Not a part of tests/run.sh, which tests the device library in node: this needs
# 1.3 GB of packages, and playwright-core from npm. Screenshots are left in
# build/web/page.
set -eu
cd "$(dirname "$0")/.."
. host_tools/setup.sh
inkcell_setup tests
inkcell_setup web
inkcell_setup packages chromium woff2
# Debian's npm does not go with a node of others.
command -v npm >/dev/null || inkcell_setup packages npm
sh host_tools/playground/build.sh
[ -f build/host/build.ninja ] || cmake --preset host -DINKCELL_JOIN_FOLDERS=ON
cmake --build build/host --target inkcell-fontgen
npm install --silent --no-audit --no-fund --ignore-scripts --prefix build/web/npm \
  playwright-core@1
root=$PWD
fontgen=$root/build/host/fonts_gen/inkcell-fontgen
node tests/web/fonts.mjs "$root/build/web/generator" "$fontgen" "$root/build/web/fonts"
node tests/web/page.mjs "$root/build/web/inkcell.html" "$root/build/web/npm" "$fontgen" \
  "$root/build/web/page"
