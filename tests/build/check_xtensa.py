"""Compiles the device library for Xtensa by Debian's gcc-xtensa-lx106, links a program
of the core lx106, which is ESP8266's, and runs it in QEMU: it must draw what this
machine draws. The cores of ESP32 differ from it by register windows and more
instructions; their compilers are Espressif's.

The compiler is no package that tests need: the test says whether it was there.

Usage: check_xtensa.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import shutil
import sys

from toolchains import (DEVICE_FLAGS, INCLUDES, LAUNCHER, ROOT, WARNINGS, archives,
                        arguments, call, device_sources, finish, in_parallel,
                        make_font, require, run)

CXX = "xtensa-lx106-elf-g++"
HERE = ROOT / "tests/build/xtensa"


def compile_source(source, target):
    result = run([*LAUNCHER, CXX, "-mlongcalls", "-mtext-section-literals", "-Os",
                  *DEVICE_FLAGS, *WARNINGS, *INCLUDES, f"-I{target.parent}", "-c",
                  source, "-o", target])
    return None if result.returncode == 0 else result.stdout


def main():
    work, build, fontgen = arguments()
    if shutil.which(CXX) is None:
        print(f"skipped: there is no {CXX}; on Debian: apt-get install "
              "gcc-xtensa-lx106")
        sys.exit(77)
    require(["g++", "qemu-system-xtensa"])
    make_font(fontgen, work / "fonts/sans.hpp")
    sources = [*device_sources(), ROOT / "boards/common/memory.cpp",
               *(HERE / name for name in ("draw.cpp", "rom.cpp", "start.S"))]
    objects = [work / f"{i}_{source.stem}.o" for i, source in enumerate(sources)]
    problems = [found for found in
                in_parallel(compile_source, list(zip(sources, objects))) if found]
    if problems:
        finish(len(sources) - len(problems), problems)
    program, here = work / "draw.elf", work / "draw"
    for command in (
            [CXX, "-nostdlib", f"-T{HERE / 'sim.ld'}", "-Wl,--gc-sections",
             *objects, "-lgcc", "-o", program],
            ["g++", "-std=c++17", *INCLUDES, f"-I{work}", HERE / "draw.cpp",
             *archives(build), "-o", here]):
        call(*command)
    drawn = run([here])
    shown = run(["qemu-system-xtensa", "-M", "sim", "-cpu", "lx106", "-semihosting",
                 "-display", "none", "-monitor", "none", "-serial", "none",
                 "-kernel", program], timeout=600)
    sizes = run([CXX.replace("g++", "size"), program]).stdout.splitlines()[1].split()
    print(f"lx106: {len(sources)} sources; a program of {sizes[0]} bytes draws "
          f"{shown.stdout}")
    if drawn.returncode != 0:
        problems.append(f"this machine draws nothing: {drawn.stdout}")
    if (shown.returncode, shown.stdout) != (drawn.returncode, drawn.stdout):
        problems.append(f"it shows {shown.stdout} ({shown.returncode}), this machine "
                        f"{drawn.stdout} ({drawn.returncode})")
    finish(len(sources) + 1, problems)


main()
