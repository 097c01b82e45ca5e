#!/bin/sh
# Runs README's commands as on a fresh machine: a minimal Debian (debootstrap,
# variant minbase) with git and nothing else. Each gets a machine of its own, a
# copy of one root directory, and in it a clone of HEAD of this checkout:
#
#   sh tests/bare.sh [--demo] [--page] [--tests] [--all] [--fresh]    # none: all four
#
#   --demo    host_tools/demo.sh; its pictures are left in build/bare/demo
#   --page    host_tools/playground/build.sh; the page is left in build/bare/page
#   --tests   tests/run.sh, the first lane; its logs are left in build/bare/tests
#   --all     tests/run.sh --all; its logs are left in build/bare/all
#   --fresh   first remove the cached root directory and the compiler cache
#
# Prints the seconds of each, in brackets those of processor time, and the last
# line of its output. Exits with 0 if all passed; otherwise it shows the end of the
# log, and leaves the machine in build/bare/machine-demo, -page, -tests or -all.
#
# Needs root, Debian and its packages (inkcell_setup bare), and about 15 GB below
# build/bare. Everything but the packages comes from this machine: Debian's
# mirrors, apt's settings of downloads, proxies, certificates, hosts, resolv.conf.
# The compiler cache of tests/run.sh, build/bare/ccache, is kept between runs.
set -eu
wanted=
fresh=
for option; do
  case $option in
    --demo | --page | --tests | --all) wanted="$wanted ${option#--}" ;;
    --fresh) fresh=yes ;;
    --help) sed -n '2,/^set/s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "tests/bare.sh: $option: there are --demo, --page, --tests, --all, --fresh," \
         "--help" >&2
       exit 2 ;;
  esac
done
fail() {
  echo "tests/bare.sh: $*" >&2
  exit 1
}
cd "$(dirname "$0")/.."
root=$PWD
if [ "$(id -u)" != 0 ]; then
  fail "needs root, to make a root directory and to change into it:" \
    "sudo sh tests/bare.sh" "$@"
fi
release=$(. /etc/os-release && echo "$ID $VERSION_CODENAME")
case $release in
  debian\ ?*) codename=${release#* } ;;
  *) fail "needs Debian, whose mirrors it takes; this machine is $release" ;;
esac
. host_tools/setup.sh
inkcell_setup bare

work=$root/build/bare
pristine=$work/pristine
mkdir -p "$work"

# Removes a folder, unless something is mounted below it.
remove() {
  if grep -qF " $1/" /proc/self/mountinfo; then
    fail "$1 is not removed: something is mounted below it (see" \
      "/proc/self/mountinfo); unmount it with umount"
  fi
  rm -rf --one-file-system "$1"
}

# in_namespace <command>...: runs it with mounts and processes of its own, which
# all end with it, however it ends.
child=
trap '[ -z "$child" ] || kill -KILL "$child" 2>/dev/null; exit 1' HUP INT TERM
in_namespace() {
  unshare --mount --pid --fork --kill-child --mount-proc "$@" </dev/null &
  child=$!
  code=0
  wait "$child" || code=$?
  child=
  return $code
}

# Debian's mirrors of this machine: lines of address, suite, components.
mirrors() {
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' | sort -u |
    awk '{ place = $1 " " $2; all[place] = all[place] " " $3 }
         END { for (place in all) print place all[place] }' | sort
}

make_pristine() {
  mirror=$(echo "$places" | awk -v suite="$codename" '$2 == suite { print $1; exit }')
  [ -n "$mirror" ] || fail "apt-get indextargets knows no mirror of" \
    "Debian's suite $codename: see /etc/apt/sources.list"
  echo "Making a minimal Debian of $codename in build/bare/pristine"
  remove "$pristine"
  in_namespace debootstrap --variant=minbase --include=git "$codename" \
    "$pristine" "$mirror" >"$work/debootstrap.log" 2>&1 || {
    tail -n 20 "$work/debootstrap.log"
    fail "debootstrap failed; all it says is in build/bare/debootstrap.log"
  }
  rm -f "$pristine/etc/apt/sources.list"
  echo "$places" | sed 's/^/deb /' >"$pristine/etc/apt/sources.list.d/host.list"
  apt-config dump Acquire | grep -v -e IndexTargets -e Auto-Detect \
    >"$pristine/etc/apt/apt.conf.d/00host"
  for file in /etc/ssl/certs/ca-certificates.crt $(sed -n \
    's,^Acquire::https.* "\(/.*\)";$,\1,p' "$pristine/etc/apt/apt.conf.d/00host"); do
    if [ -f "$file" ]; then
      mkdir -p "$pristine$(dirname "$file")"
      cp -L "$file" "$pristine$file"
    fi
  done
  echo "$places" >"$work/pristine.mirrors"
}

# Sets `processor` to the seconds of processor time that commands have taken until
# now. `times` in $() would tell of another shell.
take_processor() {
  times >"$work/times"
  processor=$(awk 'NR == 2 {
    for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] }
    printf "%d", s }' "$work/times")
}

# on_machine <name> <script and options>: runs a script of this checkout on a machine
# of its own, says how it went and how long it took, and keeps build/<name>.
on_machine() {
  name=$1
  machine=$work/machine-$name
  echo "Running $2"
  remove "$machine"
  cp -a --reflink=auto "$pristine" "$machine"
  for file in /etc/resolv.conf /etc/hosts; do
    if [ -f "$file" ]; then
      cp -L "$file" "$machine$file"
    fi
  done
  git clone --quiet --no-hardlinks "$root" "$machine/inkcell"
  mkdir -p "$work/ccache" "$machine/ccache"
  begun=$(date +%s)
  take_processor
  begun_processor=$processor
  verdict=ok
  in_namespace sh -euc '
    machine=$1 ccache=$2 script=$3
    mount -t proc proc "$machine/proc"
    mount -t sysfs -o ro sysfs "$machine/sys"
    mkdir -p "$machine/dev/pts" "$machine/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=666 devpts "$machine/dev/pts"
    mount -t tmpfs tmpfs "$machine/dev/shm"
    mount --bind "$ccache" "$machine/ccache"
    set --
    for name in http_proxy https_proxy ftp_proxy all_proxy no_proxy \
      HTTP_PROXY HTTPS_PROXY FTP_PROXY ALL_PROXY NO_PROXY; do
      eval "value=\${$name-}"
      [ -z "$value" ] || set -- "$@" "$name=$value"
    done
    exec env -i "$@" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      HOME=/root CCACHE_DIR=/ccache \
      chroot "$machine" sh -c "cd /inkcell && exec sh $script"
  ' machine "$machine" "$work/ccache" "$2" >"$work/$name.log" 2>&1 ||
    verdict=FAILED
  take_processor
  printf '%-8s%-42s%4d s (%d s)\n' $verdict "$2" $(($(date +%s) - begun)) \
    $((processor - begun_processor))
  remove "$work/$name"
  left=$machine/inkcell/build/$name
  [ $name != all ] || left=$machine/inkcell/build/tests
  if [ -d "$left" ]; then
    cp -a "$left" "$work/$name"
  fi
  if [ $verdict = ok ]; then
    tail -n 1 "$work/$name.log" | sed 's/^/    /'
    remove "$machine"
  else
    failed=yes
    grep -a '^FAILED' "$work/$name.log" | sed 's/^/    /' || true
    tail -n 40 "$work/$name.log" | sed 's/^/    /'
    echo "    All it said is in build/bare/$name.log, the machine in" \
      "build/bare/machine-$name"
  fi
}

if [ -n "$fresh" ]; then
  remove "$pristine"
  remove "$work/ccache"
  rm -f "$work/pristine.mirrors"
fi
places=$(mirrors)
if [ -z "$places" ]; then
  apt-get -qq update
  places=$(mirrors)
fi
if [ "$places" != "$(cat "$work/pristine.mirrors" 2>/dev/null)" ]; then
  rm -f "$work/pristine.mirrors"
  make_pristine
fi

changed=$(git status --porcelain | wc -l)
if [ "$changed" != 0 ]; then
  echo "HEAD is tested, without the changes of $changed files"
fi
failed=
for name in ${wanted:-demo page tests all}; do
  case $name in
    demo) on_machine demo host_tools/demo.sh ;;
    page) on_machine page "host_tools/playground/build.sh build/page" ;;
    tests) on_machine tests tests/run.sh ;;
    all) on_machine all "tests/run.sh --all" ;;
  esac
done
[ -z "$failed" ]
