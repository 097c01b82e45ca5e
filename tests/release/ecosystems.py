"""Draws the picture of picture.cpp with the archive of each ecosystem, from the zip on,
in a ready font: it must be the one that the library as two files draws. Samples of
archives draw on panels that are played, as in tests/build.

The systems are played by a few functions. Where INKCELL_MICROPYTHON_DIR names
MicroPython's sources, its unix port draws the picture; where INKCELL_PLATFORMIO_DIR
names those of PlatformIO Core, whose platform `native` is installed, that builds it; where
INKCELL_ESPHOME_DIR names ESPHome's, the program is what ESPHome generates for its
platform `host`, and draws what a painter does; where INKCELL_IDF_DIR names ESP-IDF's
sources, and PYTHONPATH its kconfgen, the picture is a project of its target `linux`.

Usage: ecosystems.py WORK_FOLDER RELEASE
"""
import asyncio
import json
import os
import pathlib
import re
import sys
import types

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent / "build"
sys.path.insert(0, str(TESTS))
import check_esphome  # noqa: E402
import check_micropython  # noqa: E402
from packages.platformio import Environment  # noqa: E402
from toolchains import arguments, call, finish, in_parallel  # noqa: E402

FONT = "inter_latin1"
# The largest fonts of a set [bytes].
LARGEST = {"noto_sans_ascii": 6144, "digits": 1536, "ascii": 9216}
COMPILE = ["g++", "-std=gnu++17", "-Os", "-fno-exceptions", "-fno-rtti",
           "-fno-threadsafe-statics", "-DARDUINO=10819", "-w"]
SAMPLES = {"esp_idf": "port/esp_idf/example/main", "zephyr": "port/zephyr/sample/src",
           "micropython": ""}
MICROPYTHON = """import framebuf, inkcell, sys
pixels = bytearray(200 * 40)
font = inkcell.Font(open(sys.argv[1], "rb").read())
font.text(pixels, 200, 40, framebuf.GS8, "Hello, 12:34", 4, 28, 24, 255, fit=False)
sys.stdout.buffer.write(b"P5 200 40 255\\n" + pixels)
"""
IDF = """cmake_minimum_required(VERSION 3.16)
set(EXTRA_COMPONENT_DIRS {top})
set(COMPONENTS main)
include($ENV{{IDF_PATH}}/tools/cmake/project.cmake)
project(picture)
"""
# The picture as fonts of ESPHome are drawn, with heights fitted.
FITTED = """
#include <inkcell/fit.hpp>
static inkcell::Style fitted(const inkcell::Font& font) {
  inkcell::Style style(inkcell::Q26_6::from_int(24));
  static inkcell::Fit fit;
  inkcell::FitOptions options;
  options.across = false;
  inkcell::Fit::make(font, style, options, fit);
  style.set_fit(fit);
  return style;
}
int main() {"""
# The same by ESPHome's print(), in place of an update of its window.
ESPHOME = """esphome: {name: picture}
host:
external_components:
  - source: {type: local, path: inkcell/port/esphome/components}
inkcell:
  - {id: sans, file: inkcell/fonts/FONT.bin, size: 24}
display:
  - platform: sdl
    dimensions: {width: 200, height: 40}
    lambda: |-
      static uint8_t pixels[200 * 40];
      struct Sheet : display::Display {
        void draw_pixel_at(int x, int y, Color color) override {
          pixels[y * 200 + x] = color.g;
        }
        void update() override {}
        int get_width() override { return 200; }
        int get_height() override { return 40; }
        int get_width_internal() override { return 200; }
        int get_height_internal() override { return 40; }
        display::DisplayType get_display_type() override {
          return display::DISPLAY_TYPE_COLOR;
        }
      } sheet;
      const char* const text = "Hello, 12:34";
      int width, left, baseline, height;
      id(sans).measure(text, &width, &left, &baseline, &height);
      id(sans).print(4, 28 - baseline, &sheet, Color(255, 255, 255), text, Color());
      printf("P5 200 40 255\\n");
      fwrite(pixels, 1, sizeof pixels, stdout);
      fflush(stdout);
      _Exit(0);
"""


def program_of(folder):
    """picture.cpp with a ready font."""
    path = folder / "picture.cpp"
    text = (HERE / "picture.cpp").read_text()
    path.write_text(re.sub(r"(?<=fonts[/:])(:?)sans\b", rf"\1{FONT}", text))
    return path


def write_header(folder, rom):
    """What a program includes, of a font that the archive has as bytes."""
    (folder / "fonts").mkdir(exist_ok=True)
    (folder / f"fonts/{FONT}.hpp").write_text(
        "#include <stdint.h>\nnamespace fonts {\nalignas(4) constexpr uint8_t "
        f"{FONT}[] = {{{','.join(map(str, rom))}}};\n}}\n")


def link(work, flags, sources, programs):
    """Compiles the sources of a library; programs of other sources, with it."""
    objects = [work / f"{i}.o" for i in range(len(sources))]
    in_parallel(call, [(*COMPILE, *flags, "-c", source, "-o", out)
                       for source, out in zip(sources, objects)])
    (work / "library.a").unlink(missing_ok=True)
    call("ar", "crs", work / "library.a", *objects)
    for name, own in programs.items():
        call(*COMPILE, *flags, *own, work / "library.a", "-o", work / name)


def arduino(top, work):
    """All of src/ with src/ alone as include folder, and each sketch."""
    played = TESTS / "arduino"
    sketches = [path.name for path in (top / "examples").iterdir()
                if path.name != "Hello"]
    link(work, [f"-I{top / 'src'}"], list((top / "src").rglob("*.cpp")), {
        "picture": [program_of(work)],
        **{name: [f"-I{top / 'examples' / name}", f"-I{played}",
                  f"-I{played / 'core'}", f"-I{played / 'displays'}",
                  "-include", "Arduino.h", played / f"test_{name}.cpp",
                  played / "core/core.cpp"] for name in sketches}})
    for name in sketches:
        call(work / name)


def from_library_json(top, work, programs):
    """What PlatformIO compiles, with the flags of the library."""
    build = json.loads((top / "library.json").read_text())["build"]
    environment = Environment(work, {})
    script = top / build["extraScript"]
    exec(compile(script.read_text(), str(script), "exec"),
         {"Import": lambda *names: None, "env": environment,
          "pio_lib_builder": types.SimpleNamespace(path=str(top))})
    flags = [word.replace("-I ", f"-I{top}/") for word in build["flags"]]
    sources = [path for word in build["srcFilter"][1:]
               for path in (top / build["srcDir"] / word[2:-1]).rglob("*.cpp")]
    link(work, [*flags, f"-I{top / build['includeDir']}",
                *(f"-I{path}" for path in environment.includes)], sources, programs)


def platformio(top, work):
    played = TESTS / "arduino"
    example = top / "port/platformio/example"
    if "custom" in (example / "platformio.ini").read_text():
        finish(0, ["PlatformIO: the example asks for a generator"])
    from_library_json(top, work, {"picture": [program_of(work)], "example": [
        "-fsyntax-only", f"-I{played / 'core'}", f"-I{played / 'displays'}",
        example / "src/main.cpp"]})


    if os.environ.get("INKCELL_PLATFORMIO_DIR"):
        real_platformio(top, work)


def real_platformio(top, work):
    """A project of PlatformIO, in place of the picture by its stand-in."""
    project = work / "project"
    (project / "src").mkdir(parents=True)
    (project / "src/main.cpp").write_text((work / "picture.cpp").read_text())
    (project / "platformio.ini").write_text(
        "[env:native]\nplatform = native\nbuild_flags = -std=gnu++17\n"
        f"lib_deps = symlink://{top}\n")
    call("/usr/bin/python3", "-m", "platformio", "run", "-d", project, env={
        **os.environ, "PYTHONPATH": os.environ["INKCELL_PLATFORMIO_DIR"]})
    (project / ".pio/build/native/program").replace(work / "picture")


def by_cmake(system):
    def build(top, work):
        sample = top / SAMPLES[system] if SAMPLES[system] else ""
        if system == "micropython":
            write_header(work, (top / f"fonts/{FONT}.bin").read_bytes())
        call("cmake", "-G", "Ninja", "-S", HERE / "played", "-B", work / "build",
             f"-DSYSTEM={system}", f"-DARCHIVE={top}", f"-DSAMPLE={sample}",
             f"-DTESTS={TESTS}", f"-DSOURCES={program_of(work)}",
             f"-DCMAKE_CXX_FLAGS=-I{work} -Os")
        call("cmake", "--build", work / "build")
        (work / "build/picture").rename(work / "picture")
        if sample:
            call(work / "build/sample")
        elif os.environ.get("INKCELL_MICROPYTHON_DIR"):
            real_micropython(top, work)
        if system == "esp_idf" and os.environ.get("INKCELL_IDF_DIR"):
            real_idf(top, work)
    return build


def real_idf(top, work):
    """A project of ESP-IDF, in place of the picture by its stand-in."""
    project = work / "project"
    (project / "main").mkdir(parents=True)
    (project / "CMakeLists.txt").write_text(IDF.format(top=top))
    (project / "main/CMakeLists.txt").write_text(
        "idf_component_register(SRCS picture.cpp PRIV_REQUIRES inkcell)\n")
    (project / "main/picture.cpp").write_text(
        (work / "picture.cpp").read_text().replace("int main()", "int draw()") +
        "#include <stdlib.h>\nextern \"C\" void app_main() {\n  const int result = draw();\n"
        "  fflush(stdout);\n  _Exit(result);\n}\n")
    environment = {**os.environ, "IDF_PATH": os.environ["INKCELL_IDF_DIR"],
                   "IDF_TARGET": "linux", "IDF_COMPONENT_MANAGER": "0"}
    call("cmake", "-G", "Ninja", "-S", project, "-B", project / "build",
         "-DIDF_TARGET=linux", "-DPYTHON=/usr/bin/python3", "-DPYTHON_DEPS_CHECKED=1",
         env=environment)
    call("cmake", "--build", project / "build", env=environment)
    picture = work / "picture"
    # Logs come first.
    picture.write_text(f"#!/bin/sh\n{project}/build/picture.elf | tail -c 8014\n")


def real_micropython(top, work):
    """The unix port with the module, in place of the picture in C++."""
    port = pathlib.Path(os.environ["INKCELL_MICROPYTHON_DIR"]) / "ports/unix"
    call("make", "-C", port, "-j2", "VARIANT=standard", *check_micropython.WITHOUT,
         f"BUILD={work / 'port'}", f"USER_C_MODULES={top / 'port/micropython'}")
    (work / "picture.py").write_text(MICROPYTHON)
    picture = work / "picture"
    picture.write_text(f"#!/bin/sh\nexec {work}/port/micropython {work}/picture.py "
                       f"{top}/fonts/{FONT}.bin\n")


def esphome(top, work):
    """The font that the component makes code of, and the library that it adds."""
    check_esphome.COMPONENT = top / "port/esphome/components/inkcell"
    component, codegen = check_esphome.load_component()
    asyncio.run(component["to_code"]({
        "id": "large", "file": str(top / f"fonts/{FONT}.bin"), "size": 24,
        "levels": 256, "fontgen": "none", "raw": "rom"}))
    named = {name for sample in ("example", "oled") for name in re.findall(
        r"file: inkcell/(\S+)", (top / f"port/esphome/{sample}.yaml").read_text())}
    if codegen.libraries != {("Inkcell", None, f"symlink://{top}")} or len(named) < 2 or (
            not all((top / name).is_file() for name in named)):
        finish(0, [f"ESPHome: {codegen.libraries}, {named}"])
    write_header(work, codegen.arrays[0])
    from_library_json(top, work, {
        "picture": [f"-I{work}", program_of(work)],
        "component": ["-fsyntax-only", f"-I{check_esphome.HERE / 'played'}",
                      check_esphome.COMPONENT / "inkcell_font.cpp"]})
    if os.environ.get("INKCELL_ESPHOME_DIR"):
        real_esphome(top, work)


def real_esphome(top, work):
    """What ESPHome makes of a configuration draws as a painter does."""
    project = work / "project"
    project.mkdir()
    (project / "inkcell").symlink_to(top)
    config = project / "picture.yaml"
    config.write_text(ESPHOME.replace("FONT", FONT))
    call("/usr/bin/python3", "-m", "esphome", "compile", "--only-generate", config,
         env={**os.environ, "PYTHONPATH": os.environ["INKCELL_ESPHOME_DIR"]})
    made = project / ".esphome/build/picture"
    asked = (made / "platformio.ini").read_text()
    if f"Inkcell=symlink://{top.resolve()}" not in asked:
        finish(0, [f"ESPHome does not add the library: {asked}"])
    flags = [word for word in asked.split() if re.match("-[DIl]", word)]
    fitted = work / "fitted.cpp"
    fitted.write_text(program_of(work).read_text().replace(
        "Style(24_px)", "fitted(font)").replace("int main() {", FITTED))
    from_library_json(top, work, {"fitted": [f"-I{work}", fitted], "program": [
        *(made / "src").rglob("*.cpp"), f"-I{made / 'src'}", *flags]})
    wanted = call(work / "fitted", encoding="latin-1")
    if call(work / "program", encoding="latin-1",
            env={**os.environ, "SDL_VIDEODRIVER": "dummy"}) != wanted:
        finish(0, ["ESPHome's program draws another picture than a painter"])


def two_files(top, work):
    fonts, = (work.parent / "fonts").iterdir()
    link(work, [f"-I{top}", f"-I{fonts}/hpp"], [top / "inkcell.cpp"],
         {"picture": [program_of(work)]})


def in_c(top, work):
    """picture.c with the two files, where inkcell.h lies, too."""
    fonts, = (work.parent / "fonts").iterdir()
    (work / "sans.h").write_text(f"#include <fonts/{FONT}.h>\n"
                                 f"#define sans {FONT}\n#define sans_size {FONT}_size\n")
    link(work, [f"-I{top}"], [top / "inkcell.cpp"], {})
    call("gcc", "-std=c99", "-Os", f"-I{top}", f"-I{work}", f"-I{fonts}/c",
         HERE / "picture.c", fonts / f"c/fonts/{FONT}.c", work / "library.a", "-o",
         work / "picture")


def by_project(name):
    """The lines of the archive's README, for a program named app."""
    file, commands = PROJECTS[name]

    def build(top, work):
        program_of(work).rename(work / "app.cpp")
        (work / "subprojects").mkdir()
        (work / "subprojects/inkcell").symlink_to(top)
        (work / "inkcell").symlink_to(top)
        block = re.search(rf"```{name}\n(.*?)```", (top / "README.md").read_text(),
                          re.S)[1]
        if name == "cmake":
            block = ("cmake_minimum_required(VERSION 3.25)\n"
                     "project(app LANGUAGES C CXX)\nadd_executable(app app.cpp)\n"
                     f"{block}")
        (work / file).write_text(block)
        call("sh", "-euc", commands, cwd=work)
        (work / "picture").symlink_to(
            work / ("app" if name == "make" else "build/app"))
    return build


PROJECTS = {"cmake": ("CMakeLists.txt", "cmake -B build; cmake --build build"),
            "make": ("Makefile", "make app"),
            "meson": ("meson.build", "meson setup build; meson compile -C build")}


def sizes_of(folder):
    """Problems of the sizes of fonts."""
    sizes = {path.stem: path.stat().st_size for path in folder.glob("*.bin")}
    return [f"{name} has {size} bytes, not {most}" for name, size in sizes.items()
            for kind, most in LARGEST.items()
            if name.endswith(kind) and size > most]


def processor_seconds():
    """Of all programs that have ended."""
    times = os.times()
    return times.children_user + times.children_system


SYSTEMS = {"two_files": two_files, "c": in_c,
           **{name: by_project(name) for name in PROJECTS},
           "arduino": arduino, "platformio": platformio, "esphome": esphome,
           **{name: by_cmake(name) for name in SAMPLES}}


def main():
    work, release = arguments()
    os.environ["CCACHE_DISABLE"] = "1"  # a user's first build
    pieces = {name: next(release.glob(pattern)) for name, pattern in (
        ("fonts", "inkcell-fonts-*.zip"), ("two_files", "inkcell-[0-9]*.zip"),
        ("c", "inkcell-[0-9]*.zip"),
        *((name, f"inkcell-{'library' if name in PROJECTS else name}-*.zip")
          for name in list(SYSTEMS)[2:]))}
    pictures = {}
    for name, piece in pieces.items():
        begun = processor_seconds()
        folder = work / name
        call("unzip", "-q", piece, "-d", folder)
        top, = folder.iterdir()
        if name == "fonts":
            continue
        built = work / f"{name}-built"
        built.mkdir()
        SYSTEMS[name](top, built)
        pictures[name] = call(built / "picture", encoding="latin-1")
        print(f"{name}: {processor_seconds() - begun:.0f} s of processor time from "
              f"a file of {piece.stat().st_size:,} bytes to a picture", flush=True)
    wanted = pictures["two_files"]
    problems = [f"{name} draws another picture" for name, picture in pictures.items()
                if picture != wanted]
    problems += sizes_of(next((work / "fonts").iterdir()) / "bin")
    if len(wanted.replace("\0", "")) < 500:
        problems.append("the picture has no ink")
    finish(len(pictures), problems)


main()
