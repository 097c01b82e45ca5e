"""Compiles each public header alone, twice included, with every compiler.

Usage: check_headers.py WORK_FOLDER
"""
import pathlib
import sys

from toolchains import (COMPILERS, INCLUDES, WARNINGS, device_headers, finish,
                        in_parallel, require, run)

# As a device compiles them, and as any other program does.
MODES = {
    "freestanding": ["-ffreestanding", "-fno-exceptions", "-fno-rtti"],
    "hosted": [],
}


def compile_header(machine, mode, header, source):
    command, _ = COMPILERS[machine]
    result = run([*command, "-std=c++17", *MODES[mode], *WARNINGS, *INCLUDES,
                  "-fsyntax-only", source])
    return None if result.returncode == 0 else (
        f"{header} ({machine}, {mode}):\n{result.stdout}")


def main():
    work = pathlib.Path(sys.argv[1])
    work.mkdir(parents=True, exist_ok=True)
    require([command[0] for command, _ in COMPILERS.values()])
    jobs = []
    for header in device_headers():
        source = work / (header.replace("/", "-") + ".cpp")
        source.write_text(f'#include "{header}"\n#include "{header}"\n')
        for machine in COMPILERS:
            for mode in MODES:
                # Without a C library there are no hosted headers for RV32.
                if (machine, mode) != ("RV32", "hosted"):
                    jobs.append((machine, mode, header, source))
    problems = [found for found in in_parallel(compile_header, jobs) if found]
    finish(len(jobs) - len(problems), problems)


main()
