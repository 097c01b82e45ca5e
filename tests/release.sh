#!/bin/sh
# Makes a release, and takes each piece as its user would:
#
#   sh tests/release.sh
#
# The archives are made twice, and must be the same. The library as two files draws
# the picture that the checkout draws, and so do the archives of ecosystems
# (tests/release/ecosystems.py) and fonts of each piece of the generator
# (tests/release/generator.sh). Works in build/release-test. Needs root.
set -eu
cd "$(dirname "$0")/.."
. host_tools/setup.sh
inkcell_setup demo
inkcell_setup pieces
export PATH="/usr/lib/ccache:$PATH" CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
release=$PWD/build/release
work=$PWD/build/release-test
fontgen=$PWD/build/fontgen/inkcell-fontgen
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
rm -rf "$work"
mkdir -p "$work/fonts"
version=$(sed -n 's/^project(inkcell VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)

echo "== the same bytes twice"
if sh host_tools/release.sh 0.0 --draft 2>"$work/refused" ||
  ! grep -q "VERSION is 0.0, and $version in CMakeLists.txt" "$work/refused"; then
  echo "another version than that of CMakeLists.txt is not refused" >&2
  exit 1
fi
sh host_tools/release.sh "$version" --draft
cp "$release/SHA256SUMS" "$work"
# Times and modes of files do not count.
(umask 077 && sleep 2 && TZ=Asia/Tokyo sh host_tools/release.sh "$version" --draft)
cmp "$release/SHA256SUMS" "$work/SHA256SUMS"
(cd "$release" && sha256sum --check --strict SHA256SUMS)
# Fonts are kept meanwhile: a face is made again.
python3 -B host_tools/release/fonts.py build/demo-host/fonts_gen/inkcell-fontgen \
  "$work/again" --only segments7
(cd "$work/again" && rm FONTS.md && find . -type f) | while read -r file; do
  cmp "$work/again/$file" "build/release-fonts/fonts/$file"
done

echo "== what is in each"
mkdir "$work/deb"
cp "$release"/*.deb "$release"/*.spdx.json "$work/deb"
/usr/bin/python3 -B tests/release/check_listing.py "$work/deb"
for piece in "$release"/*.zip "$release"/*.whl "$release"/*.tgz; do
  folder=$work/$(basename "$piece")
  case $piece in
    *.tgz) mkdir "$folder" && tar -xzf "$piece" -C "$folder" ;;
    *) unzip -q "$piece" -d "$folder" ;;
  esac
  /usr/bin/python3 -B tests/release/check_listing.py "$folder"
done

echo "== one picture by the checkout and by the two files"
cmake -G Ninja -S fonts_gen -B build/fontgen -DCMAKE_BUILD_TYPE=Release
cmake --build build/fontgen
cmake -G Ninja -S tests/release -B "$work/checkout" -DCMAKE_BUILD_TYPE=Release \
  "-DINKCELL_FONTGEN=$fontgen" "-DFONT=$font"
cmake --build "$work/checkout" --target picture
"$work/checkout/picture" >"$work/checkout.pgm"

"$fontgen" --font=$font --chars=0x20-0x7E --name=sans --quiet \
  --out="$work/fonts/sans.hpp"
two=$work/inkcell-$version.zip/inkcell-$version
c++ -std=c++17 -Os -c "$two/inkcell.cpp" -o "$work/inkcell.o"
c++ -std=c++17 -Os -I"$work" -I"$two" tests/release/picture.cpp "$work/inkcell.o" \
  -o "$work/two_files"
"$work/two_files" >"$work/two_files.pgm"
cmp "$work/checkout.pgm" "$work/two_files.pgm"
# With ink, too.
[ "$(tail -c 8000 "$work/checkout.pgm" | tr -d '\000' | wc -c)" -gt 500 ]
python3 -B tests/release/ecosystems.py "$work/ecosystems" "$release"
sh tests/release/generator.sh "$work/generator" "$release" "$fontgen"
echo "== all pieces work"
