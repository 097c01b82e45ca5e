"""Packs the library as Arduino wants it: all sources below src/, which is its only
include folder, in a folder and in a zip beside it. "Add .ZIP Library" takes the
zip; a repository for Library Manager has the content of the folder at its top.

The examples get a font of ASCII and the degree sign. Another one for a sketch:

    inkcell-fontgen --font FONT.ttf --name sans --out sans.h
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Arduino compiles all that a library has; the linker drops what is not called.
LIBRARIES = ("cache", "field", "layout", "motion", "simulation", "stored",
             "strike")
# Folders below the project's, and where their content goes below src/.
FOLDERS = {"core/include": ".", "core/src": ".",
           **{f"core/{name}/include": "." for name in LIBRARIES},
           **{f"core/{name}/src": name for name in LIBRARIES},
           "port/pixel/include": ".", "port/display/include": ".",
           "port/pixel/src": "pixel", "port/display/src": "display"}
# Where a sketch draws; the name of its font, and the characters.
FONTS = {"Hello": ("digits", "0123456789: ")}
DEFAULT_FONT = ("sans", "".join(map(chr, range(0x20, 0x7f))) + "\u00b0")
# Until the library has one.
NO_PAGE = "https://inkcell.invalid"


def read_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("font", type=pathlib.Path, metavar="FONT.ttf",
                        help="font of the examples")
    parser.add_argument("fontgen", metavar="FONTGEN",
                        help="path of inkcell-fontgen")
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER",
                        help="folder to make, such as Inkcell; FOLDER.zip too")
    parser.add_argument("--url", default=NO_PAGE,
                        help="page of the library, which Library Manager wants "
                             f"(default: {NO_PAGE})")
    return parser.parse_args()


def all_headers():
    """Inkcell.h, which has everything."""
    headers = sorted(
        str(path.relative_to(ROOT / source)) for source in FOLDERS
        if source.endswith("/include")
        for path in (ROOT / source).rglob("*.hpp"))
    lines = [f'#include "{header}"' for header in headers]
    return "\n".join(["// What a sketch includes: the whole library.",
                      "#pragma once", "", *lines, "",
                      '#include "InkcellPrint.h"', ""])


def add_examples(folder, font, fontgen):
    for example in sorted((HERE / "examples").iterdir()):
        shutil.copytree(example, folder / example.name)
        name, characters = FONTS.get(example.name, DEFAULT_FONT)
        subprocess.run(
            [fontgen, f"--font={font}", f"--symbols={characters}",
             f"--name={name}", "--quiet",
             f"--out={folder / example.name / name}.h"], check=True)


def main():
    arguments = read_arguments()
    folder = arguments.folder
    if folder.exists():
        sys.exit(f"{folder} exists: remove it, or name another folder")
    for path in (arguments.font, shutil.which(arguments.fontgen)):
        if path is None or not pathlib.Path(path).is_file():
            sys.exit(f"{path or arguments.fontgen}: no such file; FONTGEN is the path "
                     "of inkcell-fontgen (docs/BUILD.md, \"Get the generator\")")
    folder.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([sys.executable, "-B", ROOT / "port/c/make_api.py", made],
                       check=True)
        of_c = {f"{made}/include": ".", f"{made}/src": "c"}
        for source, target in {**FOLDERS, **of_c}.items():
            shutil.copytree(ROOT / source, folder / "src" / target,
                            dirs_exist_ok=True,
                            ignore=shutil.ignore_patterns("*.md"))
    shutil.copy(HERE / "InkcellPrint.h", folder / "src")
    (folder / "src/Inkcell.h").write_text(all_headers())
    properties = (HERE / "library.properties").read_text()
    (folder / "library.properties").write_text(
        re.sub("(?m)^url=.*$", f"url={arguments.url}", properties))
    shutil.copy(HERE / "keywords.txt", folder)
    shutil.copy(ROOT / "LICENSE", folder)
    add_examples(folder / "examples", arguments.font, arguments.fontgen)
    archive = shutil.make_archive(str(folder), "zip", folder.parent, folder.name)
    print(f"Packed {folder} and {archive}")
    if arguments.url == NO_PAGE:
        print(f"note: url is {NO_PAGE}; Library Manager wants a page that exists: "
              "--url", file=sys.stderr)


main()
