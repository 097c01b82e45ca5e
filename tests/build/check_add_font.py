"""Checks what inkcell_add_font() says to arguments that it does not take, who
waits for its fonts, and whose generator BuildFontgen.cmake builds.

Usage: check_add_font.py
"""
import pathlib
import shutil
import tempfile

from toolchains import ROOT, finish, run

CMAKE = ROOT / "fonts_gen/cmake"
FONT = "FONT font.ttf"
THERE = "FONT CMakeLists.txt"  # a file that is there
# Arguments, and what is said to them; to fonts that are good, nothing.
CASES = [
    (f"app {FONT} CODING Edges", "CODING is outline or field, not Edges"),
    (f"app {FONT} PREDICATE tight", "PREDICATE is size or fixed, not tight"),
    (f"app {FONT} PREDICATE fixed", "PREDICATE fixed is for CODING field"),
    (f"app {FONT} CODING edges", "CODING is outline or field, not edges"),
    (f"app {FONT} CODING outline PREDICATE fixed",
     "PREDICATE fixed is for CODING field"),
    (f"app {FONT} CODING", "not understood: CODING"),
    (f"app {FONT} COLOR red", "not understood: COLOR"),
    (f"app {FONT} CHARS A MAXPX 30", "not understood: MAXPX"),
    (f"app {FONT} CHARACTERS A", "The options are FONT NAME SYMBOLS MIN_PX MAX_PX"),
    (f"app OFF {FONT}", "not understood: OFF"),
    (f"app {FONT} CODING outline", "there is no font file"),
    (f"app {FONT} CODING field PREDICATE fixed", "there is no font file"),
    (f"nope {THERE}", "there is no target nope; add it before its fonts"),
    ("app NAME ui", "there is no FONT <file>"),
    (f'app {THERE} NAME ""', "the value after NAME is empty"),
    (f'app {THERE} SYMBOLS "${{unset}}"', "the value after SYMBOLS is empty"),
    (f"app {THERE} SYMBOLS ${{unset}}", "not understood: SYMBOLS"),
    (f'app {THERE} SYMBOLS ";"', ""),
    (f"app {THERE} PREVIEW a.png BUDGET 24K", ""),
    (f"app {THERE} BEST_EFFORT", ""),
    (f'app {THERE} INSTANCE "Semi Bold" AXIS wdth=90', ""),
    (f"app {THERE} AXIS wdth=90 wght=300..800 CHARS A", ""),
    (f"app {THERE} SET latin-1 greek,cyrillic CHARS 0x2190", ""),
    (f"app {THERE} TEXT words.txt", "not understood: TEXT"),
    (f"app {THERE} STRINGS ui.txt STRINGS_FROM src/**/*.c STRICT "
     "NO_LAYOUT_GLYPHS", ""),
    (f"app {THERE} STRINGS", "not understood: STRINGS"),
    (f"app {THERE} LANGUAGE C STRINGS ui.txt", ""),
    (f"app {THERE} STRIKE 12:1 16:4:vertical", ""),
    (f"app {THERE} STRIKE 12:1 STRIKE_ONLY", ""),
    (f"app {THERE} PAGED 1024", ""),
    (f"app {THERE} PAGED 1000", "PAGED is 512 or 1024 or 2048 or 4096, not 1000"),
    (f"app {THERE} PAGED 1024 LANGUAGE C", "PAGED is for C++"),
    (f"app {THERE} SECTION .fonts.a)\ninkcell_add_font(app {THERE} NAME b "
     "SECTION .fonts.a", "SECTION .fonts.a is that of CMakeLists; in C++"),
    (f"app {THERE} SECTION .fonts LANGUAGE C)\ninkcell_add_font(app {THERE} "
     "NAME b SECTION .fonts LANGUAGE C", ""),
    (f"app {THERE} LANGUAGE Rust", "LANGUAGE is CXX or C, not Rust"),
    (f"app {THERE} MERGE icons.ttf more.ttf=0xF000-0xF8FF", ""),
    (f"app {THERE} SVG a.svg=0xE000 SVG_DIR . SVG_HEIGHT cap", ""),
    ("app NAME ui SVG a.svg=0xE000 SVG_BASELINE bottom", ""),
    ("app SVG_DIR icons", "icons without FONT need a NAME"),
]
# Sources of a generator: these say who had them configured, and by what.
FAKE_GENERATOR = """cmake_minimum_required(VERSION 3.25)
project(fake LANGUAGES NONE)
file(APPEND ${CMAKE_BINARY_DIR}/log "${CMAKE_SOURCE_DIR}:${CMAKE_CXX_COMPILER}\\n")
add_custom_target(inkcell-fontgen)
"""
# A generator that writes its arguments into headers, and a project that uses it.
FAKE_FONTGEN = """#!/bin/sh
for word; do
  case $word in
    --out=*) out=${word#*=}; printf '// %s\\n' "$@" >"$out" ;;
    --depfile=*) echo "$out:" >"${word#*=}" ;;
  esac
done
"""
FONT_PROJECT = """cmake_minimum_required(VERSION 3.25)
project(fonts LANGUAGES CXX)
include(${FONTS}/InkcellFonts.cmake)
add_library(app INTERFACE)
inkcell_add_font(app FONT CMakeLists.txt NAME ui INSTANCE "Semi Bold"
  SECTION .ext_flash.ui MERGE icons.ttf icons.ttf=A "icons.ttf:FILL=1,instance=Semi Bold=0xE000"
    icons.ttf:height=cap)
add_subdirectory(program)
"""


def check_font(folder, arguments, said, package=CMAKE):
    """Problems of a project with this font, of which it says this."""
    lines = ["cmake_minimum_required(VERSION 3.25)",
             "project(fonts LANGUAGES NONE)",
             f'include("{package}/InkcellFonts.cmake")',
             "add_library(app INTERFACE)", f"inkcell_add_font({arguments})"]
    (folder / "CMakeLists.txt").write_text("\n".join(lines) + "\n")
    # A generator of this machine, in PATH, is none of this test's.
    result = run(["cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build",
                  "-DCMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH=OFF",
                  "-DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF",
                  "-DCMAKE_MAKE_PROGRAM=ninja"])
    if said:
        good = result.returncode != 0 and said in " ".join(result.stdout.split())
    else:
        good = result.returncode == 0
    return [] if good else [f"{arguments}: {result.stdout}"]


def check_order(folder):
    """Problems of a program in another directory than the font that it links."""
    (folder / "program").mkdir()
    generator = folder / "generator.sh"
    generator.write_text(FAKE_FONTGEN)
    generator.chmod(0o755)
    (folder / "CMakeLists.txt").write_text(FONT_PROJECT)
    (folder / "program/CMakeLists.txt").write_text(
        "add_executable(program main.cpp)\n"
        "target_link_libraries(program PRIVATE app)\n")
    (folder / "icons.ttf").write_text("")
    (folder / "program/main.cpp").write_text(
        "#include <fonts/ui.hpp>\nint main() { return 0; }\n")
    build = folder / "ordered"
    for command in (["cmake", "-G", "Ninja", "-S", folder, "-B", build,
                     f"-DFONTS={CMAKE}", f"-DINKCELL_FONTGEN={generator}"],
                    ["cmake", "--build", build, "--target", "program"]):
        result = run(command)
        if result.returncode != 0:
            return [f"a program alone: {result.stdout}"]
    header = (build / "inkcell_fonts/app/fonts/ui.hpp").read_text().splitlines()
    return [f"no argument {word}" for word in
            ["--instance=Semi Bold", "--section=.ext_flash.ui",
             f"--merge={folder}/icons.ttf",
             f"--merge={folder}/icons.ttf=A",
             f"--merge={folder}/icons.ttf:FILL=1,instance=Semi Bold=0xE000",
             f"--merge={folder}/icons.ttf:height=cap"]
            if f"// {word}" not in header]


def check_generator(folder):
    """Problems of checkouts and compilers that take turns in one folder."""
    turns = [("one", ""), ("one", ""), ("two", ""), ("two", "g++"),
             ("two", "g++"), ("two", ""), ("one", "")]
    for name in ("one", "two"):
        (folder / name).mkdir()
        (folder / name / "CMakeLists.txt").write_text(FAKE_GENERATOR)
    for name, compiler in turns:
        result = run(["cmake", f"-DSOURCE={folder / name}",
                      f"-DFOLDER={folder / 'shared'}", "-DGENERATOR=Ninja",
                      f"-DCXX={compiler}", "-P", CMAKE / "BuildFontgen.cmake"])
        if result.returncode != 0:
            return [f"generator of {name}: {result.stdout}"]
    configured = [f"{folder / name}:{compiler}"
                  for turn, (name, compiler) in enumerate(turns)
                  if turn == 0 or turns[turn - 1] != (name, compiler)]
    log = (folder / "shared/log").read_text().splitlines()
    return [] if log == configured else [f"generators configured: {log}"]


def main():
    with tempfile.TemporaryDirectory(prefix="inkcell") as name:
        folder = pathlib.Path(name)
        problems = [problem for case in CASES
                    for problem in check_font(folder, *case)]
        # Installed without a generator.
        package = folder / "prefix/lib/cmake/inkcell"
        package.mkdir(parents=True)
        shutil.copy(CMAKE / "InkcellFonts.cmake", package)
        problems += check_font(folder, f"app {THERE}",
                               "there is no inkcell-fontgen; set "
                               "INKCELL_FONTGEN", package)
        problems += check_generator(folder)
        problems += check_order(folder)
    finish(len(CASES) + 3 - len(problems), problems)


main()
