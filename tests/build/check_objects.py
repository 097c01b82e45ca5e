"""Looks into the object files of core and port, for some machines of COMPILERS.

They, and constants.cpp with styles of a program, must hold no writable data
and no constructors, refer to nothing but each other and a few helpers, use no more than a stated stack in one function, and
come from sources that include nothing but <stdint.h>, <stddef.h> and inkcell/.

Usage: check_objects.py WORK_FOLDER MACHINE...
"""
import pathlib
import re
import shutil
import sys

from toolchains import (COMPILERS, MADE, ROOT, WARNINGS,
                        compile_object, device_sources, finish, in_parallel,
                        require, run)
from limits import LIMITS

LEVELS = ["-Os", "-O2"]

# fill_rows() holds a row of a field and loops that are inlined for speed,
# mix_samples() the places of 12 samples, `step` the state of a solver,
# draw_body() seven views of bodies, band_box() a glyph of which only the box is
# wanted.
FRAMES = LIMITS["frames"]
# Functions with limits of their own, on devices and on the host:
WIDE = ("fill_rows", "mix_samples", "draw_cells", "step", "draw_body",
        "band_box", "draw_line", "gap_between")

# Where the caller lends no RAM, the first two hold a glyph, and the next two,
# below them, its points and bands. Then come rows of a picture, and a glyph of a
# TrueType file with all that it takes.
WITHOUT_RAM = ("draw_on_stack", "draw_fitted_on_stack", "draw_narrow",
               "draw_wide", "draw_greys", "draw_on_own_stack")

# What a device's C library or compiler must bring: block moves, and integer
# arithmetic that the core lacks.
ALLOWED = re.compile(
    r"mem(cpy|set|move|cmp)"
    r"|__aeabi_(mem(cpy|set|move|clr)[48]?|[ul]?idiv(mod)?|u?ldivmod|lmul"
    r"|ll?sl|ll?sr|lasr|l?cmp)"
    r"|__(u?div|u?mod|mul|ashl|ashr|lshr|clz|bswap)[sd]i[23]"
    r"|__gnu_thumb1_case_[a-z]+")

# Sections that need RAM, or code before main().
WRITABLE = re.compile(r"\.(data|bss|tdata|tbss|sdata|sbss|init_array|ctors)\b")

INCLUDE = re.compile(r"^\s*#\s*include\s*([<\"][^>\"]+[>\"])", re.M)
LIBRARY_INCLUDE = re.compile(r"<(stdint|stddef)\.h>|\"inkcell/[a-z0-9_/]+\.h(pp)?\"")


def check_includes(source):
    """Files of the device that include what a device may not have."""
    problems = []
    for name in INCLUDE.findall(source.read_text()):
        private = name.startswith('"') and any(
            (folder / name[1:-1]).exists()
            for folder in (source.parent, ROOT / "core/src"))
        if not private and not LIBRARY_INCLUDE.fullmatch(name):
            problems.append(f"{source.relative_to(ROOT)} includes {name}")
    return problems


def compile_source(machine, level, source, folder):
    """Object file of a source, and what the compiler said."""
    room = source.relative_to(ROOT).parts[:-2]
    target = folder / ("-".join(room) + "-" + source.stem + ".o")
    return target, compile_object(
        machine, [*WARNINGS, level, "-fstack-usage"], source,
        target)


def check_stack(usage, machine):
    """Functions of a .su file that use too much, and the most of any."""
    problems, most = [], 0
    where = "host" if machine == "host" else "device"
    for line in usage.read_text().splitlines():
        at, size, kind = line.split("\t")
        name = at.split(":", 3)[-1]
        function = re.search(r"([\w=!]+)\(", name)[1]
        if function in WITHOUT_RAM:
            limit = FRAMES[function]
        else:
            limit = FRAMES[where + ", wide" * (function in WIDE)]
            most = max(most, int(size))
        # "dynamic,bounded": arguments are pushed, the size counts them.
        if int(size) > limit or kind == "dynamic":
            problems.append(f"{usage.stem}: {name}: {size} B of stack, {kind}; "
                            f"at most {limit} (tests/limits.json)")
    return problems, most


def check_sections(prefix, objects):
    """Writable sections that are not empty, and bytes of code of each file."""
    problems, code = [], {path.stem: 0 for path in objects}
    stem = None
    for line in run([prefix + "size", "-A", *objects]).stdout.splitlines():
        if line.endswith(" :"):
            stem = pathlib.Path(line[:-2].rstrip()).stem
            continue
        section = re.match(r"(\.\S+)\s+(\d+)", line)
        if not section:
            continue
        name, size = section[1], int(section[2])
        if WRITABLE.match(name) and size > 0:
            problems.append(f"{stem}: {size} B in {name}")
        if name.startswith((".text", ".rodata")):
            code[stem] += size
    return problems, code


def check_symbols(prefix, objects):
    """Symbols that nobody defines and that are not allowed."""
    defined, wanted = set(), {}
    for line in run([prefix + "nm", "-A", *objects]).stdout.splitlines():
        path, _, symbol = line.rpartition(":")
        kind, name = symbol.split()[-2:]
        if kind == "U":
            wanted.setdefault(name, pathlib.Path(path).stem)
        else:
            defined.add(name)
    return [f"{where}: needs {name}" for name, where in sorted(wanted.items())
            if name not in defined and not ALLOWED.fullmatch(name)]


def check_machine(machine, level, work):
    """All checks of one machine at one level of optimisation."""
    folder = work / (machine + level)
    folder.mkdir(parents=True)
    objects, problems, stack = [], [], 0
    for source in [*device_sources(), ROOT / "tests/build/constants.cpp"]:
        target, result = compile_source(machine, level, source, folder)
        if result.returncode != 0:
            problems.append(result.stdout)
            continue
        objects.append(target)
        too_much, most = check_stack(target.with_suffix(".su"), machine)
        problems += too_much
        stack = max(stack, most)
    prefix = COMPILERS[machine][1]
    in_sections, code = check_sections(prefix, objects)
    problems += in_sections + check_symbols(prefix, objects)
    return machine, level, code, stack, problems


def print_table(results):
    """Bytes of .text and .rodata of each file, a column for each build."""
    names = sorted({name for result in results for name in result[2]})
    heads = [result[0] + " " + result[1] for result in results]
    print("code bytes".ljust(24) + "".join(head.rjust(15) for head in heads))
    for name in names:
        print(name.ljust(24) + "".join(
            str(result[2].get(name, "-")).rjust(15) for result in results))
    print("largest stack frame".ljust(24) + "".join(
        str(result[3]).rjust(15) for result in results))


def main():
    work, machines = pathlib.Path(sys.argv[1]), sys.argv[2:]
    shutil.rmtree(work, ignore_errors=True)
    require([COMPILERS[machine][0][0] for machine in machines])
    sources = device_sources()
    results = in_parallel(check_machine, [(machine, level, work)
                                          for machine in machines
                                          for level in LEVELS])
    problems = [f"{machine} {level}: {problem}"
                for machine, level, _, _, found in results for problem in found]
    # Adapters of HarfBuzz and LVGL include theirs.
    headers = [*ROOT.glob("core/**/*.hpp"),
               *(path for path in ROOT.glob("port/*/*/**/*.hpp")
                 if not {"harfbuzz", "lvgl"} & {*path.parts}),
               *MADE.glob("src/*.hpp")]
    for path in sources + headers:
        problems += check_includes(path)
    print_table(results)
    finish(len(results) * len(sources), problems)


main()
