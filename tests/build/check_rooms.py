"""Checks the rooms of core and fonts_gen: the folders of their sources.

Each library of core is one room over core/src. It may use core's public headers,
its own, and what LIBRARIES names: rooms, and public headers of other libraries.

A room uses the rooms that the tables below name, which stand before it, and no
others. It has a README of three lines, the first of which is its promise. A
source belongs to the header of its name. Files of core stay short, and hold few
passages twice.

Usage: check_rooms.py
"""
import collections
import re

from toolchains import ROOT, finish

# Rooms of core/src from the lowest to the highest, and those that each may use
# besides the public headers, `base` and itself.
CORE = {
    "base": "",
    "sink": "",
    "font": "",
    "place": "",
    "outlines": "font place",
    "rows": "outlines place",
    "effects": "place rows",
    "fit": "",
    "text": "place outlines rows",
    "verify": "font outlines",
}

# Folders of core that are libraries, and what each may use: rooms of core/src, and
# public headers of libraries that stand before it (inkcell/motion).
LIBRARIES = {
    "cache": "base rows text",
    "field": "base place outlines rows",
    "layout": "text",
    "motion": "base place outlines rows",
    "figures": "base place rows inkcell/motion",
    "layers": "base text inkcell/motion",
    "shaping": "base text",
    "simulation": "base inkcell/motion",
    "stored": "base font place outlines rows",
    "strike": "base font place rows",
    "truetype": "base place outlines rows",
}

# Folders of public headers, likewise.
PUBLIC = {
    "inkcell": "",
    "inkcell/format": "inkcell",
}

# Rooms of fonts_gen/src. They use the headers of the device's library, too.
GENERATOR = {
    "base": "",
    "shape": "",
    "svg": "shape",
    "source": "shape svg",
    "texts": "source",
    "target": "shape",
    "field": "shape target",
    "outlines": "shape source",
    "hints": "shape",
    "morph": "base shape",
    "shaping": "source",
    "rom": "shape source target field outlines hints",
    "judge": "shape source target field outlines hints rom",
    "pipeline": "shape source texts target field outlines hints morph shaping rom "
                "judge",
    "app": "source target pipeline",
}

# Sources of core that are a part of another header, linked apart.
OF_OTHER_HEADERS = {
    "core/src/effects/level_rules.cpp": "inkcell/few_levels.hpp",
    "core/src/font/code_points.cpp": "inkcell/font.hpp",
    "core/src/rows/area_painter.cpp": "rows/band.hpp",
    "core/src/rows/cover_areas.cpp": "rows/band.hpp",
    "core/src/rows/distance_painter.cpp": "rows/band.hpp",
    "core/layout/src/shorten.cpp": "next_line.hpp",
    "core/src/rows/draw_bands.cpp": "rows/source.hpp",
    "core/src/rows/edge_rows.cpp": "rows/band.hpp",
    "core/src/rows/emit_band.cpp": "rows/band.hpp",
    "core/src/rows/outline_fit.cpp": "rows/outline_source.hpp",
    "core/src/rows/wide_painter.cpp": "rows/band.hpp",
    "core/src/verify/verify.cpp": "inkcell/font.hpp",
    "fonts_gen/src/shaping/character_data.cpp": "shaping/section_writer.hpp",
    "fonts_gen/src/shaping/layout_rules.cpp": "shaping/layout_table.hpp",
    "fonts_gen/src/shaping/lookup_data.cpp": "shaping/section_writer.hpp",
    "core/shaping/src/characters.cpp": "shaper.hpp",
    "core/shaping/src/positions.cpp": "shaper.hpp",
    "core/shaping/src/substitutions.cpp": "shaper.hpp",
}

# The most lines of a file of core that gives no reason for more.
MAX_LINES = 400
REASON = "// Over 400 lines: "

# Lines of code that two passages of core must share to count as a pair, and the
# most pairs.
EQUAL_LINES = 6
MAX_PAIRS = 10

# Headers of the project, which are in quotes; not those of programs, which have
# no folder.
INCLUDE = re.compile(r'^#\s*include "([^"]+/[^"]+)"', re.M)


def room_of(name):
    """The folder of an include path: "" for a file without one."""
    return name.rpartition("/")[0]


def check_promise(room):
    """A room's README, if it is not one of three lines."""
    readme = ROOT / room / "README.md"
    lines = readme.read_text().splitlines() if readme.exists() else []
    if len(lines) == 3 and re.fullmatch(r"[A-Z][^.]*\.", lines[0]):
        return []
    return [f"{room}/README.md: not three lines, the first of them one "
            "sentence"]


class House:
    """The rooms of one folder of sources."""

    def __init__(self, source, may_use, always):
        self.source = source
        self.may_use = may_use
        self.always = always
        self.used = collections.Counter()

    def files(self):
        return sorted([*(ROOT / self.source).glob("**/*.hpp"),
                       *(ROOT / self.source).glob("**/*.cpp")])

    def check_table(self):
        """Rooms that the table puts above one that uses them."""
        known = list(self.may_use)
        return [f"{self.source}/{room}: the table lets it use {other}, which "
                "does not stand before it"
                for at, room in enumerate(known)
                for other in self.may_use[room].split()
                if other not in known[:at]]

    def check_folders(self):
        """Rooms without a line of the table, and without a promise."""
        problems = []
        folders = {path.name for path in (ROOT / self.source).iterdir()
                   if path.is_dir()}
        for room in sorted(folders ^ set(self.may_use)):
            problems.append(f"{self.source}/{room}: not both a folder and a "
                            "line of the table")
        for room in sorted(folders):
            problems += check_promise(f"{self.source}/{room}")
        return problems

    def check_includes(self):
        """Includes that the table does not name."""
        problems = []
        for path in self.files():
            name = str(path.relative_to(ROOT))
            room = path.parent.name
            allowed = {room, *self.always, *self.may_use.get(room, "").split()}
            for header in INCLUDE.findall(path.read_text()):
                other = room_of(header)
                if other in allowed:
                    self.used[room, other] += room != other
                else:
                    problems.append(f"{name}: {room} may not use {header}")
        return problems

    def check_sources(self):
        """Sources whose first header is not their own."""
        problems = []
        for path in self.files():
            name = str(path.relative_to(ROOT))
            if path.suffix != ".cpp" or name in OF_OTHER_HEADERS:
                continue
            headers = INCLUDE.findall(path.read_text())
            if "int main(" in path.read_text():
                continue
            if not headers or headers[0] not in (
                    f"{path.parent.name}/{path.stem}.hpp",
                    f"inkcell/{path.stem}.hpp",
                    f"inkcell/format/{path.stem}.hpp"):
                problems.append(f"{name}: its first include is not its own "
                                "header")
        return problems

    def print_table(self):
        """Lines of each room, and the rooms that it uses."""
        print(f"\n{self.source}")
        for room in self.may_use:
            lines = sum(path.read_text().count("\n")
                        for path in self.files() if path.parent.name == room)
            print(f"  {room:10} {lines:5} lines, uses " +
                  " ".join(other for other in self.may_use
                           if self.used[room, other]))

    def check(self):
        return (self.check_table() + self.check_folders() +
                self.check_includes() + self.check_sources())


def check_public():
    """Includes between public headers that their table does not name."""
    problems = []
    include = ROOT / "core/include"
    for path in sorted(include.glob("**/*.hpp")):
        room = str(path.parent.relative_to(include))
        allowed = {room, *PUBLIC[room].split()}
        problems += [f"{path.relative_to(ROOT)}: {room} may not use {header}"
                     for header in INCLUDE.findall(path.read_text())
                     if room_of(header) not in allowed]
    return problems


def check_library(library):
    """Includes of a library of core, and sources that are not their header's."""
    problems = check_promise(f"core/{library}")
    may_use = LIBRARIES[library].split()
    others = {name for name in may_use if name.startswith("inkcell/")}
    known = list(LIBRARIES)
    problems += [f"core/{library}: the table lets it use {other}, which does not "
                 "stand before it" for other in sorted(others)
                 if other.removeprefix("inkcell/") not in
                 known[:known.index(library)]]
    public = {"inkcell", "inkcell/format", f"inkcell/{library}", *others}
    for path in sorted((ROOT / "core" / library).glob("**/*.[hc]pp")):
        name = str(path.relative_to(ROOT))
        text = path.read_text()
        headers = INCLUDE.findall(text)
        allowed = public if "include" in path.parts else {*public, *may_use}
        problems += [f"{name}: {library} may not use {header}"
                     for header in headers if room_of(header) not in allowed]
        own = {f"inkcell/{library}/{path.stem}.hpp", f"{path.stem}.hpp",
               OF_OTHER_HEADERS.get(name)}
        first = re.search(r'^#include "([^"]+)"', text, re.M)
        if path.suffix == ".cpp" and (first is None or
                                      first.group(1) not in own):
            problems.append(f"{name}: its first include is not its own header")
    return problems


def check_libraries():
    """Problems of all libraries, and folders of core without a line of the
    table."""
    folders = {path.name for path in (ROOT / "core").iterdir() if path.is_dir()}
    problems = [f"core/{name}: not both a folder and a line of LIBRARIES"
                for name in sorted(folders ^ {"include", "src", *LIBRARIES})]
    for library in sorted(folders & set(LIBRARIES)):
        problems += check_library(library)
    return problems


def core_files():
    """Sources and headers of core, as text by name."""
    return {str(path.relative_to(ROOT)): path.read_text()
            for path in sorted((ROOT / "core").glob("**/*.[hc]pp"))}


def check_lengths(files):
    problems = []
    for name, text in files.items():
        head = text[:text.find("#include")]
        count = text.count("\n")
        if count > MAX_LINES and REASON not in head:
            problems.append(f"{name}: {count} lines, and no line that begins "
                            f"with {REASON!r}")
        if count <= MAX_LINES and REASON in head:
            problems.append(f"{name}: {count} lines need no reason")
    return problems


def code_lines(text):
    """Lines with words: no comments, directives, namespaces, lone brackets."""
    lines = [re.sub(r"//.*", "", line).strip() for line in text.splitlines()]
    return [line for line in lines if re.search(r"\w", line)
            and not line.startswith(("#", "namespace"))]


def equal_passages(files):
    """Pairs of passages with EQUAL_LINES equal lines or more."""
    code = {name: code_lines(text) for name, text in files.items()}
    places = collections.defaultdict(list)
    for name, lines in code.items():
        for at in range(len(lines) - EQUAL_LINES + 1):
            places["\n".join(lines[at:at + EQUAL_LINES])].append((name, at))
    pairs = []
    for found in places.values():
        for i, (a, at_a) in enumerate(found):
            for b, at_b in found[i + 1:]:
                begins = (at_a == 0 or at_b == 0 or
                          code[a][at_a - 1] != code[b][at_b - 1])
                if begins:
                    pairs.append((a, b, code[a][at_a]))
    return sorted(pairs)


def check_pairs(files):
    pairs = equal_passages(files)
    print(f"{len(pairs)} pairs of {EQUAL_LINES} equal lines in core, "
          f"{MAX_PAIRS} allowed")
    if len(pairs) <= MAX_PAIRS:
        return []
    return [f"{a} and {b} share {EQUAL_LINES} lines from {line!r} on"
            for a, b, line in pairs]


def main():
    files = core_files()
    houses = [House("core/src", CORE, ["base", *PUBLIC]),
              House("fonts_gen/src", GENERATOR,
                    ["base", "inkcell/field", "inkcell/layers",
                     "inkcell/shaping", "inkcell/stored", "inkcell/strike",
                     *PUBLIC])]
    problems = (check_public() + check_libraries() + check_lengths(files) +
                check_pairs(files))
    for house in houses:
        problems += house.check()
        house.print_table()
    finish(sum(len(house.files()) for house in houses), problems)


main()
