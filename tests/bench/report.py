"""What the bench measured, as tables and as docs/BENCHMARKS.md."""
import subprocess
import sys

import fingerprint
import peers

ROW = ("{:5}{:4}{:26}{:10}{:9}{:>4}{:>9}{:>9}{:>7}{:>7}{:>6}{:>7}{:>7}{:>8}"
       "{:>7}")

CORES = {"m0": "Cortex-M0", "m3": "Cortex-M3", "m4": "Cortex-M4",
         "m4f": "Cortex-M4, FPU", "m7": "Cortex-M7", "m33": "Cortex-M33",
         "rv32": "RV32IMC"}
# Ways of firmware/inkcell_modes.cpp: what the document calls them, and what
# each is compared with, in the same pixel format.
MODES = {
    "plain": ("plain", "plain"),
    "fitted": ("fitted to the grid", "plain"),
    "fitted_stems": ("fitted, stems too", "plain"),
    "outline": ("outline, 1 px", "plain"),
    "outline_and_fill": ("outline and fill", "plain"),
    "crisp_1_bit": ("crisp, 1 bit", "plain"),
    "crisp_2_bits": ("crisp, 2 bits", "plain"),
    "perceptual": ("darker edges and hairlines", "plain"),
    "motion_blur_3_px": ("motion blur, 3 px", "plain"),
    "adaptive_even": ("up to 13 samples, even rule", "plain"),
    "adaptive_paper": ("up to 13 samples, the paper's rule", "plain"),
    "plain_rgb888": ("plain, RGB888", "plain_rgb888"),
    "lcd": ("sub-pixels, RGB888", "plain_rgb888"),
    "lcd_vertical": ("sub-pixels on each other, RGB888", "plain_rgb888"),
}
# Ways of firmware/inkcell_cells.cpp.
SLANTED = {"turned": "Turned by 15 degrees", "leaning": "Leaning by 1/5, which "
           "takes a matrix"}
ENGINES = {"freetype": "FreeType", "stb": "stb_truetype"}

HEAD = """\
# Benchmarks

What one glyph costs, beside FreeType and stb_truetype. Written by
`{command}`; not by hand. It describes this core:

{lines}

## How it was measured

- 95 printable ASCII characters, each drawn once. Counted is everything from the
  code point to 8-bit coverage, look-up included, without a cache. Inkcell
  draws into strips of 16 rows, as many as the glyph needs; the others render
  once, and the bitmap that they make counts as output.
- Instructions, not cycles, under {qemu}: the same on every run.
  A loop of known length is counted first.
- One compiler, and one set of flags: the core's name and the level of
  optimisation; no attributes on single functions. Of the Cortex-M4s one
  computes with its floating-point unit (FPU). The other engines are compiled as
  hosted C and have the compiler's C library (newlib, picolibc), because they
  are written for one. Cortex-M0 code runs on the board of the Cortex-M3.
- *edges*, *samples*: the same characters for 8 to 64 px, tolerance 16/255, with
  kerning, in each coding.
- FreeType {freetype}, as released: smooth rasterizer, TrueType and sfnt
  modules, no hinting, no bitmaps. stb_truetype {stb}, as it comes. Both read
  the same face with these 95 glyphs, without hinting and kerning. They have a
  heap of first fit, which takes a few instructions a call.
- All drew the same: Inkcell's pictures are equal on all cores, and the sum of
  coverage differs by less than 3 % between engines from 24 px on.
"""


def say(text):
    print(text, file=sys.stderr, flush=True)


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
                       r.get("coding", ""), r["px"], r["instructions_mean"],
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
    name = result.get("coding") or ENGINES[result["engine"]]
    return CORES[result["cpu"]], name


def thousands(instructions):
    count = instructions / 1000
    return f"{count:.1f}" if count < 100 else f"{count:.0f}"


def ratio_tables(results):
    """FreeType's instructions over Inkcell's."""
    freetype = freetype_counts(results)
    text = ("## FreeType over Inkcell\n\nFreeType's instructions for the mean "
            "glyph divided by Inkcell's: above 1, Inkcell is\nfaster.\n\n")
    for opt in unique(r["opt"] for r in results):
        for font in unique(r["font"] for r in results):
            some = [r for r in results if r["opt"] == opt and
                    r["font"] == font and r["engine"] == "inkcell"]
            sizes = unique(r["px"] for r in some)
            rows = []
            for name in unique(kind(r) for r in some):
                means = {r["px"]: freetype[r["cpu"], opt, font, r["px"]] /
                         r["instructions_mean"]
                         for r in some if kind(r) == name}
                rows.append([", ".join(name)] +
                            [f"{means[px]:.2f}" for px in sizes])
            text += f"{font}, -{opt}:\n\n"
            text += table(["core, coding"] + [f"{px} px" for px in sizes], rows)
    return text


def count_tables(results):
    """Instructions of the mean and the worst glyph."""
    text = ("## Instructions\n\nThousands of instructions for the mean glyph "
            "(the worst one).\n\n")
    for opt in unique(r["opt"] for r in results):
        for font in unique(r["font"] for r in results):
            some = [r for r in results if r["opt"] == opt and
                    r["font"] == font]
            sizes = unique(r["px"] for r in some)
            rows = []
            for name in unique(kind(r) for r in some):
                cells = {r["px"]: f"{thousands(r['instructions_mean'])} "
                         f"({thousands(r['instructions_max'])})"
                         for r in some if kind(r) == name}
                rows.append([", ".join(name)] + [cells[px] for px in sizes])
            text += f"{font}, -{opt}:\n\n"
            text += table(["core, engine"] + [f"{px} px" for px in sizes], rows)
    return text


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


def code_table(results, figures):
    """Bytes that engines and programs take."""
    rows = []
    for f in figures:
        if f["figure"] != "code":
            continue
        row = [f"{CORES[f['cpu']]}, -{f['opt']}"]
        row += [f[name] for name in ("glyphs", "text", "turned",
                                     "all_formats", "libraries")]
        for engine in ENGINES:
            own, more = next((r["code"], r["libraries"]) for r in results
                             if r["engine"] == engine and
                             (r["cpu"], r["opt"]) == (f["cpu"], f["opt"]))
            row.append(f"{own} + {more}")
        rows.append(row)
    return ("## Code\n\nBytes of `.text` and `.rodata` that programs keep of "
            "Inkcell: upright glyphs of cells into 8-bit\ncoverage; lines of "
            "text too; any angle too; every pixel format too. What the first "
            "needs of\nlibgcc is apart. Of the others, and + what they need "
            "of libgcc and the C library.\n\n" +
            table(["core", "glyphs", "text", "turned", "all formats",
                   "libgcc", *ENGINES.values()], rows))


def bound_table(figures):
    """What no glyph exceeds."""
    some = [f for f in figures if f["figure"] == "bound"]
    sizes = unique(f["px"] for f in some)
    rows = []
    for cpu, opt in unique((f["cpu"], f["opt"]) for f in some):
        cells = {f["px"]: f"{f['per_pixel']}, {f['stack']}" for f in some
                 if (f["cpu"], f["opt"]) == (cpu, opt)}
        rows.append([f"{CORES[cpu]}, -{opt}"] + [cells[px] for px in sizes])
    return ("## Bounds\n\nUpright glyphs of edges, trees of depth 8: "
            "instructions a pixel of the dearest glyph that bytes can\n"
            "describe, and bytes of stack.\n\n" +
            table([""] + [f"{px} px" for px in sizes], rows))


def sized_table(figures, name, title, cell):
    """A table with a row for each core, optimisation and font."""
    some = [f for f in figures if f["figure"] == name]
    sizes = unique(f["px"] for f in some)
    rows = []
    for about in unique((f["cpu"], f["opt"], f["font"]) for f in some):
        cells = {f["px"]: cell(f) for f in some
                 if (f["cpu"], f["opt"], f["font"]) == about}
        rows.append([f"{CORES[about[0]]}, -{about[1]}, {about[2]}"] +
                    [cells[px] for px in sizes])
    return f"{title}\n\n" + table([""] + [f"{px} px" for px in sizes], rows)


def smallest_tables(results, figures):
    """What a build costs that leaves out what is there for speed."""
    fonts = unique(r["font"] for r in results)
    text = ("## The smallest build\n\n`INKCELL_SAMPLE_CELLS`, "
            "`INKCELL_OBJECT_ORDER` and `INKCELL_FAST_ROWS` off (PORTING.md), "
            "-Os.\nPictures are the same. Bytes of code, as above; and of "
            "stack, for the deepest upright glyph and turned\none, "
            "and for `draw` of a line of text into RGB565:\n\n")
    rows = []
    for f in figures:
        if f["figure"] == "code":
            stack = [max(r["stack"] for r in results
                         if r["cpu"] == f["cpu"])]
            stack += [max(r["stack"] for r in figures
                          if r["cpu"] == f["cpu"] and r["figure"] == figure)
                      for figure in ("turned", "run")]
            rows.append([CORES[f["cpu"]]] + [f[name] for name in (
                "glyphs", "text", "turned", "all_formats",
                "libraries")] + stack)
    text += table(["core", "glyphs", "text", "turned", "all formats",
                   "libgcc", "stack, upright", "stack, turned",
                   "stack, a line"], rows)
    text += f"{fonts[0]}, thousands of instructions for the mean glyph:\n\n"
    some = [r for r in results if r["font"] == fonts[0]]
    sizes = unique(r["px"] for r in some)
    rows = []
    for name in unique(kind(r) for r in some):
        means = {r["px"]: r["instructions_mean"] for r in some
                 if kind(r) == name}
        rows.append([", ".join(name)] + [thousands(means[px]) for px in sizes])
    for cpu in unique(f["cpu"] for f in figures):
        means = {f["px"]: f["instructions_mean"] for f in figures
                 if f["figure"] == "turned" and f["cpu"] == cpu and
                 f["font"] == fonts[0]}
        rows.append([f"{CORES[cpu]}, turned"] +
                    [thousands(means[px]) for px in sizes])
    return text + table(["core, coding"] + [f"{px} px" for px in sizes], rows)


def mode_table(figures):
    """What glyphs cost that look otherwise."""
    text = ("## Modes\n\nFonts of edges: thousands of instructions for the mean "
            "glyph, and how many times a plain one into\nthe same format; "
            "bytes of stack for the deepest. Another filter (weight, gamma, "
            "shadow, glow) is as\nfast as plain, but for the pixels that it "
            "reaches beyond.\n\n")
    some = [f for f in figures if f["figure"] == "mode"]
    for font in unique(f["font"] for f in some):
        mine = [f for f in some if f["font"] == font]
        columns = unique((f["cpu"], f["opt"], f["px"]) for f in mine)
        rows = []
        for mode in unique(f["mode"] for f in mine):
            cells = {(f["cpu"], f["opt"], f["px"]):
                     f"{thousands(f['instructions_mean'])}, "
                     f"{f['over_plain']:.2f}"
                     for f in mine if f["mode"] == mode}
            stack = max(f["stack"] for f in mine if f["mode"] == mode)
            rows.append([MODES[mode][0], *(cells[c] for c in columns), stack])
        text += f"{font}:\n\n" + table(
            ["", *(f"{CORES[cpu]}, -{opt}, {px} px"
                   for cpu, opt, px in columns), "stack"], rows)
    return text


def other_tables(figures):
    """What is not a glyph by itself."""
    text = "## More\n\nFonts of edges.\n\n"
    text += ("Slanted text: thousands of instructions a glyph, and how many "
             "times upright text.\n\n")
    for way, name in SLANTED.items():
        text += sized_table(
            figures, way, name + ":",
            lambda f: f"{thousands(f['instructions_mean'])}, "
            f"{f['over_upright']:.2f}")
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


def write_document(results, figures, smallest, sources):
    """docs/BENCHMARKS.md from all results."""
    qemu = subprocess.run(["qemu-system-arm", "--version"], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    qemu = qemu.splitlines()[0].replace("emulator version ", "").split(" (")[0]
    head = HEAD.format(
        command=fingerprint.COMMAND, lines="\n".join(fingerprint.lines()),
        qemu=qemu, freetype=peers.freetype_version(sources["freetype"]),
        stb=peers.stb_version(sources["stb"]))
    text = "\n".join([head, ratio_tables(results) + count_tables(results) +
                      stack_table(results) + memory_table(results) +
                      code_table(results, figures) +
                      smallest_tables(*smallest) + mode_table(figures) +
                      bound_table(figures) + other_tables(figures)])
    fingerprint.DOCUMENT.write_text(text.rstrip() + "\n", encoding="utf-8")
    say(f"wrote {fingerprint.DOCUMENT}")
