#!/bin/sh
# What drawing costs: instructions, stack and bytes, counted in QEMU; beside
# FreeType and stb_truetype, and in LVGL beside its bitmap fonts.
#
#   sh tests/bench/run.sh [--cpu m0,m3,m4,m7,m33,rv32] [--opt O2,Os]
#       [--engines inkcell,freetype,stb] [--coding outline,field,truetype]
#       [--px 12,16,24,32,48,96] [--font FILE]... [--what glyphs,...]
#       [--against REV [--limits]]
#       [--lvgl FOLDER] [--lv-font-conv FILE] [--write-docs] [--help]
#
# FILE is a TTF, of which the standard font is made: 95 ASCII glyphs, 8 to 64
# px, 16/255; or a ROM font. LVGL's sources and lv_font_conv (of npm) are not
# downloaded; INKCELL_LVGL_DIR may name the first. Default: DejaVu Sans and Liberation Serif. Prints
# one JSON object a line on standard output and tables on standard error.
exec python3 -B "$(dirname "$0")/bench.py" "$@"
