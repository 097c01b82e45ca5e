"""Checks the Arduino library: what Library Manager asks for, and that each example
draws on the host what a painter draws on a canvas of the whole screen.

The core of Arduino is played by tests/build/arduino/core. So are Adafruit_GFX,
Adafruit_SSD1306 and TFT_eSPI, unless INKCELL_ARDUINO_DIR names a folder of
libraries: then examples run with those of Adafruit, and the one for TFT_eSPI is
compiled with its headers, too. The example of PlatformIO is compiled with the flags
of library.json.

Usage: check_arduino.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import json
import os
import pathlib
import re
import sys

from toolchains import ROOT, archives, arguments, call, finish, make_font, run

PLAYED = ROOT / "tests/build/arduino"
PACK = ROOT / "port/arduino/pack.py"
COMPILE = ["g++", "-std=gnu++17", "-O1", "-fno-exceptions", "-fno-rtti",
           "-DARDUINO=10819", "-w"]
# Library Manager's rules, from the specification of Arduino libraries: fields of
# library.properties, categories, names, and what an archive may not hold.
FIELDS = ("name", "version", "author", "maintainer", "sentence", "paragraph",
          "category", "url", "architectures", "includes")
CATEGORIES = ("Display", "Communication", "Signal Input/Output", "Sensors",
              "Device Control", "Timing", "Data Storage", "Data Processing",
              "Other")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}")
VERSION = re.compile(r"\d+\.\d+\.\d+")
URL = re.compile(r"https?://\S+")
KEYWORD = re.compile(r"\w+\t(KEYWORD[123]|LITERAL[12])")
BANNED = (".exe", ".dll", ".so", ".a", ".o")


def check_rules(folder, url):
    """Problems of a packed library."""
    properties = dict(line.split("=", 1) for line in
                      (folder / "library.properties").read_text().splitlines())
    problems = [f"library.properties: no {key}" for key in FIELDS
                if not properties.get(key, "").strip()]
    if problems:
        return problems
    checks = {
        "name": NAME.fullmatch(properties["name"]) is not None and
                not properties["name"].lower().startswith("arduino"),
        "version": VERSION.fullmatch(properties["version"]),
        "category": properties["category"] in CATEGORIES,
        "url": URL.fullmatch(properties["url"]) and properties["url"] == url,
        "architectures": re.fullmatch(r"[\w*]+(,[\w*]+)*",
                                      properties["architectures"]),
        "includes": all((folder / "src" / header).is_file()
                        for header in properties["includes"].split(",")),
    }
    problems += [f"library.properties: {key}={properties[key]}"
                 for key, is_good in checks.items() if not is_good]
    files = [path for path in folder.rglob("*") if not path.is_dir()]
    problems += [f"{path} is not allowed in a library" for path in files
                 if path.is_symlink() or path.suffix in BANNED
                 or path.name == ".development"]
    if not (folder / "LICENSE").is_file():
        problems.append("LICENSE is missing")
    sketches = list((folder / "examples").iterdir())
    problems += [f"{sketch} has no sketch of its name" for sketch in sketches
                 if not (sketch / f"{sketch.name}.ino").is_file()]
    keywords = (folder / "keywords.txt").read_text().splitlines()
    problems += [f"keywords.txt: {line!r}" for line in keywords
                 if not KEYWORD.fullmatch(line)]
    class_text = (folder / "src/InkcellPrint.h").read_text()
    problems += [f"keywords.txt: InkcellPrint.h has no {line.split()[0]}"
                 for line in keywords
                 if not re.search(rf"\b{line.split()[0]}\b", class_text)]
    # Each public header is in Inkcell.h.
    included = set(re.findall(r'"(inkcell/.*)"',
                              (folder / "src/Inkcell.h").read_text()))
    public = {str(path.relative_to(root)) for root in
              [ROOT / "core/include", *ROOT.glob("core/*/include"),
               ROOT / "port/pixel/include", ROOT / "port/display/include"]
              for path in root.rglob("*.hpp")}
    if included != public:
        problems.append(f"Inkcell.h differs by {included ^ public}")
    return problems


def display_folders():
    """Include folders and sources of the displays, and the folder of TFT_eSPI or
    None."""
    given = os.environ.get("INKCELL_ARDUINO_DIR")
    if given is None:
        print("displays: played (INKCELL_ARDUINO_DIR names real libraries)")
        return [PLAYED / "displays"], [], None
    given = pathlib.Path(given)
    folders = [given / name for name in
               ("Adafruit-GFX-Library", "Adafruit_SSD1306", "TFT_eSPI")]
    for folder in folders:
        if not folder.is_dir():
            finish(0, [f"INKCELL_ARDUINO_DIR: there is no {folder}"])
    print(f"displays: Adafruit_GFX and Adafruit_SSD1306 of {given}; TFT_eSPI's "
          "headers are compiled, and its panel is played")
    return ([*folders[:2], PLAYED / "displays"],
            [folders[0] / "Adafruit_GFX.cpp",
             folders[1] / "Adafruit_SSD1306.cpp"], folders[2])


def check_sketch(folder, name, work, build, includes, sources):
    """Problems of a sketch that the host runs."""
    program = work / name
    result = run([*COMPILE, f"-I{folder / 'src'}", *includes,
                  f"-I{folder / 'examples' / name}", f"-I{PLAYED}", "-include",
                  "Arduino.h", PLAYED / f"test_{name}.cpp",
                  PLAYED / "core/core.cpp", *sources,
                  *archives(build), "-o", program])
    if result.returncode == 0:
        result = run([program])
        print(result.stdout, end="")
    return [f"{name}:\n{result.stdout}"] if result.returncode != 0 else []


def check_platformio(folder, includes):
    """Problems of PlatformIO's example, with the font of the packed library."""
    example = ROOT / "port/platformio/example"
    options = (example / "platformio.ini").read_text()
    build = json.loads((ROOT / "library.json").read_text())["build"]
    flags = [word.replace("-I ", f"-I{ROOT}/") for word in build["flags"]]
    result = run([*COMPILE, *flags, f"-I{ROOT / build['includeDir']}",
                  f"-I{folder / 'src'}", *includes, "-fsyntax-only", example / "src/main.cpp"])
    problems = [f"platformio.ini: no {words}" for words in
                ("build_flags = -std=gnu++17", "--name=dejavu_sans_latin1", "symlink://../../..")
                if words not in options]
    return problems + ([result.stdout] if result.returncode != 0 else [])


def main():
    work, build, fontgen = arguments()
    folder = work / "Inkcell"
    url = "https://example.org/inkcell"
    call(sys.executable, "-B", PACK, folder, "--url", url)
    make_font(fontgen, folder / "src/fonts/dejavu_sans_latin1.hpp", "0x20-0x7E,0xB0")
    sketch = folder / "examples/Adafruit_SSD1306_Strikes/Adafruit_SSD1306_Strikes.ino"
    told = re.findall(r"--chars (\S+)[^-]*--strike \S+ --strike-only --name (\S+)",
                      sketch.read_text())
    for chars, name in told:
        make_font(fontgen, folder / f"examples/Adafruit_SSD1306_Strikes/{name}.h",
                  chars, "--strike-only", f"--strike={name[-2:]}:1")
    problems = check_rules(folder, url)
    told = run([sys.executable, "-B", PACK, "--help"])
    problems += [f"pack.py --help does not name {word}" for word in
                 ("FOLDER", "--url")
                 if told.returncode != 0 or word not in told.stdout]
    again = run([sys.executable, "-B", PACK, folder])
    if again.returncode == 0 or "exists" not in again.stdout:
        problems.append(f"pack.py packs over a folder: {again.stdout}")
    folders, sources, tft = display_folders()
    includes = [f"-I{path}" for path in (*folders, PLAYED / "core")]
    sketches = sorted(path.name for path in (folder / "examples").iterdir()
                      if path.name != "Hello")  # check_packages.py has it
    for name in sketches:
        problems += check_sketch(
            folder, name, work, build, includes,
            sources if name.startswith("Adafruit") else [])
    problems += check_platformio(folder, includes)
    if tft is not None:
        result = run([*COMPILE, "-fsyntax-only", f"-I{folder / 'src'}",
                      f"-I{tft}", f"-I{PLAYED / 'core'}", "-include",
                      "Arduino.h", "-x", "c++",
                      folder / "examples/TFT_eSPI_Value/TFT_eSPI_Value.ino"])
        if result.returncode != 0:
            problems.append(f"TFT_eSPI:\n{result.stdout}")
    finish(4 + len(sketches), problems)


main()
