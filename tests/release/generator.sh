#!/bin/sh
# Takes each piece of the generator as its user would, where little else is:
#
#   sh tests/release/generator.sh WORK_FOLDER RELEASE FONTGEN
#
# FONTGEN is the generator of this checkout. Each piece makes the same font, and the
# library as two files draws the same picture with it. The machines are root folders:
# an empty one with busybox, Debian bullseye, of 2021, and bookworm; debootstrap makes
# these once in build/release-machines. The program for Windows runs by Wine, the page
# in Chromium. Needs root, and playwright-core from npm.
set -eu
[ $# = 3 ] || { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2; }
cd "$(dirname "$0")/../.."
[ "$(id -u)" = 0 ] || {
  echo "tests/release/generator.sh: needs root, to change into root folders" >&2
  exit 1
}
. host_tools/setup.sh
inkcell_setup pieces
# Debian's npm does not go with a node of others.
command -v npm >/dev/null || inkcell_setup packages npm
root=$PWD
rm -rf "$1"
mkdir -p "$1" "$root/build/release-machines"
work=$(cd "$1" && pwd)
release=$(cd "$2" && pwd)
fontgen=$(realpath "$3")
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
make="--font=sans.ttf --chars=0x20-0x7E --name=sans --quiet --out=sans.hpp"

# Sets `processor` to the milliseconds of processor time of commands until now.
take_processor() {
  times >"$work/times"
  processor=$(awk 'NR == 2 {
    for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] }
    printf "%d", 1000 * s }' "$work/times")
}

# begin <name> <file of the release>: `here` is an empty folder with a face.
begin() {
  name=$1
  piece=$(echo "$release"/$2)
  here=$work/$name
  mkdir -p "$here"
  cp "$font" "$here/sans.ttf"
  start
}

start() {
  take_processor
  begun=$processor
}

# draw <folder>: the picture of picture.cpp, in the font there.
draw() {
  mkdir -p "$here/fonts"
  cp "$1/sans.hpp" "$here/fonts"
  c++ -std=c++17 -Os "-I$here" "-I$two" tests/release/picture.cpp "$work/inkcell.o" \
    -o "$here/picture"
  "$here/picture" >"$here/picture.pgm"
}

# end <folder>: compares the font there and its picture, and says how long it took.
end() {
  cmp "$1/sans.hpp" "$work/own/sans.hpp"
  draw "$1"
  cmp "$here/picture.pgm" "$work/own/picture.pgm"
  take_processor
  echo "$name: $(((processor - begun + 500) / 1000)) s of processor time from a file" \
    "of $(stat -c %s "$piece") bytes to a picture"
}

# bare_machine <name> <packages>: a Debian of that name, in $here/root. Time starts.
bare_machine() {
  kept=$root/build/release-machines/$1
  if [ "$2" != "$(cat "$kept.made" 2>/dev/null)" ]; then
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' \
      'Origin: Debian' | head -n 1)
    rm -rf --one-file-system "$kept"
    debootstrap --variant=minbase "--include=$2" "$1" "$kept" "$mirror" \
      >"$work/debootstrap.log" || { tail "$work/debootstrap.log" >&2; exit 1; }
    echo "$2" >"$kept.made"
  fi
  cp -a --reflink=auto "$kept" "$here/root"
  start
}

unzip -q "$(echo "$release"/inkcell-[0-9]*.zip)" -d "$work/two"
two=$(echo "$work"/two/*)
c++ -std=c++17 -Os -c "$two/inkcell.cpp" -o "$work/inkcell.o"
begin own ""
(cd "$here" && "$fontgen" $make)
draw "$here"
# With ink.
[ "$(tail -c 8000 "$here/picture.pgm" | tr -d '\000' | wc -c)" -gt 500 ]

begin linux "inkcell-fontgen-*-linux-*.zip"
unzip -q "$piece" -d "$here/zip"
mkdir "$here/root"
cp "$(command -v busybox)" "$here"/zip/*/inkcell-fontgen "$here/sans.ttf" "$here/root"
chroot "$here/root" /busybox sh -c "./inkcell-fontgen $make"
end "$here/root"

begin wheel "inkcell_fontgen-*linux*.whl"
bare_machine bullseye python3-venv
cp "$here/sans.ttf" "$piece" "$here/root"
chroot "$here/root" sh -euc "
  python3 -m venv venv
  venv/bin/pip --quiet install --no-index ./*.whl
  venv/bin/inkcell-fontgen --version
  venv/bin/python -m inkcell_fontgen $make"
end "$here/root"
# The program of the zip, in the same Debian.
cp "$work/linux/root/inkcell-fontgen" "$here/root"
rm "$here/root/sans.hpp"
chroot "$here/root" sh -c "./inkcell-fontgen $make"
cmp "$here/root/sans.hpp" "$work/own/sans.hpp"

export WINEDEBUG=-all WINEPREFIX="$work/wine"
begin windows "inkcell-fontgen-*-windows-x86_64.zip"
unzip -q "$piece" -d "$here"
(cd "$here" && wine ./inkcell-fontgen-*/inkcell-fontgen.exe $make)
end "$here"

# As pip of Windows takes it; its Python is not here.
begin windows-wheel "inkcell_fontgen-*-win_amd64.whl"
/usr/bin/python3 -m venv "$here/venv"
"$here/venv/bin/pip" --quiet install --no-index --platform=win_amd64 \
  --only-binary=:all: --target="$here/site" "$piece"
(cd "$here" && wine site/inkcell_fontgen/inkcell-fontgen.exe $make)
end "$here"

begin npm "inkcell-fontgen-[0-9.]*.tgz"
npm install --offline --no-audit --no-fund --silent --prefix "$here" "$piece"
(cd "$here" && node_modules/.bin/inkcell-fontgen $make)
end "$here"

begin page "inkcell-page-*.zip"
unzip -q "$piece" -d "$here"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$work/modules" \
  playwright-core@1
node tests/release/page.mjs "$here"/inkcell-page-* "$work/modules" "$here/sans.ttf" \
  "$here/sans.hpp"
end "$here"

begin deb "inkcell-tools_*.deb"
lintian --allow-root --fail-on=error,warning \
  --suppress-tags=initial-upload-closes-no-bugs "$release"/*.deb
bare_machine bookworm "g++,cmake,ninja-build,$(dpkg-deb -f "$piece" Depends |
  sed 's/ ([^)]*)//g; s/ //g')"
mkdir "$here/root/picture"
cp "$here/sans.ttf" "$release"/*.deb tests/release/CMakeLists.txt \
  tests/release/picture.cpp "$here/root/picture"
chroot "$here/root" sh -euc "
  dpkg --install picture/*.deb >dpkg.log
  cd picture
  for program in \$(dpkg --listfiles inkcell-tools | grep ^/usr/bin/); do
    \$program --help | grep -q -- --help
  done
  inkcell-fontgen $make
  cmake -G Ninja -S . -B build -DINSTALLED=ON -DFONT=sans.ttf >cmake.log
  cmake --build build >build.log
  build/picture >picture.pgm"
cmp "$here/root/picture/picture.pgm" "$work/own/picture.pgm"
end "$here/root/picture"

echo "== each piece of the generator makes the same font"
