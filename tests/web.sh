#!/bin/sh
# Tests the generator as WebAssembly, its npm package, and the page of
# host_tools/playground, in node and in headless Chromium.
#
#   sh tests/web.sh [--here]
#
#   --here    installs nothing, neither of Debian nor of npm: says what it leaves
#             out and why, and exits with 77 then
#
# tests/run.sh runs it with --here; without, it needs 1.3 GB of packages, and
# playwright-core and typescript from npm. Screenshots are left in build/web.
set -eu
case ${1-} in
  '' | --here) ;;
  *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."
root=$PWD
web=$root/build/web
modules=$web/npm/node_modules
if [ $# = 0 ]; then
  . host_tools/setup.sh
  inkcell_setup tests
  inkcell_setup web
  inkcell_setup packages chromium woff2
  # Debian's npm does not go with a node of others.
  command -v npm >/dev/null || inkcell_setup packages npm
  npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$web/npm" \
    playwright-core@1 typescript@5.6
fi

# Compilers through ccache, as in tests/run.sh.
export PATH="/usr/lib/ccache:$PATH" CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1

skipped=
# skip <what> <why>
skip() {
  echo "skipped: $1: $2"
  skipped="${skipped:+$skipped; }$1: $2"
}
# has <file or program> <what>: whether a part can be tested here.
has() {
  command -v "$1" >/dev/null || [ -e "$1" ] || {
    skip "$2" "$(basename "$1") is missing; sh tests/web.sh installs it"
    return 1
  }
}

made='the generator, the npm package and the page'
if has emcc "$made" && has zopfli "$made"; then
  sh host_tools/playground/build.sh
  sh fonts_gen/web/pack.sh
  [ -f build/host/build.ninja ] || cmake --preset host -DINKCELL_JOIN_FOLDERS=ON
  cmake --build build/host --target inkcell-fontgen
  fontgen=$root/build/host/fonts_gen/inkcell-fontgen
  if has woff2_compress 'bytes of fonts'; then
    node tests/web/fonts.mjs "$web/generator" "$fontgen" "$web/fonts"
  fi
  if has npm 'the npm package'; then
    node tests/web/npm.mjs "$web/inkcell-fontgen" "$fontgen" "$web/npm-test"
  fi
  if has dpkg-query 'the list of packages'; then
    python3 tests/build/check_debian_packages.py --web "$web"
  fi
  if has "$modules/typescript" 'types'; then
    node "$modules/typescript/bin/tsc" -p tests/web/tsconfig.json
  fi
  if has chromium 'the page' && has woff2_compress 'the page' &&
    has "$modules/playwright-core" 'the page'; then
    node tests/web/page.mjs "$web/inkcell.html" "$web/site" "$web/npm" "$web/page"
    node tests/web/convert.mjs "$web/inkcell.html" "$web/site" "$web/npm" "$fontgen" \
      "$web/convert"
    node tests/web/access.mjs "$web/inkcell.html" "$web/npm" "$web/access"
    node tests/web/site.mjs "$web/site" "$web/npm" "$fontgen" "$web/site-test"
  fi
fi
[ -n "$skipped" ] || exit 0
echo "skipped: $skipped"
[ $# = 0 ] || exit 77
