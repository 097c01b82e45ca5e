"""Packs the library as two files, inkcell.hpp and inkcell.cpp, and inkcell.h for C:

    python3 port/two_files/pack.py FOLDER

They have all that runs on the device but simulation, in the order in which a
compiler wants it. A program includes inkcell.hpp; inkcell.cpp is compiled as C++17,
and includes nothing but what lies beside it:

    c++ -std=c++17 -Os -ffunction-sections -fdata-sections -c inkcell.cpp

A program whose fonts have strikes alone adds -DINKCELL_ONLY_STRIKES.
The interface for C is compiled where inkcell.h lies beside it.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Rooms that may change at any time stay out.
ROOMS = ("core", "core/cache", "core/field", "core/layout", "core/motion",
         "core/figures", "core/layers", "core/shaping", "core/stored", "core/strike",
         "core/truetype", "port/pixel", "port/display")
INCLUDE = re.compile(r'#include ["<]([\w/.]+)[">]')
HEAD = """// Inkcell {version}: {what}.
// Made by port/two_files/pack.py of the library's sources: edit those instead.
//
"""
OF_C = '#if __has_include("inkcell.h")\n{}#endif  // the interface for C\n'


class Joined:
    """Files one after the other, each behind what it includes, and once."""

    def __init__(self, folders, done=()):
        self.folders = folders
        self.done = set(done)
        self.lines = []

    def find(self, name, path):
        places = (folder / name for folder in (path.parent, *self.folders))
        return next((place for place in places if place.is_file()), None)

    def add(self, path):
        if path in self.done:
            return
        self.done.add(path)
        own = []
        for line in path.read_text().splitlines(keepends=True):
            include = INCLUDE.match(line)
            found = include and self.find(include.group(1), path)
            if found:
                self.add(found)
            elif line != "#pragma once\n":
                own.append(line)
        self.lines += [f"// {'-' * 8} {path.name}\n", *own, "\n"]

    def text(self):
        return re.sub(r"\n{3,}", "\n\n", "".join(self.lines))


def sources_of(folder):
    """Sources; those with weak references first: a reference that comes behind what
    it names is none."""
    paths = sorted(folder.rglob("*.cpp"))
    return sorted(paths, key=lambda path: "((weak))" not in path.read_text())


def pack(made):
    """The texts of the files, by name. `made` has the interface for C."""
    includes = [ROOT / room / "include" for room in ROOMS]
    header = Joined(includes)
    for folder in includes:
        for path in sorted(folder.rglob("*.hpp")):
            header.add(path)
    source = Joined([*includes, *(ROOT / room / "src" for room in ROOMS)],
                    header.done)
    # Canvases name what the core has, and weakly.
    for room in reversed(ROOMS):
        for path in sources_of(ROOT / room / "src"):
            source.add(path)
    c_header = Joined([made / "include"])
    c_header.add(made / "include/inkcell/inkcell.h")
    c_source = Joined([made / "include", *includes, *source.folders],
                      header.done | c_header.done)
    for path in sources_of(made / "src"):
        c_source.add(path)
    version = re.search(r"inkcell VERSION ([\d.]+)",
                        (ROOT / "CMakeLists.txt").read_text()).group(1)
    licence = "".join(f"// {line}".rstrip() + "\n" for line in
                      (ROOT / "LICENSE").read_text().splitlines())

    def head(what):
        return HEAD.format(version=version, what=what) + licence

    return {
        "inkcell.hpp": head("what a program includes") + "#pragma once\n\n" +
                       header.text(),
        "inkcell.cpp": head("what is compiled, once") +
                       '#include "inkcell.hpp"\n\n' + source.text() +
                       OF_C.format('#include "inkcell.h"\n\n' + c_source.text()),
        "inkcell.h": head("what a program of C includes") + "#pragma once\n\n" +
                     c_header.text(),
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER",
                        help="where the files go; others in it stay")
    folder = parser.parse_args().folder
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([sys.executable, "-B", ROOT / "port/c/make_api.py", made],
                       check=True)
        files = pack(pathlib.Path(made))
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text)
        print(f"Packed {folder / name}: {text.count(chr(10))} lines")


main()
