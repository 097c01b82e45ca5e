"""Checks that the tables of core/layout/src and the character sets of the
generator are what their scripts make, that those of a part of Unicode are within their limit, and that the marks of
core/src/text/blank.cpp are those of Unicode, each in the blocks that it names.

Usage: check_unicode.py WORK_FOLDER
"""
import pathlib
import re
import sys
import unicodedata

from toolchains import ROOT, finish, run
from limits import LIMITS

LAYOUT = ROOT / "core/layout/src"

# Tables, and bytes of what a part makes of its own besides: the pairs of
# classes of line_break.cpp.
TABLES = {"line_tables.cpp": 31 * 4, "bidi_tables.cpp": 0}

SETS = "east_asian_sets.cpp"

# Blocks whose combining marks text knows.
MARK_BLOCKS = [(0x300, 0x36f), (0x400, 0x4ff), (0x590, 0x5ff), (0x600, 0x6ff),
               (0xe00, 0xe7f), (0x1ab0, 0x1aef), (0x1dc0, 0x1dff),
               (0x20d0, 0x20ff), (0x2de0, 0x2dff), (0x3000, 0x30ff),
               (0xfe20, 0xfe2f)]


def problems_of_marks():
    text = (ROOT / "core/src/text/blank.cpp").read_text()
    known = set()
    for first, more in re.findall(r"\{0x(\w+), (\d+), Shown::mark\}", text):
        known.update(range(int(first, 16), int(first, 16) + int(more) + 1))
    wrong = [code for code in known
             if unicodedata.category(chr(code)) not in ("Mn", "Me", "Cn")]
    absent = [code for first, last in MARK_BLOCKS
              for code in range(first, last + 1)
              if unicodedata.category(chr(code)) in ("Mn", "Me")
              and code not in known]
    print(f"{len(known)} code points are marks")
    return ([f"blank.cpp: U+{code:04X} is no mark" for code in wrong] +
            [f"blank.cpp: the mark U+{code:04X} is not listed"
             for code in absent])


def problems_of_sets(work):
    made = run([sys.executable, "-B",
                ROOT / "host_tools/unicode/make_char_sets.py", work])
    source = ROOT / "fonts_gen/src/source" / SETS
    same = made.returncode == 0 and (work / SETS).read_text() == source.read_text()
    return [] if same else [f"{source} is not what make_char_sets.py makes: "
                            f"{made.stdout}"]


def main():
    work = pathlib.Path(sys.argv[1])
    made = run([sys.executable, "-B", ROOT / "host_tools/unicode/make_tables.py",
                work])
    print(made.stdout, end="")
    if made.returncode != 0:
        finish(0, [made.stdout])
    problems = problems_of_marks() + problems_of_sets(work)
    for name, more in TABLES.items():
        text = (work / name).read_text()
        if text != (LAYOUT / name).read_text():
            problems.append(f"core/layout/src/{name} is not what "
                            "host_tools/unicode/make_tables.py makes")
        size = int(re.search(r"^// (\d+) bytes", text, re.M).group(1)) + more
        most = LIMITS["tables"]["Unicode, each"]
        if size > most:
            problems.append(f"{name}: {size} bytes, at most {most} "
                            "(tests/limits.json)")
    finish(len(TABLES), problems)


main()
