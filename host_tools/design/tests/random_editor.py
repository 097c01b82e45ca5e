"""Does random things in inkcell-editor: scripts of `try` lines, which the seed
repeats. A crash and a journal that cannot be recovered are faults.

Usage: random_editor.py INKCELL_EDITOR [--seed N] [--seconds S] [--keep FOLDER]
"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
LINES = 200       # of a script
SHOTS = 2         # pictures of the window among them, on average
CHARS = "A,a,H,O,0xE9"
# A PNG of two pixels, black and grey.
PICTURE = ("iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAAAAADRSSBWAAAAC0lEQVR4nGNg"
           "OAEAAMsAyWnIw2wAAAAASUVORK5CYII=")
KEYS = ("escape delete s ctrl+a ctrl+x ctrl+c ctrl+v ctrl+d ctrl+z ctrl+y "
        "ctrl+s ctrl+shift+a g shift+g pagedown pageup 0 = - d c shift+l left "
        "shift+up ctrl+right v p e r o b l ctrl+u").split()
ACTIONS = ("Unite", "Subtract", "Intersect", "Exclude", "Convert to cubics",
           "Reverse contours", "Revert", "Turn left", "Reflect left and right",
           "Align top", "Distribute across")
TOOLS = "Select Pen Knife Rectangle Ellipse Stroke Measure Spacing".split()
COMMANDS = (
    {"do": "add_component", "base": "A"}, {"do": "add_component", "base": "O"},
    {"do": "decompose"}, {"do": "round_points"},
    {"do": "set_advance", "width": 700},
    {"do": "delete_glyph", "glyph": "O"},
    {"do": "add_glyph", "glyph": "O", "width": 900, "unicodes": [79]},
    {"do": "rename_glyph", "glyph": "A", "to": "Q"},
    {"do": "add_anchor", "name": "top", "x": 300, "y": 1200},
    {"do": "add_guideline", "x": 10, "y": 20, "angle": 30},
    {"do": "set_guideline", "guideline": 0, "y": 500},
    {"do": "transform", "matrix": {"turn": 90}},
    {"do": "set_bearings", "left": 40, "right": -9},
    {"do": "transform", "matrix": {"slant": 12}, "about": "middle"},
    {"do": "set_image"}, {"do": "set_image", "file": "p.png"},
    {"do": "set_image", "file": "p.png", "data": PICTURE,
     "matrix": {"scale": [900, -500], "turn": 30, "move": [100, 200]}})


class Script:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def place(self):
        if self.random.random() < 0.02:
            return self.random.choice(["1e9 1e9", "-1e9 3", "0 -1e12"])
        return (f"{self.random.randint(-300, 1600)} "
                f"{self.random.randint(-600, 1900)}")

    def words(self):
        return "".join(f" {word}" for word in ("shift", "alt", "free", "twice")
                       if self.random.random() < 0.15)

    def pointer(self):
        """A press, some moves, and mostly a release."""
        yield f"press {self.place()}{self.words()}"
        for _ in range(self.random.randint(0, 5)):
            yield f"move {self.place()}{self.words()}"
        if self.random.random() < 0.9:
            yield f"release {self.place()}"

    def near(self):
        """A drag that begins at a point."""
        yield (f"drag {self.random.randint(0, 40)} "
               f"{self.random.randint(-90, 90)} {self.random.randint(-90, 90)}"
               f"{self.words()}")

    def choice(self):
        pick = self.random.random()
        if pick < 0.35:
            yield from self.pointer()
        elif pick < 0.45:
            yield from self.near()
        elif pick < 0.75:
            yield f"key {self.random.choice(KEYS)}"
        elif pick < 0.82:
            yield f"tool {self.random.choice(TOOLS)}"
        elif pick < 0.84:
            yield f"action {self.random.choice(ACTIONS)}"
        elif pick < 0.9:
            yield f"do {json.dumps(self.random.choice(COMMANDS))}"
        elif pick < 0.95:
            yield "select " + " ".join(
                str(self.random.randint(0, 30)) for _ in range(3))
        else:
            yield f"glyph {self.random.choice(['A', 'a', 'H', 'O', 'Q'])}"

    def lines(self, folder):
        yield f"open {FONT} P.ufo {CHARS}"
        count = 0
        while count < LINES:
            for line in self.choice():
                yield f"try {line}"
                count += 1
                if self.random.random() < SHOTS / LINES:
                    yield f"screenshot {folder}/shot.ppm"
        yield "print" if self.random.random() < 0.2 else "cells off"


def run(program, folder, lines):
    script = folder / "script.txt"
    script.write_text("\n".join(lines) + "\n")
    return subprocess.run([program, "--script", script], cwd=folder, text=True,
                          capture_output=True, check=False)


def fault(program, seed, folder):
    """What is wrong with the script of a seed."""
    done = run(program, folder, list(Script(seed).lines(folder)))
    # `print` may say that a random glyph cannot be a font's.
    if done.returncode not in (0, 1) or "Sanitizer" in done.stderr or \
            "runtime error" in done.stderr:
        return f"ended with {done.returncode}: {done.stderr[-3000:]}"
    done = run(program, folder, ["open P.ufo"])
    if done.returncode != 0:
        return f"cannot be opened again: {done.stderr[-1000:]}"
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=0,
                        help="go on with the next seeds so long [one seed]")
    parser.add_argument("--keep", type=pathlib.Path,
                        help="where scripts that failed are kept")
    options = parser.parse_args()
    end = time.monotonic() + options.seconds
    seed = options.seed
    faults = 0
    while True:
        with tempfile.TemporaryDirectory() as name:
            wrong = fault(options.program.resolve(), seed, pathlib.Path(name))
            if wrong:
                faults += 1
                print(f"seed {seed} {wrong}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    text = (pathlib.Path(name) / "script.txt").read_text()
                    (options.keep / f"{seed}.txt").write_text(text)
        seed += 1
        if time.monotonic() >= end:
            break
    print(f"{seed - options.seed} scripts, {faults} faults")
    sys.exit(1 if faults else 0)


main()
