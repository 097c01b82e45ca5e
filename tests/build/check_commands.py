"""Runs the command lines of documents, block by block in their order, as readers
would: by sh, in a copy of the checkout whose host is built, with the fonts and files
that the text names. Options in the text are options of some program.

A block is lines that are indented by four blanks. TEXTS tells those that nobody
types; all others run. What installs, needs a board or a network, opens a window or
takes minutes is called as stand_in.py, which says what it does instead.

Usage: check_commands.py WORK_FOLDER BUILD_FOLDER [studio]

studio: the documents whose programs INKCELL_STUDIO builds, instead of the others.
"""
import ast
import os
import pathlib
import re
import shutil
import sys

from stand_in import STAND_INS
from toolchains import FONT, FONTS, ROOT, call, finish, in_parallel, run

# Blocks that nobody types, by their beginning: code, output, diagrams.
TEXTS = re.compile(
    r"base  s|set_target_properties\(|\.ext_flash|import \{|error: |warning: "
    r"|language  |draw 0 |# FILE\n|open DejaVu|local weight|Font::open|"
    r"custom_inkcell_fonts =")
# Diagrams and bytes only; names of before.
OTHERS = ("docs/BENCHMARKS.md", "docs/CHANGELOG.md", "docs/DESIGN.md",
          "docs/FORMAT.md")
# Heads of files, and a help, beside them.
HEADS = ("port/arduino/pack.py", "inkcell-fontgen --help")
STUDIO = ("host_tools/design/", "docs/SIMULATOR.md")
# Files that are there.
FILES = {
    "DejaVuSans.ttf": FONT, "Sans.ttf": FONT, "FONT.ttf": FONT, "twemoji.woff2": FONT,
    "Loma.ttf": FONTS / "truetype/tlwg/Loma.ttf",
    "NotoSansCJK-Regular.ttc": FONTS / "opentype/noto/NotoSansCJK-Regular.ttc",
    # LVGL's is not here; this one has the same symbols.
    "lvgl/scripts/built_in_font/FontAwesome5-Solid+Brands+Regular.woff":
        FONTS / "truetype/font-awesome/fontawesome-webfont.ttf",
    "icons/sun.svg": '<svg viewBox="0 0 8 8"><circle cx="4" cy="4" r="4" '
                     'fill="#fc0"/></svg>',
    "terminus.bdf": "STARTFONT 2.1\nFONT a-iso10646-1\nSIZE 16 72 72\n"
                    "FONTBOUNDINGBOX 8 16 0 -4\nSTARTPROPERTIES 3\n"
                    "PIXEL_SIZE 16\nCHARSET_REGISTRY \"ISO10646\"\n"
                    "CHARSET_ENCODING \"1\"\nENDPROPERTIES\nCHARS 1\n"
                    "STARTCHAR A\nENCODING 65\nDWIDTH 8 0\nBBX 3 2 0 0\n"
                    "BITMAP\n40\nE0\nENDCHAR\nENDFONT\n",
    "ui.txt": "title = Hello\n",
    "src/menu.c": 'const char* title = "Menu";\n',
    "po/zh.po": 'msgid "menu"\nmsgstr "\u83dc\u5355"\n',
    "fonts/dejavu_sans_latin1.bin": "",
    "app/startup.s": "",
    "app/flash.ld": "SECTIONS { .bss : { __bss_start__ = .; *(.bss*) "
                    "__bss_end__ = .; end = .; } }\n",
    "inkcell": pathlib.Path("."),
}
# What the text before a block tells its reader to do.
BEFORE = {"c++ -std=c++17": "cp FOLDER/inkcell.* .\n",
          # MicroPython's sources are not here; the module that is named is.
          "make -C mpy-cross": 'make() { case "$*" in *=FOLDER/*) '
                               'ls "${*#*=FOLDER/}";; esac; }\n',
          "inkcell-simulator --display": "sed -n '/^    # FILE/,/^$/s/^    //p' "
                                         "docs/SIMULATOR.md >FILE\n"}
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]+")


def text_of(name, build):
    """What is read of a document, of a file's head, of a help."""
    if name.endswith("--help"):
        return call(build / "fonts_gen/inkcell-fontgen", "--help") + "\n"
    text = (ROOT / name).read_text()
    return (text if name.endswith(".md") else
            f"{ast.get_docstring(ast.parse(text))}\n")


def blocks_of(text):
    """Blocks that are indented, each with the number of its first line."""
    text = re.sub(r"^ *```.*?^ *```$", lambda code: "\n" * code.group(0).count("\n"),
                  text, flags=re.M | re.S)
    for found in re.finditer(r"(?<=\n\n)(?:    .*\n)+", text):
        yield (text.count("\n", 0, found.start()) + 1,
               re.sub(r"^    ", "", found.group(0), flags=re.M))


def make_machine(folder, build):
    """What a reader has: the checkout, what is built, files of the text. Returns the
    environment of his shell."""
    for name in run(["git", "-C", ROOT, "ls-files", "-z"]).stdout.split("\0"):
        path = ROOT / name
        if name and path.is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, folder / name)
    for name, content in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, str):
            (folder / name).write_text(content)
        else:
            (folder / name).symlink_to(content)
    (folder / "build").mkdir()
    for name, place in (("host", build), ("demo-host", build),
                        ("fontgen", build / "fonts_gen")):
        (folder / "build" / name).symlink_to(place)
    stand_ins = folder / "build/stand-ins"
    stand_ins.mkdir()
    for name in STAND_INS:
        (stand_ins / name).write_text(
            f"#!/bin/sh\nexec {sys.executable} -B {ROOT}/tests/build/stand_in.py "
            f'{name} "$@"\n')
        (stand_ins / name).chmod(0o755)
    programs = [f"{build}/{name}" for name in
                ("fonts_gen", "host_tools", "host_tools/simulator")]
    return {**os.environ, "APP": "app",  # whose Makefile would build a generator
            "INKCELL_FONTGEN": f"{build}/fonts_gen/inkcell-fontgen",
            "PATH": ":".join([str(stand_ins), *programs, os.environ["PATH"]])}


def run_document(name, work, build):
    """How many blocks of a document were run, and what went wrong."""
    blocks = [(line, block) for line, block in blocks_of(text_of(name, build))
              if not TEXTS.match(block)]
    if not blocks:
        return 0, ""
    folder = work / re.sub("[/ ]", "_", name)
    environment = make_machine(folder, build)
    script = ""
    for line, block in blocks:
        script += f"cd {folder}; echo; echo '{name}:{line}:'\n"
        script += "".join(step for start, step in BEFORE.items()
                          if block.startswith(start)) + block
    result = run(["/bin/sh", "-euxc", script], cwd=folder, env=environment)
    shutil.rmtree(folder)
    if result.returncode == 0:
        return len(blocks), ""
    return len(blocks), result.stdout[result.stdout.rindex(f"\n{name}:"):]


def check_options(name, known):
    """Options in the text of a document that no program has."""
    text = (ROOT / name).read_text()
    spans = re.findall(r"`([^`]+)`", re.sub(r"^(```|    ).*", "", text, flags=re.M))
    options = {option for span in spans for option in OPTION.findall(span)}
    return [f"{name}: {option}: no program has it" for option in
            sorted(options - known)]


def known_options():
    """Options that sources read: of the generator, the tools, scripts."""
    files = run(["git", "-C", ROOT, "ls-files", "*.cpp", "*.sh", "*.py", "*.mjs",
                 "*.mk"]).stdout.split()
    return {option for file in files if (ROOT / file).is_file()
            for option in OPTION.findall((ROOT / file).read_text())}


def main():
    work, build = map(pathlib.Path, sys.argv[1:3])
    shutil.rmtree(work, ignore_errors=True)
    tracked = run(["git", "-C", ROOT, "ls-files", "*.md"]).stdout.split()
    studio = [name for name in tracked if name.startswith(STUDIO)]
    names = (studio if sys.argv[3:] == ["studio"] else
             [*(name for name in tracked if name not in (*OTHERS, *studio)), *HEADS])
    results = in_parallel(lambda name: run_document(name, work, build),
                          [(name,) for name in names])
    known = known_options()
    problems = [said for _, said in results if said]
    problems += [problem for name in names if name in tracked
                 for problem in check_options(name, known)]
    finish(sum(count for count, _ in results), problems)


main()
