#!/bin/sh
# Runs qemu_run.sh with semihosting off: the firmware must find no arguments,
# report that, and keep running (it cannot exit) instead of stopping at a trap.
set -u
output=$(mktemp)
INKCELL_QEMU_FLAGS="-semihosting-config enable=off" "$@" </dev/null \
  >"$output" 2>&1 &
emulator=$!
tries=0
until grep -q "no arguments" "$output" || [ $tries -ge 300 ]; do
  sleep 0.1
  tries=$((tries + 1))
done
sleep 0.3
if kill "$emulator" 2>/dev/null; then alive=yes; else alive=no; fi
wait "$emulator" 2>/dev/null
cat "$output"
grep -q "no arguments" "$output"
finished=$?
rm -f "$output"
if [ $finished -ne 0 ]; then
  echo "the firmware did not come to its end"
  exit 1
fi
if [ $alive = no ]; then
  echo "the emulator ended by itself"
  exit 1
fi
