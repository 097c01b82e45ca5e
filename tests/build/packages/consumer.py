"""The project of a user, for Cortex-M0 at -Os: the README's program and a main()
without start-up code."""
import pathlib
import re
import sys

from toolchains import ROOT, run

FONT = pathlib.Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
CPU = ["-mcpu=cortex-m0", "-mthumb"]
COMPILE = [*CPU, "-Os", "-ffunction-sections", "-fdata-sections",
           "-fno-exceptions", "-fno-rtti"]
# One coding, as in the README: the others are left out.
OPTIONS = {"INKCELL_EDGE_CELLS": 0, "INKCELL_SAMPLE_CELLS": 0}
DEFINE = [f"-D{name}={value}" for name, value in OPTIONS.items()]
# No start-up code of a board, no C library but its memset() and memcpy().
LINK = [*CPU, "-nostartfiles", "-Wl,--gc-sections", "-Wl,-e,main"]
MAIN = """#include <inkcell/status.hpp>
#include <inkcell/strip.hpp>

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
FONT_OPTIONS = ["--chars=0x20-0x7E"]


def call(*command, **options):
    """Output of a command that must work."""
    result = run(command, **options)
    if result.returncode != 0:
        words = " ".join(map(str, command))
        sys.exit(f"{words}\n{result.stdout}\n0 passed, 1 failed")
    return result.stdout


def write_sources(folder):
    """The README's code and a main() beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    text = (ROOT / "README.md").read_text()
    code = re.findall(r"^```cpp\n(.*?)^```$", text, re.M | re.S)
    (folder / "readme.cpp").write_text("\n".join(code))
    (folder / "main.cpp").write_text(MAIN)


def make_font(fontgen, folder):
    """<folder>/fonts/dejavu_sans.hpp, as the README's program includes it."""
    (folder / "fonts").mkdir(parents=True)
    call(fontgen, f"--font={FONT}", "--name=dejavu_sans", *FONT_OPTIONS,
         "--quiet", f"--out={folder / 'fonts/dejavu_sans.hpp'}")


def size_of(program):
    """Bytes of code, constants and initialised data of a linked program."""
    text, data = call("arm-none-eabi-size", program).splitlines()[1].split()[:2]
    return int(text) + int(data)
