"""Checks the packages: manifests name the project's version, licence and every
source; a clean project builds with each, compiles the libraries that it asks for
and no other, and has the same code, none of it of cells. A program of fields has no
code of outlines.

A project for Cortex-M0 at -Os, in a folder of its own, draws the README's line of
text. It gets Inkcell as a subdirectory, by FetchContent, by find_package() after
an installation, as a list of files, by Make, by Meson and as an Arduino library.
ESP-IDF and Zephyr are played by a few functions of CMake; what SCons would run for
PlatformIO, by a few lines of Python.

Usage: check_packages.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import json
import pathlib
import re
import shutil
import sys

from packages import (arduino, cmake_projects, esp_idf, file_list, make, meson,
                      platformio, zephyr)
from toolchains import LIBRARIES, ROOT, finish, require

# What the routes may differ by: Meson links as C++, with functions of another
# library.
SPREAD = 256  # [bytes]
# The most .text that the README's program may have on Cortex-M0.
MOST_CODE = 11000


def check_manifests():
    """Problems of what the manifests say of version and licence."""
    version = re.search(r"project\(inkcell VERSION ([\d.]+)",
                        (ROOT / "CMakeLists.txt").read_text()).group(1)
    if not (ROOT / "LICENSE").read_text().startswith("MIT License\n"):
        return ["LICENSE is not the MIT License"]
    lines = {
        "idf_component.yml": [f'version: "{version}"', "license: MIT"],
        "library.json": [f'"version": "{version}"', '"license": "MIT"'],
        "meson.build": [f"version: '{version}'", "license: 'MIT'"],
        "port/arduino/library.properties": [f"version={version}"],
    }
    return [f"{file} does not say {line}"
            for file, wanted in lines.items() for line in wanted
            if line not in (ROOT / file).read_text()]


def listed_in_cmake():
    """Sources that the CMake targets have: all others are compared with them."""
    return sorted(
        str(path.parent / name)
        for path in [ROOT / "core/CMakeLists.txt",
                     *(ROOT / f"core/{name}/CMakeLists.txt"
                       for name in LIBRARIES),
                     ROOT / "port/pixel/CMakeLists.txt",
                     ROOT / "port/display/CMakeLists.txt",
                     ROOT / "port/c/CMakeLists.txt"]
        for name in re.findall(r"src/[\w/]+\.cpp", path.read_text()))


def check_code(code, size):
    """Problems of what the README says of its program: bytes of .text on two
    cores, and with constants and font."""
    said = re.search(r"program as built by default: ([\d.]+) KB of `.text` on "
                     r"Cortex-M0 at -Os, ([\d.]+) on Cortex-M3,.*; ([\d.]+) KB "
                     r"on Cortex-M0 with tables and the font",
                     (ROOT / "README.md").read_text())
    problems = [f"README.md: its program has {found} bytes, not {said} KB"
                for said, found in zip(said.groups(), (*code, size))
                if abs(float(said) * 1000 - found) > 100]
    if code[0] > MOST_CODE:
        problems.append(f"the README's program has {code[0]} bytes of .text on "
                        f"Cortex-M0; {MOST_CODE} are allowed")
    return problems


def main():
    work, build, fontgen = (pathlib.Path(word).resolve()
                            for word in sys.argv[1:])
    require(["arm-none-eabi-g++", "cmake", "ninja", "make", "meson"])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    problems = check_manifests()
    sources = listed_in_cmake()
    present = sorted(map(str, [*ROOT.glob("core/src/**/*.cpp"),
                               *(path for name in LIBRARIES for path in
                                 ROOT.glob(f"core/{name}/src/*.cpp")),
                               *ROOT.glob("port/*/src/*.cpp")]))
    # Without LVGL its sources have no sense.
    present = [path for path in present if "/port/lvgl/" not in path]
    if sources != present:
        problems.append(f"CMake lacks {set(present) - set(sources)} or has too "
                        f"much: {set(sources) - set(present)}")
    passed = 2
    for package in (esp_idf, zephyr, platformio):
        found = sorted(package.sources(work / package.__name__, fontgen))
        passed += 1
        if found != sources:
            lacks = sorted(set(sources) - set(found))
            more = sorted(set(found) - set(sources))
            problems.append(f"{package.__name__}: lacks {len(lacks)} sources, "
                            f"{lacks[:3]}; has others, {more[:3]}")
    sizes = {}
    for package in (cmake_projects, file_list, make, meson, arduino):
        for name, size in package.build(work, build, fontgen).items():
            sizes[name] = size
            passed += 1
    cmake_projects.check_fields(work)
    code = cmake_projects.readme_code(work, fontgen)
    problems += check_code(code, sizes["subdirectory"])
    passed += 2
    print(f"README's program: {code[0]} bytes of .text on Cortex-M0, {code[1]} "
          "on Cortex-M3")
    for name, size in sizes.items():
        print(f"{name:14} {size} bytes of code and constants, font included")
    # Sketches have a program of their own.
    same = [size for name, size in sizes.items() if name != "arduino"]
    if max(same) - min(same) > SPREAD:
        problems.append(f"sizes differ: {json.dumps(sizes)}")
    said = re.search(r"takes ([\d.]+) KB of code and constants",
                     (ROOT / "docs/PORTING.md").read_text())
    if abs(float(said.group(1)) * 1000 - sizes["subdirectory"]) > 500:
        problems.append(f"docs/PORTING.md: {said.group(0)}")
    finish(passed, problems)


main()
