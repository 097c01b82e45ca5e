#!/usr/bin/env python3
"""Builds the bench firmware for each core, runs it, and tells the figures.

A glyph is counted from its code point to 8-bit coverage in strips of 16 rows,
without a cache; mean and worst of the 95 printable ASCII characters (of those
that the font has). Instructions, not cycles: exact and repeatable in QEMU.

Code is .text and .rodata of core and of the sink, as the linker kept them;
what they need of the compiler's library (64-bit products and division) is
apart in the table. M3 and up are compiled with -mno-unaligned-access.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DEFAULT_FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
STANDARD = ["--chars", "0x20-0x7E", "--min-px", "8", "--max-px", "64",
            "--tolerance", "16/255"]
# Core: toolchain file, board whose QEMU machine runs it, largest glyph [px].
CPUS = {
    "m0": (HERE / "firmware/toolchain_m0.cmake", "mps2_an385", 160),
    "m3": (ROOT / "boards/mps2_an385/toolchain.cmake", "mps2_an385", 160),
    "m4": (ROOT / "boards/mps2_an386/toolchain.cmake", "mps2_an386", 160),
    "m7": (ROOT / "boards/mps2_an500/toolchain.cmake", "mps2_an500", 160),
    "m33": (ROOT / "boards/mps2_an505/toolchain.cmake", "mps2_an505", 160),
    "rv32": (ROOT / "boards/riscv_virt/toolchain.cmake", "riscv_virt", 160),
    "microbit": (ROOT / "boards/microbit/toolchain.cmake", "microbit", 64),
}
BUILD_TYPES = {"O2": "Release", "Os": "MinSizeRel"}


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tests/bench/run.sh")
    parser.add_argument("--cpu", default="m0,m3,m4,rv32")
    parser.add_argument("--engines", default="inkcell")
    parser.add_argument("--px", default="12,24,48")
    parser.add_argument("--opt", default="O2")
    parser.add_argument("--font", default=DEFAULT_FONT)
    parser.add_argument("--build", default=str(ROOT / "build/bench"))
    parser.add_argument("--fontgen", help="a built inkcell-fontgen")
    arguments = parser.parse_args()
    for option, known in (("cpu", CPUS), ("opt", BUILD_TYPES),
                          ("engines", ["inkcell"])):
        for value in getattr(arguments, option).split(","):
            if value not in known:
                parser.error(f"--{option} {value}: there is "
                             f"{', '.join(known)} in this version")
    if not all(px.isdigit() for px in arguments.px.split(",")):
        parser.error("--px takes whole numbers")
    if not Path(arguments.font).is_file():
        parser.error(f"--font {arguments.font}: there is no such file")
    return arguments


def run(*command):
    """Runs a command quietly; its output is shown if it fails."""
    done = subprocess.run([str(part) for part in command],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout[-4000:]}\nbench: failed: "
                 f"{' '.join(str(part) for part in command)}")
    return done.stdout


def find_fontgen(arguments, build):
    if arguments.fontgen:
        return Path(arguments.fontgen)
    for built in (ROOT / "build/host", build / "host"):
        if (built / "fonts_gen/inkcell-fontgen").exists():
            return built / "fonts_gen/inkcell-fontgen"
    run("cmake", "-S", ROOT, "-B", build / "host", "-G", "Ninja",
        "-DINKCELL_TESTS=OFF")
    run("cmake", "--build", build / "host", "--target", "inkcell-fontgen")
    return build / "host/fonts_gen/inkcell-fontgen"


def rom_font(arguments, build):
    """The ROM font to link: as it is, or made from an outline font."""
    font = Path(arguments.font).resolve()
    with open(font, "rb") as file:
        if file.read(4) == b"INKC":
            return font
    made = build / (font.stem + ".bin")
    run(find_fontgen(arguments, build), "--font", font, *STANDARD, "--format",
        "bin", "--quiet", "--out", made)
    return made


def build_firmware(cpu, opt, font, build):
    toolchain, _, side = CPUS[cpu]
    folder = build / f"{cpu}-{opt}"
    run("cmake", "-S", HERE / "firmware", "-B", folder, "-G", "Ninja",
        f"-DCMAKE_TOOLCHAIN_FILE={toolchain}",
        f"-DCMAKE_BUILD_TYPE={BUILD_TYPES[opt]}",
        f"-DINKCELL_BENCH_FONT={font}", f"-DINKCELL_BENCH_SIDE={side}")
    run("cmake", "--build", folder, "--target", "bench")
    return folder


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
        library = re.search(r"lib(inkcell_core|inkcell_port_pixel|gcc)\.a",
                            file)
        if library is None:
            continue
        kind = name.split(".")[1]
        kind = "code" if kind in ("text", "rodata", "srodata") else kind
        key = (library.group(1), kind)
        kept[key] = kept.get(key, 0) + int(size, 16)
    return kept


def measure(cpu, opt, font, sizes, build):
    """One dictionary for each size."""
    folder = build_firmware(cpu, opt, font, build)
    kept = kept_bytes(folder / "bench.map")
    engine = ("inkcell_core", "inkcell_port_pixel")
    code = sum(kept.get((library, "code"), 0) for library in engine)
    ram = sum(kept.get((library, kind), 0) for library in engine
              for kind in ("data", "bss", "sdata", "sbss"))
    output = run("sh", ROOT / "boards/common/qemu_run.sh", CPUS[cpu][1],
                 folder / "bench.elf", *sizes)
    for line in output.splitlines():
        if not line.startswith("size "):
            continue
        px, glyphs, mean, most, stack, ink = map(int, line.split()[1:])
        yield {"engine": "inkcell", "cpu": cpu, "opt": opt, "font": font.name,
               "px": px, "instructions_mean": mean, "instructions_max": most,
               "stack": stack, "heap": 0, "static_ram": ram, "code": code,
               "font_bytes": font.stat().st_size}, {
                   "glyphs": glyphs, "ink": ink,
                   "libgcc": kept.get(("gcc", "code"), 0)}


def main():
    arguments = parse_arguments()
    for tool in ("cmake", "ninja", "qemu-system-arm", "arm-none-eabi-g++"):
        if shutil.which(tool) is None:
            sys.exit(f"bench: {tool} is missing; host_tools/setup.sh says "
                     "what to install")
    build = Path(arguments.build).resolve()
    build.mkdir(parents=True, exist_ok=True)
    font = rom_font(arguments, build)
    os.environ.pop("INKCELL_QEMU_WINDOW", None)  # it would run in real time
    row = "{:9}{:4}{:>5}{:>8}{:>10}{:>10}{:>7}{:>7}{:>8}{:>9}"
    print(row.format("cpu", "opt", "px", "glyphs", "mean", "worst", "stack",
                     "code", "libgcc", "font"), file=sys.stderr)
    inks = {}
    for cpu in arguments.cpu.split(","):
        for opt in arguments.opt.split(","):
            for result, more in measure(cpu, opt, font,
                                        arguments.px.split(","), build):
                print(json.dumps(result), flush=True)
                print(row.format(cpu, opt, result["px"], more["glyphs"],
                                 result["instructions_mean"],
                                 result["instructions_max"], result["stack"],
                                 result["code"], more["libgcc"],
                                 result["font_bytes"]), file=sys.stderr)
                inks.setdefault(result["px"], set()).add(more["ink"])
    if len(inks) != len(set(arguments.px.split(","))):
        sys.exit("bench: a size is missing")
    for px, sums in inks.items():
        if len(sums) != 1:
            sys.exit(f"bench: {px} px: cores drew different pictures: {sums}")


if __name__ == "__main__":
    main()
