#!/bin/sh
# Builds everything and runs every test: on this machine, with sanitizers, on
# the emulated boards, on a big-endian machine, and the fuzzer for a short time.
#
#   sh tests/run.sh
#
# On Debian it installs what is missing (host_tools/setup.sh). It writes to
# build/ only; the output of each step is in build/tests/<step>.log. Exits with
# 0 if everything passed.
set -u
if [ $# -ne 0 ]; then
  sed -n '2,/^set/s/^# *//p' "$0" >&2
  exit 2
fi
cd "$(dirname "$0")/.." || exit 2
root=$PWD
. host_tools/setup.sh
inkcell_setup tests

# Three boards have one core, packages are built in several ways, and most objects
# are those of the last run: every compiler is called through ccache.
export PATH="/usr/lib/ccache:$PATH" CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1

logs=$root/build/tests
mkdir -p "$logs"
jobs=$(nproc)
started=$(date +%s)
passed=0
failed=0
skipped=0

# step <name> <command>...: runs it, says how it went, and counts it. A command
# that exits with 77 could not be run here: its last line says why.
step() {
  name=$1
  shift
  begun=$(date +%s)
  "$@" >"$logs/$name.log" 2>&1
  case $? in
    0) verdict=ok passed=$((passed + 1)) ;;
    77) verdict=skipped skipped=$((skipped + 1)) ;;
    *) verdict=FAILED failed=$((failed + 1)) ;;
  esac
  printf '%-8s%-28s%4d s\n' "$verdict" "$name" $(($(date +%s) - begun))
  if [ $verdict = skipped ]; then
    tail -n 1 "$logs/$name.log" | sed 's/^/    /'
  fi
  if [ $verdict = FAILED ]; then
    tail -n 40 "$logs/$name.log" | sed 's/^/    /'
    return 1
  fi
}

# run_tests <folder> <ctest option>...: a step that counts each test instead.
run_tests() {
  name=test-$1
  folder=build/$1
  shift
  begun=$(date +%s)
  ctest --test-dir "$folder" -j "$jobs" --timeout 300 --no-tests=error \
    --output-on-failure "$@" >"$logs/$name.log" 2>&1
  result=$?
  counts=$(sed -n 's/.*, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' \
    "$logs/$name.log")
  bad=${counts% *}
  all=${counts#* }
  if [ -z "$counts" ] || { [ $result != 0 ] && [ "$bad" = 0 ]; }; then
    bad=1
    all=1
  fi
  passed=$((passed + all - bad))
  failed=$((failed + bad))
  verdict=ok
  [ "$bad" = 0 ] || verdict=FAILED
  printf '%-8s%-28s%4d s  %d of %d tests\n' $verdict "$name" \
    $(($(date +%s) - begun)) $((all - bad)) "$all"
  if [ $verdict = FAILED ]; then
    grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed |^ *Start ' "$logs/$name.log" |
      tail -n 80 | sed 's/^/    /'
  fi
}

# build <folder> <cmake option>...: configures and compiles build/<folder>.
build() {
  folder=$1
  shift
  step "configure-$folder" cmake -S . -B "build/$folder" -G Ninja "$@" &&
    step "build-$folder" cmake --build "build/$folder" -j "$jobs"
}

boards=
for toolchain in boards/*/toolchain.cmake; do
  boards="$boards $(basename "$(dirname "$toolchain")")"
done

# Joined folders compile sooner; with each source alone, packages are tested, and
# objects measured.
build host --preset host -DINKCELL_JOIN_FOLDERS=ON && host_built=yes
built_boards=
for board in $boards; do
  # As a user would, without a generator at hand; but one serves all boards.
  build "$board" --preset "$board" -DINKCELL_JOIN_FOLDERS=ON \
    "-DINKCELL_FONTGEN_DIR=$root/build/fontgen" &&
    built_boards="$built_boards $board"
done

# The host's tests include those that look at the screens of the boards.
[ -n "${host_built-}" ] && run_tests host
for board in $built_boards; do
  run_tests "$board"
done

# What is built is the same: only what runs is of interest here, and not the
# tests that make whole fonts to judge them, play whole scenes, or measure time,
# which takes minutes each: the same code runs in smaller ones. So the fonts that
# programs are built with come from the generator without sanitizers.
slow='build|fonts|screens|seams|tools\.(accuracy|animate)|design\.(figures|window)'
fontgen=-DINKCELL_FONTGEN=$root/build/host/fonts_gen/inkcell-fontgen
build host-sanitize --preset host-sanitize "$fontgen" &&
  run_tests host-sanitize -E "^($slow)"

build big-endian -DCMAKE_BUILD_TYPE=Release "$fontgen" \
  -DCMAKE_TOOLCHAIN_FILE="$root/tests/big_endian.cmake" &&
  run_tests big-endian

step fuzz sh tests/fuzz/run.sh 30
step bench-parent sh tests/bench/parent.sh

printf '\n%d s; logs in build/tests\n' $(($(date +%s) - started))
[ $skipped = 0 ] || printf '%d skipped, ' $skipped
printf '%d passed, %d failed\n' $passed $failed
[ $failed = 0 ]
