"""The project of a user, for Cortex-M0 at -Os: the README's program and a main()
without start-up code."""
import pathlib
import re

from toolchains import ROOT, call, finish

CPU = ["-mcpu=cortex-m0", "-mthumb"]
COMPILE = [*CPU, "-Os", "-ffunction-sections", "-fdata-sections",
           "-fno-exceptions", "-fno-rtti"]
# What only cells need: no program has it unless it asks for them.
FIELDS = ("FieldRows::", "read_field", "samples_distance")
# No start-up code of a board, no C library but its memset() and memcpy().
LINK = [*CPU, "-nostartfiles", "-Wl,--gc-sections", "-Wl,-e,main"]
MAIN = """#include <inkcell/inkcell.hpp>

inkcell::Status hello(const inkcell::Strip& strip);

static uint8_t pixels[2 * 160 * 40];

int main() {
  inkcell::Strip strip;
  strip.pixels = pixels;
  strip.width = 160;
  strip.height = 40;
  strip.stride = 2 * 160;
  return hello(strip) == inkcell::Status::ok ? 0 : 1;
}
"""
# The smallest program of a canvas and strikes; what its font is the linker does not
# mind. Then names of what only outlines need.
STRIKES = """#include <@HEADER@>

using namespace inkcell;

extern uint8_t pixels[2048];
uint8_t pixels[2048];
extern const uint8_t font_bytes[4];
alignas(4) const uint8_t font_bytes[4] = {};

int main() {
  Font font;
  const Status status = Font::open({font_bytes, 4}, kBitStrikeCoding, font);
  const port::@CANVAS@ canvas({pixels, 0, 0, 128, 64, 128}, 1, 0);
  Painter(canvas).text(font, Style(12_px), {4, 28}, "12:34");
  return static_cast<int>(status);
}
"""
STRIKES_IN_C = """#include <inkcell/inkcell.h>

extern uint8_t pixels[1024];
uint8_t pixels[1024];
extern const uint8_t font_bytes[4];
alignas(4) const uint8_t font_bytes[4] = {};

int main() {
  inkcell_font_t font;
  inkcell_font_open_bit_strike(font_bytes, 4, &font);
  inkcell_style_t style;
  inkcell_style_make(12 * 64, &inkcell_filter_area, &style);
  inkcell_mono_pages_target_t screen = {{pixels, 1024, 0, 0, 128, 64, 128, 0}, 128, 1};
  inkcell_sink_t sink;
  inkcell_mono_pages_sink(&screen, &sink);
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  inkcell_draw_text(&painter, &font, "12:34", 5, &style, 4 * 64, 28 * 64);
}
"""
STRIKE_CANVASES = ("MonoPages", "MonoRows", "Grey2")
OUTLINES = ("OutlineReader", "paint_areas", "cover_areas", "kFitTwoLevels",
            "kFitFourLevels", "LevelRule", "kFewLevelsMixer")
FONT_OPTIONS = ["--chars=0x20-0x7E"]
# Parts that a project compiles if it asks for them, and their folders.
LIBRARIES = {"cache": "core/cache", "field": "core/field",
             "layout": "core/layout", "motion": "core/motion",
             "figures": "core/figures",
             "layers": "core/layers",
             "shaping": "core/shaping", "simulation": "core/simulation",
             "stored": "core/stored", "strike": "core/strike",
             "truetype": "core/truetype", "lvgl": "port/lvgl", "c": "port/c"}
KCONFIG = ROOT / "port/libraries.kconfig"


def write_sources(folder):
    """The README's code and a main() beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    text = (ROOT / "README.md").read_text()
    code = re.findall(r"^```cpp\n(.*?)^```$", text, re.M | re.S)
    (folder / "readme.cpp").write_text("\n".join(code))
    (folder / "main.cpp").write_text(MAIN)


def check_libraries(system, paths, wanted):
    """Ends the test unless sources or objects are of the libraries that a project
    asks for, and of no other."""
    paths = [path.as_posix() for path in map(pathlib.Path, paths)]
    found = [name for name, folder in LIBRARIES.items()
             if any(f"/{folder}/" in path for path in paths)]
    if not paths or found != list(wanted):
        finish(0, [f"{system}: libraries {found} are compiled of {len(paths)} "
                   f"files, not {list(wanted)}"])


def library_symbols(kconfig):
    """The symbols of the libraries, which a file of Kconfig must lead to."""
    symbols = re.findall(r"^config (\w+)", KCONFIG.read_text(), re.M)
    source = re.search(r'^rsource "(\S+)"$', kconfig.read_text(), re.M)
    if (symbols != [f"INKCELL_{name.upper()}" for name in LIBRARIES] or
            source is None or
            (kconfig.parent / source.group(1)).resolve() != KCONFIG):
        finish(0, [f"{kconfig} leads to {source}, with {symbols}"])
    return symbols


def size_of(program):
    """Bytes of code, constants and initialised data of a linked program, which
    must not have code of fields."""
    names = call("arm-none-eabi-nm", "-C", program)
    for name in FIELDS:
        if name in names:
            finish(0, [f"{program}: {name} is linked by default"])
    text, data = call("arm-none-eabi-size", program).splitlines()[1].split()[:2]
    return int(text) + int(data)


def code_of(program):
    """Bytes of the sections .text of a linked program."""
    return int(re.search(r"^\.text\s+(\d+)",
                         call("arm-none-eabi-size", "-A", program),
                         re.M).group(1))
