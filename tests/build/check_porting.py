"""Checks docs/PORTING.md and others that have code: each block is code of the project,
which its tests compile, and the paths of the first exist. CMake's lines of the others
configure a project, and lines of inkcell-fontgen make fonts.

Usage: check_porting.py WORK_FOLDER FONTGEN
"""

import pathlib
import re
import shlex
import shutil
import sys

from toolchains import ROOT, run

FONTS = pathlib.Path("/usr/share/fonts")
FONT = FONTS / "truetype/dejavu/DejaVuSans.ttf"
# What lines of inkcell-fontgen read, wherever they are, and what is made of a
# set of characters that would take minutes.
INPUTS = {
    "DejaVuSans.ttf": FONT, "Sans.ttf": FONT, "FONT.ttf": FONT,
    "Loma.ttf": FONTS / "truetype/tlwg/Loma.ttf",
    "NotoSansCJK-Regular.ttc": FONTS / "opentype/noto/NotoSansCJK-Regular.ttc",
    "ui.txt": "title = Hello\n",
    "src/menu.c": 'const char* title = "Menu";\n',
    "po/zh.po": 'msgid "menu"\nmsgstr "\u83dc\u5355"\n',
}
FEWER = {"0x4E00-0x9FFF": "0x4E00-0x4E1F"}
SOURCES = ["boards", "core", "port", "tests"]


def squeeze(text):
    """Without what the layout may change."""
    return " ".join(text.split())


def configure(lines, work, fontgen):
    """What CMake says of a project that has these lines, or nothing."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    shutil.copy(FONT, work)
    (work / "ui.txt").write_text("title = Hello\n")
    (work / "main.cpp").write_text("int main() {}\n")
    (work / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(app C CXX)\n"
        f"add_subdirectory({ROOT} inkcell)\nadd_executable(app main.cpp)\n{lines}")
    result = run(["cmake", "-G", "Ninja", "-S", work, "-B", work / "build",
                  f"-DINKCELL_FONTGEN={fontgen}"])
    return [result.stdout] if result.returncode != 0 else []


def commands(help_text):
    """Lines of inkcell-fontgen in documents, heads of files and its help, which
    begins with one."""
    files = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")),
             *sorted((ROOT / "fonts_gen").rglob("*.md")),
             ROOT / "port/arduino/pack.py"]
    texts = {path.relative_to(ROOT): path.read_text() for path in files
             if path.name != "CHANGELOG.md"}
    texts["--help"] = "\n".join(help_text.splitlines()[:8])
    return {line: place for place, text in texts.items()
            for line in re.findall(r"^ {4}(?:npx )?(inkcell-fontgen --font .*)",
                                   text, re.M)}


def run_commands(lines, work, fontgen):
    """Lines that do not work."""
    shutil.rmtree(work, ignore_errors=True)
    for name, content in INPUTS.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, pathlib.Path):
            (work / name).symlink_to(content)
        else:
            (work / name).write_text(content)
    problems = []
    for line, place in lines.items():
        words = [FEWER.get(word, word) for word in shlex.split(line)[1:]]
        result = run([fontgen, *words, "--quiet"], cwd=work)
        if result.returncode != 0:
            problems.append(f"{place}: {line}\n{result.stdout}")
    return problems


def main():
    work, fontgen = map(pathlib.Path, sys.argv[1:])
    text = (ROOT / "docs/PORTING.md").read_text()
    sources = [
        squeeze(path.read_text()) for folder in SOURCES
        for path in sorted((ROOT / folder).rglob("*"))
        if (path.suffix in (".hpp", ".cpp", ".c", ".ini", ".ino", ".py")
            or path.name == "CMakeLists.txt")
    ]
    problems = []

    blocks = re.findall(r"^```\w+\n(.*?)^```", text, re.M | re.S)
    lines = []
    for name in ("LAYOUT", "STRINGS", "ANIMATING", "EDITING", "DESIGN", "SIMULATOR"):
        more = (ROOT / f"docs/{name}.md").read_text()
        for language, block in re.findall(r"^```(\w+)\n(.*?)^```", more,
                                          re.M | re.S):
            (lines if language == "cmake" else blocks).append(block)
    problems += configure("".join(lines), work, fontgen)
    calls = commands(run([fontgen, "--help"]).stdout)
    problems += run_commands(calls, work / "fonts", fontgen)
    if "--help" not in calls.values():
        problems.append("inkcell-fontgen --help does not begin with a line to type")
    if len(calls) < 8:
        problems.append("the lines of inkcell-fontgen were not found")
    if len(blocks) < 8:
        problems.append("the code blocks were not found")
    for block in blocks:
        if not any(squeeze(block) in source for source in sources):
            problems.append(f"no source contains this block:\n{block}")

    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    paths = re.findall(r"`([\w.]+/[\w./]+)`", prose)
    paths += [word for line in re.findall(r"^    (\S.*)", prose, re.M)
              for word in line.split()
              if "/" in word and "$" not in word and not word.startswith("build/")]
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
    print(f"{len(blocks)} code blocks, {len(calls)} lines of inkcell-fontgen, "
          f"{len(paths)} paths, {len(variables)} variables, "
          f"{len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
