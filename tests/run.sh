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
. tests/steps.sh
. host_tools/setup.sh
inkcell_setup tests

# run_tests <folder> <ctest option>...: a step that counts each test instead. A
# test that needs more than a few seconds has a limit of its own
# (inkcell_test_seconds).
run_tests() {
  name=test-$1
  folder=build/$1
  shift
  begun=$(date +%s)
  ctest --test-dir "$folder" -j "$jobs" --timeout 60 --no-tests=error \
    --output-on-failure "$@" >"$logs/$name.log" 2>&1
  result=$?
  of=$(sed -n 's/.*, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' \
    "$logs/$name.log")
  bad=${of% *}
  all=${of#* }
  if [ -z "$of" ] || { [ $result != 0 ] && [ "$bad" = 0 ]; }; then
    bad=1
    all=1
  fi
  echo "$((all - bad)) $bad 0" >>"$counts"
  verdict=ok
  [ "$bad" = 0 ] || verdict=FAILED
  printf '%s\n' "$(
    printf '%-8s%-28s%4d s  %d of %d tests\n' $verdict "$name" \
      $(($(date +%s) - begun)) $((all - bad)) "$all"
    if [ $verdict = FAILED ]; then
      grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed |^ *Start ' "$logs/$name.log" |
        tail -n 80 | sed 's/^/    /'
    fi
  )"
}

# build <folder> <cmake option>...: configures and compiles build/<folder>.
build() {
  folder=$1
  shift
  rm -f "$logs/built-$folder"
  step "configure-$folder" cmake -S . -B "build/$folder" -G Ninja "$@" &&
    step "build-$folder" cmake --build "build/$folder" -j "$jobs" &&
    : >"$logs/built-$folder"
}

# built <folder>: whether build() came to its end.
built() {
  [ -e "$logs/built-$1" ]
}

# await <process>: until a part in the background ends. One that was killed has
# not counted its step.
await() {
  wait "$1"
  [ $? -lt 128 ] || echo '0 1 0' >>"$counts"
}

boards=
for toolchain in boards/*/toolchain.cmake; do
  boards="$boards $(basename "$(dirname "$toolchain")")"
done

# Two at a time: while one links, or waits for its last test, the other has work
# for all cores.

# Joined folders compile sooner; with each source alone, packages are tested, and
# objects measured.
build host --preset host -DINKCELL_JOIN_FOLDERS=ON \
  "-DINKCELL_BOARD_BUILDS=$root/build" &
host=$!
for board in $boards; do
  # As a user would, without a generator at hand; but one serves all boards.
  build "$board" --preset "$board" -DINKCELL_JOIN_FOLDERS=ON \
    "-DINKCELL_FONTGEN_DIR=$root/build/fontgen"
done
await $host

# The host's tests include those that look at the screens of the boards.
host_tests() {
  built host && run_tests host
  step fuzz sh tests/fuzz/run.sh 30
  step bench-parent sh tests/bench/parent.sh
  step web sh tests/web.sh --here
}
host_tests &
host=$!

for board in $boards; do
  built "$board" && run_tests "$board"
done

# Generator and tools with each source alone, as the preset builds them:
# where folders are joined, a source may lean on what another includes.
fontgen=-DINKCELL_FONTGEN=$root/build/host/fonts_gen/inkcell-fontgen
build alone --preset host -DINKCELL_TESTS=OFF -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG=-O0 "$fontgen"

# Only what runs is of interest here, and not the tests that make whole fonts to
# judge them, play whole scenes, or measure time, which takes minutes each: the
# same code runs in smaller ones. Nor that of a firmware, which has no
# sanitizers. So tests/CMakeLists.txt leaves folders out, and the fonts that
# programs are built with come from the generator without sanitizers.
slow='fonts|bench\.m3|tools\.(accuracy|animate)|design\.(figures|window)'
build host-sanitize --preset host-sanitize "$fontgen" \
  -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld &&  # links in a sixth of the time
  run_tests host-sanitize --timeout 300 -E "^($slow)"

build big-endian -DCMAKE_BUILD_TYPE=Release "$fontgen" \
  -DCMAKE_TOOLCHAIN_FILE="$root/tests/big_endian.cmake" &&
  run_tests big-endian --timeout 300
await $host

summary
