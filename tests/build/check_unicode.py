"""Checks that the tables of core/src/layout are what their script makes, and
that those of a part of Unicode take no more than 2 KB.

Usage: check_unicode.py WORK_FOLDER
"""
import pathlib
import re
import sys

from toolchains import ROOT, finish, run

LAYOUT = ROOT / "core/src/layout"
MOST_BYTES = 2048

# Tables, and bytes of what a part makes of its own besides: the pairs of
# classes of line_break.cpp.
TABLES = {"line_tables.cpp": 31 * 4, "bidi_tables.cpp": 0}


def main():
    work = pathlib.Path(sys.argv[1])
    made = run([sys.executable, "-B", ROOT / "host_tools/unicode/make_tables.py",
                work])
    print(made.stdout, end="")
    if made.returncode != 0:
        finish(0, [made.stdout])
    problems = []
    for name, more in TABLES.items():
        text = (work / name).read_text()
        if text != (LAYOUT / name).read_text():
            problems.append(f"core/src/layout/{name} is not what "
                            "host_tools/unicode/make_tables.py makes")
        size = int(re.search(r"^// (\d+) bytes", text, re.M).group(1)) + more
        if size > MOST_BYTES:
            problems.append(f"{name}: {size} bytes, {MOST_BYTES} are allowed")
    finish(len(TABLES), problems)


main()
