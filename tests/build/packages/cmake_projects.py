"""CMake: a subdirectory, FetchContent, find_package() after an installation."""
import json
import re

from packages.consumer import (COMPILE, CPU, LINK, check_libraries, code_of,
                               size_of, write_sources)
from toolchains import FONT, ROOT, call, finish, run

TOOLCHAIN = """set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES C CXX)
{get}
add_executable(app main.cpp readme.cpp)
set_target_properties(app PROPERTIES LINKER_LANGUAGE C)
target_link_libraries(app PRIVATE inkcell::layout inkcell::port_pixel)
add_executable(fields EXCLUDE_FROM_ALL fields.cpp)
set_target_properties(fields PROPERTIES LINKER_LANGUAGE C)
target_link_libraries(fields PRIVATE inkcell::field inkcell::port_pixel)
add_executable(in_c EXCLUDE_FROM_ALL in_c.c)
set_target_properties(in_c PROPERTIES LINKER_LANGUAGE C)
target_link_libraries(in_c PRIVATE inkcell::c)
inkcell_add_font(app FONT {font} NAME dejavu_sans CHARS 0x20-0x7E)
"""
FETCH = """include(FetchContent)
FetchContent_Declare(inkcell SOURCE_DIR {root})
FetchContent_MakeAvailable(inkcell)"""
IN_C = """#include <inkcell/inkcell.h>

int main(void) { return inkcell_status_name(INKCELL_OK)[0]; }
"""
# A program that opens no font of outlines, with filters of both kinds.
FIELDS = """#include <inkcell/field/draw.hpp>
#include <inkcell/painter.hpp>
#include <inkcell/port/a8.hpp>

using namespace inkcell;

static uint8_t bytes[64];
static const Style kStyles[] = {Style(24_px), Style(24_px, kFilterText)};

int main() {
  Font font;
  Strip strip;
  strip.pixels = bytes;
  const port::A8Canvas canvas(strip);
  const Status status = Font::open({bytes, sizeof bytes}, kFieldCoding, font);
  Painter(canvas).text(font, kStyles[bytes[0]], {}, "text");
  return status == Status::ok ? 0 : 1;
}
"""
# What only outlines need: painters, and what reads points.
OUTLINES = ("paint_areas", "paint_distances", "paint_edge", "OutlineReader::")
FORCED = re.compile(r"-O[^s ]|-Werror|-W[a-z]")


def check_flags(folder):
    """Ends the test if a source is compiled with flags that nobody chose."""
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        if "-Os" not in entry["command"] or FORCED.search(entry["command"]):
            finish(0, [f"flags of the user do not hold: {entry}"])


def commands_of(folder):
    """What is compiled and how, without the names of folders."""
    text = (folder / "build/compile_commands.json").read_text()
    text = re.sub(r"_deps/inkcell-build", "inkcell", text)
    return text.replace(str(folder), "")


def build(work, host_build, fontgen):
    """Sizes of the three programs, by route."""
    prefix = work / "prefix"
    call("cmake", "--install", host_build, "--prefix", prefix)
    for name in ("bin/inkcell-fontgen", "bin/inkcell-render",
                 "share/inkcell/LICENSE"):
        if not (prefix / name).exists():
            finish(0, [f"{name} is not installed"])
    toolchain = work / "toolchain.cmake"
    toolchain.write_text(TOOLCHAIN)
    installed = [f"-DCMAKE_PREFIX_PATH={prefix}"]
    built = [f"-DINKCELL_FONTGEN={fontgen}"]
    routes = {
        "subdirectory": (f"add_subdirectory({ROOT} inkcell)", built),
        "FetchContent": (FETCH.format(root=ROOT), built),
        "find_package": ("find_package(Inkcell 0.2 REQUIRED)", installed),
    }
    sizes, commands = {}, {}
    for name, (get, options) in routes.items():
        folder = work / name
        write_sources(folder)
        (folder / "fields.cpp").write_text(FIELDS)
        (folder / "in_c.c").write_text(IN_C)
        (folder / "CMakeLists.txt").write_text(
            PROJECT.format(get=get, font=FONT))
        call("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build",
             f"-DCMAKE_TOOLCHAIN_FILE={toolchain}",
             "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
             f"-DCMAKE_C_FLAGS={' '.join([*CPU, '-Os'])}",
             f"-DCMAKE_CXX_FLAGS={' '.join(COMPILE)}",
             f"-DCMAKE_EXE_LINKER_FLAGS={' '.join(LINK)}", *options)
        check_flags(folder / "build")
        commands[name] = commands_of(folder)
        if commands[name] in list(commands.values())[:-1]:
            continue  # what is compiled alike has the same size
        call("cmake", "--build", folder / "build", "--target", "app")
        check_libraries(name, (folder / "build").rglob("*.o*"), ["layout"])
        sizes[name] = size_of(folder / "build/app")
    check_c(work)
    return sizes


def check_c(work):
    """Ends the test unless an installation serves programs of C without Python, a
    build does nothing twice, and one that lacks Python names the remedy."""
    for name in ("find_package", "subdirectory"):
        call("cmake", "-DCMAKE_DISABLE_FIND_PACKAGE_Python3=ON", work / name / "build")
    installed = work / "find_package/build"
    call("cmake", "--build", installed, "--target", "in_c")
    again = call("ninja", "-C", installed, "in_c")
    if "no work to do" not in again:
        finish(0, [f"a second build does work: {again}"])
    said = run(["cmake", "--build", work / "subdirectory/build", "--target", "in_c"])
    if said.returncode == 0 or "-DPython3_EXECUTABLE=PATH" not in said.stdout:
        finish(0, [f"without Python: {said.stdout}"])


def readme_code(work, fontgen):
    """Bytes of .text of the README's program as CMake builds it by default, on
    Cortex-M0, which build() has built, and on Cortex-M3."""
    folder, m3 = work / "subdirectory", work / "cortex-m3"
    options = {name: " ".join(flags).replace("cortex-m0", "cortex-m3")
               for name, flags in (("CXX_FLAGS", COMPILE),
                                   ("EXE_LINKER_FLAGS", LINK))}
    call("cmake", "-G", "Ninja", "-S", folder, "-B", m3,
         f"-DCMAKE_TOOLCHAIN_FILE={work / 'toolchain.cmake'}",
         f"-DINKCELL_FONTGEN={fontgen}",
         *(f"-DCMAKE_{name}={flags}" for name, flags in options.items()))
    call("cmake", "--build", m3, "--target", "app")
    return code_of(folder / "build/app"), code_of(m3 / "app")


def check_fields(work):
    """Ends the test if a program of fields has code of outlines."""
    folder = work / "subdirectory/build"
    call("cmake", "--build", folder, "--target", "fields")
    names = {program: call("arm-none-eabi-nm", "-C", folder / program)
             for program in ("app", "fields")}
    for name in OUTLINES:
        if name in names["fields"]:
            finish(0, [f"{folder}/fields: {name} is linked, and draws outlines"])
    # The README's program names one filter, and so one painter.
    if "paint_areas" not in names["app"] or "paint_edge" in names["app"]:
        finish(0, [f"{folder}/app: has other painters than paint_areas"])
