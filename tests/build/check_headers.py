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
    "freestanding": ["-ffreestanding", "-fno-exceptions", "-fno-rtti"],
    "hosted": [],
}


def compile_header(machine, mode, header, source):
    command, _ = COMPILERS[machine]
    result = run([*command, "-std=c++17", *MODES[mode], *WARNINGS, *INCLUDES,
                  "-fsyntax-only", source])
    return None if result.returncode == 0 else (
        f"{header} ({machine}, {mode}):\n{result.stdout}")


def compile_c_header(machine, mode, header, source):
    result = run([*c_compiler(machine), *C_WARNINGS, *INCLUDES,
                  *(["-ffreestanding"] if mode == "freestanding" else []),
                  "-fsyntax-only", source])
    return None if result.returncode == 0 else (
        f"{header} as C99 ({machine}, {mode}):\n{result.stdout}")


def main():
    work = pathlib.Path(sys.argv[1])
    work.mkdir(parents=True, exist_ok=True)
    require([command[0] for command, _ in COMPILERS.values()])
    jobs = []
    for compile_one, ending, headers in (
            (compile_header, ".cpp", device_headers() + c_headers()),
            (compile_c_header, ".c", c_headers())):
        for header in headers:
            source = work / (header.replace("/", "-") + ending)
            source.write_text(f'#include "{header}"\n#include "{header}"\n')
            for machine in COMPILERS:
                for mode in MODES:
                    # Without a C library there are no hosted headers for RV32.
                    if (machine, mode) != ("RV32", "hosted"):
                        jobs.append((compile_one, machine, mode, header, source))
    problems = [found for found in in_parallel(
        lambda compile_one, *job: compile_one(*job), jobs) if found]
    finish(len(jobs) - len(problems), problems)


main()
