"""Meson: Inkcell below subprojects/, and a cross file."""
import json

from packages.consumer import (COMPILE, FONT_OPTIONS, LIBRARIES, LINK,
                               check_libraries, size_of, write_sources)
from toolchains import FONT, ROOT, call

PROJECT = """project('user', 'cpp', default_options: ['cpp_std=c++17',
  'optimization=s', 'b_pie=false', 'cpp_rtti=false', 'cpp_eh=none'])
inkcell = subproject('inkcell',
  default_options: 'libraries=layout').get_variable('inkcell_dep')
fontgen = find_program('{fontgen}', native: true)
font = custom_target(input: '{font}', output: 'dejavu_sans.hpp',
  command: [fontgen, '--font=@INPUT@', '--name=dejavu_sans', {options},
            '--quiet', '--out=@OUTPUT@'])
executable('app', 'main.cpp', 'readme.cpp', font, dependencies: inkcell)
"""
LVGL = """project('lvgl')
meson.override_dependency('lvgl', declare_dependency())
"""
CROSS = """[binaries]
cpp = 'arm-none-eabi-g++'
ar = 'arm-none-eabi-ar'
[host_machine]
system = 'none'
cpu_family = 'arm'
cpu = 'cortex-m0'
endian = 'little'
[built-in options]
cpp_args = {compile}
cpp_link_args = {link}
"""


def sources_of(build):
    """What a build compiles."""
    commands = json.loads((build / "compile_commands.json").read_text())
    return [entry["file"] for entry in commands]


def build(work, _, fontgen):
    folder = work / "meson"
    write_sources(folder)
    # Meson makes no folders for outputs.
    readme = folder / "readme.cpp"
    readme.write_text(readme.read_text().replace("<fonts/dejavu_sans.hpp>",
                                                 "<dejavu_sans.hpp>"))
    (folder / "subprojects").mkdir()
    (folder / "subprojects/inkcell").symlink_to(ROOT)
    (folder / "subprojects/lvgl").mkdir()
    (folder / "subprojects/lvgl/meson.build").write_text(LVGL)
    (folder / "meson.build").write_text(PROJECT.format(
        fontgen=fontgen, font=FONT,
        options=", ".join(f"'{word}'" for word in FONT_OPTIONS)))
    # newlib-nano is what the C compiler's link takes elsewhere, too; the C++
    # library, which Debian lacks, is left out.
    (folder / "cross.ini").write_text(CROSS.format(
        compile=COMPILE, link=[*LINK, "-nodefaultlibs", "-lc", "-lgcc"]))
    call("meson", "setup", "--cross-file", folder / "cross.ini",
         folder / "build", folder)
    call("meson", "compile", "-C", folder / "build")
    check_libraries("Meson", sources_of(folder / "build"), ["layout"])
    project = folder / "meson.build"
    project.write_text(project.read_text().replace(
        "inkcell = subproject(", "subproject('lvgl')\ninkcell = subproject("))
    call("meson", "setup", "--cross-file", folder / "cross.ini",
         "-Dinkcell:libraries=c,layers,lvgl,shaping,simulation,stored,strike,truetype",
         folder / "all", folder)
    check_libraries("Meson", sources_of(folder / "all"), LIBRARIES)
    return {"meson": size_of(folder / "build/app")}
