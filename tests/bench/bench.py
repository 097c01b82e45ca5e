#!/usr/bin/env python3
"""Builds the bench firmware for each core, runs it, and tells the figures.

A glyph is counted from its code point to 8-bit coverage, without a cache; mean
and worst of the 95 printable ASCII characters (of those that the font has).
Inkcell draws into strips of 16 rows, as many as the glyph needs, outlines with
2,560 bytes of RAM lent; FreeType and stb_truetype render into a bitmap, which
counts as output. Instructions, not
cycles: exact and repeatable in QEMU. All engines have the same compiler and
the same flags; m4f is an M4 whose floating-point unit is used, no other is.

Code is .text and .rodata of the engine's library, as the linker kept them;
what they need of the C library and the compiler's (64-bit products, division,
floating point, setjmp) is apart, as "libraries".
"""
import argparse
import concurrent.futures
import copy
import json
import os
import re
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent))  # of limits.py

import against  # noqa: E402
import figures  # noqa: E402
import lvgl  # noqa: E402
import peers  # noqa: E402
import report  # noqa: E402
from peers import run, say  # noqa: E402

DEFAULT_FONTS = [
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf",
]
STANDARD = ["--chars", "0x20-0x7E", "--min-px", "8", "--max-px", "64",
            "--tolerance", "16/255"]
# Core: toolchain file, board whose QEMU machine runs it.
CPUS = {
    "m0": (HERE / "firmware/toolchain_m0.cmake", "mps2_an385"),
    "m3": (ROOT / "boards/mps2_an385/toolchain.cmake", "mps2_an385"),
    "m4": (ROOT / "boards/mps2_an386/toolchain.cmake", "mps2_an386"),
    "m4f": (HERE / "firmware/toolchain_m4f.cmake", "mps2_an386"),
    "m7": (ROOT / "boards/mps2_an500/toolchain.cmake", "mps2_an500"),
    "m33": (ROOT / "boards/mps2_an505/toolchain.cmake", "mps2_an505"),
    "rv32": (ROOT / "boards/riscv_virt/toolchain.cmake", "riscv_virt"),
}
BUILD_TYPES = {"O2": "Release", "Os": "MinSizeRel"}
# Coding, as the generator names it: firmware, and the ways that stand beside
# the other engines.
CODINGS = {
    "outline": ("outline", ("area", "upright")),
    "field": ("cells", ("upright",)),
    "truetype": ("truetype", ("area",)),  # the file that the peers read
}
# Codings as ROM fonts number them; 1 was that of earlier versions.
ROM_CODINGS = {0: "field", 2: "outline"}
# Codings that modes, runs of text and digits are measured with.
STYLED = ("outline", "field")
LIBRARIES = {"inkcell": ("inkcell_core", "inkcell_field", "inkcell_cache",
                         "inkcell_strike", "inkcell_truetype",
                         "inkcell_port_pixel"),
             "freetype": ("bench_freetype",), "stb": ("bench_stb",)}
WHAT = {
    "glyphs": "each engine, coding and size",
    "turned": "text that is turned or leans, over upright",
    "memory": "outlines without lent RAM, and decoded for each strip",
    "canvases": "a line of text into each canvas, with more and less RAM lent",
    "digits": "instructions for each pixel of the box of digits of 200 px",
    "rgb565": "a line of text into RGB565, and its sink alone",
    "modes": "every way that glyphs can look, at 12 and 24 px",
    "cache": "glyphs that a cache holds, and bitmaps of 4 bits",
    "colour": "glyphs of several colours, of ROM fonts that have them",
    "strike": "strikes, alone and beside outlines, and those outlines",
    "field": "fields generated from outlines",
    "moving": "type that moves: morphs, particles, scenes",
    "bound": "the dearest glyph of an em that bytes can describe",
    "code": "bytes that programs keep of the library",
    "lvgl": "labels and glyphs in LVGL, on m3",
}
# Codings whose smallest programs the document has.
SMALLEST = ("outline", "field")
SMALLEST_WHAT = ["glyphs", "turned", "rgb565", "strike", "code"]
# What programs keep of the library: kept.cpp.
KEPT = ("glyphs", "area", "text", "matrix", "all_formats")
# Cores that are measured at -Os, too, for the document: the others are alike.
SMALL_CODE_CPUS = ("m0", "m3", "rv32")
MODE_SIZES = ["12", "24"]
# Cores whose modes are in the document.
MODE_CPUS = ("m0", "m3")
ASCII = ("32", "126")
# What canvases are measured with, and how many times the cost with the most RAM
# a line costs with none, at most, at these sizes. QEMU's arguments have no
# blanks.
CANVAS_TEXT = "Hamburg,23.5%"
CANVAS_SIZES = ("8", "12", "16", "20", "24", "32", "40", "48", "64")
LENT = (0, 512, 1024, 2560)
MOST_WITHOUT_RAM = 1.92
# What a line takes of the stack then, at most, on m0 in C++: where text is fitted
# by itself, and elsewhere. [bytes]
STACK_WITHOUT_RAM = {"grey2": 1924, "mono_rows": 1924, "mono_pages": 1924}
OTHER_STACK_WITHOUT_RAM = 1476
DIGITS = ("48", "57")
# Fonts of strikes alone, one for each, and beside outlines. [px, bits]
STRIKES = [(px, bits) for px in (12, 24, 48) for bits in (1, 4)]
# Generated fields: half width of the band, tolerances. [u, 1/1024 u]
BAND = "32"
TOLERANCES = ("512", "1024", "2048")
# The trees of fonts: tiles of 256 u.
DEPTH = "8"


def parse_arguments():
    parser = argparse.ArgumentParser(
        prog="tests/bench/run.sh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    lists = {"cpu": (CPUS, "m0,m3,m4,rv32"), "opt": (BUILD_TYPES, "O2"),
             "engines": (LIBRARIES, ",".join(LIBRARIES)),
             "coding": (CODINGS, ",".join(CODINGS)),
             "what": (WHAT, ",".join(WHAT))}
    for option, (known, default) in lists.items():
        add("--" + option, metavar="LIST",
            help=f"of {', '.join(known)} (default: {default})")
    add("--px", default="12,16,24,32,48,96", metavar="LIST",
        help="sizes (default: %(default)s)")
    add("--font", action="append", metavar="FILE",
        help="a TTF or a ROM font, more than once for several (default: "
        "DejaVu Sans, Liberation Serif)")
    add("--build", default=str(ROOT / "build/bench"), metavar="FOLDER",
        help="where everything is made (default: build/bench)")
    add("--fontgen", metavar="FILE", help="a built inkcell-fontgen")
    add("--freetype", metavar="FOLDER",
        help="sources of FreeType (default: Debian's, downloaded)")
    add("--stb", metavar="FOLDER",
        help="of stb_truetype.h (default: Debian's, downloaded)")
    add("--lvgl", metavar="FOLDER",
        help="LVGL's sources (default: INKCELL_LVGL_DIR)")
    add("--lv-font-conv", metavar="FILE",
        help="LVGL's converter of fonts (default: in the path)")
    add("--against", metavar="REV",
        help="measure Inkcell of another commit, too, with the same fonts, and "
        "print what differs instead of the results")
    add("--limits", action="store_true",
        help="with --against: fail where a cost grows beyond its limit and no "
        "line `Costs: ...` in a commit's body names it")
    add("--write-docs", action="store_true",
        help="measure everything on all cores and write docs/BENCHMARKS.md "
        "and docs/figures.json; without LVGL its chapter stays as it is")
    arguments = parser.parse_args()
    for option, (known, default) in lists.items():
        if arguments.write_docs:
            default = ",".join(known)
        values = (getattr(arguments, option) or default).split(",")
        for value in values:
            if value not in known:
                parser.error(f"--{option} {value}: there is {', '.join(known)}")
        setattr(arguments, option, values)
    if arguments.write_docs and set(arguments.engines) != set(LIBRARIES):
        parser.error("--write-docs compares all engines")
    if arguments.limits and not arguments.against:
        parser.error("--limits needs --against")
    if arguments.against:
        if arguments.write_docs:
            parser.error("--against writes no document")
        arguments.engines = ["inkcell"]
    arguments.px = arguments.px.split(",")
    if not all(px.isdigit() and 4 <= int(px) <= 160 for px in arguments.px):
        parser.error("--px takes whole numbers from 4 to 160")
    arguments.font = [Path(font).resolve()
                      for font in arguments.font or DEFAULT_FONTS]
    for font in arguments.font:
        if not font.is_file():
            parser.error(f"--font {font}: there is no such file")
    if all(is_rom_font(font) for font in arguments.font):
        # Nobody else reads them.
        arguments.engines = ["inkcell"]
    prepare_lvgl(arguments)
    return arguments


def prepare_lvgl(arguments):
    """Leaves LVGL out where it is not there, or cannot be measured."""
    arguments.lvgl = lvgl.find(arguments)
    if "lvgl" not in arguments.what:
        return
    possible = (arguments.lvgl and not is_rom_font(arguments.font[0]) and
                "outline" in arguments.coding and not arguments.against and
                set(lvgl.CPUS) & set(arguments.cpu))
    if not possible:
        arguments.what.remove("lvgl")
        say("skipped: LVGL, which takes a TTF, outlines and --cpu m3; "
            f"{lvgl.HELP}")


def is_rom_font(font):
    with open(font, "rb") as file:
        return file.read(4) == b"INKC"


def has_colours(font):
    return is_rom_font(font) and b"COLR" in font.read_bytes()[:256]


def coding_of(font):
    """Of a ROM font: docs/FORMAT.md, `coding`."""
    return ROM_CODINGS[font.read_bytes()[39]]


def in_parallel(function, jobs):
    """[function(*job) for job in jobs], on all cores, in order."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda job: function(*job), jobs))


def find_fontgen(arguments, build):
    if arguments.fontgen:
        return Path(arguments.fontgen).resolve()
    host = ROOT / "build/host"
    if not (host / "fonts_gen/inkcell-fontgen").exists():
        host = build / "host"
        run("cmake", "-S", ROOT, "-B", host, "-G", "Ninja",
            "-DINKCELL_TESTS=OFF")
    say("building inkcell-fontgen")
    run("cmake", "--build", host, "--target", "inkcell-fontgen")
    return host / "fonts_gen/inkcell-fontgen"


class Fonts:
    """The font files that engines read, below the build folder."""

    def __init__(self, arguments, build):
        self.folder = build / "fonts"
        self.folder.mkdir(exist_ok=True)
        self.files = {}  # (font, engine, coding): name in the folder
        wanted = {}
        for font in arguments.font:
            name = re.sub(r"[^\w.-]", "_", font.stem)
            if is_rom_font(font):
                shutil.copyfile(font, self.folder / (name + ".bin"))
                coding = coding_of(font)
                if coding not in arguments.coding:
                    sys.exit(f"bench: {font} is of {coding}: "
                             f"--coding {coding}")
                self.files[font, "inkcell", coding] = name + ".bin"
                continue
            if "inkcell" in arguments.engines:
                for coding in arguments.coding:
                    if coding == "truetype":
                        continue
                    made = f"{name}-{coding}.bin"
                    wanted[made] = (font, ["--coding", coding])
                    self.files[font, "inkcell", coding] = made
                if "strike" in arguments.what and not arguments.against:
                    wanted.update(self.strikes(font, name))
            readers = {"freetype": (font, "freetype", None),
                       "stb": (font, "stb", None)}
            readers = [readers[engine] for engine in arguments.engines
                       if engine in readers]
            if {"inkcell", "truetype"} <= {*arguments.engines,
                                           *arguments.coding}:
                readers.append((font, "inkcell", "truetype"))
            if readers:
                made = self.folder / (name + ".ttf")
                peers.make_subset(font, made, build)
                self.files.update((reader, made.name) for reader in readers)
        if wanted:
            self.generate(find_fontgen(arguments, build), wanted)

    def strikes(self, font, name):
        """Fonts of strikes alone and beside outlines, and how each is made."""
        options = [f"--strike={px}:{bits}" for px, bits in STRIKES]
        wanted = {f"{name}-strikes.bin": (font, options)}
        for (px, bits), strike in zip(STRIKES, options):
            wanted[f"{name}-strike-{px}-{bits}.bin"] = (
                font, [strike, "--strike-only"])
        return wanted

    def generate(self, fontgen, wanted):
        def make(made, source):
            font, options = source
            target = self.folder / made
            if (target.exists() and
                    target.stat().st_mtime > fontgen.stat().st_mtime):
                return
            say(f"generating {made}")
            run(fontgen, "--font", font, *STANDARD, *options, "--format",
                "bin", "--quiet", "--out", target.with_suffix(".new"))
            target.with_suffix(".new").rename(target)
        in_parallel(make, wanted.items())

    def of(self, coding):
        """The same with fonts of one coding only."""
        some = copy.copy(self)
        some.files = {key: name for key, name in self.files.items()
                      if key[2] == coding}
        return some

    def bytes(self, name):
        return (self.folder / name).stat().st_size


def build_firmware(cpu, opt, sources, targets, build):
    folder = build / f"{cpu}-{opt}"
    say(f"building {cpu} -{opt}")
    if cpu in lvgl.CPUS and "lvgl" in sources:
        targets = [*targets, *lvgl.targets()]
    else:
        sources = {**sources, "lvgl": "", "lv_fonts": ""}
    run("cmake", "-S", HERE / "firmware", "-B", folder, "-G", "Ninja",
        f"-DCMAKE_TOOLCHAIN_FILE={CPUS[cpu][0]}",
        f"-DCMAKE_BUILD_TYPE={BUILD_TYPES[opt]}",
        f"-DINKCELL_BENCH_FREETYPE={sources.get('freetype', '')}",
        f"-DINKCELL_BENCH_STB={sources.get('stb', '')}",
        f"-DINKCELL_BENCH_LVGL={sources['lvgl']}",
        f"-DINKCELL_BENCH_LV_FONTS={sources['lv_fonts']}")
    run("cmake", "--build", folder, "--target", *targets)
    return folder


def kept_modules(linker_map, library):
    """Bytes of code that the linker kept of each object of a library."""
    kept = {}
    text = linker_map.read_text()
    text = text[text.index("Linker script and memory map"):]
    for size, module in re.findall(
            r"^ \.(?:text|s?rodata)\S*\s+0x[0-9a-f]+\s+0x([0-9a-f]+) "
            rf"\S*lib{library}\.a\((\w+)", text, re.MULTILINE):
        kept[module] = kept.get(module, 0) + int(size, 16)
    return kept


def kept_bytes(linker_map):
    """Bytes that the linker kept, by library and kind of section."""
    text = linker_map.read_text()
    text = text[text.index("Linker script and memory map"):]
    kept = {}
    # " .text.name  0x address  0x size  file", the name perhaps on a line of
    # its own.
    for name, size, file in re.findall(
            r"^ (\.\S+)\s+0x[0-9a-f]+\s+0x([0-9a-f]+) (\S+)$", text,
            re.MULTILINE):
        library = re.search(r"lib(\w+)\.a\(", file)
        if library is None:
            continue
        kind = name.split(".")[1]
        kind = {"rodata": "code", "srodata": "code", "text": "code",
                "data": "ram", "sdata": "ram", "bss": "ram",
                "sbss": "ram"}.get(kind, kind)
        key = (library.group(1), kind)
        kept[key] = kept.get(key, 0) + int(size, 16)
    return kept


class Firmware:
    """The programs of one core and optimisation."""

    def __init__(self, cpu, opt, sources, targets, fonts, build):
        self.cpu, self.opt, self.fonts = cpu, opt, fonts
        self.folder = build_firmware(cpu, opt, sources, targets, build)

    def run(self, program, *arguments):
        """Lines of numbers that a program prints, by their first word."""
        output = run("sh", ROOT / "boards/common/qemu_run.sh",
                     CPUS[self.cpu][1], self.folder / (program + ".elf"),
                     *arguments, cwd=self.fonts.folder)
        return [(line.split()[0], [int(word) for word in line.split()[1:]])
                for line in output.splitlines()
                if re.fullmatch(r"\w+( \d+)+", line)]

    def glyphs(self, engine, coding, font, way, characters, sizes):
        """One dictionary for each size."""
        program = CODINGS[coding][0] if coding else engine
        if program == "cells" and way in report.SLANTED:
            program = "turned"
        program = "modes" if way in report.MODES else program
        program = "cache" if way in report.CACHE else program
        kept = kept_bytes(self.folder / (program + ".map"))
        name = self.fonts.files[font, engine, coding]
        for _, numbers in self.run(program, name, way, *characters, *sizes):
            (px, glyphs, mean, most, stack, heap, workspace, ink,
             box) = numbers
            result = {"engine": engine, "cpu": self.cpu, "opt": self.opt,
                      "font": font.stem, "px": px, "instructions_mean": mean,
                      "instructions_max": most, "stack": stack, "heap": heap,
                      "static_ram": sum(kept.get((library, "ram"), 0)
                                        for library in LIBRARIES[engine]),
                      "code": sum(kept.get((library, "code"), 0)
                                  for library in LIBRARIES[engine]),
                      "font_bytes": self.fonts.bytes(name)}
            if coding:
                result["coding"] = coding
                result["way"] = way
                result["workspace"] = workspace
            result["libraries"] = sum(kept.get((library, "code"), 0)
                                      for library in ("c", "m", "gcc"))
            yield result, {"glyphs": glyphs, "ink": ink, "box": box}


def measure_glyphs(firmware, arguments, pictures):
    """Results of all engines, codings and fonts, table by table."""
    jobs = [job for job in firmware.fonts.files
            if (job[1] == "inkcell" and job[2] in arguments.coding) or
            (job[1] != "inkcell" and job[1] in arguments.engines)]
    jobs.sort(key=lambda job: (arguments.font.index(job[0]),
                               list(LIBRARIES).index(job[1]),
                               list(CODINGS).index(job[2]) if job[2] else 0))
    jobs = [(*job, way) for job in jobs
            for way in (CODINGS[job[2]][1] if job[2] else ("upright",))]

    def one(font, engine, coding, way):
        return list(firmware.glyphs(engine, coding, font, way, ASCII,
                                    arguments.px))
    results = []
    for job, rows in zip(jobs, in_parallel(one, jobs)):
        if len(rows) != len(arguments.px):
            sys.exit(f"bench: {firmware.cpu}: {job}: a size is missing")
        for result, more in rows:
            results.append(result)
            key = job[0].stem, result["px"]
            name = job[1] if job[2] is None else f"{job[2]}, {job[3]}"
            pictures.setdefault(key, {}).setdefault(name, set()).add(
                more["ink"])
    return results


def check_pictures(pictures):
    """That all drew the same text: Inkcell bit by bit, others about."""
    for (font, px), engines in pictures.items():
        for engine, inks in engines.items():
            if engine not in LIBRARIES and len(inks) > 1:
                sys.exit(f"bench: {font}, {px} px: {engine}: pictures differ "
                         f"between cores: {inks}")
        inks = [ink for some in engines.values() for ink in some]
        if px >= 24 and max(inks) > 1.03 * min(inks):
            sys.exit(f"bench: {font}, {px} px: engines did not draw the same: "
                     f"{engines}")


def check_bounds(results, figures):
    """That no glyph, of up to 1.25 em by 1.25 em, costs more than may be."""
    bounds = {(f["cpu"], f["opt"], f["px"]): f["per_pixel"] for f in figures
              if f["figure"] == "bound"}
    for r in results:
        bound = bounds.get((r["cpu"], r["opt"], r["px"]))
        if r.get("coding") != "field" or bound is None:
            continue
        if r["instructions_max"] > bound * (1.25 * r["px"]) ** 2:
            sys.exit(f"bench: {r['font']}, {r['px']} px: a glyph costs more "
                     f"than the bound of {bound} instructions a pixel")


def measure_ways(firmware, ways, sizes, font, about, upright):
    """Ways of drawing glyphs, over upright ones in the same coding."""
    coding = about["coding"]
    for way, plain in ways.items():
        for result, _ in firmware.glyphs("inkcell", coding, font, way, ASCII,
                                         sizes):
            px, mean = result["px"], result["instructions_mean"]
            straight = upright.get((coding, plain, font.stem, px))
            yield {"figure": way, **about, "px": px, "instructions_mean": mean,
                   "stack": result["stack"],
                   "over_upright": straight and round(mean / straight, 3)}


def measure_modes(firmware, font, about, pictures):
    """What every mode costs, and how many times a plain glyph."""
    means = {}
    modes = [mode for mode, (_, _, codings) in report.MODES.items()
             if about["coding"] in codings]

    def one(mode):
        return list(firmware.glyphs("inkcell", about["coding"], font, mode,
                                    ASCII, MODE_SIZES))
    for mode, rows in zip(modes, in_parallel(one, [(m,) for m in modes])):
        for result, more in rows:
            px, mean = result["px"], result["instructions_mean"]
            means[mode, px] = mean
            pictures.setdefault(
                (f"{font.stem}, {about['coding']}, {mode}", px), {}).setdefault(
                    mode, set()).add(more["ink"])
            plain = means[report.MODES[mode][1], px]
            yield {"figure": "mode", **about, "px": px, "mode": mode,
                   "instructions_mean": mean,
                   "instructions_max": result["instructions_max"],
                   "stack": result["stack"],
                   "over_plain": round(mean / plain, 2)}


def measure_cache(firmware, sizes, font, about):
    """Cached glyphs over bitmaps of the same pictures."""
    cached, bitmaps = (
        [result for result, _ in firmware.glyphs(
            "inkcell", about["coding"], font, way, ASCII, sizes)]
        for way in report.CACHE)
    for held, bitmap in zip(cached, bitmaps):
        mean, plain = held["instructions_mean"], bitmap["instructions_mean"]
        yield {"figure": "cache", **about, "px": held["px"],
               "instructions_mean": mean, "bitmap_mean": plain,
               "over_bitmap": round(mean / plain, 2), "stack": held["stack"],
               "ram": held["workspace"]}


def measure_colour(firmware, sizes, font, about):
    """Glyphs of several colours, mean and worst, in the ways of drawing them."""
    for px in sizes:
        ways = {}
        for way, (_, instructions, stack) in firmware.run(
                "colour", firmware.fonts.files[font, "inkcell", "outline"], px):
            ways.setdefault(way, []).append((instructions, stack))
        for way, glyphs in ways.items():
            instructions = [count for count, _ in glyphs]
            yield {"figure": "colour", **about, "px": int(px), "way": way,
                   "glyphs": len(glyphs),
                   "instructions_mean": round(sum(instructions) / len(glyphs)),
                   "instructions_max": max(instructions),
                   "stack": max(stack for _, stack in glyphs)}


def measure_strikes(firmware, font):
    """Strikes alone, beside outlines, and the outlines whose pictures they are."""
    name = re.sub(r"[^\w.-]", "_", font.stem)
    for px, bits in STRIKES:
        canvas = "pages" if bits == 1 else "a8"
        inks = []
        for way in report.STRIKE_WAYS:
            file = (f"{name}-strike-{px}-{bits}.bin" if way == "alone"
                    else f"{name}-strikes.bin")
            prefix = "" if way == "alone" else f"{way}_"
            (_, numbers), = firmware.run("strike", file, prefix + canvas, *ASCII,
                                         str(px))
            _, _, mean, most, stack, heap, workspace, ink, _ = numbers
            inks.append(ink)
            yield {"figure": "strike", "cpu": firmware.cpu, "opt": firmware.opt,
                   "font": font.stem, "way": way, "bits": bits, "px": px,
                   "instructions_mean": mean, "instructions_max": most,
                   "stack": stack, "heap": heap, "workspace": workspace,
                   "font_bytes": firmware.fonts.bytes(file)}
        # Pictures of 1 bit are those of outlines.
        if max(inks) > (1 if bits == 1 else 1.01) * min(inks):
            sys.exit(f"bench: {font.stem}, {px} px, {bits} bits: strikes do not "
                     f"draw what outlines draw: {inks}")


def measure_strike_code(firmware):
    """What a program keeps of the library that opens fonts of strikes alone."""
    kept = kept_bytes(firmware.folder / "kept_strike.map")
    return {"figure": "strike_code", "cpu": firmware.cpu, "opt": firmware.opt,
            "glyphs": sum(kept.get((library, "code"), 0)
                          for library in LIBRARIES["inkcell"]),
            "libraries": kept.get(("gcc", "code"), 0)}


def measure_canvases(firmware, font):
    """A line of text into each canvas, in C++ and in C."""
    name = firmware.fonts.files[font, "inkcell", "outline"]
    for language, program in (("C++", "canvases"), ("C", "canvases_c")):
        pictures = {}
        for canvas, numbers in firmware.run(
                program, name, CANVAS_TEXT, ",".join(map(str, LENT)),
                *CANVAS_SIZES):
            px, lent, instructions, stack, picture = numbers
            pictures.setdefault((canvas, px), set()).add(picture)
            yield {"figure": "canvas", "cpu": firmware.cpu,
                   "opt": firmware.opt, "font": font.stem,
                   "language": language, "canvas": canvas, "px": px,
                   "lent": lent, "instructions": instructions, "stack": stack}
        for (canvas, px), drawn in pictures.items():
            if len(drawn) != 1:
                sys.exit(f"bench: {font.stem}, {canvas}, {px} px: the picture "
                         "depends on the RAM that is lent")


def check_canvases(figures):
    """That no line costs much more for want of RAM."""
    most = {}
    canvases = [f for f in figures if f["figure"] == "canvas"]
    for f in canvases:
        if f["lent"] == LENT[-1]:
            most[report.canvas_key(f)] = f["instructions"]
    for f in canvases:
        ratio = f["instructions"] / most[report.canvas_key(f)]
        if ratio > MOST_WITHOUT_RAM:
            sys.exit(f"bench: {f['cpu']} -{f['opt']}, {f['language']}, "
                     f"{f['font']}, {f['canvas']}, {f['px']} px: with "
                     f"{f['lent']} B lent a line costs {ratio:.2f} times what "
                     f"it costs with {LENT[-1]} B; {MOST_WITHOUT_RAM} is the "
                     "limit")
        limit = STACK_WITHOUT_RAM.get(f["canvas"], OTHER_STACK_WITHOUT_RAM)
        if (f["cpu"], f["language"]) == ("m0", "C++") and f["stack"] > limit:
            sys.exit(f"bench: {f['font']}, {f['canvas']}, {f['px']} px, "
                     f"{f['lent']} B lent: {f['stack']} B of stack; {limit} is "
                     "the limit")


def measure_styled(firmware, arguments, font, coding, upright, pictures):
    """The figures of one font that are not a table."""
    name = firmware.fonts.files[font, "inkcell", coding]
    about = {"cpu": firmware.cpu, "opt": firmware.opt, "coding": coding,
             "font": font.stem}
    ways = {}
    if "turned" in arguments.what:
        ways.update((way, plain) for way, (_, plain, codings)
                    in report.SLANTED.items() if coding in codings)
    if "memory" in arguments.what and coding == "outline":
        ways.update((way, "upright") for way in report.MEMORY)
    yield from measure_ways(firmware, ways, arguments.px, font, about, upright)
    if "modes" in arguments.what and (
            not arguments.write_docs or
            (firmware.cpu in MODE_CPUS and firmware.opt == "O2")):
        yield from measure_modes(firmware, font, about, pictures)
    if "colour" in arguments.what and has_colours(font):
        yield from measure_colour(firmware, arguments.px, font, about)
    if "cache" in arguments.what and coding == "outline":
        yield from measure_cache(firmware, arguments.px, font, about)
    if "digits" in arguments.what:
        for result, more in firmware.glyphs("inkcell", coding, font, "upright",
                                            DIGITS, ["200"]):
            mean = result["instructions_mean"]
            yield {"figure": "digits", **about, "px": 200,
                   "instructions_mean": mean, "stack": result["stack"],
                   "per_pixel": round(mean * more["glyphs"] / more["box"], 2)}
    if "rgb565" in arguments.what:
        for word, numbers in firmware.run("rgb565", name, *arguments.px):
            if word == "run":
                yield {"figure": "run", **about, "px": numbers[0],
                       "instructions": numbers[1], "stack": numbers[2],
                       "strips": numbers[3]}
            elif font == arguments.font[0] and coding == arguments.coding[0]:
                yield {"figure": "blend", "cpu": firmware.cpu,
                       "opt": firmware.opt,
                       "per_partly_covered": numbers[0] / 100,
                       "per_solid": numbers[1] / 100,
                       "call_coverage": numbers[2],
                       "call_solid": numbers[3]}


def measure_fields(firmware, font):
    """What it takes to generate fields of outlines."""
    name = firmware.fonts.files[font, "inkcell", "outline"]
    kept = kept_bytes(firmware.folder / "field.map")
    for _, numbers in firmware.run("field", name, *ASCII, BAND, *TOLERANCES):
        (tolerance, _, mean, most, stack, record, most_record, ram,
         most_ram) = numbers
        yield {"figure": "field", "cpu": firmware.cpu, "opt": firmware.opt,
               "font": font.stem, "tolerance": tolerance,
               "instructions_mean": mean, "instructions_max": most,
               "stack": stack, "record_mean": record,
               "record_max": most_record, "ram_mean": ram,
               "ram_max": most_ram,
               "code": kept.get(("inkcell_core", "code"), 0)}


def measure_moving(firmware, font):
    """What type that moves takes, and its code by module."""
    name = firmware.fonts.files[font, "inkcell", "outline"]
    about = {"cpu": firmware.cpu, "opt": firmware.opt, "font": font.stem}
    for what, numbers in firmware.run("moving", name):
        if what == "morph":
            px, scale, mean, most, take, stack, ram = numbers
            yield {"figure": "morph", **about, "px": px, "scale_log2": scale,
                   "instructions_mean": mean, "instructions_max": most,
                   "instructions_set": take, "stack": stack, "ram": ram}
        elif what == "outline_morph":
            px, mean, most, plain, stack = numbers
            yield {"figure": "outline_morph", **about, "px": px,
                   "instructions_mean": mean, "instructions_max": most,
                   "instructions_plain": plain, "stack": stack}
        elif what == "particles":
            count, step, pull = numbers
            yield {"figure": "particles", **about, "particles": count,
                   "instructions_step": step, "instructions_pull": pull}
        elif what == "level_set":
            side, flow, sweep, stack = numbers
            yield {"figure": "level_set", **about, "side": side,
                   "advect": flow / 10, "redistance": sweep / 10,
                   "stack": stack}
        elif what == "dot":
            yield {"figure": "dot", **about, "instructions_mean": numbers[0]}
        else:
            width, height, mean, most, whole, stack, ram = numbers
            yield {"figure": "scene", **about, "scene": what, "width": width,
                   "height": height, "instructions_mean": mean,
                   "instructions_max": most, "instructions_whole": whole,
                   "stack": stack, "ram": ram}
    for library in ("motion", "simulation"):
        modules = kept_modules(firmware.folder / "moving.map",
                               f"inkcell_{library}")
        yield {"figure": f"{library}_code", **about, **modules,
               "total": sum(modules.values())}


def measure_others(firmware, arguments, upright, pictures):
    """All figures of Inkcell that are not a table."""
    for coding in STYLED:
        for font in arguments.font:
            if (font, "inkcell", coding) in firmware.fonts.files:
                yield from measure_styled(firmware, arguments, font, coding,
                                          upright, pictures)
    if "field" in arguments.what:
        for font in arguments.font:
            if (font, "inkcell", "outline") in firmware.fonts.files:
                yield from measure_fields(firmware, font)
    if "strike" in arguments.what and not arguments.against:
        for font in arguments.font:
            if (font, "inkcell", "outline") in firmware.fonts.files and (
                    not is_rom_font(font)):
                yield from measure_strikes(firmware, font)
        yield measure_strike_code(firmware)
    if "canvases" in arguments.what and firmware.opt == "O2" and (
            not arguments.write_docs or firmware.cpu in MODE_CPUS):
        for font in arguments.font:
            if (font, "inkcell", "outline") in firmware.fonts.files:
                yield from measure_canvases(firmware, font)
    if "moving" in arguments.what:
        for font in arguments.font:
            if (font, "inkcell", "outline") in firmware.fonts.files:
                yield from measure_moving(firmware, font)
    if "bound" in arguments.what and "field" in arguments.coding:
        for _, numbers in firmware.run("bound", DEPTH, *arguments.px):
            px, pixels, instructions, stack = numbers
            yield {"figure": "bound", "cpu": firmware.cpu,
                   "opt": firmware.opt, "px": px, "stack": stack,
                   "per_pixel": round(instructions / pixels)}
    if "lvgl" in arguments.what and firmware.cpu in lvgl.CPUS:
        font = arguments.font[0]
        yield from lvgl.measure(firmware, font,
                                firmware.fonts.files[font, "inkcell",
                                                     "outline"],
                                kept_bytes, kept_modules)
    if "code" in arguments.what:
        kept = [kept_bytes(firmware.folder / f"{program}.map")
                for program in kept_programs(arguments)]
        yield {"figure": "code", "cpu": firmware.cpu, "opt": firmware.opt,
               **{name: sum(level.get((library, "code"), 0)
                            for library in LIBRARIES["inkcell"])
                  for name, level in zip(KEPT, kept)},
               "libraries": kept[0].get(("gcc", "code"), 0)}


def options_again(arguments):
    """What the other commit's bench is asked for."""
    options = []
    for option in ("cpu", "opt", "coding", "what", "px"):
        values = getattr(arguments, option)
        if values:
            options += ["--" + option, ",".join(values)]
    for font in arguments.font:
        options += ["--font", str(font)]
    return [*options, "--engines", "inkcell"]


def measure(firmware, arguments, pictures):
    """The results and the other figures of one build, told as they come."""
    glyphs, more = [], []
    if "glyphs" in arguments.what:
        glyphs = measure_glyphs(firmware, arguments, pictures)
        report.print_table(glyphs)
    upright = {(result["coding"], result["way"], result["font"],
                result["px"]): result["instructions_mean"]
               for result in glyphs if "coding" in result}
    if "inkcell" in arguments.engines:
        more = list(measure_others(firmware, arguments, upright, pictures))
        report.print_others(more)
    if not arguments.against:
        for line in glyphs + more:
            print(json.dumps(line), flush=True)
    return glyphs, more


def kept_programs(arguments):
    """Those of kept.cpp: of fields, if nothing else is asked for."""
    kind = "kept_field" if arguments.coding == ["field"] else "kept"
    return [f"{kind}_{level}" for level in range(len(KEPT))]


def targets_of(arguments):
    """The programs that measure what is asked for."""
    targets = {CODINGS[coding][0] for coding in arguments.coding}
    targets |= {engine for engine in arguments.engines if engine != "inkcell"}
    if any(map(has_colours, arguments.font)):
        targets.add("colour")
    targets |= ({"bound", "cache", "field", "modes", "moving", "rgb565",
                 "strike"} & set(arguments.what))
    if "strike" in targets:
        targets.add("kept_strike")
    if "turned" in arguments.what and "field" in arguments.coding:
        targets.add("turned")
    if "canvases" in arguments.what:
        targets |= {"canvases", "canvases_c"}
    if "code" in arguments.what:
        targets |= set(kept_programs(arguments))
    return sorted(targets)


def measure_smallest(arguments, lvgl_sources, fonts, pictures, build):
    """Results and figures of the smallest build of each core, by coding."""
    measured = {}
    for coding in SMALLEST:
        in_lvgl = coding == "outline" and bool(lvgl_sources)
        some = argparse.Namespace(**{**vars(arguments), "engines": ["inkcell"],
                                     "coding": [coding],
                                     "what": SMALLEST_WHAT +
                                     ["lvgl"] * in_lvgl})
        results, others = [], []
        for cpu in SMALL_CODE_CPUS:
            firmware = Firmware(cpu, "Os", lvgl_sources if in_lvgl else {},
                                targets_of(some),
                                fonts.of(coding),
                                build / f"smallest-{coding}")
            glyphs, more = measure(firmware, some, pictures)
            results += glyphs
            others += more
        measured[coding] = results, others
    return measured


def main():
    arguments = parse_arguments()
    for tool in ("cmake", "ninja", "qemu-system-arm", "arm-none-eabi-g++"):
        if shutil.which(tool) is None:
            sys.exit(f"bench: {tool} is missing; host_tools/setup.sh says "
                     "what to install")
    build = Path(arguments.build).resolve()
    build.mkdir(parents=True, exist_ok=True)
    os.environ.pop("INKCELL_QEMU_WINDOW", None)  # it would run in real time
    sources = peers.find_sources(arguments, build)
    if "lvgl" in arguments.what:
        sources["lvgl"], converter = arguments.lvgl
        sources["lv_fonts"] = lvgl.make_fonts(converter, arguments.font[0],
                                              build / "lv_fonts", run)
    fonts = Fonts(arguments, build)
    results, others, pictures = [], [], {}
    for opt in arguments.opt:
        for cpu in arguments.cpu:
            if (arguments.write_docs and opt == "Os" and
                    cpu not in SMALL_CODE_CPUS):
                continue
            firmware = Firmware(cpu, opt, sources, targets_of(arguments),
                                fonts, build)
            glyphs, more = measure(firmware, arguments, pictures)
            results += glyphs
            others += more
    check_bounds(results, others)
    check_canvases(others)
    if arguments.against:
        made = all(is_rom_font(font) for font in arguments.font)
        before = against.measure(ROOT, arguments.against, build,
                                 options_again(arguments),
                                 None if made
                                 else find_fontgen(arguments, build))
        exceeded = against.compare(before, results + others)
        if arguments.limits:
            against.check_limits(ROOT, arguments.against, exceeded)
    smallest = None
    if arguments.write_docs:
        lvgl_sources = {name: sources[name] for name in ("lvgl", "lv_fonts")
                        if name in sources}
        smallest = measure_smallest(arguments, lvgl_sources, fonts, pictures,
                                    build)
    check_pictures(pictures)
    if arguments.write_docs:
        write_docs(arguments, results, others, smallest, sources)


def write_docs(arguments, results, others, smallest, sources):
    versions = {"freetype": peers.freetype_version(sources["freetype"])}
    chapter = None
    if "lvgl" in arguments.what:
        versions["lvgl"] = lvgl.version(sources["lvgl"])
        chapter = lvgl.document(others, smallest["outline"][1],
                                *arguments.lvgl)
    report.write_document(results, others, smallest, sources, chapter)
    figures.store("bench", figures.of_bench(results, others, smallest,
                                            versions))


if __name__ == "__main__":
    main()
