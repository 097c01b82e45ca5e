"""Make: the whole Makefile of port/make/example, and port/make/inkcell.mk."""
import shutil

from packages.consumer import (CPU, FONT_OPTIONS, LIBRARIES, LINK, check_libraries,
                               size_of, write_sources)
from toolchains import FONT, ROOT, call, finish, run

# Beside the whole Makefile: fonts before any goal, and a comma in their options.
OF_C = """include $(INKCELL)/port/make/inkcell.mk
$(eval $(call inkcell_c_font,in_c,$(FONT),--chars=0x20-0x2F,U+B0,U+B1 --quiet))
list: $(INKCELL_FONTS)/fonts/in_c.c
	echo $(INKCELL_SOURCES)
"""


def stop(problem):
    finish(0, [f"Make: {problem}"])


def build(work, _, fontgen):
    folder = work / "make"
    write_sources(folder)
    shutil.copy(ROOT / "port/make/example/Makefile", folder)
    make = ["make", "-C", folder, "-j2", "-s", f"INKCELL={ROOT}",
            f"INKCELL_FONTGEN={fontgen}", f"FONT={FONT}"]
    app = [*make, "INKCELL_LIBRARIES=pixel layout", "SOURCES=main.cpp readme.cpp",
           f"CPU={' '.join(CPU)}", f"START={' '.join(LINK)}", "LDFLAGS=",
           "FONT_NAME=dejavu_sans"]
    options = "FONT_OPTIONS=" + " ".join(FONT_OPTIONS)
    call(*app, options)
    objects = list((folder / "build").rglob("*.o"))
    check_libraries("Make", objects, ["layout"])
    if any("/display/" in str(path) for path in objects):
        stop("display is compiled, which nobody asks for")
    font = folder / "build/inkcell_fonts/fonts/dejavu_sans.hpp"
    times = []
    for more in (options, options, options + " --max-px=24"):
        call(*app, more, font.relative_to(folder))
        times.append(font.stat().st_mtime_ns)
    if times[0] != times[1] or times[1] == times[2]:
        stop(f"the font is made anew, or is not, where its options change: {times}")
    header = next(word for word in
                  (folder / "build/inkcell/core/src/font/font.d").read_text().split()
                  if word.endswith("inkcell/font.hpp"))
    if "src/font/font.cpp" not in call(*app, options, "-n", "-W", header):
        stop("objects do not depend on headers")
    size = size_of(folder / "app.elf")

    (folder / "of_c.mk").write_text(OF_C)
    (folder / "lvgl").mkdir()
    (folder / "lvgl/lvgl.h").write_text("")
    of_c = [*make, "-f", "of_c.mk", "LVGL_PATH=lvgl",
            "INKCELL_LIBRARIES=c layers lvgl shaping simulation stored strike truetype"]
    listed = call(*of_c).split()
    check_libraries("Make", listed, LIBRARIES)
    fonts = folder / "build/inkcell_fonts/fonts"
    if "U+B0,U+B1 --quiet" not in (fonts / "in_c.options").read_text():
        stop("options after a comma are lost")
    call("arm-none-eabi-gcc", *CPU, "-std=c99", "-c", fonts / "in_c.c", "-o",
         folder / "in_c.o")
    made = "build/inkcell/port/c/src/types.o"
    call(*of_c, made)
    if run([*of_c, "-q", made]).returncode != 0:
        stop("the interface for C is made again")
    said = run([*of_c, "INKCELL_BUILD=build/other", "INKCELL_PYTHON=no-python"])
    if said.returncode == 0 or "name it by INKCELL_PYTHON" not in said.stdout:
        stop(f"without Python: {said.stdout}")
    said = run([*of_c, "LVGL_PATH=nowhere"])
    if said.returncode == 0 or "'nowhere', where LVGL is not" not in said.stdout:
        stop(f"without LVGL: {said.stdout}")
    said = run([*make, "INKCELL_LIBRARIES=layuot"])
    if said.returncode == 0 or "there is no layuot" not in said.stdout:
        stop(f"a library that is not there: {said.stdout}")
    return {"make": size}
