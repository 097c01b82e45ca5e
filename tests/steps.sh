# Steps of tests/run.sh and tests/night.sh, which include this file from the
# folder of the sources, and name the wanted steps in $only: each writes
# build/tests/<step>.log, says how it went and is counted.

# Three boards have one core, packages are built in several ways, and most objects
# are those of the last run: every compiler is called through ccache. So are fonts,
# of which several builds make the same.
root=$PWD
export PATH="/usr/lib/ccache:$PATH" CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1
export INKCELL_FONTGEN_LAUNCHER="$root/tests/font_cache.py"

logs=$root/build/tests
mkdir -p "$logs"
jobs=$(nproc)
started=$(date +%s)
counts=$logs/counts  # a line a step: passed, failed, skipped
: >"$counts"
# Steps run side by side, and do not hear the key that ends this script.
trap 'trap - INT; kill 0; exit 130' INT

# wanted <name>: whether the step is one of $only.
wanted() {
  case " $only " in *" $1 "*) ;; *) return 1 ;; esac
}

# measure <name>: sets $processor, the seconds of processor time of children of
# this shell that have ended.
measure() {
  # Not in $(), which would tell of another shell.
  times >"$logs/$1.times"
  processor=$(awk 'NR == 2 {
    for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] }
    printf "%d", s }' "$logs/$1.times")
}

# step <name> <command>...: runs it, says how it went and how many seconds it took,
# in brackets those of processor time, and counts it. A command that exits with 77
# could not be run here: its last line says why.
step() {
  name=$1
  shift
  begun=$(date +%s)
  measure "$name"
  before=$processor
  "$@" >"$logs/$name.log" 2>&1
  case $? in
    0) verdict=ok count='1 0 0' ;;
    77) verdict=skipped count='0 0 1' ;;
    *) verdict=FAILED count='0 1 0' ;;
  esac
  echo "$count" >>"$counts"
  measure "$name"
  # At once, so that steps side by side do not mix their lines.
  printf '%s\n' "$(
    printf '%-8s%-28s%4d s (%d s)\n' $verdict "$name" \
      $(($(date +%s) - begun)) $((processor - before))
    case $verdict in
      skipped) tail -n 1 "$logs/$name.log" | sed 's/^/    /' ;;
      FAILED) tail -n 40 "$logs/$name.log" | sed 's/^/    /' ;;
    esac
  )"
  [ $verdict != FAILED ]
}

# summary: says what was counted. Fails where a step did, or none was taken.
summary() {
  passed=0 failed=0 skipped=0
  while read -r good bad left; do
    passed=$((passed + good)) failed=$((failed + bad)) skipped=$((skipped + left))
  done <"$counts"
  measure all
  printf '\n%d s, %d s of processor time; logs in build/tests\n' \
    $(($(date +%s) - started)) "$processor"
  [ $skipped = 0 ] || printf '%d skipped, ' $skipped
  printf '%d passed, %d failed\n' $passed $failed
  [ $failed = 0 ] && [ $passed != 0 ]
}
