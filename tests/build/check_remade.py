"""Checks that Make, CMake and Meson make a font anew after each change of a file that
the generator reads, after a file came or went in a folder of icons, and at no other
time. So it is with sources of C, and with files for storage and their headers.

Usage: check_remade.py WORK_FOLDER FONTGEN
"""
import pathlib

from toolchains import FONT, FONTS, ROOT, arguments, finish, run

SQUARE = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8">'
          '<path d="M0 0h{0}v{0}h-{0}z"/></svg>\n')
OPTIONS = ["--svg-dir={0}/icons", "--text-file={0}/text.txt",
           "--merge={0}/more.ttf=0x42", "--max-px=12"]
STRINGS = "--strings={0}/ui.txt"  # for fonts in mapped memory
PAGED = "--paged=512"
# Each is a change of a file below the project's folder, which may come or go.
CHANGES = {
    "an icon": ("icons/one.svg", SQUARE.format(4)),
    "a new icon": ("icons/two.svg", SQUARE.format(5)),
    "a text": ("text.txt", "A and C\n"),
    "strings": ("ui.txt", "title = CA\n"),
    "a merged face": ("more.ttf", FONTS / "truetype/dejavu/DejaVuSansMono.ttf"),
    "the font": ("font.ttf", FONTS / "truetype/dejavu/DejaVuSans-Bold.ttf"),
    "an icon that goes": ("icons/two.svg", None),
}
# CMake's Makefiles never forget a dependency: without a file that is gone they make
# the font at each build, until it is cleaned.
NEVER_FORGETS = "CMake, Make"

MAKE = """INKCELL := {root}
INKCELL_FONTGEN := {fontgen}
include $(INKCELL)/port/make/inkcell.mk
$(eval $(call inkcell_{rule},ui,{folder}/font.ttf,{options}))
all: $(INKCELL_FONTS)/fonts/ui.{suffix}
"""
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES NONE)
set(INKCELL_FONTGEN {fontgen})
set(INKCELL_FONTGEN_LAUNCHER "")
include({root}/fonts_gen/cmake/InkcellFonts.cmake)
add_library(app INTERFACE)
inkcell_add_font(app FONT font.ttf NAME ui SVG_DIR icons TEXT_FILE text.txt
  STRINGS ui.txt MERGE more.ttf=0x42 MAX_PX 12)
"""
CACHED = CMAKE.replace('LAUNCHER ""', "LAUNCHER {root}/tests/font_cache.py")
MESON = """project('user')
fontgen = find_program('{fontgen}', native: true)
custom_target(input: 'font.ttf', output: [{outputs}], depfile: 'ui.d',
  build_by_default: true,
  command: [fontgen, '--font=@INPUT@', '--name=ui', {quoted}, '--quiet',
            '--out=@OUTPUT0@', '--depfile=@DEPFILE@'])
"""
CONFIGURE = ["cmake", "-S", "{0}", "-B", "{0}/build", "-G"]
BUILD = ["cmake", "--build", "{0}/build", "--target", "app_ui_files"]

# What writes a project, its file, what configures it, what builds it, its font.
SYSTEMS = {
    "Make": (MAKE, "Makefile", [], ["make", "-s", "-C", "{0}", "all"],
             "build/inkcell_fonts/fonts/ui.hpp"),
    "Make, C": (MAKE, "Makefile", [], ["make", "-s", "-C", "{0}", "all"],
                "build/inkcell_fonts/fonts/ui.c"),
    "Make, stored": (MAKE, "Makefile", [], ["make", "-s", "-C", "{0}", "all"],
                     "build/inkcell_fonts/fonts/ui.bin"),
    "CMake, Ninja": (CMAKE, "CMakeLists.txt", [*CONFIGURE, "Ninja"], BUILD,
                     "build/inkcell_fonts/app/fonts/ui.hpp"),
    "CMake, cached": (CACHED, "CMakeLists.txt", [*CONFIGURE, "Ninja"], BUILD,
                      "build/inkcell_fonts/app/fonts/ui.hpp"),
    "CMake, Make": (CMAKE, "CMakeLists.txt", [*CONFIGURE, "Unix Makefiles"],
                    BUILD, "build/inkcell_fonts/app/fonts/ui.hpp"),
    "Meson": (MESON, "meson.build", ["meson", "setup", "{0}/build", "{0}"],
              ["meson", "compile", "-C", "{0}/build"], "build/ui.hpp"),
    "Meson, stored": (MESON, "meson.build",
                      ["meson", "setup", "{0}/build", "{0}"],
                      ["meson", "compile", "-C", "{0}/build"], "build/ui.bin"),
}


def write(path, content):
    if content is None:
        path.unlink()
    elif isinstance(content, pathlib.Path):
        path.write_bytes(content.read_bytes())
    else:
        path.write_text(content)


def write_project(folder, name, text, fontgen, suffix):
    (folder / "icons").mkdir(parents=True)
    write(folder / "icons/one.svg", SQUARE.format(8))
    write(folder / "text.txt", "A\n")
    write(folder / "ui.txt", "title = AC\n")
    write(folder / "more.ttf", FONTS / "truetype/dejavu/DejaVuSerif.ttf")
    write(folder / "font.ttf", FONT)
    is_stored = suffix == ".bin"
    options = [option.format(folder) for option in
               [*OPTIONS, PAGED if is_stored else STRINGS]]
    more = ["--header=@OUTPUT1@"] if is_stored else []
    write(folder / name, text.format(
        root=ROOT, fontgen=fontgen, folder=folder, options=" ".join(options),
        rule={".c": "c_font", ".bin": "stored_font"}.get(suffix, "font"),
        outputs="'ui.bin', 'ui.hpp'" if is_stored else "'ui.hpp'",
        suffix=suffix[1:],
        quoted=", ".join(f"'{option}'" for option in [*options, *more])))


class Project:
    """The project of a build system, and when its font was made."""

    def __init__(self, folder, build, font):
        self.build = [word.format(folder) for word in build]
        self.font = folder / font

    def make(self):
        result = run(self.build)
        if result.returncode != 0:
            raise RuntimeError(result.stdout)
        return self.font.stat().st_mtime_ns


def problems_of(work, system, fontgen):
    text, name, configure, build, font = SYSTEMS[system]
    folder = work / system.replace(", ", "-")
    suffix = pathlib.Path(font).suffix
    write_project(folder, name, text, fontgen, suffix)
    if configure:
        result = run([word.format(folder) for word in configure])
        if result.returncode != 0:
            return [f"{system}: {result.stdout}"]
    project = Project(folder, build, font)
    problems = []
    try:
        made = project.make()
        for what, (file, content) in CHANGES.items():
            if what == "strings" and suffix == ".bin":
                continue
            if project.make() != made:
                problems.append(f"{system}: made anew before {what}")
            write(folder / file, content)
            before, made = made, project.make()
            if made == before:
                problems.append(f"{system}: not made anew after {what}")
        if project.make() != made and system != NEVER_FORGETS:
            problems.append(f"{system}: made anew after all changes")
        if suffix == ".bin" and "namespace ui {" not in project.font.with_suffix(
                ".hpp").read_text():
            problems.append(f"{system}: there is no header of the file")
    except RuntimeError as error:
        problems.append(f"{system}: {error}")
    return problems


def main():
    work, fontgen = arguments()
    problems = [problem for system in SYSTEMS
                for problem in problems_of(work, system, fontgen)]
    finish(len(SYSTEMS) * len(CHANGES) - len(problems), problems)


main()
