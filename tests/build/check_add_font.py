"""Checks what inkcell_add_font() says to values that it does not take.

Usage: check_add_font.py
"""
import pathlib
import tempfile

from toolchains import ROOT, finish, run

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


def main():
    problems = []
    with tempfile.TemporaryDirectory(prefix="inkcell") as folder:
        script = pathlib.Path(folder, "script.cmake")
        for arguments, said in CASES:
            script.write_text(
                "cmake_minimum_required(VERSION 3.25)\n"
                f'include("{ROOT}/fonts_gen/cmake/InkcellFonts.cmake")\n'
                f"inkcell_add_font(app {arguments})\n")
            result = run(["cmake", "-P", script])
            if result.returncode == 0 or said not in " ".join(
                    result.stdout.split()):
                problems.append(f"{arguments}: {result.stdout}")
    finish(len(CASES), problems)


main()
