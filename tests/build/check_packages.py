"""Checks the packages: manifests name every source; a clean project builds with each,
compiles the libraries that it asks for and no other, and has the same code, none of it
of cells. A program of fields has no code of outlines.

A project for Cortex-M0 at -Os, in a folder of its own, draws the README's line of
text. It gets Inkcell as a subdirectory, by FetchContent, by find_package() after
an installation, as two files, by Make, by Meson and as an Arduino library.
ESP-IDF and Zephyr are played by a few functions of CMake; what SCons would run for
PlatformIO, by a few lines of Python. WORK_FOLDER/figures.json has the sizes.

Usage: check_packages.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import json
import re

from packages import (arduino, cmake_projects, esp_idf, make, meson,
                      platformio, two_files, zephyr)
from toolchains import LIBRARIES, MADE, ROOT, arguments, finish, require
import limits

# What the routes may differ by: Meson links as C++, with functions of another
# library; in two files the compiler shares what one program calls once.
SPREAD = 0.02


def listed_in_cmake():
    """Sources that the CMake targets have: all others are compared with them. Those
    that are compiled ALONE are named twice."""
    return sorted({
        str(path.parent / name)
        for path in [ROOT / "core/CMakeLists.txt",
                     *(ROOT / f"core/{name}/CMakeLists.txt"
                       for name in LIBRARIES),
                     ROOT / "port/pixel/CMakeLists.txt",
                     ROOT / "port/display/CMakeLists.txt",
                     ROOT / "port/lvgl/CMakeLists.txt"]
        for name in re.findall(r"src/[\w/]+\.cpp", path.read_text())})


def main():
    work, build, fontgen = arguments()
    require(["arm-none-eabi-g++", "cmake", "ninja", "make", "meson"])
    problems = []
    sources = listed_in_cmake()
    present = sorted(map(str, [*ROOT.glob("core/src/**/*.cpp"),
                               *(path for name in LIBRARIES for path in
                                 ROOT.glob(f"core/{name}/src/*.cpp")),
                               *ROOT.glob("port/*/src/*.cpp")]))
    # The interface for C is made by each system in a folder of its own. Without
    # HarfBuzz its adapter has no sense.
    present = [path for path in present if "/port/harfbuzz/" not in path]
    if sources != present:
        problems.append(f"CMake lacks {set(present) - set(sources)} or has too "
                        f"much: {set(sources) - set(present)}")
    sources = sorted([*sources, *map(str, MADE.glob("src/*.cpp"))])
    passed = 1
    for package in (esp_idf, zephyr, platformio):
        found = sorted(re.sub(".*/port/c/(?=src/)", f"{MADE}/", path)
                       .replace("/build/port/lvgl/", "/port/lvgl/") for path in
                       package.sources(work / package.__name__, fontgen))
        passed += 1
        if found != sources:
            lacks = sorted(set(sources) - set(found))
            more = sorted(set(found) - set(sources))
            problems.append(f"{package.__name__}: lacks {len(lacks)} sources, "
                            f"{lacks[:3]}; has others, {more[:3]}")
    sizes = {}
    for package in (cmake_projects, two_files, make, meson, arduino):
        for name, size in package.build(work, build, fontgen).items():
            sizes[name] = size
            passed += 1
    # Of strikes alone: nothing of outlines, wherever the library's objects come from.
    strikes = {f"{canvas}, {name}": size
               for name in ("two files", "arduino")
               for canvas, size in sizes.pop(f"{name}, strikes").items()}
    print(f"strikes alone: {strikes}")
    problems += limits.exceeded("strikes", strikes)
    cmake_projects.check_fields(work)
    code = cmake_projects.readme_code(work, fontgen)
    figures = {"text, Cortex-M0": code[0], "text, Cortex-M3": code[1],
               "all, Cortex-M0": sizes["subdirectory"]}
    problems += limits.exceeded("readme", figures)
    (work / "figures.json").write_text(json.dumps(figures))
    passed += 1
    print(f"README's program: {figures}")
    for name, size in sizes.items():
        print(f"{name:14} {size} bytes of code and constants, font included")
    # Sketches have a program of their own.
    same = [size for name, size in sizes.items() if name != "arduino"]
    if max(same) > (1 + SPREAD) * min(same):
        problems.append(f"sizes differ: {json.dumps(sizes)}")
    finish(passed, problems)


main()
