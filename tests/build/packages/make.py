"""Make: port/make/inkcell.mk in a Makefile."""
from packages.consumer import (COMPILE, CPU, FONT, FONT_OPTIONS, LIBRARIES, LINK,
                               call, check_libraries, size_of, write_sources)
from toolchains import ROOT

CXX = "arm-none-eabi-g++"
MAKEFILE = """INKCELL := {root}
INKCELL_FONTGEN := {fontgen}
INKCELL_LIBRARIES := pixel layout
CXX := {cxx}
CXXFLAGS := {compile}
include $(INKCELL)/port/make/inkcell.mk

app: build/main.o build/readme.o $(INKCELL_OBJECTS)
	arm-none-eabi-gcc {link} $^ -o $@
build/%.o: %.cpp
	mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(INKCELL_FLAGS) -c $< -o $@
$(eval $(call inkcell_font,dejavu_sans,{font},{options}))
build/readme.o: $(INKCELL_FONTS)/fonts/dejavu_sans.hpp
$(eval $(call inkcell_c_font,in_c,{font},{options}))
list:
	echo $(INKCELL_SOURCES)
"""


def build(work, _, fontgen):
    folder = work / "make"
    write_sources(folder)
    (folder / "Makefile").write_text(MAKEFILE.format(
        root=ROOT, cxx=CXX, fontgen=fontgen, font=FONT, link=" ".join(LINK),
        compile=" ".join(COMPILE), options=" ".join(FONT_OPTIONS)))
    call("make", "-C", folder, "-j2", "-s")
    objects = list((folder / "build").rglob("*.o"))
    check_libraries("Make", objects, ["layout"])
    if any("/display/" in str(path) for path in objects):
        raise SystemExit("Make: display is compiled, which nobody asks for\n"
                         "0 passed, 1 failed")
    call("make", "-C", folder, "-s", "build/inkcell_fonts/fonts/in_c.h")
    call(CXX.replace("g++", "gcc"), *CPU, "-std=c99", "-c",
         folder / "build/inkcell_fonts/fonts/in_c.c", "-o", folder / "in_c.o")
    listed = call("make", "-C", folder, "-s", "list",
                  "INKCELL_LIBRARIES=c kinetic stored").split()
    check_libraries("Make", listed, LIBRARIES)
    return {"make": size_of(folder / "app")}
