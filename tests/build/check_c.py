"""Makes the C interface again, and links its examples with a C compiler, and nothing
of C++.

A program of C needs no C++ library: without any library but stand-ins for what
memory moves need, nothing is missing. It has what it calls and nothing else.
Each function of a header is defined, as one of C. States how many bytes of the
interface each example takes on Cortex-M0 at -Os.

Usage: check_c.py WORK_FOLDER BUILD_FOLDER
"""
import re
import shutil

from toolchains import (C_WARNINGS, COMPILERS, INCLUDES, MADE, MAKE_API, ROOT, archives,
                        arguments, c_compiler, call, compile_object, finish,
                        in_parallel, require, run)

EXAMPLES = ROOT / "port/c/examples"

# How each example is called, with a font that is none.
CALLS = {
    "label": "draw_label(rom, 64, \"A\", pixels)",
    "clock": "draw_clock(rom, 64, \"A\", send, 0, &stats)",
    "paragraph": "draw_paragraph(rom, 64, \"A\", pixels)",
    "plot": "draw_plot(rom, 64, \"A\", pixels)",
}

# A program without a C library. Its result is the status of a font that is
# none.
PROGRAM = """
#include "examples.h"
static const uint32_t rom[16] = {1};
static uint8_t pixels[8192];
static inkcell_glyph_cache_stats_t stats;
void send(void* display, const inkcell_strip_t* strip);
void send(void* display, const inkcell_strip_t* strip) {
  pixels[0] = strip->pixels[0];
  (void)display;
}
int run(void);
int run(void) { (void)send; (void)pixels; (void)stats; return CALL; }
"""
MEMORY = """
#include <stddef.h>
void* memcpy(void* to, const void* from, size_t n) {
  for (size_t i = 0; i < n; ++i) ((char*)to)[i] = ((const char*)from)[i];
  return to;
}
void* memmove(void* to, const void* from, size_t n) {
  return to < from ? memcpy(to, from, n) : to;
}
void* memset(void* to, int value, size_t n) {
  for (size_t i = 0; i < n; ++i) ((char*)to)[i] = (char)value;
  return to;
}
int memcmp(const void* a, const void* b, size_t n) {
  for (size_t i = 0; i < n; ++i)
    if (((const char*)a)[i] != ((const char*)b)[i]) return 1;
  return 0;
}
"""

# Functions that an example must not have, and one that it must.
WITHOUT = {
    "label": ["paint_areas", "GlyphStore", "TextBox::", "inkcell_filter_make",
              "Rgb565", "mix_lcd", "Bidi::", "Fit::make"],
    "clock": ["TextBox::", "MonoPages", "inkcell_filter_make", "mix_lcd", "Bidi::"],
    "paragraph": ["paint_areas", "GlyphStore", "Rgb565", "Bidi::", "mix_lcd"],
    "plot": ["paint_areas", "GlyphStore", "TextBox::", "Rgb565", "Grey8"],
}
WITH = {"label": "MonoPages", "clock": "GlyphStore", "paragraph": "TextBox::",
        "plot": "draw_text"}


def files_of(folder):
    """When each file was written, and what it holds."""
    return {path.relative_to(folder): (path.stat().st_mtime_ns, path.read_text())
            for path in folder.rglob("*.*")}


def check_again(work):
    """What is made again is left alone where it is the same. What is not made any
    more is removed, and what others wrote is not."""
    folder = work / "made"
    shutil.copytree(MADE, folder)
    (folder / "src/own.cpp").write_text("// Of somebody else.\n")
    wanted = files_of(folder)
    shutil.copy(folder / "src/font.cpp", folder / "src/gone.cpp")
    shutil.copy(folder / "include/inkcell/c/font.h", folder / "include/inkcell/c/gone.h")
    call(*MAKE_API, folder)
    found = files_of(folder)
    return [f"made again, {name} is not as it was" for name in
            sorted(name for name in wanted.keys() | found.keys()
                   if wanted.get(name) != found.get(name))]


def check_build(build):
    """CMake has made and compiled what the tables make now."""
    problems = [f"{build}/port/c/{name} is not what port/c/make_api.py makes: build "
                "inkcell_port_c" for name, (_, text) in files_of(MADE).items()
                if not (build / "port/c" / name).exists() or
                (build / "port/c" / name).read_text() != text]
    wanted = {f"{path.name}.o" for path in MADE.glob("src/*.cpp")}
    objects = set(call("ar", "t", archives(build)[0]).split())
    return problems + [f"port/c/CMakeLists.txt and make_api.py do not both have {name}"
                       for name in sorted(wanted ^ objects)]


def declared():
    """Functions of the headers."""
    text = "".join(path.read_text()
                   for path in sorted(MADE.glob("include/inkcell/c/*.h")))
    text = re.sub(r"//.*", "", text)
    text = re.sub(r"(?m)^\s*#.*(\\\n.*)*", "", text)
    return set(re.findall(r"\b(inkcell_\w+)\(", text))


def check_functions(library):
    names = run(["nm", "--defined-only", library]).stdout
    defined = set(re.findall(r" T (inkcell_\w+)$", names, re.M))
    wanted = declared()
    if len(wanted) < 80:
        return [f"only {len(wanted)} functions were found in headers"]
    print(f"{len(wanted)} functions")
    return ([f"{name}: declared, not defined" for name in wanted - defined] +
            [f"{name}: defined, not declared" for name in defined - wanted])


def link(example, work, build):
    """An example as a program of C without libraries, and what is wrong."""
    source = work / f"{example}.c"
    source.write_text(PROGRAM.replace("CALL", CALLS[example]))
    memory = work / f"{example}_memory.c"
    memory.write_text(MEMORY)
    program = work / example
    result = run(["gcc", *C_WARNINGS, *INCLUDES, f"-I{EXAMPLES}", "-O2",
                  "-ffreestanding", "-fno-pie", "-ffunction-sections", "-c",
                  source, "-o", f"{source}.o"])
    if result.returncode == 0:
        result = run(["gcc", "-std=c99", "-pedantic", *INCLUDES,
                      f"-I{EXAMPLES}", "-O2", "-ffreestanding", "-fno-pie",
                      "-fno-tree-loop-distribute-patterns",
                      "-fno-stack-protector", "-ffunction-sections",
                      "-nostdlib", "-static", "-no-pie", "-Wl,--gc-sections",
                      "-Wl,-e,run", f"{source}.o", memory,
                      EXAMPLES / f"{example}.c",
                      *archives(build), "-o", program])
    if result.returncode != 0:
        return [f"{example}: {result.stdout}"]
    names = run(["nm", "-C", "--defined-only", program]).stdout
    problems = [f"{example}: {name} is linked" for name in WITHOUT[example]
                if name in names]
    if WITH[example] not in names:
        problems.append(f"{example}: {WITH[example]} is not linked")
    return problems


def compile_layer(source, folder):
    target = folder / (source.stem + ".o")
    return target, compile_object("Cortex-M0", ["-Os"], source, target)


def calls_of(example, folder):
    """Functions of the interface that an example calls on a device."""
    target = folder / f"{example}_example.o"
    result = run([*c_compiler("Cortex-M0"), *C_WARNINGS, *INCLUDES, "-Os",
                  "-ffreestanding", "-c", EXAMPLES / f"{example}.c", "-o",
                  target])
    names = run([COMPILERS["Cortex-M0"][1] + "nm", target]).stdout
    return result, set(re.findall(r" U (inkcell_\w+)$", names, re.M))


def print_sizes(folder):
    """Bytes of the interface for each example, and for all of it."""
    problems, sizes = [], {}
    for target, result in in_parallel(
            compile_layer, [(source, folder) for source in
                            sorted(MADE.glob("src/*.cpp"))]):
        if result.returncode != 0:
            problems.append(result.stdout)
            continue
        names = run([COMPILERS["Cortex-M0"][1] + "nm", "-S", target]).stdout
        for size, name in re.findall(r"^\w+ (\w+) [TR] (inkcell_\w+)$", names,
                                     re.M):
            sizes[name] = int(size, 16)
    for example in CALLS:
        result, calls = calls_of(example, folder)
        if result.returncode != 0 or not calls:
            problems.append(f"{example}: {result.stdout}")
        print(f"{example:10} {len(calls):3} functions, "
              f"{sum(sizes.get(name, 0) for name in calls):5} bytes")
    print(f"{'all':10} {len(sizes):3} functions, {sum(sizes.values()):5} bytes")
    return problems


def main():
    work, build = arguments()
    require(["ar", "gcc", "nm", COMPILERS["Cortex-M0"][0][0]])
    problems = check_again(work) + check_build(build)
    problems += check_functions(archives(build)[0])
    all_names = call("nm", "-C", "--defined-only", *archives(build))
    problems += [f"{name} is nowhere: the test looks for nothing"
                 for name in {*sum(WITHOUT.values(), []), *WITH.values()}
                 if name not in all_names]
    for example in CALLS:
        problems += link(example, work, build)
    problems += print_sizes(work)
    finish(len(CALLS) + 2, problems)


main()
