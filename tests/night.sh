#!/bin/sh
# Measures all that documents say, and looks for faults for hours:
#
#   sh tests/night.sh [--only NAME...]
#
#   bench      instructions, stack and bytes on seven cores: docs/BENCHMARKS.md,
#              docs/figures.json and the tables that are drawn from it
#   programs   bytes of whole programs: docs/figures.json
#   corpus     fonts of 180 faces: a chapter of docs/BENCHMARKS.md
#   editing    the claims of host_tools/design/docs/EDITING.md
#   mutate     mistakes in the core that no unit test notices
#   coverage   lines and branches of the core that no test runs
#   fuzz       all fuzzers, an hour
#   shaping    sentences and random strings by the device and by HarfBuzz
#   release    tests/release.sh: the files of a release, as users take them
#   bare       tests/bare.sh: demo, page and tests on a bare Debian; needs root
#
# Commit the documents that it changed by themselves. LVGL is measured where
# INKCELL_LVGL_DIR names its sources and lv_font_conv (of npm) is in the path.
# The output of each step is in build/tests/<step>.log. Exits with 0 if everything
# passed.
set -u
cd "$(dirname "$0")/.." || exit 2
all='bench programs corpus editing mutate coverage fuzz shaping release bare'
usage() {
  sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
  exit 2
}
only=$all
case ${1-} in
  '') ;;
  --only) shift; only=$*; [ $# != 0 ] || usage ;;
  *) usage ;;
esac
for name in $only; do
  case " $all " in *" $name "*) ;; *) usage ;; esac
done
. tests/steps.sh
. host_tools/setup.sh
inkcell_setup tests

# Bytes of programs are those of build.examples and build.packages.
programs() {
  cmake --build build/host -j "$jobs" --target all &&
    ctest --test-dir build/host --output-on-failure --no-tests=error \
      -R '^build\.(examples|packages)$' || return
  made=build/host/tests/build
  python3 -B tests/bench/figures.py programs $made/example_programs/figures.json \
    readme $made/packages/figures.json
}
bench() {
  sh tests/bench/run.sh --write-docs >"$logs/bench.jsonl"
}
editing() {
  cmake --build build/host -j "$jobs" --target all &&
    python3 -B host_tools/design/tests/figures.py build/host/host_tools/design
}
shaping() {
  cmake --build build/host -j "$jobs" --target inkcell-fontgen inkcell-inspect &&
    for kind in sentences random; do
      python3 -B tests/gen/shaped_words.py build/host/fonts_gen/inkcell-fontgen \
        build/host/host_tools/inkcell-inspect build/tests/shaped_$kind $kind ||
        return
    done
}
bare() {
  [ "$(id -u)" = 0 ] || { echo "needs root"; return 77; }
  sh tests/bare.sh
}

step host cmake -S . --preset host -DINKCELL_JOIN_FOLDERS=ON \
  -DINKCELL_SECOND_LANE=ON -DINKCELL_STUDIO=ON &&
  step generator cmake --build build/host --target inkcell-fontgen
wanted bench && step bench bench
wanted programs && step programs programs
wanted corpus && step corpus sh tests/fonts/corpus.sh --write-docs
wanted editing && step editing editing
wanted mutate && step mutate sh tests/mutate.sh
wanted coverage && step coverage sh tests/coverage.sh
wanted fuzz && step fuzz sh tests/fuzz/run.sh 3600
wanted shaping && step shaping shaping
wanted release && step release sh tests/release.sh
wanted bare && step bare bare
git status --short docs README.md
summary
