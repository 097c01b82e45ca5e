#!/bin/sh
# Runs the fuzzers of fonts, of outlines, of fonts in storage, of strikes, of
# TrueType files, of shaping, of type that moves, of layers and of figures for a
# while, on all cores, each for a ninth of the time:
#
#   sh tests/fuzz/run.sh [SECONDS [FOLDER]]      (30 build/fuzz)
#
# New inputs gather in FOLDER/corpus, FOLDER/corpus_outline, FOLDER/corpus_stored,
# FOLDER/corpus_strike, FOLDER/corpus_truetype, FOLDER/corpus_shaping,
# FOLDER/corpus_moving, FOLDER/corpus_layers and FOLDER/corpus_figures, in a folder for
# each core, and are the start of the next run.
# A crash ends it with an exit code; its input is FOLDER/crash-*. Put that into the
# folder of the same name in tests/fuzz, with the fix: CTest runs all of them
# (fuzz.corpus, fuzz.corpus_outline and so on).
set -eu
seconds=${1:-30}
folder=${2:-build/fuzz}
case $seconds in
  *[!0-9]*)
    sed -n '2,/^set/s/^# *//p' "$0" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/../.."
command -v clang++ >/dev/null || {
  echo "tests/fuzz/run.sh: clang++ is missing: apt-get install clang" >&2
  exit 1
}
rm -rf "$folder/objects"
mkdir -p "$folder/objects"
flags="-std=c++17 -O1 -g -fsanitize=address,undefined
  -fno-sanitize-recover=all -DINKCELL_LIBFUZZER=1
  -Icore/include -Icore/src -Icore/field/include
  -Icore/figures/include -Icore/layers/include -Icore/motion/include
  -Icore/shaping/include -Icore/simulation/include -Icore/stored/include
  -Icore/strike/include -Icore/truetype/include -Iport/pixel/include
  -Itests/unit -Itests/hostile"

# Objects of the sources given, side by side.
# shellcheck disable=SC2016,SC2086  # $2 is that of sh, flags are to be split
compile() {
  printf '%s\n' "$@" | xargs -P "$(nproc)" -I '{}' sh -c '
    source=$1 folder=$2
    shift 2
    exec clang++ "$@" -fsanitize=fuzzer-no-link -c "$source" \
      -o "$folder/objects/$(echo "$source" | tr / -).o"' \
    sh '{}' "$folder" $flags
}
compile core/src/*/*.cpp core/field/src/*.cpp tests/hostile/exercise.cpp tests/unit/font_builder.cpp

# Fuzzer, folder of its corpus, longest input, more sources.
run() {
  target=$1
  corpus=$2
  longest=$3
  shift 3
  # shellcheck disable=SC2086  # flags are meant to be split
  clang++ $flags -fsanitize=fuzzer "tests/fuzz/$target.cpp" "$@" \
    "$folder"/objects/*.o -o "$folder/$target"
  # A unit that hangs is as bad as a crash.
  common="-max_len=$longest -timeout=60 -rss_limit_mb=1024"
  pids=
  for job in $(seq "$(nproc)"); do
    # A folder of its own: one job removes what another is about to read.
    mkdir -p "$folder/$corpus/$job"
    # shellcheck disable=SC2086  # options are meant to be split
    "$folder/$target" $common -artifact_prefix="$folder/" \
      -max_total_time="$((seconds / 9))" -print_final_stats=1 \
      "$folder/$corpus/$job" "tests/fuzz/$corpus" \
      >"$folder/$target-$job.log" 2>&1 &
    pids="$pids $!"
  done
  job=0
  for pid in $pids; do
    job=$((job + 1))
    log=$folder/$target-$job.log
    if ! wait "$pid"; then
      failed=1
      tail -n 40 "$log"
    fi
    grep -E 'number_of_executed_units|new_units_added' "$log" || true
    grep -E ' cov: ' "$log" | tail -n 1
  done
}

failed=0
run fuzz_font corpus 4096
run fuzz_outline corpus_outline 1024 tests/hostile/outline_pictures.cpp
run fuzz_strike corpus_strike 2048 core/strike/src/*.cpp
run fuzz_truetype corpus_truetype 3000 core/truetype/src/*.cpp
run fuzz_shaping corpus_shaping 4096 core/shaping/src/*.cpp
compile core/motion/src/*.cpp core/simulation/src/*.cpp
run fuzz_stored corpus_stored 4096 core/stored/src/*.cpp \
  core/strike/src/*.cpp core/layers/src/*.cpp
run fuzz_moving corpus_moving 6000
run fuzz_layers corpus_layers 1024 core/layers/src/*.cpp
run fuzz_figures corpus_figures 512 core/figures/src/*.cpp port/pixel/src/*.cpp
exit $failed
