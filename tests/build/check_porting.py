"""Checks docs/PORTING.md, LAYOUT.md, STRINGS.md and ANIMATING.md: their code is code
of the project, and the paths of the first exist.

Usage: check_porting.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ["boards", "core", "port", "tests"]


def squeeze(text):
    """Without what the layout may change."""
    return " ".join(text.split())


def main():
    text = (ROOT / "docs/PORTING.md").read_text()
    sources = [
        squeeze(path.read_text()) for folder in SOURCES
        for path in sorted((ROOT / folder).rglob("*"))
        if (path.suffix in (".hpp", ".cpp", ".c", ".ino", ".py")
            or path.name == "CMakeLists.txt")
    ]
    problems = []

    blocks = re.findall(r"^```\w+\n(.*?)^```", text, re.M | re.S)
    for name in ("LAYOUT", "STRINGS", "ANIMATING"):
        more = (ROOT / f"docs/{name}.md").read_text()
        blocks += re.findall(r"^```c(?:pp)?\n(.*?)^```", more, re.M | re.S)
    if len(blocks) < 8:
        problems.append("the code blocks were not found")
    for block in blocks:
        if not any(squeeze(block) in source for source in sources):
            problems.append(f"no source contains this block:\n{block}")

    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    paths = re.findall(r"`([\w.]+/[\w./]+)`", prose)
    paths += [word for line in re.findall(r"^    (\S.*)", prose, re.M)
              for word in line.split()
              if "/" in word and not word.startswith("build/")]
    if len(paths) < 10:
        problems.append("the paths were not found")
    for path in paths:
        places = [ROOT, *ROOT.glob("core/**/include"),
                  *ROOT.glob("port/*/include")]
        if not any((place / path).exists() for place in places):
            problems.append(f"there is no {path}")

    names = {path.parent.name for path in ROOT.glob("boards/*/board.cmake")}
    variables = set()
    for name in names:
        variables |= set(re.findall(
            r"set\((INKCELL_(?:DISPLAY|DEMO)_[A-Z_]+[A-Z])",
            (ROOT / "boards" / name / "board.cmake").read_text()))
    for variable in sorted(variables):
        if variable not in text:
            problems.append(f"{variable} of a board.cmake is not explained")

    for problem in problems:
        print(problem)
    print(f"{len(blocks)} code blocks, {len(paths)} paths, "
          f"{len(variables)} variables, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
