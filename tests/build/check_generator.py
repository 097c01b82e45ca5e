"""Compiles the sources of the generator, folder by folder, with compilers beside the
one of the build: the newest clang that is installed, and mingw-w64 for Windows,
where threads are POSIX's.

Where INKCELL_WINDOWS_DIR names the folder of `sh fonts_gen/web/build.sh --windows`,
its program is brought up to date and, if Wine is there, makes a font, whose bytes
must be those of this machine's generator.

mingw-w64 and Wine are no packages that tests need: the test says what was there.

Usage: check_generator.py WORK_FOLDER FONTGEN
"""
import os
import pathlib
import re
import shutil

from toolchains import FONT, ROOT, arguments, finish, in_parallel, require, run

SOURCES = ROOT / "fonts_gen/src"
# Headers of libraries, and where Debian has them.
HEADERS = ("CLI", "fribidi", "freetype2", "harfbuzz", "nlohmann", "png.h",
           "pngconf.h", "polyclipping", "pugiconfig.hpp", "pugixml.hpp",
           "zconf.h", "zlib.h")
PLACES = ("/usr/include", "/usr/include/x86_64-linux-gnu")
MINGW = "x86_64-w64-mingw32-g++-posix"
WINE = "wine"


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


def check_windows(work, fontgen):
    """Problems of the program for Windows, and how many checks there were."""
    folder = os.environ.get("INKCELL_WINDOWS_DIR")
    if folder is None:
        print("for Windows: compiled, not linked: INKCELL_WINDOWS_DIR names no folder "
              "of `sh fonts_gen/web/build.sh --windows`")
        return [], 0
    built = run(["cmake", "--build", pathlib.Path(folder) / "windows", "--target",
                 "inkcell-fontgen"])
    if built.returncode != 0:
        return [built.stdout[-2000:]], 1
    if shutil.which(WINE) is None:
        print("for Windows: linked, not run: there is no wine")
        return [], 1
    fonts = []
    for name, command in (("windows", [WINE, pathlib.Path(folder) /
                                       "windows/inkcell-fontgen.exe"]),
                          ("here", [fontgen])):
        said = run([*command, f"--font={FONT}", "--chars=0x20-0x7E", "--format=bin",
                    "--quiet", f"--out={name}.bin"], cwd=work,
                   env={**os.environ, "WINEDEBUG": "-all",
                        "WINEPREFIX": str(work / "wine")})
        if said.returncode != 0:
            return [f"{name}: {said.stdout}"], 1
        fonts.append((work / f"{name}.bin").read_bytes())
    print(f"for Windows: linked, and by Wine it made a font of {len(fonts[0])} bytes")
    return (["the font that was made for Windows differs"]
            if fonts[0] != fonts[1] else []), 2


def main():
    work, fontgen = arguments()
    require(["clang++"])
    headers = link_headers(work)
    own = [f"-I{path}" for path in
           (SOURCES, ROOT / "fonts_gen/program", ROOT / "core/include",
            ROOT / "core/src", ROOT / "core/field/include",
            ROOT / "core/field/src", ROOT / "core/layers/include",
            ROOT / "core/shaping/include", ROOT / "core/stored/include",
            ROOT / "core/strike/include")]
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
    more, count = check_windows(work, fontgen) if MINGW in compilers else ([], 0)
    finish(len(jobs) + count - len(problems + more), problems + more)


main()
