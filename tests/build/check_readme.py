"""Makes a project of the README's code, builds it and runs it.

Once as the README has it, with add_subdirectory(inkcell); once as its comment
says, with find_package(Inkcell) after an installation. Compiled and linked as
docs/BUILD.md says, by the C compiler, the program has what it calls and nothing
else.

Usage: check_readme.py subdirectory|installed WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import pathlib
import re
import shutil
import sys

from toolchains import FONT, ROOT, call, finish, run

COMPILER_FLAGS = "-ffunction-sections"
LINKER_FLAGS = "-Wl,--gc-sections"
LINKER = "set_target_properties(app PROPERTIES LINKER_LANGUAGE C)"
# Functions that the program calls; that others would.
CALLED = ["paint_areas(", "Painter::text("]
NOT_CALLED = ["mix_lcd", "mix_stroke", "mix_bilevel", "mix_contrast", "Mean::",
              "repaint(", "paint_crossings", "paint_distances(", "paint_wide",
              "PreparedGlyph::make", "Fit::make", "kGridFit", "Font::verify"]
SUBDIRECTORY = re.compile(r"add_subdirectory\(inkcell\).*")


def blocks(language):
    """All code of one language in the README; none at all is an error."""
    text = (ROOT / "README.md").read_text()
    found = re.findall(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)
    if not found:
        sys.exit(f"README.md: no {language} block")
    return "\n".join(found)


def write_project(mode, project):
    """The user's folder: sources, the font, and inkcell beside them."""
    template = ROOT / "tests/build/readme"
    cmake = blocks("cmake")
    if not SUBDIRECTORY.search(cmake):
        sys.exit("README.md: no add_subdirectory(inkcell)")
    if mode == "installed":
        package = re.search(r"find_package\(Inkcell.*?\)", cmake)
        if not package:
            sys.exit("README.md: no find_package(Inkcell ...)")
        cmake = SUBDIRECTORY.sub(package.group(0), cmake)
    else:
        (project / "inkcell").symlink_to(ROOT)
    (project / "readme.cpp").write_text(blocks("cpp"))
    shutil.copy(template / "main.cpp", project)
    shutil.copy(FONT, project)
    text = (template / "CMakeLists.txt.in").read_text()
    (project / "CMakeLists.txt").write_text(
        text.replace("@README_CMAKE@", f"{cmake}\n{LINKER}"))


def check_linked(program, library):
    """What is missing in a program, or too much."""
    def names_of(binary):
        return run(["nm", "-C", "--defined-only", binary]).stdout

    names, all_names = names_of(program), names_of(library)
    return ([f"{name} is not linked" for name in CALLED if name not in names] +
            [f"{name} is linked" for name in NOT_CALLED if name in names] +
            [f"{name} is nowhere: the test looks for nothing"
             for name in NOT_CALLED if name not in all_names])


def check_render(work, build):
    """Problems of inkcell-render, which draws by area what the program draws:
    white on black, 5 bits of red and 6 of green in place of 8 of grey."""
    picture, screen = work / "hello.pgm", work / "screen"
    text = re.search(r'painter\.text\(.*?"(.*?)"',
                     blocks("cpp")).group(1)
    result = run([build / "host_tools/inkcell-render", "--font", FONT, "--text",
                  text, "--px", 24, "--width", 160, "--height", 40, "--ox", 4,
                  "--oy", 28, "--filter", "area", "--out", picture])
    if result.returncode != 0 or run([work / "build/app", screen]).returncode:
        return [f"inkcell-render: {result.stdout}"]
    grey = picture.read_bytes().split(b"\n", 3)[3]
    pixels = screen.read_bytes()
    worst = 0
    for i, value in enumerate(grey):
        word = pixels[2 * i] | pixels[2 * i + 1] << 8
        worst = max(worst, abs((word >> 11) * 255 / 31 - value),
                    abs((word >> 5 & 63) * 255 / 63 - value))
    # The sink blends in 32 steps of coverage; a fitted glyph differs by 100.
    return [] if worst <= 255 / 31 + 1 else [
        f"inkcell-render draws {worst:.0f}/255 else than the README's program"]


def main():
    mode, work, build, fontgen = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
    shutil.rmtree(work, ignore_errors=True)
    project = work / "project"
    project.mkdir(parents=True)
    write_project(mode, project)
    options, commands = [], []
    if mode == "installed":
        prefix = work / "prefix"
        commands.append(["cmake", "--install", build, "--prefix", prefix])
        options = [f"-DCMAKE_PREFIX_PATH={prefix}"]
    else:
        options = [f"-DINKCELL_FONTGEN={fontgen}"]
    commands += [
        ["cmake", "-G", "Ninja", "-S", project, "-B", work / "build",
         "-DCMAKE_BUILD_TYPE=Release",
         f"-DCMAKE_CXX_FLAGS={COMPILER_FLAGS}",
         f"-DCMAKE_EXE_LINKER_FLAGS={LINKER_FLAGS}", *options],
        ["cmake", "--build", work / "build"],
        [work / "build/app"],
    ]
    for command in commands:
        said = call(*command)
    print(said, end="")
    problems = check_linked(work / "build/app",
                            build / "core/libinkcell_core.a")
    problems += check_render(work, build)
    finish(len(commands) + 2, problems)


main()
