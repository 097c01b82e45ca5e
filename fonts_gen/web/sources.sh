#!/bin/sh
# Fetches Debian's sources of the libraries that the generator needs, to compile
# them for WebAssembly or Windows.
#
#   sh fonts_gen/web/sources.sh FOLDER
#
# apt-get checks them. They lie unpacked in FOLDER/<package>; FOLDER/versions.txt
# names what they are. What is there already stays.
set -eu
[ $# = 1 ] || { sed -n '2,/^set/s/^# *//p' "$0" >&2; exit 2; }
packages="brotli freetype harfbuzz fribidi libpolyclipping pugixml"
mkdir -p "$1/apt/lists/partial" "$1/apt/cache/archives/partial" "$1/apt/parts"
folder=$(cd "$1" && pwd)

# This machine's archives, as archives of sources; nothing outside FOLDER changes.
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
  /etc/apt/sources.list.d/*.sources; do
  [ ! -f "$file" ] || sed 's/^deb /deb-src /; s/^Types:.*/Types: deb-src/' "$file" \
    >"$folder/apt/parts/$(basename "$file")"
done
apt() {
  program=$1
  shift
  nice -n 10 "$program" -qq -o Dir::Etc::SourceList=/dev/null \
    -o Dir::Etc::SourceParts="$folder/apt/parts" \
    -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" \
    -o APT::Sandbox::User="$(id -un)" "$@"
}

# download PACKAGE: the newest version that the archives still have.
download() {
  for version in $(apt apt-cache showsrc --only-source "$1" |
    sed -n 's/^Version: //p' | sort -rVu); do
    apt apt-get --download-only --only-source source "$1=$version" && return
  done
  echo "$1: no archive in /etc/apt has its source" >&2
  return 1
}

listed=
for package in $packages; do
  [ ! -d "$folder/$package" ] || continue
  # An archive that fails need not be one that has the package.
  [ -n "$listed" ] || apt apt-get update || true
  listed=yes
  rm -rf "$folder/new"
  mkdir "$folder/new"
  (cd "$folder/new" && download "$package" &&
    dpkg-source --no-check -x ./*.dsc unpacked >/dev/null)
  (cd "$folder/new" && sed -n 's/^Version: //p' ./*.dsc) >"$folder/new/unpacked/version"
  mv "$folder/new/unpacked" "$folder/$package"
done
for package in $packages; do
  echo "$package $(cat "$folder/$package/version")"
done >"$folder/versions.txt"
cat "$folder/versions.txt"
