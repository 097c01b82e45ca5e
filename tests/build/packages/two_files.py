"""No build system: a compiler, and the library as two files, as docs/BUILD.md says."""
import sys

from packages.consumer import (COMPILE, LINK, OUTLINES, STRIKE_CANVASES, STRIKES,
                               code_of, size_of, write_sources)
from toolchains import (COMPILERS, DEVICE_FLAGS, ROOT, WARNINGS, c_compiler, call,
                        finish, in_parallel, make_font, run)

IN_C = """#include "inkcell.h"

int main(void) { return inkcell_status_name(INKCELL_OK)[0]; }
"""
# A local name may be that of another source.
STRICT = [flag for flag in WARNINGS if flag != "-Wshadow"]


def compile_all(folder, sources, options):
    """Compiles the sources as C++ and returns their objects."""
    folder.mkdir(parents=True, exist_ok=True)
    objects = [folder / f"{i}.o" for i in range(len(sources))]
    in_parallel(call, [
        ("arm-none-eabi-g++", *COMPILE, *options, "-x", "c++", "-c", source, "-o",
         out) for source, out in zip(sources, objects)])
    return objects


def link(program, objects):
    call("arm-none-eabi-gcc", *LINK, *objects, "-o", program)
    return size_of(program)


def build_strikes(folder, header, options, library, more=None):
    """Bytes of code of the programs of strikes alone that are linked with the library,
    by canvas, and of `more` by name; they must have nothing of outlines."""
    folder.mkdir(parents=True, exist_ok=True)
    programs = {canvas: STRIKES.replace("@HEADER@", header)
                .replace("@CANVAS@", f"{canvas}Canvas")
                for canvas in STRIKE_CANVASES} | (more or {})
    for name, text in programs.items():
        (folder / f"{name}.cpp").write_text(text)
    parts = compile_all(folder, [folder / f"{name}.cpp" for name in programs], options)
    sizes = {}
    for name, part in zip(programs, parts):
        program = folder / name
        link(program, [part, *library])
        symbols = call("arm-none-eabi-nm", "-C", program)
        for symbol in OUTLINES:
            if symbol in symbols:
                finish(0, [f"{program}: {symbol} is linked, which strikes do not "
                           "need"])
        sizes[name] = code_of(program)
    return sizes


def build(work, _, fontgen):
    folder = work / "two_files"
    library = folder / "inkcell"
    write_sources(folder)
    make_font(fontgen, folder / "fonts/dejavu_sans.hpp")
    call(sys.executable, "-B", ROOT / "port/two_files/pack.py", library)
    packed = {path.name: path.read_bytes() for path in library.iterdir()}
    call(sys.executable, "-B", ROOT / "port/two_files/pack.py", library)
    if packed != {path.name: path.read_bytes() for path in library.iterdir()}:
        finish(0, ["two_files: packed twice, the files differ"])
    version = call(fontgen, "--version").split()[1].rstrip(",")
    for name, text in packed.items():
        if not text.startswith(f"// Inkcell {version}:".encode()):
            finish(0, [f"two_files: {name} does not begin with version {version}"])
    # Every compiler takes them, with all warnings.
    in_parallel(call, [
        (*command, *DEVICE_FLAGS, *STRICT, "-Os", "-c", library / "inkcell.cpp",
         *more, "-o", folder / f"{machine}{len(more)}.o")
        for machine, (command, _) in COMPILERS.items()
        for more in ([], ["-DINKCELL_ONLY_STRIKES"])])
    objects = compile_all(folder / "objects",
                          [library / "inkcell.cpp", folder / "main.cpp",
                           folder / "readme.cpp"],
                          [*DEVICE_FLAGS, f"-I{folder}", f"-I{library}"])
    # A program of C, and one of C++ that has no inkcell.h.
    (folder / "in_c.c").write_text(IN_C)
    call(*c_compiler("host"), "-no-pie", f"-I{library}", folder / "in_c.c",
         folder / "host0.o", "-o", folder / "in_c")
    (library / "inkcell.h").unlink()
    without_c = compile_all(folder / "without_c", [library / "inkcell.cpp"],
                            [*DEVICE_FLAGS])
    size = link(folder / "app", objects)
    if link(folder / "app", [*without_c, *objects[1:]]) != size:
        finish(0, ["two_files: the interface for C is linked without a call"])
    only_strikes = [*DEVICE_FLAGS, f"-I{library}", "-DINKCELL_ONLY_STRIKES"]
    strikes = build_strikes(
        folder / "strikes", "inkcell.hpp", only_strikes,
        compile_all(folder / "only_strikes", [library / "inkcell.cpp"],
                    only_strikes))
    said = run(["arm-none-eabi-gcc", *LINK, *objects[1:],
                folder / "only_strikes/0.o", "-o", folder / "refused"])
    if "kOutlineCoding" not in said.stdout or said.returncode == 0:
        finish(0, [f"two_files: only strikes, but outlines are linked: {said.stdout}"])
    return {"two files": size, "two files, strikes": strikes}
