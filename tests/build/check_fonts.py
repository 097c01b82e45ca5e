"""Checks the fonts of host_tools/release/fonts.py, of two faces: a compiler takes them
with the library as two files, all forms have the same bytes, licences and pictures lie
beside them, headers name icons, and two runs give the same. host_tools/setup.sh has the packages of all.

Usage: check_fonts.py WORK_FOLDER FONTGEN RENDER
"""
import json
import re
import sys

from toolchains import (C_WARNINGS, DEVICE_FLAGS, ROOT, WARNINGS, arguments, c_compiler,
                        call, finish, run)

RELEASE = ROOT / "host_tools/release"
FACES = ("dejavu_sans", "roboto")
FONTS = [f"{face}_digits" for face in FACES]

# Writes what the headers hold, and what the sources of C hold.
PROGRAM = """#include <stdio.h>

{includes}
namespace in_c {{
{c_includes}}}

int main() {{
{writes}  return 0;
}}
"""
WRITE = """  fwrite(fonts::{0}, 1, sizeof fonts::{0}, stdout);
  fwrite(in_c::{0}, 1, in_c::{0}_size, stdout);
"""


def make(folder, fontgen, render):
    call(sys.executable, "-B", RELEASE / "fonts.py", fontgen, folder, "--render",
         render, "--only", *FACES, "--sets", "digits")
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


def problems_of_forms(work, files):
    """What a program has of the fonts, against the files for storage."""
    call(sys.executable, "-B", ROOT / "port/two_files/pack.py", work / "inkcell")
    program = PROGRAM.format(
        includes="".join(f"#include <fonts/{font}.hpp>\n" for font in FONTS),
        c_includes="".join(f"#include <fonts/{font}.h>\n" for font in FONTS),
        writes="".join(map(WRITE.format, FONTS)))
    (work / "program.cpp").write_text(program)
    made = work / "made"
    objects = []
    for font in FONTS:
        objects.append(work / f"{font}.o")
        call(*c_compiler("host"), *C_WARNINGS, f"-I{made}/c", "-c",
             made / f"c/fonts/{font}.c", "-o", objects[-1])
    call("g++", *DEVICE_FLAGS, *WARNINGS, "-no-pie", f"-I{made}/hpp", f"-I{made}/c",
         f"-I{work}/inkcell", work / "program.cpp", *objects, "-o", work / "program")
    call("sh", "-c", f"{work}/program >{work}/bytes")
    expected = b"".join(2 * files[f"bin/{font}.bin"] for font in FONTS)
    return ([] if (work / "bytes").read_bytes() == expected else
            ["headers and sources hold other bytes than bin"])


def problems_of_packages():
    faces = json.loads((RELEASE / "fonts.json").read_text())["faces"]
    listed = re.search(r'inkcell_packages_fonts="([^"]*)"',
                       (ROOT / "host_tools/setup.sh").read_text()).group(1).split()
    return [f"inkcell_packages_fonts of host_tools/setup.sh lacks {face['package']}"
            for face in faces
            if face["package"] not in listed and not face["package"].startswith("npm:")]


def main():
    work, fontgen, render = arguments()
    files = make(work / "made", fontgen, render)
    problems = problems_of_forms(work, files) + problems_of_packages()
    problems += [f"{name} is missing"
                 for face in FACES
                 for name in (f"licences/{face}.txt", f"specimens/{face}.png")
                 if name not in files]
    if b"Apache License" not in files.get("licences/roboto.txt", b""):
        problems.append("the licence of Roboto lacks its text")
    again = make(work / "again", fontgen, render)
    problems += [f"made again, {name} differs"
                 for name in sorted({*files, *again})
                 if files.get(name) != again.get(name)]
    call(sys.executable, "-B", RELEASE / "fonts.py", fontgen, work / "icons", "--render",
         render, "--only", "font_awesome", "--sets", "weather")
    problems += [f"{name} does not tell the code of an icon"
                 for name in ("FONTS.md", "hpp/fonts/font_awesome_weather.hpp",
                              "c/fonts/font_awesome_weather.h")
                 if "umbrella U+F0E9" not in
                 re.sub(r"\n \*", "", (work / "icons" / name).read_text())]
    result = run([sys.executable, "-B", RELEASE / "fonts.py", fontgen, work, "--only",
                  "nothing"])
    if result.returncode == 0 or "there are inter" not in result.stdout:
        problems.append(f"--only of no face: {result.stdout}")
    finish(len(FACES), problems)


main()
