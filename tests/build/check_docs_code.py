"""Checks the code of documents: each block is code of the project, which its tests
compile, or lines of CMake that configure a project. check_commands.py runs the
command lines.

Usage: check_docs_code.py WORK_FOLDER FONTGEN
"""

import re
import shutil

from toolchains import FONT, ROOT, arguments, finish, run

SOURCES = ["boards", "core", "port", "tests"]
ENDINGS = (".hpp", ".cpp", ".c", ".ini", ".ino", ".py", ".rs", ".toml")
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
    if len(blocks) < 8:
        problems.append("the code was not found")
    finish(len(blocks) - len(problems), problems)


main()
