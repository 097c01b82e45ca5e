"""Arduino: the packed library and its smallest sketch, all compiled with src/ alone
as include folder, and a core that is played. check_arduino.py has the rest."""
import sys

from packages.consumer import STRIKES_IN_C
from packages.two_files import build_strikes, compile_all, link
from toolchains import ROOT, call, make_font

CORE = ROOT / "tests/build/arduino/core"
MAIN = """#include "Arduino.h"
#include "Hello.ino"
extern "C" void __cxa_pure_virtual() {}
int main() { setup(); loop(); }
"""
FLAGS = ["-std=gnu++17", "-fno-exceptions", "-fno-rtti",
         "-fno-threadsafe-statics", "-Wno-error", "-DARDUINO=10819"]


def build(work, _, fontgen):
    folder = work / "arduino"
    library = folder / "Inkcell"
    folder.mkdir()
    call(sys.executable, "-B", ROOT / "port/arduino/pack.py", library)
    make_font(fontgen, library / "src/fonts/dejavu_sans_digits.hpp", "0x20,0x30-0x3A")
    (folder / "main.cpp").write_text(MAIN)
    sources = [*(library / "src").rglob("*.cpp"), folder / "main.cpp",
               CORE / "core.cpp"]
    objects = compile_all(folder / "objects", sources, [
        *FLAGS, f"-I{library / 'src'}", f"-I{library / 'examples/Hello'}",
        f"-I{CORE}"])
    # As dot_a_linkage of library.properties asks for.
    archive = folder / "libInkcell.a"
    call("arm-none-eabi-ar", "rcs", archive, *objects[:-2])
    return {"arduino": link(folder / "app", [*objects[-2:], archive]),
            "arduino, strikes": build_strikes(
                folder / "strikes", "Inkcell.h",
                [*FLAGS, f"-I{library / 'src'}", f"-I{CORE}"],
                [archive, objects[-1]], {"C": STRIKES_IN_C})}
