#!/bin/sh
# Shows Inkcell on a fresh machine: builds everything, makes a font of each coding,
# draws with them on this machine and on four emulated boards with displays.
#
#   sh host_tools/demo.sh [FONT.ttf]
#
# Installs what is missing (host_tools/setup.sh), writes to build/ only, and
# leaves pictures and tables in build/demo/.
set -eu
case ${1:-} in
  -*) sed -n '5p' "$0" | sed 's/^# *//' >&2; exit 2 ;;
esac
font=${1:-/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf}
case $font in
  /*) ;;
  *) font=$PWD/$font ;;
esac
cd "$(dirname "$0")/.."
. host_tools/setup.sh
inkcell_setup demo
if [ ! -r "$font" ]; then
  echo "There is no font file $font" >&2
  exit 1
fi

out=$PWD/build/demo
host=$PWD/build/demo-host
mkdir -p "$out"
rm -rf "$out"/*

echo "Building the generator and the tools (build/demo-host)"
cmake --preset demo-host -DINKCELL_DEMO_FONT="$font" >"$out/build.log" 2>&1 &&
  ninja -C "$host" inkcell_demo >>"$out/build.log" 2>&1 || {
  tail -n 30 "$out/build.log"
  exit 1
}
tools=$host/host_tools
fontgen=$host/fonts_gen/inkcell-fontgen

echo "Making fonts of $(basename "$font"), and comparing with exact areas and distances"
for coding in outline field; do
  "$fontgen" --font "$font" --coding $coding --out "$out/$coding.bin" \
    --report "$out/$coding.json" >>"$out/sizes.txt"
  "$tools/inkcell-accuracy" --font "$out/$coding.bin" --truth "$font" \
    --report "$out/${coding}_accuracy.json" --no-check >>"$out/accuracy.txt"
done
"$fontgen" --font "$font" --symbols 0123456789: --min-px 48 --max-px 200 \
  --out "$out/digits.bin" >>"$out/sizes.txt"
python3 host_tools/size_table.py "$out" outline field >"$out/table.txt"
cat "$out/table.txt"

echo "Drawing on this machine"
"$tools/inkcell-specimen" "$out/outline.bin" --draw-sizes "$out/sizes.png" \
  --draw-body "$out/body.png" --draw-turned "$out/turned.png" \
  --draw-moved "$out/moved.png" --draw-filters "$out/filters.png" \
  --draw-effects "$out/effects.png" --draw-lcd "$out/lcd.png" \
  --draw-levels "$out/levels.png" --draw-maps "$out/maps.png" \
  --draw-fitting "$out/fitting.png"
"$tools/inkcell-specimen" "$out/field.bin" --draw-contrast "$out/contrast.png" \
  --draw-motion "$out/motion.png"
"$tools/inkcell-specimen" "$out/digits.bin" --draw-digits "$out/digits.png"
"$tools/inkcell-inspect" "$out/field.bin" --cells "$out/cells.png" \
  >>"$out/sizes.txt"
"$tools/inkcell-inspect" "$out/outline.bin" --points "$out/points.png" \
  --field "$out/field.png" >>"$out/sizes.txt"
"$tools/inkcell-inspect" "$out/outline.bin" --sheet "$out/sheet.png" \
  >>"$out/sizes.txt"
"$tools/inkcell-render" --font "$out/outline.bin" --px 24 --zoom 6 --stats \
  --text "Hamburgefonts 24 px" --out "$out/enlarged.png" >>"$out/sizes.txt"

# A font with many contours may not fit the smallest board, which is then left
# out.
missed=
for board in lm3s6965evb lm3s811evb versatilepb riscv_virt; do
  echo "Running the demo on $board"
  if ! ninja -C "$host" "scene_hosts_$board" >"$out/$board.log" 2>&1; then
    missed="$missed $board"
    tail -n 20 "$out/$board.log"
  elif ! python3 host_tools/screens/screens.py \
    "$host/host_tools/screens/screens.json" \
    --board "$board" --picture scene --save "$out" >"$out/$board.log" 2>&1; then
    missed="$missed $board"
    tail -n 5 "$out/$board.log"
  else
    sed 's/^/  /' "$out/$board.log"
    sed -n 's/^ok *\([^:]*\):.*; \(.* instructions .*\)/\1: \2/p' \
      "$out/$board.log" >>"$out/speed.txt"
  fi
done

if [ -f tests/bench/run.sh ]; then
  echo "Counting instructions"
  if ! sh tests/bench/run.sh --font "$out/outline.bin" --fontgen "$fontgen" \
    --cpu m0,m3 --px 12,24,48 --what glyphs,code >"$out/bench.jsonl" 2>"$out/bench.txt"; then
    missed="$missed bench"
    tail -n 5 "$out/bench.txt"
  else
    cat "$out/bench.txt"
  fi
fi

echo
echo "In build/demo/:"
describe() {
  if [ -e "$out/$1" ]; then
    printf '  %-34s %s\n' "$1" "$2"
  fi
}
describe outline.bin "95 characters for 8 to 64 px, outlines"
describe field.bin "the same, cells of nine distances"
describe digits.bin "digits for 48 to 200 px"
describe table.txt "the two side by side"
describe sizes.txt "bytes of their parts, points and cells of each glyph"
describe accuracy.txt "errors of pixels against the exact distance"
describe speed.txt "instructions for a frame of each board"
describe bench.txt "instructions for a glyph, stack, bytes of code"
describe bench.jsonl "the same, one JSON object a line"
describe sizes.png "one font at ten sizes, and turned"
describe body.png "paragraphs"
describe digits.png "a clock"
describe turned.png "a word in 24 directions"
describe moved.png "a line moved by 1/8 px from row to row"
describe filters.png "filters, weights, gamma"
describe fitting.png "grid fitting, in grey and in 1 bit"
describe contrast.png "darker edges and thin strokes"
describe effects.png "outlines, shadow, glow"
describe lcd.png "sub-pixels"
describe levels.png "1 and 2 bits"
describe maps.png "leaning, narrow, mirrored"
describe motion.png "motion blur"
describe enlarged.png "pixels of 24 px type"
describe points.png "the contours of a glyph and their points"
describe field.png "the distance field of an outline near its edge"
describe cells.png "the distance field of a glyph and its cells"
describe sheet.png "all glyphs"
for picture in "$out"/*_scene_*.png; do
  describe "$(basename "$picture")" "a screen, as the board showed it"
done
if [ -n "$missed" ]; then
  echo "Without:$missed" >&2
  exit 1
fi
