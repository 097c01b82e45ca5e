"""Adds up the stack of calls that lay out text on Cortex-M0.

Follows calls from the functions that a program calls. Drawing and the fitting
of glyphs are left out: they have limits of their own. Calls through pointers
are those of layout to Bidi.

Usage: check_layout_stack.py WORK_FOLDER
"""
import functools
import pathlib
import re
import shutil
import sys

from toolchains import (COMPILERS, DEVICE_FLAGS, INCLUDES, ROOT, WARNINGS,
                        finish, require, run)

# Bytes of the deepest chain, of which the font's kerning takes 200.
LIMIT = 896
LEVELS = ["-Os", "-O2"]
ROOMS = ["base", "font", "layout", "text", "place"]

ENTRIES = ["LineBreaker::next", "next_line", "shorten", "lay_out",
           "Bidi::resolve", "TextBox::lay_out", "TextBox::draw",
           "TextBox::measure", "TextBox::hit", "TextBox::caret",
           "ScrollingLabel::make"]

# What calls through pointers, and a part of the name of what it reaches.
INDIRECT = {
    "prepare": "Bidi&, Text, size_t, BaseDirection",
    "cursor": "Bidi&, Text, size_t, BaseDirection",
    "put": "uint32_t",
    "begin_text": "const Bidi&, size_t, size_t)",
    "next_in_text": "const Bidi&, size_t, size_t, BidiRun&)",
}

# Where drawing begins.
DRAWING = re.compile(r"^(void )?inkcell::draw\(")

NODE = re.compile(r'node: { title: "([^"]+)" label: "([^"\\]+)[^"]*?'
                  r'(?:\\n(\d+) bytes \((\w+)\)[^"]*)?"')
EDGE = re.compile(r'edge: { sourcename: "([^"]+)" targetname: "([^"]+)"')


def compile_all(level, folder):
    """Call graphs of the sources; what compilers said goes to `problems`."""
    compiler, _ = COMPILERS["Cortex-M0"]
    problems = []
    sources = [path for room in ROOMS
               for path in sorted((ROOT / "core/src" / room).glob("*.cpp"))]
    for source in sources:
        target = folder / (source.stem + ".o")
        result = run([*compiler, *DEVICE_FLAGS, *WARNINGS, *INCLUDES, level,
                      "-fcallgraph-info=su", "-c", source, "-o", target])
        if result.returncode != 0:
            problems.append(result.stdout)
    return problems


def read_graph(folder):
    """Names and stack of functions, and what they call, by symbol."""
    names, stack, calls = {}, {}, {}
    for path in folder.glob("*.ci"):
        text = path.read_text()
        for symbol, label, size, _ in NODE.findall(text):
            if size:
                names[symbol] = label
                stack[symbol] = int(size)
        for source, target in EDGE.findall(text):
            calls.setdefault(source, set()).add(target)
    return names, stack, calls


def deepest(entry, names, stack, calls):
    """Bytes of the deepest chain of calls, and its symbols."""
    def reached(symbol):
        targets = calls.get(symbol, set())
        part = INDIRECT.get(short(names[symbol]).split("::")[-1])
        if "__indirect_call" in targets and part:
            found = {s for s, name in names.items()
                     if "<lambda" in name and part in name}
            targets = targets | found
        return [target for target in targets
                if target in stack and not DRAWING.match(names[target])]

    @functools.lru_cache(maxsize=None)
    def below(symbol):
        depth, chain = max([below(target) for target in reached(symbol)],
                           default=(0, ()))
        return depth + stack[symbol], (symbol, *chain)

    return below(entry)


def short(name):
    return re.sub(r"\(.*", "", name).split(" ")[-1].replace("inkcell::", "")


def check_level(level, work):
    folder = work / level
    folder.mkdir(parents=True)
    problems = compile_all(level, folder)
    names, stack, calls = read_graph(folder)
    for entry in ENTRIES:
        found = [symbol for symbol, name in names.items()
                 if re.search(rf"(^| )inkcell::{entry}\(", name)]
        if not found:
            problems.append(f"{entry}: there is no such function")
        for symbol in found:
            depth, chain = deepest(symbol, names, stack, calls)
            path = " > ".join(f"{short(names[s])} {stack[s]}" for s in chain)
            print(f"{level} {depth:4} B: {path}")
            if depth > LIMIT:
                problems.append(f"{level} {entry}: {depth} bytes of stack, "
                                f"{LIMIT} are allowed")
    return problems


def main():
    work = pathlib.Path(sys.argv[1])
    shutil.rmtree(work, ignore_errors=True)
    require([COMPILERS["Cortex-M0"][0][0]])
    problems = [problem for level in LEVELS
                for problem in check_level(level, work)]
    finish(len(ENTRIES) * len(LEVELS), problems)


main()
