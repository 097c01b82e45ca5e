#!/bin/sh
# Draws the pictures of README.md and docs/ into docs/img/, those of the studio into
# host_tools/design/docs/img/.
#
#   sh host_tools/draw_docs.sh <host build folder>
set -eu
if [ $# -ne 1 ] || [ ! -x "$1/host_tools/inkcell-specimen" ]; then
  echo "draw_docs.sh <host build folder>, with the tools built" >&2
  exit 2
fi
tools=$(cd "$1" && pwd)/host_tools
cd "$(dirname "$0")/.."
fonts=/usr/share/fonts/truetype
images=host_tools/design/docs/img
mkdir -p docs/img $images
"$tools/inkcell-specimen" "$fonts/dejavu/DejaVuSans.ttf" \
  --draw-sizes docs/img/sizes.png --draw-filters docs/img/filters.png \
  --draw-lcd docs/img/lcd.png --draw-levels docs/img/levels.png \
  --draw-maps docs/img/maps.png --draw-effects docs/img/effects.png \
  --draw-motion docs/img/motion.png
"$tools/inkcell-specimen" "$fonts/liberation/LiberationSerif-Regular.ttf" \
  --draw-compare-body docs/img/compare_body.png \
  --draw-compare-display docs/img/compare_display.png --draw-star docs/img/star.png
"$tools/inkcell-specimen" "$fonts/liberation/LiberationSerif-Regular.ttf" \
  --draw-fitting docs/img/fitting.png --draw-contrast docs/img/contrast.png
"$tools/inkcell-specimen" "$fonts/liberation/LiberationSerif-Italic.ttf" \
  --draw-compare-body docs/img/compare_italic.png
"$tools/inkcell-inspect" "$fonts/liberation/LiberationSerif-Regular.ttf" \
  --glyph a --side 600 --coding field --cells docs/img/cells.png >/dev/null
"$tools/inkcell-inspect" "$fonts/liberation/LiberationSerif-Regular.ttf" \
  --glyph a --side 600 --points docs/img/points.png >/dev/null
"$tools/inkcell-inspect" "$fonts/dejavu/DejaVuSans.ttf" \
  --glyph e --side 400 --points docs/img/hints.png >/dev/null
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# The reel's word in a face that the studio draws.
"$tools/design/inkcell-design" script host_tools/design/samples/pen_face.lua \
  --set weight=130 --set x_height=540 --out "$folder/Pen.ufo"
"$tools/design/inkcell-design" export --project "$folder/Pen.ufo" --out "$folder/Pen.ttf"
"$tools/inkcell-animate" reel --font "$folder/Pen.ttf" --out docs/img/reel.gif
# Eight frames each of the recipes: scene, first frame [s], frames a second.
for strip in count,0,3 clock,2.6,10 typewriter,1.7,5 wipe,0,6 bounce,0,10 \
  pulse,0,6 ticker,0,2 icons,0,6 melt,0,2; do
  scene=${strip%%,*} rest=${strip#*,} fps=${strip##*,}
  "$tools/inkcell-animate" "$scene" --size 96x48 --from "${rest%%,*}" \
    --fps "$fps" --seconds "$(echo "8 / $fps" | awk '{print $1 / $3}')" \
    --format sheet --out "docs/img/recipe_$scene.png"
done
"$tools/inkcell-animate" pulse --font "$fonts/inter-vf/Inter.var.ttf" \
  --axis wght=300..800 --size 96x48 --fps 6 --seconds 1.334 --format sheet \
  --out docs/img/recipe_masters.png
cat >"$folder/editor.txt" <<END
open $fonts/dejavu/DejaVuSans.ttf $folder/Mine.ufo 0x20-0x7E
glyph a
text Hamburg 012
select 3
screenshot $images/editor.png
END
"$tools/design/editor/inkcell-editor" --script "$folder/editor.txt"
# A knot of the sample's n, with its nib.
cat >"$folder/strokes.txt" <<END
sample
press 280 462
release 280 462
screenshot $PWD/$images/strokes.png
END
(cd "$folder" && "$tools/design/editor/inkcell-editor" --script strokes.txt)
"$tools/simulator/inkcell-simulator" --display grey4 --size 128x64 --px 40 \
  --text Rag --hint vertical --overlay on --screenshot docs/img/simulator.png
# Eight letters made by the steps of the window's test, and an OLED with them.
python3 -B host_tools/design/tests/check_window.py \
  "$tools/design/editor/inkcell-editor" --letters "$folder"
cp "$folder/letters.png" $images/letters.png
"$tools/simulator/inkcell-simulator" --font "$folder/Letters.ttf" \
  --board lm3s6965evb_grey4 --text "hound blind" --px 22 \
  --screenshot $images/letters_oled.png
# Text drawn by LVGL, if the build has it (tests/lvgl).
shots=$tools/../tests/lvgl/inkcell_lvgl_shots
if [ -x "$shots" ]; then
  "$shots" "$folder"
  cp "$folder/text_large.png" docs/img/lvgl.png
else
  echo "docs/img/lvgl.png stays as it is: the build is without LVGL" >&2
fi
ls -l docs/img $images
