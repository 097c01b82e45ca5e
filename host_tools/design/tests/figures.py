"""Prints what EDITING.md promises: must, aim, measured, verdict.

Usage: figures.py BUILD [--quick] [--fonts FILE...]

BUILD is the build folder of the studio, with inkcell-design and tests/. With
--quick few characters, strokes and masters, in less than a minute; without it
ASCII of five faces and 100,000 strokes of about 8 ms each. --fonts names other
faces than the five and measures the round trip only. Exits with 1 if a figure
misses its 'must'.

A new row is an entry of other_rows(): quantity, must, aim, unit, and a function
of Bench that measures it.
"""
import argparse
import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from typing import Callable, NamedTuple

FONTS = pathlib.Path("/usr/share/fonts/truetype")
SANS = FONTS / "dejavu/DejaVuSans.ttf"
FACES = (
    SANS,
    FONTS / "liberation/LiberationSerif-Regular.ttf",
    FONTS / "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    FONTS / "dejavu/DejaVuSansMono-Oblique.ttf",
    FONTS / "liberation/LiberationSerif-Italic.ttf",
)
TEN = "aegSB8RKQ&"
ROM_TOLERANCE = 38  # offset in the header of a font (docs/FORMAT.md)


class Row(NamedTuple):
    quantity: str
    must: float
    aim: float
    unit: str
    measure: Callable
    is_least: bool = False  # must and aim are least values, not largest ones


class Bench:
    """Runs the programs of a build, each measurement once."""

    def __init__(self, build, is_quick, faces):
        self.tests = build / "tests"
        self.design = build / "inkcell-design"
        self.is_quick = is_quick
        self.faces = faces

    @functools.lru_cache(maxsize=None)
    def roundtrip(self, font, symbols=None):
        """The report of a face: ASCII, or these characters."""
        with tempfile.TemporaryDirectory() as name:
            report = pathlib.Path(name) / "report.json"
            command = [self.design, "roundtrip", "--font", font, "--quiet",
                       "--report", report]
            if symbols:
                command += ["--symbols", symbols]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            return json.loads(report.read_text())

    def reports(self):
        return [self.roundtrip(face, "a&" if self.is_quick else None)
                for face in self.faces]

    def worst(self, key):
        return max(report[key] for report in self.reports())

    def total(self, key):
        return sum(report[key] for report in self.reports())

    def worst_milliseconds(self):
        return max(glyph["milliseconds"] for report in self.reports()
                   for glyph in report["glyphs"].values())

    @functools.lru_cache(maxsize=None)
    def strokes(self):
        count = "200" if self.is_quick else "100000"
        text = self.output("inkcell_stroke_figures", count)
        return numbers(r"worst ([\d.]+) u .*, (\d+) with open", text)

    @functools.lru_cache(maxsize=None)
    def curves(self, px_per_em, kind):
        """Curves of a master or a scan: worst and RMS [u], glyphs with a speck
        or without a contour, largest time [s]."""
        letters = "aB" if self.is_quick and kind != "scan" else TEN
        text = self.output("inkcell_bitmap_figures", SANS, letters,
                           str(px_per_em), kind)
        return numbers(r"curves ([\d.]+) u worst .*\), ([\d.]+) RMS, .* "
                       r"segments, (\d+) glyphs .*, ([\d.]+) s", text)

    @functools.lru_cache(maxsize=None)
    def hanzi(self, count, *settings):
        """A font of glyphs that hanzi.lua makes: bytes a glyph, and the worst
        pixel [1/255], or the tolerance if that is kept."""
        with tempfile.TemporaryDirectory() as name:
            project = pathlib.Path(name) / "Hanzi.ufo"
            rom = pathlib.Path(name) / "hanzi.bin"
            script = [self.design, "script",
                      pathlib.Path(__file__).with_name("hanzi.lua"),
                      "--out", project, "--set", f"count={count}"]
            for setting in settings:
                script += ["--set", setting]
            for command in (script, [self.design, "export", "--project",
                                     project, "--out", rom]):
                subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            data = rom.read_bytes()
            return len(data) / count, data[ROM_TOLERANCE]

    def rectangular_hanzi(self):
        return self.hanzi(20 if self.is_quick else 500, "rectangle=1",
                          "angle=0")

    def elliptic_hanzi(self):
        return self.hanzi(100)

    def passes(self, name, test):
        """Whether a test passes; one that does not exist does not."""
        text = self.output(f"inkcell_test_design_{name}",
                           f"--gtest_filter={test}")
        return "[  PASSED  ] 1 test." in text

    def output(self, program, *arguments):
        """What a program prints, whatever it thinks of its figures."""
        return subprocess.run([self.tests / program, *arguments], text=True,
                              stdout=subprocess.PIPE, check=False).stdout


def numbers(pattern, text):
    found = re.search(pattern, text)
    if not found:
        sys.exit(f"error: no figures like '{pattern}' in: {text}")
    return [float(group) for group in found.groups()]


def roundtrip_rows():
    return [
        Row("round trip, worst", 1.5, 1.0, "u", lambda b: b.worst("worst_u")),
        Row("round trip, RMS", 0.5, 0.25, "u", lambda b: b.worst("rms_u")),
        Row("segments beside the faces' own", 1, 1, "",
            lambda b: b.total("segments") / b.total("source_segments")),
        Row("corners found", 99, 100, "%", lambda b: 100 *
            b.total("corners_found") / b.total("corners"), True),
        Row("false corners", 1, 0, "%", lambda b: 100 *
            b.total("corners_false") / b.total("corners")),
        Row("second round, worst", 0.5, 0.1, "u",
            lambda b: b.worst("second_round_u")),
        Row("field to curves, mean glyph", 100, 16, "ms",
            lambda b: b.worst("milliseconds_mean")),
        Row("field to curves, slowest glyph", 100, 16, "ms",
            lambda b: b.worst_milliseconds()),
    ]


def other_rows():
    return [
        Row(f"segments of {TEN} of DejaVu Sans", 252, 160, "",
            lambda b: b.roundtrip(SANS, TEN)["segments"]),
        Row("strokes against brute force", 0.25, 1 / 16, "u",
            lambda b: b.strokes()[0]),
        Row("strokes with open or missing contours", 0, 0, "",
            lambda b: b.strokes()[1]),
        Row("master 4096 px/em, 1 bit, worst", 0.5, 0.27, "u",
            lambda b: b.curves(4096, "bilevel")[0]),
        Row("master 4096 px/em, 1 bit, RMS", 0.1, 0.05, "u",
            lambda b: b.curves(4096, "bilevel")[1]),
        Row("master 4096 px/em, slowest", 2, 0.5, "s",
            lambda b: b.curves(4096, "bilevel")[3]),
        Row("master 1024 px/em, 8 bits, worst", 0.8, 0.3, "u",
            lambda b: b.curves(1024, "grey")[0]),
        Row("master 1024 px/em, 8 bits, RMS", 0.08, 0.05, "u",
            lambda b: b.curves(1024, "grey")[1]),
        Row("scan 200 px/em, RMS", 0.5, 0.25, "u",
            lambda b: b.curves(200, "scan")[1]),
        Row("scan 1200 px/em, worst", 1, 0.5, "u",
            lambda b: b.curves(1200, "scan")[0]),
        Row("scan 1200 px/em, RMS", 0.15, 0.1, "u",
            lambda b: b.curves(1200, "scan")[1]),
        Row("scans with a speck or without a contour", 0, 0, "",
            lambda b: b.curves(200, "scan")[2] + b.curves(1200, "scan")[2]),
        Row("hanzi of strokes, rectangular nib, a glyph", 200, 120, "bytes",
            lambda b: b.rectangular_hanzi()[0]),
        Row("hanzi of strokes, rectangular nib, worst pixel", 16, 16, "/255",
            lambda b: b.rectangular_hanzi()[1]),
    ]


def full_rows():
    """Rows without --quick; most are of tests that print no figure."""
    return [
        Row("hanzi of strokes, elliptic nib, a glyph", 200, 120, "bytes",
            lambda b: b.elliptic_hanzi()[0]),
        Row("hanzi of strokes, elliptic nib, worst pixel", 16, 16, "/255",
            lambda b: b.elliptic_hanzi()[1]),
        Row("unions of 2 to 6 parts while drawing, worst pixel", 32, 16, "/255",
            lambda b: numbers(r"worst pixel ([\d.]+) of 255", b.output(
                "inkcell_union_figures", "60"))[0]),
        Row("CSG true beyond 1/64 u from the edge", 1, 1, "",
            lambda b: b.passes("csg", "Csg.RandomTreesHaveTheirPointsOn"
                               "TheRightSide"), True),
        Row("100,000 commands undone and redone", 1, 1, "",
            lambda b: b.passes("journal", "Journal.HundredThousandCommands"
                               "UndoneAndRedone"), True),
        Row("journal cut at any byte recovers", 1, 1, "",
            lambda b: b.passes("journal", "Journal.CutAtAnyByteRecovers"
                               "TheWholeRecordsBefore"), True),
    ]


def verdict(row, measured):
    sign = -1 if row.is_least else 1
    for name, limit in (("aim", row.aim), ("must", row.must)):
        if sign * measured <= sign * limit:
            return name
    return "missed"


def print_table(rows, bench):
    print("| quantity | must | aim | measured | verdict |")
    print("|---|---|---|---|---|")
    missed = 0
    for row in rows:
        measured = row.measure(bench)
        result = verdict(row, measured)
        missed += result == "missed"
        values = [f"{value:.3g} {row.unit}".strip() for value in
                  (row.must, row.aim)]
        values.append("yes" if measured is True else
                      "no" if measured is False else
                      f"{measured:.4g} {row.unit}".strip())
        if isinstance(measured, bool):
            values[:2] = ["yes", "yes"]
        print(f"| {row.quantity} | {' | '.join(values)} | {result} |",
              flush=True)
    return missed


def print_faces(bench):
    print("| | worst | RMS | segments | the font's | corners found | false "
          "| 2nd round |")
    print("|---|---|---|---|---|---|---|---|")
    for face, r in zip(bench.faces, bench.reports()):
        print(f"| {face.stem} | {r['worst_u']:.2f} | {r['rms_u']:.2f} | "
              f"{r['segments']} | {r['source_segments']} | "
              f"{r['corners_found']} of {r['corners']} | "
              f"{r['corners_false']} | {r['second_round_u']:.2f} |")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--fonts", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    bench = Bench(arguments.build.resolve(), arguments.quick,
                  arguments.fonts or FACES)
    rows = roundtrip_rows()
    if not arguments.fonts:
        rows += other_rows()
        rows += [] if arguments.quick else full_rows()
    print_faces(bench)
    sys.exit(1 if print_table(rows, bench) else 0)


main()
