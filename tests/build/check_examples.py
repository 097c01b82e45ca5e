"""Builds the complete programs of port/display/examples for Cortex-M0 at -Os, runs
them in QEMU and on the host against models of their displays, and compares their
sizes with the table of docs/PORTING.md.

Code is .text of the program with libgcc, memcpy() and memset(), without start-up
code; RAM is what is static. Stack is what main() took in QEMU. Both machines, and
programs of C++ and C, must show the same screens.

Usage: check_examples.py WORK_FOLDER FONTGEN PROGRAM...
"""
import pathlib
import re
import shutil
import sys

from toolchains import ARM, ROOT, finish, require, run

EXAMPLES = ROOT / "port/display/examples"
TOOLCHAIN = ROOT / "tests/bench/firmware/toolchain_m0.cmake"
QEMU = ROOT / "boards/common/qemu_run.sh"
# The most lines of a program's main() and of the function that it runs.
MOST_LINES = 60
# The most code of the smallest program of 1 bit. [bytes]
MOST_LEAST = 14900
# What the table may be off by. [bytes]
SPREAD = {"code": 100, "constants": 100, "RAM": 50, "stack": 32}


def call(*command):
    """Output of a command that must work."""
    result = run(command)
    if result.returncode != 0:
        finish(0, [" ".join(map(str, command)) + "\n" + result.stdout])
    return result.stdout


def source_of(name):
    """The source of a program: st7789.c of st7789_c."""
    return re.sub("_c$", ".c", name) if name.endswith("_c") else f"{name}.cpp"


def count_lines(name):
    """Lines of run() and main(), which end the program."""
    text = (EXAMPLES / source_of(name)).read_text()
    begin = re.search(r"^static \w+ run\((void)?\) \{", text, re.M)
    return len(text[begin.start():].splitlines())


def sizes_of(program):
    """Bytes of a linked program's sections."""
    output = call(ARM + "size", "-A", program)
    sections = {name: int(size) for name, size in
                re.findall(r"^(\.\S+)\s+(\d+)", output, re.M)}
    return {"code": sections[".text"], "constants": sections[".rodata"],
            "RAM": sections.get(".data", 0) + sections.get(".bss", 0)}


def table():
    """The rows of the table, by the program's name."""
    rows = re.findall(r"^\| `(\w+\.c(?:pp)?)` \|.*\| (\d+) \| (\d+) \| (\d+) "
                      r"\| (\d+) \|$",
                      (ROOT / "docs/PORTING.md").read_text(), re.M)
    return {name: dict(zip(SPREAD, map(int, figures)))
            for name, *figures in rows}


def check(program, build, said, screens):
    """Problems of one program, which the host has run as `program`. `screens` has
    what programs show."""
    name = program.name.removeprefix("example_")
    source = source_of(name)
    host = run([program])
    device = run(["sh", QEMU, "mps2_an385", build / f"example_{name}.elf"])
    problems = [f"{name} ({where}):\n{result.stdout}"
                for where, result in (("host", host), ("Cortex-M0", device))
                if result.returncode != 0]
    stacks = [int(size) for size in
              re.findall(r"^stack (\d+)$", device.stdout, re.M)]
    if problems or not stacks:
        return problems or [f"{name}: no stack in {device.stdout}"]
    if re.sub(r"stack \d+\n", "", device.stdout) != host.stdout:
        problems.append(f"{name}: other screens on Cortex-M0:\n{device.stdout}\n"
                        f"than on the host:\n{host.stdout}")
    shown = screens.setdefault(source.split(".")[0], host.stdout)
    if shown != host.stdout:
        problems.append(f"{source} shows other screens:\n{host.stdout}\nthan in "
                        f"C++:\n{shown}")
    found = {**sizes_of(build / f"examples/{name}.elf"),
             "stack": max(stacks)}
    print(f"{source:12} " + ", ".join(f"{what} {size}"
                                   for what, size in found.items()))
    problems += [f"docs/PORTING.md: {source} takes {found[what]} bytes of "
                 f"{what}, not {said.get(source, {}).get(what)}"
                 for what, spread in SPREAD.items()
                 if abs(said.get(source, {}).get(what, -1000) - found[what]) > spread]
    lines = count_lines(name)
    if lines > MOST_LINES:
        problems.append(f"{source}: run() and main() have {lines} lines; "
                        f"{MOST_LINES} are allowed")
    return problems


def main():
    work, fontgen, *programs = (pathlib.Path(word).resolve()
                                for word in sys.argv[1:])
    require([ARM + "g++", "cmake", "ninja", "qemu-system-arm"])
    shutil.rmtree(work, ignore_errors=True)
    sources = {path.name for path in EXAMPLES.glob("*.c*")} - {"your_board.c"}
    said = table()
    problems = []
    for what, found in (("tests", {source_of(path.name.removeprefix("example_"))
                                   for path in programs}),
                        ("rows in docs/PORTING.md", set(said))):
        if found != sources:
            problems.append(f"examples {sorted(sources)}, {what} {sorted(found)}")
    call("cmake", "-G", "Ninja", "-S", ROOT / "tests/build/examples", "-B", work,
         f"-DCMAKE_TOOLCHAIN_FILE={TOOLCHAIN}", "-DCMAKE_BUILD_TYPE=MinSizeRel",
         f"-DINKCELL_FONTGEN={fontgen}")
    call("cmake", "--build", work, "--target",
         *(program.name for program in programs), "least_oled")
    least = sizes_of(work / "least_oled.elf")
    print("smallest program of 1 bit: " +
          ", ".join(f"{what} {size}" for what, size in least.items()))
    said_least = re.search(r"draws fitted outlines ([\d.]+) KB of code",
                           (ROOT / "README.md").read_text())
    if least["code"] > MOST_LEAST:
        problems.append(f"least_oled.cpp: {least['code']} bytes of code; "
                        f"{MOST_LEAST} are allowed")
    if abs(float(said_least.group(1)) * 1000 - least["code"]) > 100:
        problems.append(f"README.md: {said_least.group(0)}, not {least['code']}")
    screens = {}
    for program in programs:
        problems += check(program, work, said, screens)
    finish(len(programs) + 2, problems)


main()
