"""Fonts of releases, one of each version of the format, which never change: the
library opens and verifies those that it says it reads, and refuses the others.

Usage: test_released.py DUMP_CELLS FONT...
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFUSED = 3  # of dump_cells


def main():
    dump, *fonts = sys.argv[1:]
    header = (ROOT / "core/include/inkcell/version.hpp").read_text()
    major, minor = (int(re.search(rf"kFormat{part} = (\d+);", header).group(1))
                    for part in ("Major", "Minor"))
    failed = 0
    for font in map(pathlib.Path, fonts):
        of_font = tuple(map(int, font.stem.split(".")))
        read = of_font == (major, minor) or (
            of_font[0] == major > 0 and of_font[1] <= minor)
        done = subprocess.run([dump, font], text=True, stdout=subprocess.PIPE)
        # It dumps what it verified; cells are there in fields only.
        if (bool(done.stdout), done.returncode == REFUSED) == (read, not read):
            continue
        failed += 1
        print(f"{font.name}: by version.hpp format {major}.{minor} "
              f"{'reads' if read else 'refuses'} it; dump_cells ended with "
              f"{done.returncode}")
    print(f"{len(fonts) - failed} passed, {failed} failed")
    sys.exit(failed != 0 or not fonts)


main()
