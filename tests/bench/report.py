"""What the bench measured, as tables and as docs/BENCHMARKS.md."""
import re
import subprocess

import peers
from figures import DOCS
from peers import say

DOCUMENT = DOCS / "BENCHMARKS.md"
COMMAND = "sh tests/bench/run.sh --write-docs"
ROW = ("{:5}{:4}{:26}{:10}{:14}{:>4}{:>9}{:>9}{:>7}{:>7}{:>6}{:>7}{:>7}{:>8}"
       "{:>7}")

CORES = {"m0": "Cortex-M0", "m3": "Cortex-M3", "m4": "Cortex-M4",
         "m4f": "Cortex-M4, FPU", "m7": "Cortex-M7", "m33": "Cortex-M33",
         "rv32": "RV32IMC"}
ALL = ("outline", "field")
CELLS = ("field",)
OUTLINES = ("outline",)
# Ways of firmware/inkcell_modes.cpp: what the document calls them, what each is
# compared with, in the same pixel format, and the codings that have it. Shadows
# and glows of cells need fonts with a wider band.
MODES = {
    "plain": ("plain", "plain", ALL),
    "fitted": ("fitted to the grid", "plain", ALL),
    "fitted_stems": ("fitted, stems too", "plain", ALL),
    "bold": ("weight, 1/4 px", "plain", ALL),
    "outline": ("outline, 1 px", "plain", ALL),
    "outline_and_fill": ("outline and fill", "plain", ALL),
    "shadow_2_px": ("shadow, 2 px", "plain", OUTLINES),
    "glow_4_px": ("glow, 4 px", "plain", OUTLINES),
    "bilevel_1_bit": ("bilevel, 1 bit", "plain", ALL),
    "bilevel_2_bits": ("bilevel, 2 bits", "plain", ALL),
    "perceptual": ("darker edges and hairlines", "plain", ALL),
    "motion_blur_3_px": ("motion blur, 3 px", "plain", ALL),
    "adaptive_even": ("supersampling, even rule", "plain", ALL),
    "adaptive_area": ("supersampling of exact area", "plain", OUTLINES),
    "adaptive_paper": ("supersampling, the paper's rule", "plain", CELLS),
    "plain_rgb888": ("plain, RGB888", "plain_rgb888", ALL),
    "lcd": ("sub-pixels, RGB888", "plain_rgb888", ALL),
    "lcd_vertical": ("sub-pixels on each other, RGB888", "plain_rgb888", ALL),
}
# Ways of firmware/inkcell_cells.cpp and inkcell_outline.cpp: title, what each is
# compared with, codings that have it.
SLANTED = {
    "turned": ("Turned by 15 degrees", "upright", ALL),
    "leaning": ("Leaning by 1/5, which takes a matrix", "upright", ALL),
    "area_turned": ("Turned by 15 degrees, by area", "area", OUTLINES),
}
# Rows of inkcell_outline.cpp, compared with points that are decoded once.
MEMORY = {
    "strips": "Lent RAM, but points decoded anew for each strip",
    "stack": "No lent RAM: a band on the stack",
}
# Rows of inkcell_cache.cpp: what is held, and a bitmap font of the pictures.
CACHE = ("cached", "bitmap")
# Rows of inkcell_strike.cpp, by font and coding.
STRIKE_WAYS = {
    "alone": "strikes alone",
    "both": "strikes beside outlines",
    "outline": "those outlines, 2,560 B lent",
}
# What codings can do; measured figures stand above it.
ABILITIES = [
    ["any size, position and matrix; kerning", "yes", "yes"],
    ["grid fitting", "yes", "no"],
    ["filters, weight, gamma, sub-pixels, outlines, 1 and 2 bits", "yes",
     "yes"],
    ["exact area", "yes", "no"],
    ["shadow and glow", "to 4 px", "as far as `BAND_PX`"],
    ["supersampling, motion blur, darker edges and hairlines", "yes", "yes"],
    ["the field at any point: queries, 13 samples by the paper's rule, splats",
     "no", "yes"],
]
ENGINES = {"freetype": "FreeType", "stb": "stb_truetype"}

HEAD = """\
# Benchmarks

What one glyph costs, beside FreeType and stb_truetype, and in LVGL. Written by
`{command}`, by night; not by hand. Measured at commit
{commit}, with {compiler}.

## How it was measured

- 95 printable ASCII characters, each drawn once. Counted is everything from the
  code point to 8-bit coverage, look-up included, without a cache. Inkcell
  draws into strips of 16 rows, as many as the glyph needs; the others render
  once, and the bitmap that they make counts as output.
- *outline* draws by exact area, which a style does unless another filter is asked
  for, *outline, text* by distance, both with 2,560 bytes of lent RAM: points are
  decoded once for all strips. *field* draws by distance.
- Instructions, not cycles, under {qemu}: the same on every run.
  A loop of known length is counted first.
- One compiler, and one set of flags: the core's name and the level of
  optimisation; no attributes on single functions. Of the Cortex-M4s one
  computes with its floating-point unit (FPU). The other engines are compiled as
  hosted C and have the compiler's C library (newlib, picolibc), because they
  are written for one. Cortex-M0 code runs on the board of the Cortex-M3.
- *outline*, *field*: the same characters for 8 to 64 px, tolerance 16/255, with
  kerning and hints, in each coding.
- FreeType {freetype}, as released: smooth rasterizer, TrueType and sfnt
  modules, no hinting, no bitmaps. stb_truetype {stb}, as it comes. Both read
  the same face with these 95 glyphs, without hinting and kerning. They have a
  heap of first fit, which takes a few instructions a call.
- All drew the same: each coding's pictures are equal on all cores, and the sum of
  coverage differs by less than 3 % between engines from 24 px on.
"""


def coding_of(result):
    """The coding, and the filter if it is not the default."""
    by_distance = result["coding"] == "outline" and result["way"] != "area"
    return result["coding"] + (", text" if by_distance else "")


def freetype_counts(results):
    """FreeType's instructions by core, optimisation, font and size."""
    return {(r["cpu"], r["opt"], r["font"], r["px"]): r["instructions_mean"]
            for r in results if r["engine"] == "freetype"}


def print_table(results):
    """One row a result; the last column is FreeType's instructions over it."""
    say(ROW.format("cpu", "opt", "font", "engine", "coding", "px", "mean",
                   "worst", "stack", "heap", "ram", "lent", "code", "font",
                   "ratio"))
    freetype = freetype_counts(results)
    for r in results:
        other = freetype.get((r["cpu"], r["opt"], r["font"], r["px"]))
        ratio = f"{other / r['instructions_mean']:.2f}" if other else ""
        say(ROW.format(r["cpu"], r["opt"], r["font"][:25], r["engine"],
                       coding_of(r) if "coding" in r else "", r["px"], r["instructions_mean"],
                       r["instructions_max"], r["stack"], r["heap"],
                       r["static_ram"], r.get("workspace", ""), r["code"],
                       r["font_bytes"], ratio))


def print_others(figures):
    """A table for each kind of figure, its first column the kind."""
    for kind_of in unique(figure["figure"] for figure in figures):
        rows = [f for f in figures if f["figure"] == kind_of]
        lines = [list(rows[0]), *(list(map(str, row.values()))
                                  for row in rows)]
        lines[0][0] = ""
        widths = [max(map(len, column)) for column in zip(*lines)]
        for line in lines:
            say("  ".join(word.ljust(width) for word, width
                          in zip(line, widths)).rstrip())


def table(head, rows):
    """A table of the document; all columns but the first are numbers."""
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "".join("| " + " | ".join(str(word) for word in line) + " |\n"
                   for line in lines) + "\n"


def unique(values):
    return list(dict.fromkeys(values))


def kind(result):
    """The row that a result belongs to: core, and engine or coding."""
    name = (coding_of(result) if "coding" in result
            else ENGINES[result["engine"]])
    return CORES[result["cpu"]], name


def thousands(instructions):
    count = instructions / 1000
    return f"{count:.1f}" if count < 100 else f"{count:.0f}"


def glyph_tables(results, title, head, cell):
    """A table for each level of optimisation and font, its columns sizes."""
    text = title + "\n\n"
    for opt in unique(r["opt"] for r in results):
        for font in unique(r["font"] for r in results):
            some = [r for r in results if r["opt"] == opt and
                    r["font"] == font]
            sizes = unique(r["px"] for r in some)
            rows = []
            for name in unique(kind(r) for r in some):
                cells = {r["px"]: cell(r) for r in some if kind(r) == name}
                rows.append([", ".join(name)] + [cells[px] for px in sizes])
            text += f"{font}, -{opt}:\n\n"
            text += table([head] + [f"{px} px" for px in sizes], rows)
    return text


def ratio_tables(results):
    """FreeType's instructions over Inkcell's."""
    freetype = freetype_counts(results)

    def ratio(r):
        other = freetype[r["cpu"], r["opt"], r["font"], r["px"]]
        return f"{other / r['instructions_mean']:.2f}"

    return glyph_tables(
        [r for r in results if r["engine"] == "inkcell"],
        "## FreeType over Inkcell\n\nFreeType's instructions for the mean "
        "glyph divided by Inkcell's: above 1, Inkcell is\nfaster.",
        "core, coding", ratio)


def count_tables(results):
    """Instructions of the mean and the worst glyph."""
    return glyph_tables(
        results, "## Instructions\n\nThousands of instructions for the mean "
        "glyph (the worst one).", "core, engine",
        lambda r: f"{thousands(r['instructions_mean'])} "
                  f"({thousands(r['instructions_max'])})")


def stack_table(results):
    """The deepest glyph of all sizes and fonts."""
    rows = []
    names = unique(kind(r)[1] for r in results)
    for cpu, opt in unique((r["cpu"], r["opt"]) for r in results):
        def most(name, limit):
            return max((r["stack"] for r in results
                        if (r["cpu"], r["opt"]) == (cpu, opt) and
                        kind(r)[1] == name and r["px"] <= limit), default="")
        rows.append([f"{CORES[cpu]}, -{opt}"] +
                    [f"{most(name, 48)}, {most(name, 1024)}"
                     for name in names])
    return ("## Stack\n\nBytes for the deepest glyph, to 48 px and at all "
            "sizes; painted before, measured after.\nMost of FreeType's is a "
            "pool of 16 KB; builds with a smaller one are slower.\n\n" +
            table(["core", *names], rows))


def codings_table(results, figures, smallest):
    """The codings side by side."""
    names = unique(r["coding"] for r in results if r.get("coding") in ALL)
    first = results[0]["font"]

    def of(coding, cpu, way="upright", field="instructions_mean"):
        return {r["px"]: r[field] for r in results
                if (r.get("coding"), r["cpu"], r["opt"], r["font"]) ==
                (coding, cpu, "O2", first) and r["way"] == way}

    def most(coding, field):
        return max(r[field] for r in results
                   if r.get("coding") == coding and r["cpu"] == "m3" and
                   r["opt"] == "O2")

    rows = [[f"font, {font}, bytes"] +
            [next(r["font_bytes"] for r in results
                  if r.get("coding") == name and r["font"] == font)
             for name in names]
            for font in unique(r["font"] for r in results)]
    sizes = [px for px in unique(r["px"] for r in results)
             if px in (12, 24, 48, 96)]
    for cpu in ("m0", "m3"):
        for px in sizes:
            cells = []
            for name in names:
                area = of(name, cpu, "area").get(px)
                text = thousands(of(name, cpu)[px])
                cells.append(f"{thousands(area)}, text {text}" if area else text)
            rows.append([f"thousand instructions, {CORES[cpu]}, {px} px",
                         *cells])
    for way in ("turned", "leaning"):
        some = {f["coding"]: f["over_upright"] for f in figures
                if f["figure"] == way and
                (f["cpu"], f["opt"], f["font"], f["px"]) ==
                ("m3", "O2", first, 24)}
        rows.append([f"{way}, over upright, Cortex-M3, 24 px"] +
                    [f"{some[name]:.2f}" if name in some else ""
                     for name in names])
    rows.append(["stack, Cortex-M3, bytes"] +
                [most(name, "stack") for name in names])
    rows.append(["RAM lent, bytes"] +
                [most(name, "workspace") for name in names])
    rows.append(["stack without lent RAM, Cortex-M3, bytes"] +
                [max((f["stack"] for f in figures
                      if (f["figure"], f["cpu"], f["opt"]) ==
                      ("stack", "m3", "O2") and f["coding"] == name),
                     default=most(name, "stack")) for name in names])
    kept = {coding: next(f["glyphs"] for f in more
                         if f["figure"] == "code" and f["cpu"] == "m0")
            for coding, (_, more) in smallest.items()}
    rows.append(["code for glyphs, smallest build, Cortex-M0, bytes"] +
                [kept.get(name, "") for name in names])
    rows += ABILITIES
    return (f"## The codings\n\n{first}, -O2, unless a row says "
            "otherwise. All rows are taken from the tables that follow.\n\n" +
            table(["", *names], rows))


def memory_table(results):
    """What engines take of RAM and fonts, on any core."""
    fonts = unique(r["font"] for r in results)
    rows = []
    for name in unique(kind(r)[1] for r in results):
        mine = [r for r in results if kind(r)[1] == name]
        sizes = {r["font"]: r["font_bytes"] for r in mine}
        rows.append([name] + [sizes[font] for font in fonts] +
                    [max(r.get(field, 0) for r in mine)
                     for field in ("workspace", "heap", "static_ram")])
    return ("## Fonts and RAM\n\nBytes, the most of all sizes, fonts and "
            "cores. The workspace is lent by the caller. Heap is\nwhat was "
            "asked for, without the allocator's own, and holds FreeType's "
            "bitmap.\n\n" +
            table(["", *fonts, "workspace", "heap", "static RAM"], rows))


KEPT_TEXT = """\
Bytes of `.text` and `.rodata` that programs keep of Inkcell: upright glyphs into
8-bit coverage by distance; the same by area; by distance with lines of text; with
any matrix too; with both filters and every pixel format too."""
KEPT_HEAD = ["glyphs", "by area", "text", "any matrix", "all formats", "libgcc"]
KEPT = ("glyphs", "area", "text", "matrix", "all_formats", "libraries")


def code_table(results, figures):
    """Bytes that engines and programs take."""
    rows = []
    for f in figures:
        if f["figure"] != "code":
            continue
        row = [f"{CORES[f['cpu']]}, -{f['opt']}"]
        row += [f[name] for name in KEPT]
        for engine in ENGINES:
            own, more = next((r["code"], r["libraries"]) for r in results
                             if r["engine"] == engine and
                             (r["cpu"], r["opt"]) == (f["cpu"], f["opt"]))
            row.append(f"{own} + {more}")
        rows.append(row)
    return (f"## Code\n\n{KEPT_TEXT} Their fonts are of\noutlines. What the "
            "first program needs of libgcc is apart. Of the others, and + what "
            "they need of\nlibgcc and the C library.\n\n" +
            table(["core", *KEPT_HEAD, *ENGINES.values()], rows))


def sized_table(figures, name, title, cell,
                keys=("cpu", "opt", "font", "coding")):
    """A table with a row for each core, optimisation, font and coding."""
    some = [f for f in figures if f["figure"] == name]
    sizes = unique(f["px"] for f in some)
    rows = []
    for about in unique(tuple(f[key] for key in keys) for f in some):
        cells = {f["px"]: cell(f) for f in some
                 if tuple(f[key] for key in keys) == about}
        cpu, opt, *more = about
        rows.append([", ".join([CORES[cpu], f"-{opt}", *more])] +
                    [cells[px] for px in sizes])
    return f"{title}\n\n" + table([""] + [f"{px} px" for px in sizes], rows)


def bound_table(figures):
    """What no glyph exceeds."""
    return sized_table(
        figures, "bound", "## Bounds\n\nUpright glyphs of fields, trees of "
        "depth 8: instructions a pixel of the dearest glyph that bytes can\n"
        "describe, and bytes of stack.",
        lambda f: f"{f['per_pixel']}, {f['stack']}", ("cpu", "opt"))


SMALLEST_TEXT = {
    "outline": "Outlines only: a program that opens no other fonts, -Os.",
    "field": "Fields only: a program that opens no other fonts, -Os.",
}


def smallest_rows(results, figures):
    """Code and stack of each core."""
    for f in figures:
        if f["figure"] == "code":
            stack = [max(r["stack"] for r in results
                         if r["cpu"] == f["cpu"])]
            stack += [max(r["stack"] for r in figures
                          if r["cpu"] == f["cpu"] and r["figure"] == figure)
                      for figure in ("turned", "run")]
            yield [CORES[f["cpu"]]] + [f[name] for name in KEPT] + stack


def smallest_speed(results, figures):
    """Instructions of the first font."""
    font = results[0]["font"]
    some = [r for r in results if r["font"] == font]
    sizes = unique(r["px"] for r in some)
    rows = []
    for name in unique(kind(r) for r in some):
        means = {r["px"]: r["instructions_mean"] for r in some
                 if kind(r) == name}
        rows.append([", ".join(name)] + [thousands(means[px]) for px in sizes])
    for cpu in unique(f["cpu"] for f in figures):
        means = {f["px"]: f["instructions_mean"] for f in figures
                 if f["figure"] == "turned" and f["cpu"] == cpu and
                 f["font"] == font}
        rows.append([f"{CORES[cpu]}, turned"] +
                    [thousands(means[px]) for px in sizes])
    return table(["core, coding"] + [f"{px} px" for px in sizes], rows)


def smallest_tables(smallest):
    """What builds cost that can draw one coding only."""
    text = ("## The smallest builds\n\nBytes of code, as above; and of stack, "
            "for the deepest upright glyph and turned one, and for\n`draw` of "
            "a line of text into RGB565. Then thousands of instructions for "
            "the mean glyph of\nthe first font.\n\n")
    for coding, (results, figures) in smallest.items():
        text += SMALLEST_TEXT[coding] + "\n\n"
        text += table(["core, " + coding, *KEPT_HEAD, "stack, upright",
                       "stack, turned", "stack, a line"],
                      smallest_rows(results, figures))
        text += smallest_speed(results, figures)
    return text


def mode_table(figures):
    """What glyphs cost that look otherwise."""
    text = ("## Modes\n\nThousands of instructions for the mean glyph, and how "
            "many times a plain one into the same format;\nbytes of stack for "
            "the deepest.\n\n")
    some = [f for f in figures if f["figure"] == "mode"]
    for coding, font in unique((f["coding"], f["font"]) for f in some):
        mine = [f for f in some
                if (f["coding"], f["font"]) == (coding, font)]
        columns = unique((f["cpu"], f["opt"], f["px"]) for f in mine)
        rows = []
        for mode in unique(f["mode"] for f in mine):
            cells = {(f["cpu"], f["opt"], f["px"]):
                     f"{thousands(f['instructions_mean'])}, "
                     f"{f['over_plain']:.2f}"
                     for f in mine if f["mode"] == mode}
            stack = max(f["stack"] for f in mine if f["mode"] == mode)
            rows.append([MODES[mode][0], *(cells[c] for c in columns), stack])
        text += f"{font}, {coding}:\n\n" + table(
            ["", *(f"{CORES[cpu]}, -{opt}, {px} px"
                   for cpu, opt, px in columns), "stack"], rows)
    return text


def canvas_key(figure):
    """All of a line of text but the RAM that is lent."""
    return tuple(figure[name] for name in
                 ("cpu", "opt", "font", "language", "canvas", "px"))


def canvas_tables(figures):
    """A line of text into each canvas, with more and less RAM lent."""
    some = [f for f in figures if f["figure"] == "canvas"]
    text = ("## Canvases, and RAM that is lent\n\nThousands of instructions "
            "for a line of 13 characters, in one call, by the bytes of RAM "
            "that are lent;\nand the deepest stack of all sizes, in bytes, in "
            "C++ and in C. Pictures are the same.\n\n")
    for cpu, opt, font in unique((f["cpu"], f["opt"], f["font"])
                                 for f in some):
        mine = [f for f in some
                if (f["cpu"], f["opt"], f["font"]) == (cpu, opt, font)]
        sizes = unique(f["px"] for f in mine)
        rows = []
        for canvas, lent in unique((f["canvas"], f["lent"]) for f in mine):
            row = [f for f in mine
                   if (f["canvas"], f["lent"]) == (canvas, lent)]
            cells = {f["px"]: thousands(f["instructions"]) for f in row
                     if f["language"] == "C++"}
            stacks = [max(f["stack"] for f in row
                          if f["language"] == language)
                      for language in ("C++", "C")]
            rows.append([f"`{canvas}`, {lent}", *(cells[px] for px in sizes),
                         *stacks])
        text += f"{font}, {CORES[cpu]}, -{opt}:\n\n" + table(
            ["canvas, lent", *(f"{px} px" for px in sizes), "stack",
             "stack in C"], rows)
    return text


def other_tables(figures):
    """What is not a glyph by itself."""
    def ratio(figure):
        return (f"{thousands(figure['instructions_mean'])}, "
                f"{figure['over_upright']:.2f}")

    text = ("## More\n\nSlanted text: thousands of instructions a glyph, and "
            "how many times upright text.\n\n")
    for way, (title, _, _) in SLANTED.items():
        text += sized_table(figures, way, title + ":", ratio)
    text += ("Outlines with less RAM: the same figures, over 2,560 lent bytes "
             "and points that are decoded\nonce. Pictures are the same.\n\n")
    for way, title in MEMORY.items():
        text += sized_table(figures, way, title + ":", ratio)
    text += sized_table(
        figures, "cache", "Glyphs that a cache of 4 bits holds, all 95 of "
        "them: thousands of instructions, how many times what a\nbitmap of 4 "
        "bits a pixel takes, and the bytes of the cache:",
        lambda f: f"{thousands(f['instructions_mean'])}, "
                  f"{f['over_bitmap']:.2f}, {f['ram']}")
    for bits, canvas in ((1, "1 bit, into pages of a display"),
                         (4, "4 bits, into 8-bit coverage")):
        some = [{**f, "way": STRIKE_WAYS[f["way"]]} for f in figures
                if f["figure"] == "strike" and f["bits"] == bits]
        text += sized_table(
            some, "strike", f"Strikes of {canvas}, and the outlines that they "
            "are pictures of: thousands of\ninstructions, and bytes of stack:",
            lambda f: f"{thousands(f['instructions_mean'])}, {f['stack']}",
            ("cpu", "opt", "font", "way"))
    text += sized_table(
        figures, "digits", "The ten digits: instructions for each pixel of the "
        "box of the ink:", lambda f: f["per_pixel"])
    text += sized_table(
        figures, "run", "`draw` of \"Hello, 12:34\" into strips of RGB565, 640 "
        "x 16: thousands of instructions for all\nstrips, and bytes of stack:",
        lambda f: f"{thousands(f['instructions'])}, {f['stack']}")
    rows = [[f"{CORES[f['cpu']]}, -{f['opt']}", f["per_partly_covered"],
             f["per_solid"], f["call_coverage"], f["call_solid"]]
            for f in figures if f["figure"] == "blend"]
    text += ("The sink for RGB565 by itself, instructions: for one more pixel, "
             "and for the call.\n\n")
    return text + table(["", "partly covered", "solid", "call of coverage",
                         "call of solid"], rows)


def chapter_of(heading):
    """A chapter as the document has it, which another program writes, or this
    one with LVGL."""
    found = re.search(rf"^## {heading}\n.*?\n(?=## |\Z)",
                      DOCUMENT.read_text(encoding="utf-8"),
                      re.DOTALL | re.MULTILINE)
    return found.group() if found else ""


def first_line(*command):
    """Of what a program says."""
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True,
                          cwd=DOCS).stdout.splitlines()[0]


def write_document(results, figures, smallest, sources, lvgl):
    """docs/BENCHMARKS.md from all results; `lvgl`: its last chapter, if it was
    measured."""
    qemu = first_line("qemu-system-arm", "--version")
    qemu = qemu.replace("emulator version ", "").split(" (")[0]
    head = HEAD.format(
        command=COMMAND, commit=first_line("git", "rev-parse", "--short", "HEAD"),
        compiler=first_line("arm-none-eabi-g++", "--version"),
        qemu=qemu, freetype=peers.freetype_version(sources["freetype"]),
        stb=peers.stb_version(sources["stb"]))
    text = "\n".join([head, codings_table(results, figures, smallest) +
                      ratio_tables(results) + count_tables(results) +
                      stack_table(results) + memory_table(results) +
                      code_table(results, figures) +
                      smallest_tables(smallest) + mode_table(figures) +
                      bound_table(figures) + canvas_tables(figures) +
                      other_tables(figures) +
                      chapter_of("Faces") + (lvgl or chapter_of("In LVGL"))])
    DOCUMENT.write_text(text.rstrip() + "\n", encoding="utf-8")
    say(f"wrote {DOCUMENT}")
