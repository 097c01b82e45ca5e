"""Builds the complete programs of port/display/examples for Cortex-M0 at -Os, runs
them in QEMU and on the host against models of their displays, and compares their
sizes with tests/limits.json.

Code is .text of the program with libgcc, memcpy() and memset(), without start-up
code; RAM is what is static. Stack is what main() took in QEMU. Both machines, and
programs of C++ and C, must show the same screens. WORK_FOLDER/figures.json holds
the sizes, for the table of docs/DISPLAY.md.

Usage: check_examples.py WORK_FOLDER FONTGEN PROGRAM...
"""
import json
import pathlib
import re

from toolchains import ARM, ROOT, arguments, call, finish, require, run
import limits

EXAMPLES = ROOT / "port/display/examples"
TOOLCHAIN = ROOT / "tests/bench/firmware/toolchain_m0.cmake"
QEMU = ROOT / "boards/common/qemu_run.sh"
# Programs that are linked, not run.
SMALL = ("least_oled.cpp", "least_both.cpp", "least_any.cpp", "least_strike.cpp",
         "thermometer.c", "any_truetype.cpp")
# What strikes beside outlines add to a program's code: of 1 bit, and of any.
MOST_BESIDE = {"least_both.cpp": 1000, "least_any.cpp": 1300}
# The most lines of a program's main() and of the function that it runs.
MOST_LINES = 60


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


def check(program, build, screens, figures):
    """Problems of one program, which the host has run as `program`. `screens` has
    what programs show, `figures` what they take."""
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
    figures[source] = {**sizes_of(build / f"examples/{name}.elf"),
                       "stack": max(stacks)}
    print(f"{source:12} {figures[source]}")
    lines = count_lines(name)
    if lines > MOST_LINES:
        problems.append(f"{source}: run() and main() have {lines} lines; "
                        f"{MOST_LINES} are allowed")
    return problems


def main():
    work, fontgen, *programs = arguments()
    require([ARM + "g++", "cmake", "ninja", "qemu-system-arm"])
    sources = {path.name for path in EXAMPLES.glob("*.c*")} - {"your_board.c"}
    tested = {source_of(path.name.removeprefix("example_"))
              for path in programs}
    problems = [] if tested == sources else [
        f"examples {sorted(sources)}, tests {sorted(tested)}"]
    call("cmake", "-G", "Ninja", "-S", ROOT / "tests/build/examples", "-B", work,
         f"-DCMAKE_TOOLCHAIN_FILE={TOOLCHAIN}", "-DCMAKE_BUILD_TYPE=MinSizeRel",
         f"-DINKCELL_FONTGEN={fontgen}")
    call("cmake", "--build", work, "--target",
         *(program.name for program in programs),
         *(pathlib.Path(source).stem for source in SMALL))
    figures = {source: sizes_of(work / f"{pathlib.Path(source).stem}.elf")
               for source in SMALL}
    for source, most in MOST_BESIDE.items():
        beside = figures[source]["code"] - figures["least_oled.cpp"]["code"]
        print(f"{source}: {beside} bytes of code beside outlines")
        if beside > most:
            problems.append(f"strikes beside outlines take {beside} bytes of code "
                            f"in {source}; {most} are allowed")
    screens = {}
    for program in programs:
        problems += check(program, work, screens, figures)
    problems += limits.exceeded("programs", {
        f"{source}, {what}": size for source, sizes in figures.items()
        for what, size in sizes.items()})
    (work / "figures.json").write_text(json.dumps(figures))
    finish(len(programs) + 1, problems)


main()
