"""Packs the library as Arduino wants it: all sources below src/, which is its only
include folder. The folder goes to `libraries` of the sketchbook; a repository for
Library Manager has its content at the top.

The examples take fonts of src/fonts/, which has those of a release. To make one:

    inkcell-fontgen --font DejaVuSans.ttf --set latin-1 --name dejavu_sans_latin1 --out dejavu_sans_latin1.hpp
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
LIBRARIES = ("cache", "field", "figures", "layers", "layout", "motion", "shaping",
             "simulation", "stored", "strike", "truetype")
# Folders below the project's, and where their content goes below src/.
FOLDERS = {"core/include": ".", "core/src": ".",
           **{f"core/{name}/include": "." for name in LIBRARIES},
           **{f"core/{name}/src": name for name in LIBRARIES},
           "port/pixel/include": ".", "port/display/include": ".",
           "port/pixel/src": "pixel", "port/display/src": "display"}
# Compiled where a sketch includes <lvgl.h>, and so has its folder.
LVGL = {"port/lvgl/include": ".", "port/lvgl/src": "lvgl"}
# Until the library has one.
NO_PAGE = "https://inkcell.invalid"


def read_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER",
                        help="folder to make, such as Inkcell")
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


def main():
    arguments = read_arguments()
    folder = arguments.folder
    if folder.exists():
        sys.exit(f"{folder} exists: remove it, or name another folder")
    folder.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([sys.executable, "-B", ROOT / "port/c/make_api.py", made],
                       check=True)
        of_c = {f"{made}/include": ".", f"{made}/src": "c"}
        for source, target in {**FOLDERS, **LVGL, **of_c}.items():
            shutil.copytree(ROOT / source, folder / "src" / target,
                            dirs_exist_ok=True,
                            ignore=shutil.ignore_patterns("*.md"))
    for path in (folder / "src/lvgl").glob("*.cpp"):
        path.write_text(f"#if __has_include(<lvgl.h>)\n{path.read_text()}#endif\n")
    shutil.copy(HERE / "InkcellPrint.h", folder / "src")
    (folder / "src/Inkcell.h").write_text(all_headers())
    properties = (HERE / "library.properties").read_text()
    (folder / "library.properties").write_text(
        re.sub("(?m)^url=.*$", f"url={arguments.url}", properties))
    shutil.copy(HERE / "keywords.txt", folder)
    shutil.copy(ROOT / "LICENSE", folder)
    shutil.copytree(HERE / "examples", folder / "examples")
    (folder / "src/fonts").mkdir()
    print(f"Packed {folder}")
    if arguments.url == NO_PAGE:
        print(f"note: url is {NO_PAGE}; Library Manager wants a page that exists: "
              "--url", file=sys.stderr)


main()
