#!/bin/sh
# Runs qemu_run.sh with semihosting off: the firmware must find no arguments,
# say so, and stay alive (it cannot exit), instead of stopping at a trap.
set -u
output=$(INKCELL_QEMU_FLAGS="-semihosting-config enable=off" timeout 3 "$@")
code=$?
echo "$output"
if [ $code -ne 124 ]; then
  echo "exit code $code, not stopped by the time limit"
  exit 1
fi
case $output in
  *"no arguments"*) ;;
  *) echo "the firmware did not come to its end" && exit 1 ;;
esac
