"""Compiles each public header alone, twice included, with every compiler.

Headers of the C interface are compiled as C99, too.

Usage: check_headers.py WORK_FOLDER
"""
import pathlib
import sys

from toolchains import (C_WARNINGS, COMPILERS, INCLUDES, WARNINGS, c_compiler,
                        c_headers, device_headers, finish, in_parallel,
                        require, run)

# As a device compiles them, and as any other program does.
MODES = {
    "freestanding": {"C++17": ["-ffreestanding", "-fno-exceptions", "-fno-rtti"],
                     "C99": ["-ffreestanding"]},
    "hosted": {"C++17": [], "C99": []},
}



def check(machine, mode, language, sources):
    """What a compiler says of the sources, which it is given all at once: it
    compiles each by itself, and starts in less time."""
    if language == "C99":
        command = [*c_compiler(machine), *C_WARNINGS]
    else:
        command = [*COMPILERS[machine][0], "-std=c++17", *WARNINGS]
    result = run([*command, *MODES[mode][language], *INCLUDES, "-fsyntax-only",
                  *sources])
    return None if result.returncode == 0 else (
        f"{language} ({machine}, {mode}):\n{result.stdout}")


def main():
    work = pathlib.Path(sys.argv[1])
    work.mkdir(parents=True, exist_ok=True)
    require([command[0] for command, _ in COMPILERS.values()])
    jobs, checked = [], 0
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
                    jobs.append((machine, mode, language, sources))
                    checked += len(sources)
    problems = [found for found in in_parallel(check, jobs) if found]
    finish(checked, problems)


main()
