"""Arduino: the packed library and its sketch, all compiled with src/ alone as
include folder, and a few lines in place of Arduino.h."""
import sys

from packages.consumer import FONT, call
from packages.file_list import compile_all, link
from toolchains import ROOT

ARDUINO_H = """#pragma once
#include <stdint.h>
#include <stddef.h>
struct Port {
  void begin(long) {}
  void println(const char*) {}
  void println(int) {}
};
extern Port Serial;
void delay(unsigned long);
void setup();
void loop();
"""
ARDUINO_CPP = """#include "Arduino.h"
Port Serial;
void delay(unsigned long) {}
int main() { setup(); loop(); }
"""
FLAGS = ["-std=gnu++17", "-fno-exceptions", "-fno-rtti",
         "-fno-threadsafe-statics", "-Wno-error"]


def build(work, _, fontgen):
    folder = work / "arduino"
    library = folder / "Inkcell"
    folder.mkdir()
    call(sys.executable, ROOT / "port/arduino/pack.py", FONT, fontgen, library)
    properties = dict(line.split("=", 1) for line in
                      (library / "library.properties").read_text().splitlines())
    for key in ("name", "version", "author", "maintainer", "sentence",
                "paragraph", "category", "architectures", "includes"):
        if not properties.get(key):
            raise SystemExit(f"library.properties: no {key}\n"
                             "0 passed, 1 failed")
    core = folder / "core"
    core.mkdir()
    (core / "Arduino.h").write_text(ARDUINO_H)
    (core / "main.cpp").write_text(ARDUINO_CPP)
    sources = [*(library / "src").rglob("*.cpp"), core / "main.cpp",
               library / "examples/Hello/Hello.ino"]
    objects = compile_all(folder / "objects", sources, [
        *FLAGS, f"-I{library / 'src'}", f"-I{core}", "-include", "Arduino.h"])
    return {"arduino": link(folder / "app", objects)}
