#!/usr/bin/env python3
"""Writes a PNG of what a program shows on an emulated board.

    shoot.py BOARD FIRMWARE.elf OUT.png [SECONDS]

Waits so many seconds, by default 2, after QEMU's start. INKCELL_QEMU_FLAGS has more
options for QEMU, such as the device of a display.
"""
import os
import sys
import tempfile
import time

import screens


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    board, program, out = sys.argv[1:4]
    seconds = float(sys.argv[4]) if len(sys.argv) == 5 else 2

    def wait(process):
        time.sleep(seconds)
        if process.poll() is not None:
            raise screens.Failure(
                f"QEMU ended with {process.returncode}: "
                f"{process.stdout.read().decode(errors='replace')}\nmain() must not "
                "return; what it returns is the exit code")

    with tempfile.TemporaryDirectory(prefix="inkcell") as folder:
        try:
            picture, _ = screens.run_and_shoot(
                [board, program], os.environ.get("INKCELL_QEMU_FLAGS", ""), wait,
                folder)
        except screens.Failure as failure:
            sys.exit(f"{program}: {failure}")
    picture.save_png(out)


main()
