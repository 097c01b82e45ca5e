"""Checks what can be false in documents and the form of all tracked files.

Links, paths and names in documents are there, tables of figures are those of
docs/figures.json, FORMAT.md places numbers where the library does, versions agree,
and no file names a path that only one machine has.

Usage: check_docs.py
"""
import pathlib
import re
import sys

from toolchains import MADE, ROOT, finish, run

SOURCES = (".hpp", ".cpp", ".h", ".c", ".cmake", ".py", ".sh")

# Written in pieces so that this file passes.
FOREIGN = re.compile(r"\.\." + r"/shared|(?<![\w.])/" +
                     r"(work|root|farm|home)/")
UNFINISHED = re.compile(r"\b(TO" + r"DO|FIX" + r"ME)\b")


def tracked_files():
    """Files in git that are there, and text."""
    listing = run(["git", "-C", ROOT, "ls-files", "-z"])
    if listing.returncode != 0:
        sys.exit("not a git checkout: " + listing.stdout)
    result = {}
    for name in listing.stdout.split("\0"):
        path = ROOT / name
        if name and path.is_file():
            try:
                result[name] = path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                pass  # a picture or a font
    return result


def anchor(heading):
    """The name by which a link finds a heading."""
    words = re.sub(r"[^\w\- ]", "", heading.strip().lower())
    return words.replace(" ", "-")


def check_links(name, text):
    """Links of a document that lead nowhere."""
    problems = []
    prose = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    for link in re.findall(r"\]\(([^)\s]+)\)", prose):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, section = link.partition("#")
        target = (ROOT / name).parent / path if path else ROOT / name
        if not target.exists():
            problems.append(f"{name}: link to {link}: no such file")
        elif section and target.suffix == ".md":
            headings = re.findall(r"^#+ (.+)$", target.read_text(), re.M)
            if section not in map(anchor, headings):
                problems.append(f"{name}: link to {link}: no such heading")
    return problems


def check_paths(name, text):
    """Paths of this project that a document names and that do not exist."""
    rooms = sorted(path.name for path in ROOT.iterdir()
                   if path.is_dir() and not path.name.startswith(".")
                   and path.name != "build")
    pattern = r"(?<![\w/.<-])(?:" + "|".join(rooms) + r")/[\w./-]*"
    return [f"{name}: names {path}: no such file"
            for path in sorted(set(re.findall(pattern, text)))
            if not (ROOT / path.rstrip(".")).exists()]


def check_names(name, text, code):
    """Headers and options of CMake that a document names and that no source has."""
    folders = [*ROOT.glob("core/include"), *ROOT.glob("core/*/include"),
               *ROOT.glob("port/*/include"), MADE / "include",
               MADE / "include/inkcell"]
    headers = set(re.findall(r"[`<](inkcell/[\w./]+\.hp{0,2})[`>]", text))
    options = set(re.findall(r"\bINKCELL_[A-Z0-9_]+", text))
    return ([f"{name}: names {header}: no such header" for header in sorted(headers)
             if not any((folder / header).exists() for folder in folders)] +
            [f"{name}: names {option}, which no source has"
             for option in sorted(options) if option not in code])


# A symbol of a source, as an item: - `path`: `symbol`.
SYMBOL = re.compile(r"^- `([\w./-]+\.\w+)`: `([^`]+)`$", re.M)


def check_symbols(name, text, files):
    """Symbols that are not in the source that a document names."""
    return [f"{name}: {path} has no {symbol}"
            for path, symbol in SYMBOL.findall(text)
            if symbol not in files.get(path, "")]


def check_offsets(files):
    """Where FORMAT.md places numbers, and where format/rom.hpp does."""
    form = files["docs/FORMAT.md"]
    source = files["core/include/inkcell/format/rom.hpp"]
    problems = []
    for heading, space, least in [("## Header", "header", 31),
                                  ("## Section directory", "section", 3)]:
        part = form[form.index(f"\n{heading}\n"):]
        rows = re.findall(r"^\| (\d+) \| (\d+) \|[^|]*\| (\w+) \|",
                          part[:part.index("\n#", 1)], re.M)
        body = re.search(rf"namespace {space} {{\n(.*?)\n}}", source,
                         re.S).group(1)
        if len(rows) < least:
            problems.append(f"docs/FORMAT.md: {heading}: {len(rows)} rows")
        end = 0
        for offset, size, name in rows:
            constant = "k" + name.title().replace("_", "")
            if (not re.search(rf"\b{constant} = {offset};", body) or
                    int(offset) != end):
                problems.append(f"docs/FORMAT.md: {heading}: {name} is not at "
                                f"{space}::{constant}, the next free place")
            end = int(offset) + int(size)
        if not re.search(rf"\bkBytes = {end};", body):
            problems.append(f"docs/FORMAT.md: {heading}: not {end} bytes")
    return problems


def check_prose(name, text):
    """Lines of a document that an editor would wrap: not of tables and code."""
    return [f"{name}:{number}: over 100 columns"
            for number, line in enumerate(text.splitlines(), 1)
            if len(line) > 100 and not line.startswith(("|", "    "))]


def constant(text, name):
    return re.search(rf"{name} = (\d+);", text).group(1)


def check_versions(files):
    """Versions that are said in several places."""
    header = files["core/include/inkcell/version.hpp"]
    library = ".".join(constant(header, "kLibraryVersion" + part)
                       for part in ("Major", "Minor", "Patch"))
    form = ".".join(constant(header, "kFormat" + part)
                    for part in ("Major", "Minor"))
    problems = []
    for name, pattern, version in [
            ("docs/FORMAT.md", r"[Ff]ormat version\D{0,8}(\d+\.\d+)", form),
            ("docs/CHANGELOG.md", r"^## \D*(\d+\.\d+\.\d+)", library),
            ("CMakeLists.txt", r"project\(inkcell VERSION ([\d.]+)", library),
            ("idf_component.yml", r'^version: "(.*)"', library),
            ("library.json", r'"version": "(.*)"', library),
            ("meson.build", r"version: '(.*?)'", library),
            ("port/arduino/library.properties", r"^version=(.*)", library)]:
        found = re.search(pattern, files.get(name, ""), re.M)
        if not found or found.group(1) != version:
            problems.append(f"{name}: says version "
                            f"{found.group(1) if found else 'nothing'}, "
                            f"version.hpp {version}")
    return problems


def check_source(name, text):
    """The form of one source."""
    problems = []
    if name.endswith((".hpp", ".cpp", ".h")):
        lines = text.splitlines()
        # A source with a header of its own leaves that to the header.
        own = re.compile(r'#include "[\w/]*\b' +
                         re.escape(pathlib.Path(name).stem) + r'\.hpp"')
        if not lines or not (lines[0].startswith("// ") or own.match(lines[0])):
            problems.append(f"{name}: the first line says what it is for")
        if len(lines) > 600:
            problems.append(f"{name}: {len(lines)} lines")
        problems += [f"{name}:{number}: over 80 columns"
                     for number, line in enumerate(lines, 1) if len(line) > 80]
    if name.startswith(("core/", "port/")) and not text.isascii():
        problems.append(f"{name}: not ASCII")
    if UNFINISHED.search(text):
        problems.append(f"{name}: holds an unfinished mark")
    return problems


def main():
    files = tracked_files()
    problems = check_versions(files) + check_offsets(files)
    drawn = run([sys.executable, "-B", ROOT / "tests/bench/figures.py",
                 "--check"])
    if drawn.returncode != 0:
        problems.append(drawn.stdout)
    code = "\n".join(text for name, text in files.items()
                     if not name.endswith(".md"))
    for name, text in files.items():
        if name.endswith(".md"):
            if name != "docs/CHANGELOG.md":  # it has names of before
                problems += check_names(name, text, code)
            problems += check_links(name, text)
            problems += check_paths(name, text)
            problems += check_symbols(name, text, files)
            if name != "docs/BENCHMARKS.md":  # a program wraps that
                problems += check_prose(name, text)
        if name.endswith(SOURCES):
            problems += check_source(name, text)
        problems += [f"{name}: names {found.group(0)}"
                     for found in FOREIGN.finditer(text)]
    finish(len(files), problems)


main()
