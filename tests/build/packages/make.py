"""Make: port/make/inkcell.mk in a Makefile."""
from packages.consumer import (COMPILE, FONT, FONT_OPTIONS, LIBRARIES, LINK,
                               call, check_libraries, size_of, write_sources)
from toolchains import ROOT

MAKEFILE = """INKCELL := {root}
INKCELL_FONTGEN := {fontgen}
INKCELL_LIBRARIES := layout
CXX := arm-none-eabi-g++
CXXFLAGS := {compile}
include $(INKCELL)/port/make/inkcell.mk

app: build/main.o build/readme.o $(INKCELL_OBJECTS)
	arm-none-eabi-gcc {link} $^ -o $@
build/%.o: %.cpp
	mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(INKCELL_FLAGS) -c $< -o $@
$(eval $(call inkcell_font,dejavu_sans,{font},{options}))
build/readme.o: $(INKCELL_FONTS)/fonts/dejavu_sans.hpp
list:
	echo $(INKCELL_SOURCES)
"""


def build(work, _, fontgen):
    folder = work / "make"
    write_sources(folder)
    (folder / "Makefile").write_text(MAKEFILE.format(
        root=ROOT, fontgen=fontgen, font=FONT, link=" ".join(LINK),
        compile=" ".join(COMPILE), options=" ".join(FONT_OPTIONS)))
    call("make", "-C", folder, "-j2", "-s")
    check_libraries("Make", (folder / "build").rglob("*.o"), ["layout"])
    listed = call("make", "-C", folder, "-s", "list",
                  "INKCELL_LIBRARIES=c kinetic").split()
    check_libraries("Make", listed, LIBRARIES)
    return {"make": size_of(folder / "app")}
