#!/bin/sh
# How well small text reads, beside FreeType's three ways to hint.
#
#   sh tests/bench/reading.sh --render <build>/host_tools/inkcell-render
#       [--font FILE]... [--px 8,9,10,12] [--rows "grey, both;1 bit"]
#       [--at-least PERCENT] [--help]
#
# Needs Tesseract and Debian's Python with FreeType; installs what is missing.
# Prints one JSON object a line on standard output and tables on standard error.
set -eu
. "$(dirname "$0")/../../host_tools/setup.sh"
inkcell_setup reading
before=
for word; do
  case $before in
    --language) inkcell_setup packages "tesseract-ocr-$(echo "$word" | tr _ -)" ;;
  esac
  before=$word
done
exec /usr/bin/python3 -B "$(dirname "$0")/reading.py" "$@"
