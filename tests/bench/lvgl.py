"""What labels and glyphs cost in LVGL: with fonts of lv_font_conv, and with
Inkcell's by way of port/lvgl. On Cortex-M3 only.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import limits
import report

CPUS = ("m3",)
# Sizes of labels, and the fonts of lv_font_conv. [px]
LABEL_SIZES = ("14", "28")
GLYPH_SIZES = ("12", "16", "24", "32", "48")
WAYS = {"raw": ["--no-compress"], "rle": []}
# By the number that firmware/lvgl/label.cpp knows; what the document calls them.
LABELS = {
    "blank": "",
    "raw": "lv_font_conv, raw",
    "rle": "lv_font_conv, compressed",
    "bitmap": "Inkcell, as bitmaps",
    "fitted": "Inkcell, as bitmaps, heights fitted",
    "direct": "Inkcell, direct",
    "cached": "Inkcell, direct and cached",
}
# Text, its row, width and height of the screen, rows of a strip.
LABEL = ("Kitchen-21.5", "4", "320", "40", "40")
DIGIT = ("0", "-60", "320", "480", "16")
DIGIT_SIZE = "512"
# LVGL's own code is that of the library, Inkcell's what it adds.
OWN_LIBRARIES = ("inkcell_core", "inkcell_cache", "inkcell_port_pixel",
                 "inkcell_port_lvgl", "gcc")
HELP = ("LVGL's sources: --lvgl FOLDER or INKCELL_LVGL_DIR; lv_font_conv, a "
        "program of npm: --lv-font-conv FILE, or in the path")


def find(arguments):
    """LVGL's sources and lv_font_conv, or None."""
    folder = arguments.lvgl or os.environ.get("INKCELL_LVGL_DIR")
    converter = arguments.lv_font_conv or shutil.which("lv_font_conv")
    if not folder or not converter:
        return None
    folder, converter = Path(folder).resolve(), Path(converter).resolve()
    for file in (folder / "lvgl.h", converter):
        if not file.exists():
            sys.exit(f"bench: there is no {file}")
    return folder, converter


def version(folder):
    text = (folder / "lv_version.h").read_text()
    return ".".join(re.search(rf"LVGL_VERSION_{part} (\d+)", text).group(1)
                    for part in ("MAJOR", "MINOR", "PATCH"))


def converter_version(converter):
    return subprocess.run([str(converter), "--version"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout.strip()


def make_fonts(converter, font, folder, run):
    """Fonts of the 95 glyphs of ASCII, 4 bits a pixel, and a list of them."""
    folder.mkdir(exist_ok=True)
    names = {}
    for px in sorted({*LABEL_SIZES, *GLYPH_SIZES}, key=int):
        for way, options in WAYS.items():
            name = f"lv_{px}_{way}"
            names[name] = (px, way)
            run(converter, "--font", font, "-r", "0x20-0x7E", "--size", px,
                "--bpp", "4", *options, "--format", "lvgl", "--lv-include",
                "lvgl.h", "-o", folder / (name + ".c"))
    lines = ['#include "lvgl.h"',
             *(f"LV_FONT_DECLARE({name})" for name in names),
             "static const struct {", "  uint32_t px;", "  const char* way;",
             "  const lv_font_t* font;", "} lv_fonts[] = {",
             *(f'    {{{px}, "{way}", &{name}}},'
               for name, (px, way) in names.items()), "};"]
    (folder / "lv_fonts.h").write_text("\n".join(lines) + "\n")
    return folder


def targets():
    return ["lvgl_glyphs"] + [f"lvgl_label_{i}" for i in range(len(LABELS))]


def measure_glyphs(firmware, rom, about, kept_modules, code_of):
    """A glyph's metrics and its bitmap, mean of 95."""
    program = firmware.folder / "lvgl_glyphs.map"
    fonts = kept_modules(program, "bench_lv_fonts")
    code = code_of("lvgl_label_1") - code_of("lvgl_label_0")
    for way in WAYS:
        for _, numbers in firmware.run("lvgl_glyphs", rom, way, "32", "126",
                                       *GLYPH_SIZES):
            px, _, mean, most, stack, heap, *_ = numbers
            yield {"figure": "lvgl_glyph", **about, "way": way, "px": px,
                   "instructions_mean": mean, "instructions_max": most,
                   "stack": stack, "heap": heap, "code": code,
                   "font_bytes": fonts[f"lv_{px}_{way}"]}


def measure_labels(firmware, rom, about, kept_modules, code_of):
    """A label with each font, over one without text."""
    for number, label in enumerate(LABELS):
        if label == "blank":
            continue
        program = f"lvgl_label_{number}"
        fonts = kept_modules(firmware.folder / (program + ".map"),
                             "bench_lv_fonts")
        *rows, (_, (own, shared)) = firmware.run(program, rom, *LABEL,
                                                 *LABEL_SIZES)
        for _, (px, first, later, stack, heap) in rows:
            yield {"figure": "lvgl_label", **about, "label": label, "px": px,
                   "instructions_first": first, "instructions_later": later,
                   "stack": stack, "heap": heap, "object": own,
                   "cache": shared,
                   "code": code_of(program) - code_of("lvgl_label_0"),
                   "font_bytes": fonts.get(f"lv_{px}_{label}",
                                           firmware.fonts.bytes(rom))}


def measure_digit(firmware, rom, about):
    """A digit of 262 x 360 px, as a bitmap and direct; checks the latter."""
    for label in ("bitmap", "direct"):
        number = list(LABELS).index(label)
        (_, (_, _, instructions, stack, heap)), (_, (object_bytes, _)) = (
            firmware.run(f"lvgl_label_{number}", rom, *DIGIT, DIGIT_SIZE))
        problems = limits.exceeded("digit in LVGL", {
            "heap": heap, "stack and font": stack + object_bytes}
        ) if label == "direct" else []
        if problems:
            sys.exit("bench: " + "\n".join(problems))
        yield {"figure": "lvgl_digit", **about, "label": label,
               "instructions": instructions, "stack": stack, "heap": heap,
               "object": object_bytes}


def measure(firmware, font, rom, kept_bytes, kept_modules):
    """All figures of one build."""
    about = {"cpu": firmware.cpu, "opt": firmware.opt, "font": font.stem}

    def code_of(program):
        kept = kept_bytes(firmware.folder / (program + ".map"))
        return sum(kept.get((library, "code"), 0)
                   for library in ("lvgl", "c", *OWN_LIBRARIES))

    yield from measure_glyphs(firmware, rom, about, kept_modules, code_of)
    yield from measure_labels(firmware, rom, about, kept_modules, code_of)
    yield from measure_digit(firmware, rom, about)


def of(figures, name, **values):
    """Figures of a kind, with some values."""
    return [f for f in figures if f["figure"] == name and
            all(f[key] == value for key, value in values.items())]


def glyph_table(figures, font):
    rows = []
    for opt in report.unique(f["opt"] for f in of(figures, "lvgl_glyph")):
        cached = {f["px"]: f["instructions_mean"]
                  for f in of(figures, "cache", cpu=CPUS[0], opt=opt,
                              font=font)}
        for way in WAYS:
            some = {f["px"]: f["instructions_mean"]
                    for f in of(figures, "lvgl_glyph", opt=opt, way=way)}
            rows.append([f"{LABELS[way]}, -{opt}"] +
                        [report.thousands(some[int(px)]) for px in GLYPH_SIZES])
            rows.append(["Inkcell, held by a cache, over that"] +
                        [f"{cached[int(px)] / some[int(px)]:.2f}"
                         for px in GLYPH_SIZES])
    return report.table([""] + [f"{px} px" for px in GLYPH_SIZES], rows)


def label_table(figures):
    rows = []
    for opt in report.unique(f["opt"] for f in of(figures, "lvgl_label")):
        for label in report.unique(f["label"]
                                   for f in of(figures, "lvgl_label")):
            some = of(figures, "lvgl_label", opt=opt, label=label)
            rows.append([f"{LABELS[label]}, -{opt}"] +
                        [report.thousands(f[name]) for f in some
                         for name in ("instructions_first",
                                      "instructions_later")])
    return report.table([""] + [f"{px} px, {when}" for px in LABEL_SIZES
                                for when in ("first", "later")], rows)


def memory_table(figures):
    """Of fonts at both sizes; Inkcell's are one in ROM."""
    rows = []
    for label in report.unique(f["label"] for f in of(figures, "lvgl_label")):
        some = of(figures, "lvgl_label", label=label, opt="Os")
        is_bitmap = label in WAYS
        fonts = (sum(f["font_bytes"] for f in some) if is_bitmap
                 else some[0]["font_bytes"])
        code = some[0]["code"]
        objects = len(some) * some[0]["object"] + some[0]["cache"]
        rows.append([LABELS[label], code, fonts, code + fonts, objects,
                     max(f["heap"] for f in some),
                     max(f["stack"] for f in some)])
    return report.table(["", "code", "fonts", "flash", "objects and cache",
                         "heap", "stack"], rows)


def digit_table(figures):
    rows = [[f"{LABELS[f['label']]}, -{f['opt']}",
             report.thousands(f["instructions"]), f["heap"], f["stack"],
             f["object"], f["stack"] + f["object"]]
            for f in of(figures, "lvgl_digit")]
    return report.table(["", "thousand instructions", "heap", "stack", "font",
                         "stack and font"], rows)


def peer_table(figures):
    """What README.md says of LVGL beside the others."""
    rows = []
    for way in WAYS:
        some = of(figures, "lvgl_glyph", opt="Os", way=way)
        rows += [[f"{LABELS[way]}, {f['px']} px", f["code"], f["font_bytes"],
                  f["stack"], f["heap"],
                  f"{report.thousands(f['instructions_mean'])} "
                  f"({report.thousands(f['instructions_max'])})"]
                 for f in some]
    return report.table(["", "code", "font", "stack", "heap",
                         "thousand instructions"], rows)


def document(figures, smallest, folder, converter):
    """The chapter of docs/BENCHMARKS.md. `smallest`: figures of the smallest
    build for outlines."""
    font = of(figures, "lvgl_glyph")[0]["font"]
    return f"""\
## In LVGL

LVGL {version(folder)}, software renderer, on Cortex-M3. {font}, 95 characters:
fonts of lv_font_conv {converter_version(converter)} (4 bits a pixel, hinted by FreeType, its defaults)
and Inkcell's by way of `port/lvgl`.

Glyphs: metrics and the bitmap in 8 bits from the code point, mean of 95, thousands of
instructions; and how many times that Inkcell takes for a glyph that its cache holds (the
table of cached glyphs, above).

{glyph_table(figures, font)}\
A label of {len(LABEL[0])} letters on a screen of {LABEL[2]} x {LABEL[3]} px in RGB565: what the text takes more than
a space, thousands of instructions. The cache has 4,096 bytes.

{label_table(figures)}\
What fonts of {" and ".join(LABEL_SIZES)} px take together, bytes, -Os, of outlines. Code: what the program has more than one without a font, of LVGL,
Inkcell and libraries. Fonts: lv_font_conv's have no kerning, Inkcell's has, and hints. Heap
and stack: the most, beside what a space takes.

{memory_table(smallest)}\
A digit of 262 x 360 px ({DIGIT_SIZE} px/em), in strips of {DIGIT[4]} rows; bytes beside the strip and what
a space takes:

{digit_table(figures)}\
Glyphs by themselves, -Os, bytes; and thousands of instructions for the mean glyph (the worst
one):

{peer_table(figures)}"""
