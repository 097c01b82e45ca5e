"""Makes the tables of Unicode properties of core/layout/src.

Reads the Unicode Character Database (Debian: unicode-data) and writes
line_tables.cpp and bidi_tables.cpp into a folder.

Usage: make_tables.py FOLDER [UCD_FOLDER]
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAYOUT = ROOT / "core/layout/src"
END = 0x110000
RUNS_OF_BLOCK = 32
COMMON = 7  # classes that a run names without a byte of their own

# Line breaking describes these, and takes all others for letters: the scripts
# and symbols of U+10000 to U+1EFFF would take 500 bytes more.
LINE_RANGES = [(0x80, 0x10000), (0x1F000, END)]

# Code points without a character that are kept for ideographs: UAX #14, class
# XX; and for currency signs.
IDEOGRAPHS = [(0x3400, 0x4DBF), (0x4E00, 0x9FFF), (0xF900, 0xFAFF),
              (0x1F000, 0x1FAFF), (0x1FC00, 0x1FFFD), (0x20000, 0x2FFFD),
              (0x30000, 0x3FFFD)]
CURRENCY = (0x20A0, 0x20CF)

# Bidi_Class of code points without a character, as DerivedBidiClass.txt names
# it.
BIDI_MISSING = {"Left_To_Right": None, "Right_To_Left": "R",
                "Arabic_Letter": "AL", "European_Terminator": "ET",
                "Boundary_Neutral": "BN"}


class Database:
    """Properties of the Unicode Character Database, by code point."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        first = (self.folder / "LineBreak.txt").read_text().split("\n", 1)[0]
        self.version = re.search(r"LineBreak-([\d.]+)\.txt", first).group(1)

    def entries(self, name):
        """First and last code point and the fields of each line of a file."""
        text = (self.folder / name).read_text(encoding="utf-8")
        for line in text.splitlines():
            fields = [field.strip() for field in line.split("#")[0].split(";")]
            if len(fields) > 1:
                first, _, last = fields[0].partition("..")
                yield int(first, 16), int(last or first, 16), fields[1:]

    def property(self, name, other, value=None):
        """A list of the first field of a file, for each code point."""
        values = [other] * END
        for first, last, fields in self.entries(name):
            if value is None or fields[0] == value:
                values[first:last + 1] = [fields[0]] * (last + 1 - first)
        return values


def is_within(ranges, code_point):
    return any(first <= code_point <= last for first, last in ranges)


def line_classes(data):
    """Rule LB1 for each code point; None where any class will do."""
    categories = data.property("extracted/DerivedGeneralCategory.txt", "Cn")
    widths = data.property("EastAsianWidth.txt", "N")
    pictures = data.property("emoji/emoji-data.txt", "",
                             "Extended_Pictographic")
    classes = data.property("LineBreak.txt", "XX")
    for at, name in enumerate(classes):
        is_empty = categories[at] == "Cn"
        if is_empty and pictures[at]:
            name = "EB"  # LB30b
        elif is_empty and name == "XX":
            name = ("PR" if is_within([CURRENCY], at) else
                    "ID" if is_within(IDEOGRAPHS, at) else None)
        elif name in ("AI", "SG", "XX"):
            name = "AL"
        elif name == "CJ":
            name = "NS"
        elif name == "SA":
            name = "CM" if categories[at] in ("Mn", "Mc") else "AL"
        elif name in ("H2", "H3"):
            name = "H"
        elif name == "OP" and widths[at] in "FWH":
            name = "OPW"
        elif name == "CP" and widths[at] in "FWH":
            sys.exit(f"U+{at:04X}: a wide closing parenthesis is new")
        classes[at] = name
    return classes


def bidi_classes(data):
    """Bidi_Class of each code point; None where any class will do."""
    name = "extracted/DerivedBidiClass.txt"
    classes = data.property(name, "")
    missing = [None] * END
    text = (data.folder / name).read_text(encoding="utf-8")
    for first, last, kept in re.findall(
            r"^# @missing: (\w+)\.\.(\w+); (\w+)", text, re.M):
        for at in range(int(first, 16), int(last, 16) + 1):
            missing[at] = BIDI_MISSING[kept]
    return [known or kept for known, kept in zip(classes, missing)]


def runs_of(classes, first):
    """[start, length, class] of runs from `first` on to the last that counts.

    None takes the class of what stands before it."""
    runs = []
    for at in range(first, END):
        name = classes[at]
        if name is not None and (not runs or runs[-1][1] != name):
            runs.append((at, name))
    end = max(at for at in range(END) if classes[at] is not None) + 1
    starts = [first] + [start for start, _ in runs[1:]] + [end]
    return [(a, b - a, name)
            for a, b, (_, name) in zip(starts, starts[1:], runs)], end


def numbers_of(header):
    """The enumerators of a header of classes, in upper case."""
    text = (LAYOUT / header).read_text()
    body = re.search(r"enum class \w+ : uint8_t {(.*?)};", text, re.S).group(1)
    body = re.sub(r"//.*", "", body)
    names = re.findall(r"(\w+)\s*,", body.upper())
    return {name: number for number, name in enumerate(names)}


def encode(run, common, numbers):
    """The bytes of a run: class_table.hpp."""
    _, length, name = run
    index = common.index(name) if name in common else COMMON
    own = [] if name in common else [numbers[name]]
    if length <= 29:
        return [index << 5 | length - 1, *own]
    if length < 286:
        return [index << 5 | 29, *own, length - 30]
    rest = min(length - 286, 0xFFFF)
    return [index << 5 | 30, *own, rest & 255, rest >> 8]


def split_long(runs):
    """Runs no longer than three bytes can say."""
    for start, length, name in runs:
        while length > 0:
            part = min(length, 286 + 0xFFFF)
            yield start, part, name
            start, length = start + part, length - part


def rows(values, per_row, form):
    lines = []
    for at in range(0, len(values), per_row):
        lines.append("    " + " ".join(form(value) + ","
                                       for value in values[at:at + per_row]))
    return "\n".join(lines)


def class_table(name, classes, first, numbers):
    """C++ of a ClassTable, and its bytes."""
    runs, end = runs_of(classes, first)
    runs = list(split_long(runs))
    names = [run[2] for run in runs]
    common = sorted(sorted(set(names)), key=lambda n: -names.count(n))[:COMMON]
    code, blocks = [], []
    for i, run in enumerate(runs):
        if i % RUNS_OF_BLOCK == 0:
            blocks.append(run[0] << 11 | len(code))
        code += encode(run, common, numbers)
    if len(code) >= 1 << 11:
        sys.exit(f"{name}: {len(code)} bytes of runs, and 2047 are allowed")
    other = numbers["L" if "LRE" in numbers else "AL"]
    size = len(code) + 4 * len(blocks)
    text = f"""constexpr uint8_t k{name}Runs[] = {{
{rows(code, 15, "{}".format)}
}};

constexpr uint32_t k{name}Blocks[] = {{
{rows(blocks, 6, "0x{:08x}".format)}
}};

}}  // namespace

const ClassTable k{name}Classes = {{
    k{name}Runs,
    k{name}Blocks,
    {len(blocks)},
    0x{end:x},
    {{{", ".join(str(numbers[c]) for c in common)}}},
    {other}}};
"""
    return text, size


def mirror_blocks(data):
    """[first, distance, count, kind] of pairs: bidi_tables.hpp."""
    images = {first: int(fields[0], 16)
              for first, _, fields in data.entries("BidiMirroring.txt")}
    brackets = {first: fields[1]
                for first, _, fields in data.entries("BidiBrackets.txt")}
    kinds = {None: 0, "o": 1, "c": 2}
    pairs = sorted((a, b) for a, b in images.items() if a < b)
    if any(images[b] != a for a, b in pairs) or 2 * len(pairs) != len(images):
        sys.exit("mirror images do not come in pairs")
    for first, _, fields in data.entries("BidiBrackets.txt"):
        if images[first] != int(fields[0], 16):
            sys.exit(f"U+{first:04X}: a bracket that is no mirror image")
    blocks = []
    for a, b in pairs:
        kind = kinds[brackets.get(a)]
        for block in blocks:
            first, distance, count, _ = block
            step = 2 if distance == 1 else 1
            room = distance == 1 or count < distance
            if (b - a == distance and kind == block[3] and count < 4
                    and room and a == first + step * count):
                block[2] += 1
                break
        else:
            blocks.append([a, b - a, 1, kind])
    return blocks


def mirror_table(data):
    blocks = mirror_blocks(data)
    entries = []
    for first, distance, count, kind in blocks:
        if first > 0xFFFF or distance >= 1 << 12:
            sys.exit(f"U+{first:04X}: its image is too far away")
        code = distance << 4 | (count - 1) << 2 | kind
        entries.append(f"{{0x{first:04x}, {code}}}")
    return f"""
const MirrorBlock kMirrorBlocks[] = {{
{rows(entries, 4, str)}
}};
const uint32_t kMirrorBlockCount = {len(blocks)};
""", 4 * len(blocks) + 4


def source(header, version, size, text):
    return f"""#include "{header}"

// Generated by host_tools/unicode/make_tables.py from Unicode {version}:
// {size} bytes. Do not edit.
// clang-format off

namespace inkcell::detail {{
{text}
}}  // namespace inkcell::detail
"""


def line_tables(data):
    numbers = numbers_of("line_class.hpp")
    classes = line_classes(data)
    ascii_classes = [numbers[name] for name in classes[:128]]
    described = [name if any(a <= at < b for a, b in LINE_RANGES) else None
                 for at, name in enumerate(classes)]
    # Letters stand between the ranges, and after the last ideographs.
    described[LINE_RANGES[0][1]] = "AL"
    described[IDEOGRAPHS[-1][1] + 1] = "AL"
    table, size = class_table("Line", described, 0x80, numbers)
    return source("line_tables.hpp", data.version, size + 128, f"""
const uint8_t kAsciiLineClasses[128] = {{
{rows(ascii_classes, 16, "{}".format)}
}};

namespace {{

{table}"""), size + 128


def bidi_tables(data):
    numbers = numbers_of("bidi_class.hpp")
    table, size = class_table("Bidi", bidi_classes(data), 0, numbers)
    mirrors, mirror_size = mirror_table(data)
    size += mirror_size
    return source("bidi_tables.hpp", data.version, size,
                  f"namespace {{\n\n{table}{mirrors}"), size


def main():
    folder = pathlib.Path(sys.argv[1])
    data = Database(sys.argv[2] if len(sys.argv) > 2 else "/usr/share/unicode")
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in (("line_tables.cpp", line_tables),
                       ("bidi_tables.cpp", bidi_tables)):
        text, size = make(data)
        (folder / name).write_text(text)
        print(f"{name}: {size} bytes of tables, Unicode {data.version}")


main()
