"""Compiles the device library for Xtensa by Debian's gcc-xtensa-lx106, links a program
of the core lx106, which is ESP8266's, and runs it in QEMU: it must draw what this
machine draws. The cores of ESP32 differ from it by register windows and more
instructions; their compilers are Espressif's.

The compiler is no package that tests need: the test says whether it was there.

Usage: check_xtensa.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import pathlib
import shutil
import sys

from toolchains import (DEVICE_FLAGS, INCLUDES, LAUNCHER, ROOT, WARNINGS,
                        device_sources, finish, in_parallel, require, run)

CXX = "xtensa-lx106-elf-g++"
HERE = ROOT / "tests/build/xtensa"
LIBRARIES = ["port/pixel/libinkcell_port_pixel.a", "core/layout/libinkcell_layout.a",
             "core/motion/libinkcell_motion.a", "core/libinkcell_core.a"]
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def compile_source(source, target):
    result = run([*LAUNCHER, CXX, "-mlongcalls", "-mtext-section-literals", "-Os",
                  *DEVICE_FLAGS, *WARNINGS, *INCLUDES, f"-I{target.parent}", "-c",
                  source, "-o", target])
    return None if result.returncode == 0 else result.stdout


def main():
    work, build, fontgen = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    if shutil.which(CXX) is None:
        print(f"skipped: there is no {CXX}; on Debian: apt-get install "
              "gcc-xtensa-lx106")
        sys.exit(77)
    require(["g++", "qemu-system-xtensa"])
    shutil.rmtree(work, ignore_errors=True)
    (work / "fonts").mkdir(parents=True)
    made = run([fontgen, f"--font={FONT}", "--chars=0x20-0x7E", "--name=sans",
                "--quiet", f"--out={work / 'fonts/sans.hpp'}"])
    if made.returncode != 0:
        finish(0, [made.stdout])
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
             *(build / library for library in LIBRARIES), "-o", here]):
        result = run(command)
        if result.returncode != 0:
            finish(len(sources), [result.stdout[-3000:]])
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
