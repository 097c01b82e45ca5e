"""Checks the module of MicroPython.

It is compiled against played headers. Where INKCELL_MICROPYTHON_DIR names
MicroPython's sources, the unix port is built with it, too, and a script draws into
buffers of framebuf, which must equal those of the interface for C.

Usage: check_micropython.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import os
import pathlib
import re

from toolchains import C_WARNINGS, FONT, MADE, ROOT, archives, arguments, finish, run

MODULE = ROOT / "port/micropython/inkcell/inkcell_module.c"
HERE = ROOT / "tests/build/micropython"
# Parts of the unix port that need more than its own sources.
WITHOUT = ["MICROPY_PY_BTREE=0", "MICROPY_PY_SSL=0", "MICROPY_SSL_MBEDTLS=0",
           "MICROPY_PY_FFI=0", "MICROPY_PY_THREAD=0", "MICROPY_PY_SOCKET=0",
           "FROZEN_MANIFEST="]
# What draw.py must say, but for its counts of pixels.
SAID = ["inkcell: font: bad_magic", "inkcell: buffer: buffer_small",
        "inkcell: format: unsupported", "inkcell: size: bad_argument",
        "inkcell: x: bad_argument", "inkcell: font: read_failed", "TrueType", "color True",
        "lines ['21 22', '23', '24 25'] True", "below 24 24 True True",
        "wrap(text, width, size", "see help(inkcell.Font)"]
UNSAID = ["no error", "ends beyond"]


def check_played(work):
    names = sorted(set(re.findall(r"MP_QSTR_\w+", MODULE.read_text())))
    (work / "qstrs.h").write_text("enum { " + ", ".join(names) + " };\n")
    result = run(["gcc", *C_WARNINGS, "-Wno-pedantic", "-fsyntax-only",
                  f"-I{work}", f"-I{HERE / 'played'}",
                  f"-I{MADE / 'include'}", MODULE])
    return [result.stdout] if result.returncode != 0 else []


def check_real(sources, work, build, fontgen):
    """Problems of a MicroPython with the module."""
    program = work / "build/micropython"
    expected = work / "expected"
    font = work / "dejavu_sans_latin1.bin"
    for command in (
            ["make", "-C", sources / "ports/unix", f"-j{os.cpu_count()}",
             "VARIANT=standard", *WITHOUT, f"BUILD={work / 'build'}",
             f"USER_C_MODULES={ROOT / 'port/micropython'}"],
            [fontgen, f"--font={FONT}", "--symbols=0123456789.\u00b0CA ",
             "--name=sans", "--format=bin", "--quiet", f"--out={font}"],
            ["gcc", "-std=c99", f"-I{MADE / 'include'}",
             HERE / "expected.c", *archives(build), "-o", expected],
            [expected, font, work / "wanted"]):
        result = run(command)
        if result.returncode != 0:
            return [" ".join(map(str, command)) + "\n" + result.stdout[-3000:]]
    for example in ("example.py", "oled.py"):
        shown = run([program, ROOT / "port/micropython" / example], cwd=work,
                    env={**os.environ, "MICROPYPATH": str(HERE / "played")})
        if shown.returncode != 0:
            return [f"{example}: {shown.stdout}"]
    if int((re.search(r"ink (\d+)", shown.stdout) or [0, 0])[1]) < 200:
        return [f"oled.py: {shown.stdout}"]
    drawn = run([program, HERE / "draw.py", font, work / "drawn"])
    print(drawn.stdout, end="")
    problems = [f"draw.py does not say {words}" for words in SAID
                if words not in drawn.stdout]
    problems += [f"draw.py says {words}" for words in UNSAID
                 if words in drawn.stdout]
    if not re.search(r"^moved \{\d+\}$", drawn.stdout, re.M):
        problems.append("fonts at other addresses differ")
    counts = re.findall(r"^(\w+) (\d+)$", drawn.stdout, re.M)
    if len(counts) != 6 or any(int(count) < 100 for _, count in counts):
        problems.append(f"draw.py: {drawn.stdout}")
    elif (work / "drawn").read_bytes() != (work / "wanted").read_bytes():
        problems.append("MicroPython draws something else than C")
    return problems


def main():
    work, build, fontgen = arguments()
    problems = check_played(work)
    given = os.environ.get("INKCELL_MICROPYTHON_DIR")
    if given is None:
        print("MicroPython: played (INKCELL_MICROPYTHON_DIR names its sources)")
        finish(1, problems)
    print(f"MicroPython: {given}")
    problems += check_real(pathlib.Path(given), work, build, fontgen)
    finish(2, problems)


if __name__ == "__main__":
    main()
