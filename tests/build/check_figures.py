"""Checks figures that documents repeat: of BENCHMARKS.md, and of the sources.

A figure may be rounded, to as many places as it is written with.

Usage: check_figures.py
"""
import re
import sys

from toolchains import ROOT, finish

# Constants that documents state: document, words around the figure, source,
# words around the constant.
CONSTANTS = [
    ("docs/DESIGN.md", r"in bands of (\d+) rows and",
     "core/src/leaf_band.hpp", r"kRows = (\d+)"),
    ("docs/DESIGN.md", r"in bands of 8 rows and (\d+) columns",
     "core/src/leaf_band.hpp", r"kColumns = (\d+)"),
    ("docs/DESIGN.md", r"height in the band make (\d+) px",
     "core/src/field_band.cpp", r"kMinReduced = (\d+)"),
    ("docs/DESIGN.md", r"and in object order from (\d+) px on",
     "core/src/render.cpp", r"kCellsFrom = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"From (\d+) px on the fit fades",
     "core/include/inkcell/fit.hpp", r"kFades = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"the fit fades, to nothing at (\d+) px",
     "core/include/inkcell/fit.hpp", r"kEnds = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"spans of at most (\d+) coverages",
     "core/include/inkcell/strip.hpp", r"kMaxSpan = (\d+)"),
    ("docs/DESIGN.md", r"Only one below (\d+) sums is refused",
     "core/include/inkcell/splat.hpp", r"kMinSplatSums = (\d+)"),
    ("docs/DESIGN.md", r"Sizes (\d+) to 1024 px/em",
     "core/include/inkcell/brush.hpp", r"kMinSize = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"Sizes 4 to (\d+) px/em",
     "core/include/inkcell/brush.hpp", r"kMaxSize = Q26_6::from_int\((\d+)\)"),
    ("README.md", r"text of 8 to (\d+) px that stands still",
     "core/include/inkcell/fit.hpp", r"kEnds = Q26_6::from_int\((\d+)\)"),
]


class Benchmarks:
    """The tables of docs/BENCHMARKS.md."""

    def __init__(self):
        self.text = (ROOT / "docs/BENCHMARKS.md").read_text()

    def table(self, section, title=""):
        """The cells of the first table below a heading and a title."""
        part = self.text[self.text.index(f"\n## {section}\n"):]
        part = part[part.index(f"\n{title}"):]
        lines = re.search(r"^\|.*?\n\n", part + "\n\n", re.M | re.S).group(0)
        return [[cell.strip() for cell in line.strip("|").split("|")]
                for line in lines.strip().split("\n")]

    def number(self, section, row, column, title=""):
        """The first number of a cell."""
        names, *lines = self.table(section, title)
        found = next(line for line in lines if line[0] == row)
        return float(re.match(r"[\d.]+", found[names.index(column)]).group(0))

    def stacks(self, engine):
        """Bytes at small sizes and at all of them, of each core."""
        names, _, *lines = self.table("Stack")
        return [[int(number) for number in line[names.index(engine)].split(",")]
                for line in lines]


def measured(bench):
    """What documents say of BENCHMARKS.md: document, words, figures."""
    o2, code = "DejaVuSans, -O2:", "Cortex-M3, -Os"

    def glyph(engine, px, core="Cortex-M3"):
        return bench.number("Instructions", f"{core}, {engine}", f"{px} px",
                            title=o2)

    def font(coding):
        return bench.number("Fonts and RAM", coding, "DejaVuSans") / 1000
    glyphs = bench.number("Code", code, "glyphs") / 1000

    def least(column):
        return bench.number("The smallest build", "Cortex-M0", column) / 1000
    most_stack = max(all_sizes for _, all_sizes in bench.stacks("edges"))
    return [
        ("README.md", r"([\d.]+) KB of stack, your strip",
         [most_stack / 1000]),
        ("README.md", r"\| code \| ([\d.]+) KB on Cortex-M3 at -Os", [glyphs]),
        ("README.md", r"([\d.]+) KB more for lines of text",
         [bench.number("Code", code, "text") / 1000 - glyphs]),
        ("README.md", r"with kerning: ([\d.]+) KB,", [font("edges")]),
        ("README.md", r"of samples ([\d]+) KB", [font("samples")]),
        ("README.md", r"([\d.]+) thousand instructions a glyph at 12 px on "
         r"Cortex-M3, ([\d.]+) at 48 px",
         [glyph("edges", 12), glyph("edges", 48)]),
        ("README.md", r"FreeType takes ([\d.]+) and ([\d.]+), in ([\d.]+) KB",
         [glyph("FreeType", 12), glyph("FreeType", 48),
          bench.number("Stack", "Cortex-M3, -O2", "FreeType") / 1000]),
        ("README.md", r"on Cortex-M0 ([\d.]+) and ([\d.]+), FreeType ([\d.]+) "
         r"and ([\d.]+)",
         [glyph(engine, px, "Cortex-M0") for engine in ("edges", "FreeType")
          for px in (12, 48)]),
        *[(document, words,
           [least(column) for column in (
               "glyphs", "libgcc", "all formats", "stack, upright",
               "stack, turned")])
          for document, words in [
              ("README.md", r"-Os: ([\d.]+) KB for one pixel format and "
               r"([\d.]+) of libgcc, ([\d.]+) KB with text, .*?; ([\d.]+) KB "
               r"of stack for a glyph, ([\d.]+) for a turned one"),
              ("docs/PORTING.md", r"into one format takes ([\d.]+) KB, and "
               r"([\d.]+) of libgcc; ([\d.]+) KB with lines .*?\. A glyph "
               r"takes ([\d.]+) KB of stack, a turned one ([\d.]+)")]],
        ("docs/DESIGN.md", r"a line of text into RGB565 takes ([\d]+) bytes",
         [1000 * least("stack, a line")]),
        ("docs/CHANGELOG.md", r"in pixel order, is ([\d.]+) KB on Cortex-M0",
         [least("all formats")]),
        ("docs/CHANGELOG.md", r"([\d.]+) KB of code on Cortex-M3 at -Os",
         [glyphs]),
        ("docs/CHANGELOG.md", r"([\d.]+) KB of edges, (\d+) KB of samples",
         [font("edges"), font("samples")]),
    ]


def check_offsets():
    """Where FORMAT.md places numbers, and where format.hpp does."""
    form = (ROOT / "docs/FORMAT.md").read_text()
    source = (ROOT / "core/include/inkcell/format.hpp").read_text()
    problems = []
    for heading, space, least in [("## Header", "header", 31),
                                  ("## Section directory", "section", 3)]:
        part = form[form.index(f"\n{heading}\n"):]
        rows = re.findall(r"^\| (\d+) \| (\d+) \|[^|]*\| (\w+) \|",
                          part[:part.index("\n#", 1)], re.M)
        body = re.search(rf"namespace {space} {{\n(.*?)\n}}", source,
                         re.S).group(1)
        if len(rows) < least:
            problems.append(f"docs/FORMAT.md: {heading}: {len(rows)} rows")
        end = 0
        for offset, size, name in rows:
            constant = "k" + name.title().replace("_", "")
            if not re.search(rf"\b{constant} = {offset};", body):
                problems.append(f"docs/FORMAT.md: {heading}: {name} is not at "
                                f"{space}::{constant}")
            if int(offset) != end:
                problems.append(f"docs/FORMAT.md: {heading}: {name} is not "
                                "behind what is before it")
            end = int(offset) + int(size)
        if not re.search(rf"\bkBytes = {end};", body):
            problems.append(f"docs/FORMAT.md: {heading}: not {end} bytes")
    return problems


def squeezed(document):
    return " ".join((ROOT / document).read_text().split())


def check(document, words, values):
    """Problems of one sentence."""
    found = re.search(words, squeezed(document))
    if found is None:
        return [f"{document}: nothing says {words}"]
    problems = []
    for said, value in zip(found.groups(), values):
        places = len(said.partition(".")[2])
        if abs(float(said) - value) > 0.5 * 10 ** -places + 1e-9:
            problems.append(f"{document}: {found.group(0)}: {said} is "
                            f"{value:.{places}f}")
    return problems


def main():
    problems = check_offsets()
    figures = measured(Benchmarks())
    for document, words, source, constant in CONSTANTS:
        found = re.search(constant, (ROOT / source).read_text())
        if found is None:
            problems.append(f"{source}: nothing says {constant}")
        else:
            figures.append((document, words, [float(found.group(1))]))
    for figure in figures:
        problems += check(*figure)
    finish(len(figures), problems)


sys.exit(main())
