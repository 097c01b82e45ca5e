#!/bin/sh
# What drawing costs: instructions, stack and bytes, counted in QEMU.
#
#   sh tests/bench/run.sh [--cpu m0,m3,m4,m7,m33,rv32,microbit] [--px 12,24,48]
#       [--opt O2,Os] [--engines inkcell] [--font FILE] [--build FOLDER]
#
# FILE is a ROM font, or a TTF that becomes the standard font: 95 ASCII glyphs,
# 8 to 64 px, 16/255. Default: DejaVu Sans. Prints one JSON object a line on
# standard output and a table on standard error. See bench.py.
exec python3 "$(dirname "$0")/bench.py" "$@"
