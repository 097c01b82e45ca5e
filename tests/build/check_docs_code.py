"""Checks the code of documents: each block is code of the project, which its tests
compile, or lines of CMake that configure a project. Lines of inkcell-fontgen make
fonts.

Usage: check_docs_code.py WORK_FOLDER FONTGEN
"""

import pathlib
import re
import shlex
import shutil

from toolchains import FONT, FONTS, ROOT, arguments, finish, run

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
ENDINGS = (".hpp", ".cpp", ".c", ".ini", ".ino", ".py")
BLOCK = re.compile(r"^ *```(\w+)\n(.*?)^ *```", re.M | re.S)


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
    texts = {path.relative_to(ROOT): path.read_text() for path in files}
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
    work, fontgen = arguments()
    sources = [
        squeeze(path.read_text()) for folder in SOURCES
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in ENDINGS or path.name == "CMakeLists.txt"]
    # build.readme_subdirectory builds the README's.
    blocks = [found for path in sorted((ROOT / "docs").glob("*.md"))
              for found in BLOCK.findall(path.read_text())]
    strange = [(language, block) for language, block in blocks
               if not any(squeeze(block) in source for source in sources)]
    problems = [f"no source contains this block:\n{block}"
                for language, block in strange if language != "cmake"]
    problems += configure("".join(block for language, block in strange
                                  if language == "cmake"), work, fontgen)
    calls = commands(run([fontgen, "--help"]).stdout)
    problems += run_commands(calls, work / "fonts", fontgen)
    if "--help" not in calls.values():
        problems.append("inkcell-fontgen --help does not begin with a line to type")
    if len(blocks) < 8 or len(calls) < 8:
        problems.append("the code was not found")
    finish(len(blocks) + len(calls) - len(problems), problems)


main()
