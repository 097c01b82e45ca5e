"""Checks what inkcell_add_font() says to values that it does not take, and
whose generator BuildFontgen.cmake builds.

Usage: check_add_font.py
"""
import pathlib
import tempfile

from toolchains import ROOT, finish, run

CMAKE = ROOT / "fonts_gen/cmake"
FONT = "FONT font.ttf"
CASES = [
    (f"{FONT} CELLS curves", "CELLS is fields or samples, not curves"),
    (f"{FONT} CODING Packed", "CODING is direct or packed, not Packed"),
    (f"{FONT} PREDICATE tight", "PREDICATE is size or fixed, not tight"),
    (f"{FONT} CELLS samples CODING packed", "not for CODING packed"),
    (f"{FONT} PREDICATE fixed", "PREDICATE fixed is for CELLS samples"),
    (f"{FONT} CODING", "not understood: CODING"),
    (f"{FONT} COLOUR red", "not understood: COLOUR"),
    # Good so far: it is the font that is not there.
    (f"{FONT} CELLS fields CODING packed", "there is no font file"),
    (f"{FONT} CELLS samples PREDICATE fixed", "there is no font file"),
]
# Sources of a generator: these say who had them configured, and by what.
FAKE_GENERATOR = """cmake_minimum_required(VERSION 3.25)
project(fake LANGUAGES NONE)
file(APPEND ${CMAKE_BINARY_DIR}/log "${CMAKE_SOURCE_DIR}:${CMAKE_CXX_COMPILER}\\n")
add_custom_target(inkcell-fontgen)
"""


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
    problems = []
    with tempfile.TemporaryDirectory(prefix="inkcell") as folder:
        script = pathlib.Path(folder, "script.cmake")
        for arguments, said in CASES:
            script.write_text(
                "cmake_minimum_required(VERSION 3.25)\n"
                f'include("{CMAKE}/InkcellFonts.cmake")\n'
                f"inkcell_add_font(app {arguments})\n")
            result = run(["cmake", "-P", script])
            if result.returncode == 0 or said not in " ".join(
                    result.stdout.split()):
                problems.append(f"{arguments}: {result.stdout}")
        problems += check_generator(pathlib.Path(folder))
    finish(len(CASES) + 1 - len(problems), problems)


main()
