"""Builds the library without each part that an option leaves out, and draws.

What is left must look as it does with all parts; fonts and records that need
what is missing must be answered with `unsupported`, and no code of it may be
linked. Glyphs look the same in either order.

Usage: check_options.py WORK_FOLDER FULL_PROBE
"""
import pathlib
import shutil
import sys

from toolchains import INCLUDES, ROOT, finish, run

FONTS = [ROOT / "tests/golden/fonts" / f"dejavu_sans{kind}.bin"
         for kind in ("_samples", "")]
# What the probe says, line by line.
LINES = ["record of samples", "record of fields", "font of samples",
         "font of edges"]
UNSUPPORTED = "7"

# Option: what is missing without it, and names of functions that only that
# needs.
OPTIONS = {
    "INKCELL_OUTLINES": (set(), ["paint_distances(", "OutlineReader::"]),
    "INKCELL_SAMPLE_CELLS": ({"record of samples", "font of samples"},
                             ["find_samples", "samples_distance",
                              "paint_samples", "Block::visit_tile"]),
    "INKCELL_EDGE_CELLS": ({"record of fields", "font of edges"},
                            ["find_in_heap", "CellBand::prune_box",
                             "Csg::rounded"]),
    "INKCELL_FAST_CELLS": (set(), ["CellBand::prune_box", "RowValues<"]),
}


def linked(probe):
    """The names of all functions of a program."""
    return run(["nm", "-C", "--defined-only", probe]).stdout


def answers(probe):
    """Status and result of each line that a probe prints."""
    result = run([probe, *FONTS])
    lines = [line.split() for line in result.stdout.splitlines()]
    if result.returncode != 0 or len(lines) != len(LINES):
        finish(0, [f"{probe}: {result.stdout}"])
    return dict(zip(LINES, lines))


def build(option, work):
    """The probe without what an option stands for."""
    folder = work / option
    for command in (
            ["cmake", "-G", "Ninja", "-S", ROOT / "tests/build/options",
             "-B", folder, f"-DINKCELL={ROOT}", f"-D{option}=OFF",
             "-DCMAKE_BUILD_TYPE=MinSizeRel", "-DINKCELL_JOIN_FOLDERS=ON",
             "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror"],
            ["cmake", "--build", folder, "--target", "probe"]):
        result = run(command)
        if result.returncode != 0:
            finish(0, [f"{option}=OFF: {result.stdout}"])
    return folder / "probe"


def check_option(option, full, full_names, work):
    """What is wrong without an option."""
    missing, functions = OPTIONS[option]
    probe = build(option, work)
    names, problems = linked(probe), []
    for function in functions:
        if function not in full_names:
            problems.append(f"{function} is nowhere: the test looks for nothing")
        if function in names:
            problems.append(f"{option}=OFF: {function} is linked")
    for line, answer in answers(probe).items():
        if line in missing and answer[0] != UNSUPPORTED:
            problems.append(f"{option}=OFF: {line}: status {answer[0]}")
        if line not in missing and answer != full[line]:
            problems.append(f"{option}=OFF: {line}: {answer}, not {full[line]}")
    return problems


def check_refused(work):
    """Nothing is left without all codings; tests need all of them."""
    problems = []
    source = work / "none.cpp"
    source.write_text('#include "inkcell/field.hpp"\n')
    result = run(["g++", "-std=c++17", *INCLUDES, "-DINKCELL_EDGE_CELLS=0",
                  "-DINKCELL_SAMPLE_CELLS=0", "-DINKCELL_OUTLINES=0",
                  "-fsyntax-only", source])
    if "one coding must be left" not in result.stdout:
        problems.append(f"no coding compiles: {result.stdout}")
    for option in ("INKCELL_SAMPLE_CELLS", "INKCELL_OUTLINES"):
        result = run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", work / "tests",
                      f"-D{option}=OFF"])
        if result.returncode == 0 or option not in result.stdout:
            problems.append(f"tests without {option} configure: "
                            f"{result.stdout}")
        shutil.rmtree(work / "tests")
    return problems


def main():
    work, probe = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    full = answers(probe)
    problems = [f"{line}: status {answer[0]}"
                for line, answer in full.items() if answer[0] != "0"]
    names = linked(probe)
    for option in OPTIONS:
        problems += check_option(option, full, names, work)
    problems += check_refused(work)
    finish(len(OPTIONS) * len(LINES), problems)


main()
