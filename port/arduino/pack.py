"""Packs the library as Arduino wants it: all sources below src/, which is its only
include folder.

Usage: pack.py FONT.ttf FONTGEN FOLDER

FOLDER, such as Inkcell, is made; its zip is what "Add .ZIP Library" takes. FONT is
the font of the example, FONTGEN the path of inkcell-fontgen.
"""
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Arduino compiles all that a library has; the linker drops what is not called.
LIBRARIES = ("cache", "field", "kinetic", "layout")
# Folders below the project's, and where their content goes below src/.
FOLDERS = {"core/include": ".", "core/src": ".",
           **{f"core/{name}/include": "." for name in LIBRARIES},
           **{f"core/{name}/src": name for name in LIBRARIES},
           "port/pixel/include": ".", "port/display/include": ".",
           "port/pixel/src": "pixel", "port/display/src": "display",
           "port/c/include": ".", "port/c/src": "c"}


def main():
    font, fontgen, folder = map(pathlib.Path, sys.argv[1:])
    folder.mkdir(parents=True)
    for source, target in FOLDERS.items():
        shutil.copytree(ROOT / source, folder / "src" / target,
                        dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("*.md"))
    shutil.copy(HERE / "Inkcell.h", folder / "src")
    shutil.copy(HERE / "library.properties", folder)
    shutil.copy(ROOT / "LICENSE", folder)
    example = folder / "examples/Hello"
    shutil.copytree(HERE / "Hello", example)
    subprocess.run([fontgen, f"--font={font}", "--symbols=0123456789: ",
                    "--name=digits", "--format=hpp", "--quiet",
                    f"--out={example / 'digits.h'}"], check=True)


main()
