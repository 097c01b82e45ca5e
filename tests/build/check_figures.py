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
    ("docs/DESIGN.md", r"From (\d+) px on fitting of grey text fades",
     "core/include/inkcell/fit.hpp", r"kFades = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"of grey text fades, to nothing at (\d+) px",
     "core/include/inkcell/fit.hpp", r"kEnds = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"spans of at most (\d+) coverages",
     "core/include/inkcell/strip.hpp", r"kMaxSpan = (\d+)"),
    ("docs/DESIGN.md", r"Only one below (\d+) sums is refused",
     "core/field/include/inkcell/field/splat.hpp", r"kMinSplatSums = (\d+)"),
    ("docs/DESIGN.md", r"Sizes (\d+) to 1024 px/em",
     "core/include/inkcell/style.hpp", r"kMinSize = Q26_6::from_int\((\d+)\)"),
    ("docs/DESIGN.md", r"Sizes 4 to (\d+) px/em",
     "core/include/inkcell/style.hpp", r"kMaxSize = Q26_6::from_int\((\d+)\)"),
    ("README.md", r"of 8 to (\d+) px that stands still",
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


def measured(bench):
    """What documents say of BENCHMARKS.md: document, words, figures."""
    o2 = "DejaVuSans, -O2:"

    def glyph(engine, px, core="Cortex-M3"):
        return bench.number("Instructions", f"{core}, {engine}", f"{px} px",
                            title=o2)

    def font(coding):
        return bench.number("Fonts and RAM", coding, "DejaVuSans") / 1000

    def least(column, title="Outlines only"):
        return bench.number("The smallest builds", "Cortex-M0", column,
                            title=title) / 1000

    def outline(row):
        return bench.number("The codings", row, "outline")

    def os_glyph(engine):
        return [bench.number("Instructions", f"Cortex-M3, {engine}", f"{px} px",
                             title="DejaVuSans, -Os:") for px in (12, 24, 48)]

    def rom(engine):
        return bench.number("Fonts and RAM", engine, "DejaVuSans")

    # FreeType's code, and what it needs of the C library.
    names, *lines = bench.table("Code")
    row = next(line for line in lines if line[0] == "Cortex-M3, -Os")
    freetype = sum(map(int, row[names.index("FreeType")].split(" + ")))
    inkcell = bench.number("The smallest builds", "Cortex-M3", "glyphs",
                           title="Outlines only")
    # The bytes of a cache stand behind what a glyph costs.
    names, *lines = bench.table("More", "Glyphs that a cache")
    row = next(line for line in lines
               if line[0] == "Cortex-M3, -O2, DejaVuSans, outline")
    cached = int(row[names.index("12 px")].split(", ")[2]) / 1000
    # LVGL's font of a size, and what its glyphs take.
    def lvgl(px, column):
        return bench.number("In LVGL", f"lv_font_conv, compressed, {px} px",
                            column, title="Glyphs by themselves")

    lvgl_fonts = [lvgl(px, "font") for px in (12, 24, 48)]

    def label(name, column):
        return bench.number("In LVGL", name, column, title="A label of")

    def digit(name, column):
        return bench.number("In LVGL", f"Inkcell, {name}, -O2", column,
                            title="A digit of") / 1000

    def held_over_lvgl(px):
        names, *lines = bench.table("In LVGL", "Glyphs: metrics")
        first = [line[0] for line in lines].index(
            "lv_font_conv, compressed, -Os")
        return float(lines[first + 1][names.index(f"{px} px")])

    stacks = [outline("stack without lent RAM, Cortex-M3, bytes") / 1000,
              outline("stack, Cortex-M3, bytes") / 1000]
    return [
        ("README.md", r"\| Inkcell, outlines, filter `text` \| (\d+) \| (\d+), any "
         r"size, kerning, hints \| (\d+); (\d+); (\d+) \| (\d+) \+ 0 \+ (\d+) "
         r"\| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|",
         [inkcell, rom("outline"), *3 * [inkcell + rom("outline")],
          bench.number("Stack", "Cortex-M3, -Os", "outline"),
          bench.number("Fonts and RAM", "outline", "workspace"),
          *os_glyph("outline")]),
        ("README.md", r"\| FreeType 2.12.1, unhinted \| (\d+) \| (\d+), any size "
         r"\| (\d+); (\d+); (\d+) \| (\d+) \+ (\d+) \+ 0 "
         r"\| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|",
         [freetype, rom("FreeType"), *3 * [freetype + rom("FreeType")],
          bench.number("Stack", "Cortex-M3, -Os", "FreeType"),
          bench.number("Fonts and RAM", "FreeType", "heap"),
          *os_glyph("FreeType")]),
        ("README.md", r"\| LVGL 9.5.0, 4-bit bitmaps, compressed, light "
         r"autohint \| (\d+) \| (\d+) at 12 px, (\d+) at 24, (\d+) at 48 "
         r"\| (\d+) at 12 px; (\d+); none \| (\d+) \+ (\d+) \+ 0 "
         r"\| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|",
         [lvgl(12, "code"), *lvgl_fonts, lvgl(12, "code") + lvgl_fonts[0],
          lvgl(12, "code") + sum(lvgl_fonts), lvgl(48, "stack"),
          lvgl(48, "heap"),
          *(lvgl(px, "thousand instructions") for px in (12, 24, 48))]),
        ("README.md", r"takes ([\d.]+) times LVGL's instructions at 12 px and "
         r"([\d.]+) times at 24",
         [held_over_lvgl(12), held_over_lvgl(24)]),
        ("docs/PORTING.md", r"a digit of 512 px/em then takes ([\d.]+) KB of "
         r"stack and no heap; as a bitmap, (\d+) KB of heap",
         [digit("direct", "stack"), digit("as bitmaps", "heap")]),
        ("docs/PORTING.md", r"of 14 px takes (\d+) thousand instructions from "
         r"the second drawing on, and (\d+) without a cache; with bitmaps of "
         r"lv_font_conv (\d+), compressed, and (\d+), raw",
         [label(f"{name}, -O2", "14 px, later") for name in
          ("Inkcell, direct and cached", "Inkcell, direct",
           "lv_font_conv, compressed", "lv_font_conv, raw")]),
        ("README.md", r"([\d.]+) KB of stack, or ([\d.]+) KB of stack and "
         r"([\d.]+) KB that you lend",
         stacks + [outline("RAM lent, bytes") / 1024]),
        ("docs/PORTING.md", r"nothing lent, the default \| ([\d.]+) KB \|.*?"
         r"multiple of 4 \| ([\d.]+) KB", stacks),
        ("README.md", r"\| code of glyphs alone \| ([\d.]+) KB on Cortex-M0 at "
         r"-Os for one pixel format and outlines, and ([\d.]+) of libgcc",
         [least("glyphs"), least("libgcc")]),
        ("docs/PORTING.md", r"distance takes ([\d.]+) KB, and ([\d.]+) of "
         r"libgcc; ([\d.]+) KB with lines",
         [least("glyphs"), least("libgcc"), least("all formats")]),
        ("README.md", r"kerning and hints: ([\d.]+) KB; as a field (\d+) KB",
         [font("outline"), font("field")]),
        ("docs/DESIGN.md", r"\| outlines \| (\d+) \| (\d+) \|",
         [rom("outline"), bench.number("Fonts and RAM", "outline",
                                       "LiberationSerif-Regular")]),
        *(("README.md", rf"\| {core} at (\d+) MHz \| ([\d.]+) ms "
           r"\| ([\d.]+) ms \| ([\d.]+) ms \|",
           [mhz, *(20 * glyph("outline, area", px, core) / mhz
                   for px in (12, 24, 48))])
          for core, mhz in (("Cortex-M0", 48), ("Cortex-M3", 100),
                            ("RV32IMC", 160))),
        ("docs/PORTING.md", r"ASCII characters at 12 px into ([\d.]+) KB",
         [cached]),
        ("docs/CHANGELOG.md", r"([\d.]+) KB of code on Cortex-M0 at -Os",
         [least("glyphs")]),
        ("docs/CHANGELOG.md", r"([\d.]+) KB of outlines, (\d+) KB as a field",
         [font("outline"), font("field")]),
    ]


def check_offsets():
    """Where FORMAT.md places numbers, and where format.hpp does."""
    form = (ROOT / "docs/FORMAT.md").read_text()
    source = (ROOT / "core/include/inkcell/format/rom.hpp").read_text()
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
