"""Compiles the sources of the generator, folder by folder, with compilers beside the
one of the build: the newest clang that is installed, and mingw-w64 for Windows,
where threads are POSIX's. Without its libraries nothing is linked for Windows.

mingw-w64 is no package that tests need: the test says whether it was there.

Usage: check_generator.py WORK_FOLDER
"""
import os
import pathlib
import re
import shutil
import sys

from toolchains import ROOT, finish, in_parallel, require, run

SOURCES = ROOT / "fonts_gen/src"
# Headers of libraries, and where Debian has them.
HEADERS = ("CLI", "fribidi", "freetype2", "harfbuzz", "nlohmann", "png.h",
           "pngconf.h", "polyclipping", "pugiconfig.hpp", "pugixml.hpp",
           "zconf.h", "zlib.h")
PLACES = ("/usr/include", "/usr/include/x86_64-linux-gnu")
MINGW = "x86_64-w64-mingw32-g++-posix"


def newest_clang():
    """The clang++ with the highest version in PATH."""
    found = [path for folder in os.environ["PATH"].split(":")
             for path in pathlib.Path(folder).glob("clang++-*")
             if re.fullmatch(r"clang\+\+-\d+", path.name)]
    return max(found, key=lambda path: int(path.name.split("-")[1]),
               default=shutil.which("clang++"))


def join_sources(work):
    """A source for each folder, which includes those of the folder."""
    joined = []
    for folder in sorted({path.parent for path in SOURCES.rglob("*.cpp")}):
        source = work / f"{folder.name}.cpp"
        source.write_text("".join(f'#include "{path}"\n'
                                  for path in sorted(folder.glob("*.cpp"))))
        joined.append(source)
    return joined


def link_headers(work):
    """An include folder with headers of libraries and none of the system's."""
    folder = work / "include"
    folder.mkdir()
    for name in HEADERS:
        for place in PLACES:
            path = pathlib.Path(place) / name
            if path.exists() and not (folder / name).exists():
                (folder / name).symlink_to(path)
    return folder


def check(name, command, source, includes):
    result = run([*command, "-std=c++17", "-Wall", "-Wextra", "-Werror",
                  "-fsyntax-only", *includes, source])
    return None if result.returncode == 0 else (
        f"{name}, {source.stem}:\n{result.stdout[:2000]}")


def main():
    work = pathlib.Path(sys.argv[1])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    require(["clang++"])
    headers = link_headers(work)
    own = [f"-I{path}" for path in
           (SOURCES, ROOT / "fonts_gen/program", ROOT / "core/include",
            ROOT / "core/src", ROOT / "core/field/include",
            ROOT / "core/field/src", ROOT / "core/stored/include")]
    libraries = ["-isystem", headers]
    for name in ("freetype2", "harfbuzz", "fribidi"):
        libraries += ["-isystem", headers / name]
    sources = join_sources(work)
    clang = newest_clang()
    compilers = {pathlib.Path(clang).name: [clang]}
    if shutil.which(MINGW) is None:
        print(f"not for Windows: there is no {MINGW}; on Debian: apt-get install "
              "g++-mingw-w64-x86-64-posix")
    else:
        compilers[MINGW] = [MINGW, "-D__USE_MINGW_ANSI_STDIO=1"]
    print("compilers: " + ", ".join(compilers))
    jobs = [(name, command, source, own + libraries)
            for name, command in compilers.items() for source in sources]
    problems = [found for found in in_parallel(check, jobs) if found]
    finish(len(jobs) - len(problems), problems)


main()
