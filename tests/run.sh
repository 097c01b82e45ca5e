#!/bin/sh
# Builds and tests what a change of the library needs: the first lane.
#
#   sh tests/run.sh [--all] [--only NAME...]
#
#   --all     the second lane as well
#   --only    these steps, of either lane:
#
# first lane
#   host                          core, ports, generator, tools; with --all the studio
#                                 and the rest
#   microbit lm3s6965evb riscv_virt    the same tests on emulated boards
#   parent                        costs of drawing against the parent commit
# second lane
#   lm3s811evb mps2_an385 mps2_an386 mps2_an500 mps2_an505 versatilepb
#                                 the other boards
#   alone                         each source compiled by itself, at -O0, in the
#                                 studio's own project
#   sanitize                      host tests with address and undefined sanitizers
#   big-endian                    host tests on an emulated PowerPC
#   fuzz                          four fuzzers, 30 s
#   web                           the generator and the page, in node and Chromium
#
# On Debian it installs what is missing (host_tools/setup.sh). It writes to
# build/ only, but for the caches of objects and of fonts (font_cache.py); the
# output of each step is in build/tests/<step>.log. Exits with 0 if everything
# passed.
set -u
cd "$(dirname "$0")/.." || exit 2
usage() {
  sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
  exit 2
}
first='host microbit lm3s6965evb riscv_virt parent'
second='lm3s811evb mps2_an385 mps2_an386 mps2_an500 mps2_an505 versatilepb
  alone sanitize big-endian fuzz web'
lane=first
steps=
while [ $# != 0 ]; do
  case $1 in
    --all) lane=all ;;
    --only) shift; steps=$*; [ $# != 0 ] || usage; break ;;
    *) usage ;;
  esac
  shift
done
for name in $steps; do
  case " $(echo $first $second) " in *" $name "*) ;; *) usage ;; esac
done
if [ -z "$steps" ]; then
  steps=$first
  [ $lane = first ] || steps="$first $second"
fi
only=$(echo $steps)

. tests/steps.sh
. host_tools/setup.sh
# The first lane has no need of what its steps do not call.
packages=first
for name in $only; do
  case " $first " in *" $name "*) ;; *) packages=tests ;; esac
done
[ $lane = first ] || packages=tests
inkcell_setup $packages

# run_tests <folder> <ctest option>...: a step that counts each test instead. A
# test that needs more than 20 s has a limit of its own (inkcell_test_seconds).
run_tests() {
  name=test-$1
  folder=build/$1
  shift
  begun=$(date +%s)
  measure "$name"
  before=$processor
  ctest --test-dir "$folder" -j "$jobs" --timeout 400 --no-tests=error \
    --output-on-failure "$@" >"$logs/$name.log" 2>&1
  result=$?
  measure "$name"
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
    printf '%-8s%-28s%4d s (%d s)  %d of %d tests\n' $verdict "$name" \
      $(($(date +%s) - begun)) $((processor - before)) $((all - bad)) "$all"
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

rest=ON  # the second lane of tests, and the studio
[ $lane = all ] || rest=OFF
# One generator makes the fonts of all builds, but in --all those of the boards:
# they find none at hand, as a user's do, and build one together.
fontgen=-DINKCELL_FONTGEN=$root/build/host/fonts_gen/inkcell-fontgen
boards_fontgen=$fontgen
[ $lane = first ] || boards_fontgen=-DINKCELL_FONTGEN_DIR=$root/build/fontgen

# Joined folders compile sooner; with each source alone, packages are tested, and
# objects measured.
case $only in
  fuzz | parent | web) ;;
  *)
    step configure-host cmake -S . --preset host -DINKCELL_JOIN_FOLDERS=ON \
      -DINKCELL_SECOND_LANE=$rest -DINKCELL_STUDIO=$rest \
      "-DINKCELL_BOARD_BUILDS=$root/build" &&
      step build-generator cmake --build build/host -j "$jobs" \
        --target inkcell-fontgen || {
      summary
      exit 1
    }
    ;;
esac

# Two at a time: while one links, or waits for its last test, the other has work
# for all cores.
rm -f "$logs/built-host"
build_host() {
  step build-host cmake --build build/host -j "$jobs" && : >"$logs/built-host"
}
if wanted host; then
  build_host &
  host=$!
fi
boards=
for name in $only; do
  if [ -d "boards/$name" ]; then
    boards="$boards $name"
    build "$name" --preset "$name" -DINKCELL_JOIN_FOLDERS=ON \
      -DINKCELL_SECOND_LANE=$rest "$boards_fontgen"
  fi
done
if wanted host; then
  await $host
fi

# The host's tests include those that look at the screens of the boards.
host_tests() {
  wanted host && built host && run_tests host
  wanted fuzz && step fuzz sh tests/fuzz/run.sh 30
  wanted parent && step parent sh tests/bench/parent.sh
  wanted web && step web sh tests/web.sh --here
}
host_tests &
host=$!

for board in $boards; do
  built "$board" && run_tests "$board"
done

# The studio as a project of its own, and all that it is built over, with each
# source alone: where folders are joined, a source may lean on what another
# includes.
if wanted alone; then
  step configure-alone cmake -S host_tools/design -B build/alone -G Ninja \
    -DINKCELL_TESTS=OFF -DINKCELL_ASSERTIONS=ON -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 "$fontgen" &&
    step build-alone cmake --build build/alone -j "$jobs" \
      --target all inkcell/all
fi

# Only what runs is of interest here, and not the tests that make whole fonts to
# judge them, play whole scenes, or measure time, which takes minutes each: the
# same code runs in smaller ones. Nor that of a firmware, which has no
# sanitizers. So tests/CMakeLists.txt leaves folders out, and the fonts that
# programs are built with come from the generator without sanitizers.
slow='fonts|format\.shaping|bench\.m3|tools\.(accuracy|animate)|design\.(family|figures|window)'
if wanted sanitize; then
  build host-sanitize --preset host-sanitize "$fontgen" \
    -DINKCELL_SECOND_LANE=ON -DINKCELL_STUDIO=ON \
    -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld &&  # links in a sixth of the time
    run_tests host-sanitize --timeout 2000 -E "^($slow)"
fi

if wanted big-endian; then
  build big-endian -DCMAKE_BUILD_TYPE=Release "$fontgen" \
    -DINKCELL_SECOND_LANE=ON \
    -DCMAKE_TOOLCHAIN_FILE="$root/tests/big_endian.cmake" &&
    run_tests big-endian --timeout 4000
fi
await $host

summary
result=$?
if [ "$only" = "$first" ]; then
  cat <<'END'

The second lane (sh tests/run.sh --all) holds: the studio (host_tools/design), the
simulator's window, simulation (bodies, particles, level sets, prints), the
field's splats and seams, judgements of seven faces, screens of the boards with
displays, six more boards, complete programs and packages, sanitizers, fuzzers, a
big-endian machine, -O0, and the page.
END
  # What this machine lacks of the first lane: Clang, node.
  grep -hE 'left out|not tested' "$logs/configure-host.log" | sed 's/^-- //'
fi
exit $result
