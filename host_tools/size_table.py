#!/usr/bin/env python3
"""Prints fonts of one face side by side: bytes, points or cells, errors.

    size_table.py FOLDER NAME...

For each name: FOLDER/NAME.json, the report of inkcell-fontgen, and
FOLDER/NAME_accuracy.json, the table of inkcell-accuracy.
"""

import json
import pathlib
import sys


def column(folder, name):
    """What the table says of one font."""
    made = json.loads((folder / f"{name}.json").read_text())
    judged = json.loads((folder / f"{name}_accuracy.json").read_text())
    total = next(row for row in judged["rows"] if "px" not in row)
    size = made["bytes"]
    return {
        "": made["coding"],
        "font file, bytes": size["total"],
        "of these for glyphs": size["glyphs"],
        "bytes a glyph": round(size["glyphs"] / made["glyphs"]),
        "points": made["point_count"],
        "cells": made["cell_count"],
        "worst pixel, 1/255": f"{total['max']:.1f}",
        "mean, 1/255": f"{total['mean']:.2f}",
    }


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.split("\n\n")[1])
    columns = [column(pathlib.Path(sys.argv[1]), name) for name in sys.argv[2:]]
    widths = [max(len(str(value)) for value in each.values())
              for each in columns]
    for title in columns[0]:
        print("  ".join([f"{title:<28}"] + [
            f"{each[title]:>{width}}" for each, width in zip(columns, widths)
        ]).rstrip())


if __name__ == "__main__":
    main()
