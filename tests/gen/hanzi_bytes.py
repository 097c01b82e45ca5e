#!/usr/bin/env python3
"""Bytes a hanzi: fonts of characters of GB 2312 level 1, evenly spread.

    hanzi_bytes.py FONTGEN [--count N] [--check]

Prints what a hanzi takes in each part of the font. Parts of the font that all
characters share, such as the tables of code words, are spread over the N
characters. With --check it fails where a hanzi takes more than its limit.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

NOTO = Path("/usr/share/fonts/opentype/noto")
SANS = NOTO / "NotoSansCJK-Regular.ttc"
SERIF = NOTO / "NotoSerifCJK-Regular.ttc"
SIMPLIFIED_CHINESE = "2"  # the face in the collection
SMALL = ["--min-px", "12", "--max-px", "32", "--tolerance", "24/255"]
# Name, file, options, most bytes a hanzi.
ROWS = [
    ("sans, 8 to 64 px, 16/255", SANS, [], 162),
    ("sans, 12 to 32 px, 24/255", SANS, SMALL, 152),
    ("serif, 8 to 64 px, 16/255", SERIF, [], None),
    ("serif, 12 to 32 px, 24/255", SERIF, SMALL, None),
]
PARTS = ("glyphs", "hints", "metrics", "cmap")


def level_1():
    """The 3,755 characters, in the order of the standard."""
    codes = [bytes((row, cell)) for row in range(0xb0, 0xd8)
             for cell in range(0xa1, 0xff) if (row, cell) <= (0xd7, 0xf9)]
    return [code.decode("gb2312") for code in codes]


def sample(count):
    characters = level_1()
    return "".join(characters[i * len(characters) // count]
                   for i in range(count))


def measure(fontgen, folder, font, options, characters):
    """Bytes of the whole font, and of its parts."""
    report = Path(folder) / "report.json"
    subprocess.run(
        [fontgen, "--font", font, "--face", SIMPLIFIED_CHINESE, "--symbols",
         characters, "--no-layout-glyphs", *options, "--quiet", "--report",
         report, "--out", Path(folder) / "font.bin"], check=True)
    return json.loads(report.read_text())["bytes"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("fontgen")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    characters = sample(arguments.count)
    print(f"{'bytes a hanzi':28}{'whole':>8}" +
          "".join(f"{part:>9}" for part in PARTS))
    too_many = []
    with tempfile.TemporaryDirectory() as folder:
        for name, font, options, limit in ROWS:
            if arguments.check and limit is None:
                continue
            size = measure(arguments.fontgen, folder, font, options,
                           characters)
            total = size["total"] / arguments.count
            print(f"{name:28}{total:8.1f}" + "".join(
                f"{size[part] / arguments.count:9.1f}" for part in PARTS))
            if limit is not None and total > limit:
                too_many.append(f"{name}: {total:.1f} bytes a hanzi; "
                                f"{limit} are allowed")
    if arguments.check and too_many:
        sys.exit("\n".join(too_many))


if __name__ == "__main__":
    main()
