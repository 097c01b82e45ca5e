"""Checks the external component of ESPHome.

A font prints on a display what a painter prints on a canvas, with headers of
ESPHome that are played; so is its configuration in Python. Where
INKCELL_ESPHOME_DIR names ESPHome's sources, the component is compiled against
them, too.

Usage: check_esphome.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import asyncio
import os
import pathlib
import sys
import types

from toolchains import (FONT, INCLUDES, ROOT, archives, arguments, finish, make_font,
                        run)

COMPONENT = ROOT / "port/esphome/components/inkcell"
HERE = ROOT / "tests/build/esphome"
SOURCES = [HERE / "test_font.cpp", COMPONENT / "inkcell_font.cpp"]


# The configuration of which the fonts are a part.
CONFIG = {}


class Anything:
    """Any attribute, called with anything, is the like."""

    def __getattr__(self, name):
        return self

    def __call__(self, *_, **__):
        return self


class Codegen(Anything):
    """esphome.codegen, which notes what the component asks for."""

    def __init__(self):
        self.arrays, self.fonts, self.libraries = [], [], set()

    def progmem_array(self, name, values):
        self.arrays.append(bytes(values))
        return name

    def new_Pvariable(self, *arguments):
        self.fonts.append(arguments)

    def add_library(self, *arguments):
        self.libraries.add(arguments)


class Validation(Anything):
    class Invalid(Exception):
        def __init__(self, message, path=()):
            super().__init__(message)
            self.path = path


def load_component():
    """The component's Python with modules of ESPHome that are played."""
    codegen = Codegen()
    core = types.SimpleNamespace(
        CORE=types.SimpleNamespace(relative_config_path=pathlib.Path, config=CONFIG),
        HexInt=int)
    const = types.SimpleNamespace(CONF_FILE="file", CONF_GLYPHS="glyphs",
                                  CONF_ID="id", CONF_RAW_DATA_ID="raw",
                                  CONF_SIZE="size")
    modules = {"esphome": types.ModuleType("esphome"), "esphome.codegen": codegen,
               "esphome.config_validation": Validation(),
               "esphome.const": const, "esphome.core": core}
    modules["esphome"].codegen = codegen
    modules["esphome"].config_validation = modules["esphome.config_validation"]
    sys.modules.update(modules)
    path = COMPONENT / "__init__.py"
    module = {"__file__": str(path), "__name__": "inkcell"}
    # The schema is what real ESPHome checks; here any dictionary will do.
    Validation.Schema = staticmethod(dict)
    Validation.Required = Validation.Optional = staticmethod(
        lambda name, default=None: name)
    Validation.GenerateID = staticmethod(lambda name: name)
    Validation.All = staticmethod(lambda *parts: parts)
    Validation.ensure_list = staticmethod(
        lambda _: lambda value: value if isinstance(value, list) else [value])
    exec(compile(path.read_text(), str(path), "exec"), module)
    return module, codegen


def check_python(fontgen):
    """Problems of the code that the component generates."""
    module, codegen = load_component()
    fonts = [{"id": name, "file": str(FONT), "size": size, "glyphs": "0123",
              "levels": levels, "fontgen": str(fontgen), "raw": f"rom_{name}"}
             for name, size, levels in (("small", 14, 256), ("large", 80.5, 2))]
    for config in fonts:
        asyncio.run(module["to_code"](config))
    problems = []
    if len(codegen.arrays) != 1 or codegen.arrays[0][:4] != b"INKC":
        problems.append(f"two sizes of one font make {len(codegen.arrays)} arrays")
    size = len(codegen.arrays[0])
    wanted = [("small", "rom_small", size, 14 * 64, False),
              ("large", "rom_small", size, 5152, True)]
    if codegen.fonts != wanted:
        problems.append(f"fonts are {codegen.fonts}, not {wanted}")
    if codegen.libraries != {("Inkcell", None, f"symlink://{ROOT}")}:
        problems.append(f"libraries are {codegen.libraries}")
    if len(codegen.arrays) == 1:
        made = pathlib.Path("made.bin").resolve()
        made.write_bytes(bytes(codegen.arrays[0]))
        if module["make_font"]("no-such-program", made, "0123") != made.read_bytes():
            problems.append("a font that was made before is not taken")
        made.unlink()
    return problems + check_refused(module, fonts[0]) + check_levels(module)


def check_refused(module, font):
    """What `esphome config` must refuse, and the words of why."""
    whole = module["make_font"](font["fontgen"], font["file"], "0123")
    headed = {name: whole[:at] + bytes([value]) + whole[at + 1:]
              for name, at, value in (("newer.bin", 4, 99), ("strikes.bin", 39, 3))}
    bad = {**headed, "cut.bin": whole[:-4], "changed.bin": whole[:-1] + b"?", "no.bin": b"no font",
           "no.ttf": b"no font", "whole.bin": whole}
    for name, data in bad.items():
        pathlib.Path(name).write_bytes(data)
    problems = []
    plain = {name: value for name, value in font.items() if name != "glyphs"}
    for change, words in (({"fontgen": "no-such-program", "glyphs": "7"},
                           "inkcell-fontgen zip"),
                          ({"glyphs": "0\u4e00"}, "U+4E00"),
                          ({"file": "cut.bin"}, "cut short"),
                          ({"file": "changed.bin"}, "copy it again"),
                          ({"file": "no.bin"}, "no font of"),
                          ({"file": "newer.bin"}, "has format 0.99"),
                          ({"file": "strikes.bin"}, "--strike-only"),
                          ({"file": "gone.bin"}, "gone.bin"),
                          ({"file": "no.ttf"}, "no.ttf"),
                          ({"file": "whole.bin", "glyphs": "0"}, "leave `glyphs` out")):
        try:
            module["made"]({**plain, **change})
            problems.append(f"{change} is valid")
        except Validation.Invalid as error:
            if words not in str(error):
                problems.append(f"{change}: {error}")
    module["made"]({**plain, "file": "whole.bin"})
    for glyphs in ("0123", ["01", "23"]):
        value = glyphs
        for step in module["GLYPHS"]:
            value = step(value)
        if value != "0123":
            problems.append(f"glyphs {glyphs} are {value}")
    if "\u00b0" not in module["key_of"](plain)[2]:
        problems.append("there is no degree sign by default")
    for name in bad:
        pathlib.Path(name).unlink()
    return problems


def check_levels(module):
    """Two colours are the default where all displays have them."""
    problems = []
    for platforms, given, wanted in ((["ssd1306_i2c"], {}, True),
                                     (["ssd1306_i2c", "ili9xxx"], {}, False),
                                     ([], {}, False), (["st7789v"], {}, False),
                                     (["pcd8544"], {"levels": 256}, False),
                                     (["st7789v"], {"levels": 2}, True)):
        CONFIG["display"] = [{"platform": name} for name in platforms]
        if module["has_two_colours"](given) != wanted:
            problems.append(f"{platforms}, {given}: not {wanted}")
    CONFIG.clear()
    return problems


def main():
    work, build, fontgen = arguments()
    problems = check_python(fontgen)
    make_font(fontgen, work / "fonts/sans.hpp", "0x20-0x7E,0xB0")
    command = ["g++", "-std=gnu++20", "-w", "-fno-exceptions", f"-I{work}",
               f"-I{COMPONENT}", *INCLUDES]
    program = work / "test_font"
    result = run([*command, f"-I{HERE / 'played'}", *SOURCES, *archives(build), "-o",
                  program])
    if result.returncode == 0:
        result = run([program])
        print(result.stdout, end="")
        if "inkcell: the font is none" not in result.stdout:
            problems.append("a font that does not open is not logged")
    if result.returncode != 0:
        problems.append(result.stdout)
    given = os.environ.get("INKCELL_ESPHOME_DIR")
    print("headers of ESPHome: played (INKCELL_ESPHOME_DIR names its sources)"
          if given is None else f"headers of ESPHome: played, and {given}")
    for source in SOURCES if given is not None else []:
        result = run([*command, "-DREAL_ESPHOME", f"-I{HERE / 'defines'}",
                      f"-I{given}", "-fsyntax-only", source])
        if result.returncode != 0:
            problems.append(result.stdout)
    finish(2 if given is None else 4, problems)


if __name__ == "__main__":
    main()
