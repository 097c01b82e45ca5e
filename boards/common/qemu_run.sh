#!/bin/sh
# Runs a firmware in QEMU and returns its exit code:
#
#     qemu_run.sh BOARD FIRMWARE.elf [ARGUMENT...]
#
# BOARD is a folder in boards/. Arguments, without blanks, reach main() by
# semihosting. The board's UART is standard output.
#
#   INKCELL_QEMU_FLAGS   more options for QEMU, e.g. "-device VGA,romfile="
#   INKCELL_QEMU_WINDOW  gtk or sdl: show the display in a window, in real time
#
# Without a window the virtual time is counted in instructions, so all runs are
# the same: an instruction takes 2^8 ns (counter.hpp relies on it), or 1 ns on
# RISC-V, whose counter needs no timer.
set -eu
if [ $# -lt 2 ]; then
  sed -n '2,11s/^# \{0,1\}//p' "$0" >&2
  exit 64
fi
board=$1
firmware=$2
shift 2

arguments="arg=$(basename "$firmware")"
for argument; do
  arguments="$arguments,arg=$(printf %s "$argument" | sed 's/,/,,/g')"
done

shift_log2=8
case $board in
  riscv_virt)
    set -- qemu-system-riscv32 -M virt -cpu lowrisc-ibex -bios none -m 32M \
      -vga none
    shift_log2=0
    ;;
  versatilepb)
    set -- qemu-system-arm -M versatilepb -m 32M -audiodev none,id=none
    ;;
  *)
    set -- qemu-system-arm -M "$(printf %s "$board" | tr _ -)"
    ;;
esac

if [ -n "${INKCELL_QEMU_WINDOW:-}" ]; then
  set -- "$@" -display "$INKCELL_QEMU_WINDOW"
else
  set -- "$@" -display none -icount "shift=$shift_log2,sleep=off"
fi

# shellcheck disable=SC2086  # flags are meant to be split
exec "$@" -monitor none -serial stdio \
  -semihosting-config "enable=on,target=native,$arguments" \
  ${INKCELL_QEMU_FLAGS:-} -kernel "$firmware"
