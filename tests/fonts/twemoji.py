#!/usr/bin/env python3
"""Makes a font of all of Twemoji's drawings, and tells what it takes.

    twemoji.py FONTGEN FOLDER [--every N]

npm fetches the drawings into FOLDER, once; twemoji.bin, twemoji.json and the
list of code points are left there. A sequence gets a code point from U+F0000
on. Drawings that the generator refuses are left out, and told.
"""
import argparse
import json
import pathlib
import re
import subprocess
import time

PACKAGE = "@twemoji/svg@15.0.0"
FIRST_SEQUENCE = 0xF0000


def fetch(folder):
    """The folder of the drawings."""
    drawings = folder / "package"
    if not drawings.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        name = subprocess.run(["npm", "pack", "--silent", PACKAGE], cwd=folder,
                              check=True, capture_output=True,
                              text=True).stdout.split()[-1]
        subprocess.run(["tar", "xzf", name], cwd=folder, check=True)
    return drawings


def code_points(names):
    codes = {}
    following = FIRST_SEQUENCE
    for name in names:
        if "-" in name:
            codes[name] = following
            following += 1
        else:
            codes[name] = int(name, 16)
    return codes


def make(fontgen, drawings, codes, out):
    """The font, and what was refused: a reason for each name."""
    refused = {}
    while True:
        (drawings / "codepoints").write_text("".join(
            f"{name} {code:X}\n" for name, code in codes.items()
            if name not in refused))
        done = subprocess.run(
            [fontgen, "--svg-dir", drawings, "--colour", "--min-px", "16",
             "--max-px", "64", "--out", out, "--report",
             out.with_suffix(".json")], capture_output=True, text=True)
        if done.returncode == 0:
            return refused
        reason = done.stderr.strip().splitlines()[-1]
        found = re.search(r"([0-9a-f-]+)\.svg: (.*)", reason)
        if found is None:
            raise SystemExit(done.stderr)
        refused[found[1]] = found[2]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("fontgen")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    arguments = parser.parse_args()
    drawings = fetch(arguments.folder)
    names = sorted(file.stem for file in drawings.glob("*.svg"))
    codes = dict(list(code_points(names).items())[::arguments.every])
    out = arguments.folder / "twemoji.bin"
    begin = time.monotonic()
    refused = make(arguments.fontgen, drawings, codes, out)
    seconds = time.monotonic() - begin
    report = json.loads(out.with_suffix(".json").read_text())
    count = len(codes) - len(refused)
    layers = report["layers"]
    print(f"{count} of {len(codes)} drawings, {layers['outlines']} outlines, "
          f"{layers['colours']} colours, {seconds:.0f} s")
    for part, size in report["bytes"].items():
        print(f"  {part:10} {size:8} bytes {size / count:7.1f} a drawing")
    forms = sum(size for name, size in report["bytes_per_glyph"].items()
                if not name.startswith("layer of "))
    print(f"  forms of one colour, of these {forms / count:.1f} a drawing")
    for name, reason in refused.items():
        print(f"refused {name}.svg: {reason}")


if __name__ == "__main__":
    main()
