"""Builds the library as options and fonts ask for it, and draws.

What a build has must look as it does with all parts; fonts and records that need
what is missing must be answered with `unsupported`, and no code of it may be
linked. Glyphs look the same in either order. By default a build has outlines;
a font of inkcell_add_font() brings what its coding needs.

Usage: check_options.py WORK_FOLDER FULL_PROBE FONTGEN
"""
import pathlib
import shutil
import sys
import zlib

from toolchains import INCLUDES, ROOT, finish, run

FONTS = [ROOT / "tests/golden/fonts" / f"dejavu_sans_{coding}.bin"
         for coding in ("field", "outline")]
# What the probe says, line by line: of its own font only where it has one.
LINES = ["record of cells", "font of fields", "fields of fields",
         "font of outlines", "fields of outlines", "font of its own",
         "fields of its own"]
UNSUPPORTED = "7"

# What is missing without each part, and names of functions that only that
# needs.
OUTLINES = ({"font of outlines"}, ["paint_distances(", "OutlineReader::"])
FIELDS = ({"record of cells", "font of fields", "fields of outlines"},
           ["find_samples", "samples_distance", "paint_samples",
            "Block::visit_tile"])
CELLS = (set(), ["CellBand::", "draw_tiles"])

# Builds: what CMake is told, and what they leave out.
BUILDS = {
    "by default": ([], [FIELDS, CELLS]),
    "without outlines": (["INKCELL_OUTLINES=OFF", "INKCELL_SAMPLE_CELLS=ON"],
                         [OUTLINES]),
    "with a font of fields": (["CODING=field"], []),
    "with small code of cells": (["CODING=field", "INKCELL_FAST_CELLS=OFF"],
                                 []),
}


def linked(probe):
    """The names of all functions of a program."""
    return run(["nm", "-C", "--defined-only", probe]).stdout


def answers(probe):
    """Status and result of each line that a probe prints."""
    result = run([probe, *FONTS])
    lines = [line.split() for line in result.stdout.splitlines()]
    if result.returncode != 0 or len(lines) not in (len(LINES), len(LINES) - 2):
        finish(0, [f"{probe}: {result.stdout}"])
    return dict(zip(LINES, lines))


def check_edges(probe, work):
    """What is wrong with how a build answers a font of edges, coding 1, which
    only earlier versions made."""
    data = bytearray(FONTS[0].read_bytes())
    header_bytes = int.from_bytes(data[6:8], "little")
    data[39] = 1
    crc = zlib.crc32(data[16:header_bytes], zlib.crc32(data[:12]))
    data[12:16] = crc.to_bytes(4, "little")
    font = work / "edges.bin"
    font.write_bytes(data)
    said = run([probe, font]).stdout.splitlines()
    # The first line is that of the record.
    good = len(said) > 2 and said[1].split()[0] == UNSUPPORTED
    return [] if good else [f"{probe}: a font of edges: {said}"]


def build(name, fontgen, work):
    """The probe of a build."""
    folder = work / name.replace(" ", "_")
    for command in (
            ["cmake", "-G", "Ninja", "-S", ROOT / "tests/build/options",
             "-B", folder, f"-DINKCELL={ROOT}", f"-DINKCELL_FONTGEN={fontgen}",
             *(f"-D{option}" for option in BUILDS[name][0]),
             "-DCMAKE_BUILD_TYPE=MinSizeRel", "-DINKCELL_JOIN_FOLDERS=ON",
             "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror"],
            ["cmake", "--build", folder, "--target", "probe"]):
        result = run(command)
        if result.returncode != 0:
            finish(0, [f"{name}: {result.stdout}"])
    return folder / "probe"


def check_build(name, full, full_names, fontgen, work):
    """What is wrong with a build."""
    parts = BUILDS[name][1]
    missing = set().union(*(lines for lines, _ in parts))
    functions = [function for _, names in parts for function in names]
    probe = build(name, fontgen, work)
    names, problems = linked(probe), []
    for function in functions:
        if function not in full_names:
            problems.append(f"{function} is nowhere: the test looks for nothing")
        if function in names:
            problems.append(f"{name}: {function} is linked")
    problems += check_edges(probe, work)
    found = answers(probe)
    if ("font of its own" in found) != any("CODING" in option
                                           for option in BUILDS[name][0]):
        problems.append(f"{name}: has fonts {list(found)}")
    for line, answer in found.items():
        if line in missing:
            good = answer[0] == UNSUPPORTED
        elif line == "font of its own":
            good = answer[0] == "0" and answer[2] == "1"
        elif line.startswith("fields") and (line == "fields of its own" or
                                            line.replace("fields", "font", 1)
                                            in missing):
            good = True  # of a font that is not open, or that is new
        else:
            good = answer == full[line]
        if not good:
            problems.append(f"{name}: {line}: {answer}, {full.get(line)}")
    return problems


def check_refused(work):
    """Nothing is left without all codings; tests need outlines."""
    problems = []
    source = work / "none.cpp"
    source.write_text('#include "inkcell/field.hpp"\n')
    result = run(["g++", "-std=c++17", *INCLUDES, "-DINKCELL_SAMPLE_CELLS=0",
                  "-DINKCELL_OUTLINES=0", "-fsyntax-only", source])
    if "one coding must be left" not in result.stdout:
        problems.append(f"no coding compiles: {result.stdout}")
    result = run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", work / "tests",
                  "-DINKCELL_OUTLINES=OFF"])
    if result.returncode == 0 or "INKCELL_OUTLINES" not in result.stdout:
        problems.append(f"tests without outlines configure: {result.stdout}")
    return problems


def main():
    work, probe, fontgen = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    full = answers(probe)
    problems = [f"{line}: {answer}" for line, answer in full.items()
                if not line.startswith("fields") and answer[0] != "0"]
    if full["fields of outlines"] != ["0", "0", UNSUPPORTED]:
        problems.append(f"fields of outlines: {full['fields of outlines']}")
    names = linked(probe)
    for name in BUILDS:
        problems += check_build(name, full, names, fontgen, work)
    problems += check_refused(work)
    finish(len(BUILDS) * len(LINES), problems)


main()
