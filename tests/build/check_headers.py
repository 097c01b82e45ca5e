"""Compiles each public header alone, twice included, with every compiler; also
after the macros of other projects, foreign_macros.py. Below C++17 each begins
with an error that names the remedy.

Headers of the C interface are compiled as C99, too, and need no C++17.

Usage: check_headers.py WORK_FOLDER
"""
import re

import foreign_macros
from toolchains import (C_WARNINGS, COMPILERS, INCLUDES, LAUNCHER, WARNINGS,
                        arguments, c_compiler, c_headers, device_headers,
                        finish, in_parallel, require, run)

FREESTANDING = {"C++17": ["-ffreestanding", "-fno-exceptions", "-fno-rtti"],
                "C99": ["-ffreestanding"]}
MACROS = "foreign_macros.h"  # in the work folder
# As a device compiles them, as any other program does, and in a source that has
# the macros of other projects.
MODES = {
    "freestanding": FREESTANDING,
    "hosted": {"C++17": [], "C99": []},
    "after foreign macros": {
        language: [*flags, "-include", MACROS]
        for language, flags in FREESTANDING.items()},
}
# In the compiler's first message.
REMEDY = re.compile(r"error: .*Inkcell needs C\+\+17: .*-std=gnu\+\+17")

def check(machine, mode, language, source):
    """What a compiler says of a source. It makes an object: what a compiler only
    reads, a cache of objects does not know."""
    if language == "C99":
        command = [*c_compiler(machine), *C_WARNINGS]
    else:
        command = [*COMPILERS[machine][0], "-std=c++17", *WARNINGS]
    cast_align = "-Wcast-align" + ("" if "clang" in machine else "=strict")
    target = source.with_suffix(f".{machine}.{mode}.o".replace(" ", "-"))
    result = run([*LAUNCHER, *command, *MODES[mode][language], cast_align,
                  *INCLUDES, "-c", source, "-o", target], cwd=source.parent)
    return None if result.returncode == 0 else (
        f"{language} ({machine}, {mode}):\n{result.stdout}")


def check_old(source):
    """A header must refuse C++14 before it says anything else, those for C serve
    C++11."""
    is_c = source.name.removesuffix(".cpp").endswith(".h")
    result = run(["g++", f"-std=gnu++{11 if is_c else 14}", *INCLUDES,
                  "-fsyntax-only", source])
    first = re.search(r"^.*error: .*$", result.stdout, re.M)
    is_good = first is None if is_c else first and REMEDY.search(first.group())
    return None if is_good else (
        f"{source.stem} in an old standard begins with:\n{result.stdout[:500]}")


def main():
    work, = arguments()
    foreign_macros.write(work / MACROS)
    require([command[0] for command, _ in COMPILERS.values()])
    jobs = []
    for language, ending, headers in (
            ("C++17", ".cpp", device_headers() + c_headers()),
            ("C99", ".c", c_headers())):
        sources = []
        for header in headers:
            source = work / (header.replace("/", "-") + ending)
            source.write_text(f'#include "{header}"\n#include "{header}"\n')
            sources.append(source)
        for machine in COMPILERS:
            for mode in MODES:
                # Without a C library there are no hosted headers for RV32.
                if (machine, mode) != ("RV32", "hosted"):
                    jobs += [(machine, mode, language, source)
                             for source in sources]
        if language == "C++17":
            old = [(source,) for source in sources]
    problems = [found for found in
                in_parallel(check, jobs) + in_parallel(check_old, old) if found]
    finish(len(jobs) + len(old), problems)


main()
