"""Adds up the stack of calls that lay out text on Cortex-M0.

Follows calls from the functions that a program calls. Drawing, the fitting of
glyphs and storage are left out: they have limits of their own. Calls through
pointers go to Bidi, as CALLS_BIDI says.

Usage: check_layout_stack.py WORK_FOLDER
"""
import functools
import os
import re

from toolchains import (COMPILERS, DEVICE_FLAGS, INCLUDES, ROOT, WARNINGS, arguments,
                        finish, require, run)
from limits import LIMITS

# Of the deepest chain the font's kerning takes 170 bytes. A box that is drawn
# keeps the line at hand, and the style that a canvas of 1 or 2 bits adapts.
LEVELS = ["-Os", "-O2"]
FOLDERS = ["core/src/base", "core/src/font", "core/src/text", "core/src/place",
           "core/layout/src"]

ENTRIES = ["LineBreaker::next", "next_line", "shorten", "lay_out",
           "Bidi::resolve", "TextBox::lay_out", "TextBox::draw",
           "TextBox::box", "TextBox::measure", "TextBox::hit", "TextBox::caret",
           "ScrollingLabel::make"]

# Members of BidiOrder, in the order of its initializer, and who calls each,
# perhaps in a function that the compiler has put into it.
CALLS_BIDI = {
    "prepare": ["prepare", "find_next_line", "next_line", "next", "shorten",
                "lay_out", "make", "draw", "box", "hit", "caret"],
    "level": ["level", "find_end", "cut_front", "next_cell"],
    "first_run": ["begin_text"],
    "next_run": ["begin_character"],
    "mirrored": ["look_up"],
}
# Who asks a fitter for advances.
CALLS_FITTER = ["has_whole_advances", "advance", "advances", "own_units", "to_units",
                "to_whole_px", "Pen", "RunCursor", "join"]

# Who asks a canvas to adapt a style or draws, and who the pages of a stored font.
CALLS_SINK = ["draw_line", "draw_lines", "place_near", "measure", "lay_out"]
# Who asks for a substitute of a character.
CALLS_REPORT = ["replace"]
CALLS_PAGES = ["find_row", "glyph_of", "kerning"]
# Who asks for words: of a program that names a shaper, whose stack comes on top.
CALLS_WORDS = ["put_word", "next", "continues", "begin_cluster", "begin_character",
               "advance", "lay_out_in", "draw_line", "find_end", "shorten_line", "find",
               "look", "open"]

# Who asks for the face of a span, which FaceSpans names.
CALLS_SPANS = {"find_in_spans": ["find_shown", "find_glyph"]}

# Where drawing begins.
DRAWING = re.compile(r"^inkcell::Painter::")

NODE = re.compile(r'node: { title: "([^"]+)" label: "[^"]*?'
                  r'\\n(\d+) bytes \((\w+)\)[^"]*"')
EDGE = re.compile(r'edge: { sourcename: "([^"]+)" targetname: "([^"]+)"')
LAMBDA = re.compile(r"kBidiOrderMUl.*E(\d?)_4_FUN")


def compile_all(level, folder):
    """Call graphs of the sources; what compilers said goes to `problems`."""
    compiler, _ = COMPILERS["Cortex-M0"]
    problems = []
    # A compiler cache does not keep call graphs.
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    sources = [path for folder in FOLDERS
               for path in sorted((ROOT / folder).glob("*.cpp"))]
    for source in sources:
        target = folder / (source.stem + ".o")
        result = run([*compiler, *DEVICE_FLAGS, *WARNINGS, *INCLUDES,
                      level, "-fcallgraph-info=su", "-c", source,
                      "-o", target],
                     env=environment)
        if result.returncode != 0:
            problems.append(result.stdout)
    return problems


def read_graph(folder):
    """Names and stack of functions, and what they call, by symbol."""
    stack, calls = {}, {}
    for path in folder.glob("*.ci"):
        text = path.read_text()
        for symbol, size, _ in NODE.findall(text):
            stack[symbol] = int(size)
        for source, target in EDGE.findall(text):
            calls.setdefault(source, set()).add(target)
    symbols = list(stack)
    filt = run([COMPILERS["Cortex-M0"][1] + "c++filt",
                *[symbol.rpartition(":")[2] for symbol in symbols]])
    names = dict(zip(symbols, filt.stdout.splitlines()))
    return names, stack, calls


def bidi_functions(names):
    """Symbols of what BidiOrder points to, by its members."""
    found = {}
    for symbol in names:
        match = LAMBDA.search(symbol)
        if match:
            index = int(match[1]) + 1 if match[1] else 0
            found[list(CALLS_BIDI)[index]] = symbol
    return found


class Chains:
    """Deepest chains of calls."""

    def __init__(self, names, stack, calls):
        self.names, self.stack, self.calls = names, stack, calls
        self.bidi = bidi_functions(names)
        self.unknown = set()

    def reached(self, symbol):
        targets = set(self.calls.get(symbol, set()))
        if "__indirect_call" in targets:
            name = short(self.names[symbol])
            members = [member for member, callers in CALLS_BIDI.items()
                       if name in callers]
            spans = [target for target in self.names
                     if name in CALLS_SPANS.get(short(self.names[target]), ())]
            targets |= set(spans)
            if not members and not spans and name not in (CALLS_FITTER + CALLS_SINK + CALLS_REPORT +
                                            CALLS_PAGES + CALLS_WORDS):
                self.unknown.add(name)
            targets |= {self.bidi[member] for member in members}
        return [target for target in targets
                if target in self.stack
                and not DRAWING.match(self.names[target])]

    @functools.lru_cache(maxsize=None)
    def below(self, symbol):
        """Bytes of the deepest chain from a function on, and its symbols."""
        depth, chain = max([self.below(target)
                            for target in self.reached(symbol)],
                           default=(0, ()))
        return depth + self.stack[symbol], (symbol, *chain)


def short(name):
    """The last part of a function's name."""
    name = name.replace("(anonymous namespace)", "")
    return re.sub(r"\(.*", "", name).split("::")[-1]


def check_level(level, work):
    folder = work / level
    folder.mkdir(parents=True)
    problems = compile_all(level, folder)
    names, stack, calls = read_graph(folder)
    chains = Chains(names, stack, calls)
    if len(chains.bidi) != len(CALLS_BIDI):
        problems.append(f"{level}: found {sorted(chains.bidi)} of BidiOrder")
    for entry in ENTRIES:
        found = [symbol for symbol, name in names.items()
                 if name.startswith(f"inkcell::{entry}(")]
        if not found:
            problems.append(f"{entry}: there is no such function")
        for symbol in found:
            depth, chain = chains.below(symbol)
            path = " > ".join(f"{short(names[s])} {stack[s]}" for s in chain)
            print(f"{level} {depth:4} B: {path}")
            # A box that is drawn or measured in pixels keeps the style that a
            # canvas adapts.
            limit = LIMITS["layout"].get(entry, LIMITS["layout"]["others"])
            if depth > limit:
                problems.append(f"{level} {entry}: {depth} bytes of stack, "
                                f"{limit} are allowed")
    problems += [f"{level} {name}: calls through a pointer; say where to"
                 for name in sorted(chains.unknown)]
    return problems


def main():
    work, = arguments()
    require([COMPILERS["Cortex-M0"][0][0]])
    problems = [problem for level in LEVELS
                for problem in check_level(level, work)]
    finish(len(ENTRIES) * len(LEVELS), problems)


main()
