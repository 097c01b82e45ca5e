#!/bin/sh
# Compares the cost of drawing with the parent commit: Cortex-M3 at -O2, two
# codings, two sizes, with the frozen fonts. About half a minute.
#
#   sh tests/bench/parent.sh
#
# Fails where a cost grows beyond the limits in against.py and no line
# `Costs: <name>, ...` in the commit's body names it. Uncommitted changes are
# compared with HEAD. Exits with 77 where there is no parent to compare with.
set -u
cd "$(dirname "$0")/../.." || exit 2

measured="core port/pixel boards/common boards/mps2_an385 tests/bench"
if ! git rev-parse --verify --quiet HEAD >/dev/null; then
  echo "skipped: these sources are not in a git repository"
  exit 77
fi
base=HEAD
if git diff --quiet HEAD -- $measured; then
  base=HEAD^
fi
if ! git rev-parse --verify --quiet "$base^{commit}" >/dev/null; then
  echo "skipped: the parent commit is not here (a shallow clone?);" \
    "git fetch --deepen 1"
  exit 77
fi
if git diff --quiet "$base" -- $measured; then
  echo "what is measured does not differ from $base"
  exit 0
fi
fonts=tests/golden/fonts
exec sh tests/bench/run.sh --against "$base" --limits --cpu m3 --opt O2 \
  --px 12,48 --coding outline,field --what glyphs,code \
  --font $fonts/dejavu_sans_outline.bin --font $fonts/dejavu_sans_field.bin \
  --build build/bench-parent
