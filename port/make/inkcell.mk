# Inkcell in a Makefile. Set INKCELL to its folder and include this file. Link
# $(INKCELL_OBJECTS), which $(CXX) makes with your $(CXXFLAGS), with
# -Wl,--gc-sections; compile your sources with $(INKCELL_INCLUDES). Objects keep
# the folders of their sources, some of which have the same name.
#
#   INKCELL := inkcell
#   include $(INKCELL)/port/make/inkcell.mk
#   $(eval $(call inkcell_font,dejavu_sans,DejaVuSans.ttf,--chars=0x20-0x7E))
#
# The font is $(INKCELL_FONTS)/fonts/dejavu_sans.hpp; name it as a prerequisite of
# the objects that include it. In C it is a source and a header:
#
#   $(eval $(call inkcell_c_font,dejavu_sans,DejaVuSans.ttf,--chars=0x20-0x7E))
#
# $(INKCELL_FONTS)/fonts/dejavu_sans.c is yours to compile, with your C flags.
#
# INKCELL_LIBRARIES names what is compiled besides the core: pixel, display (which
# needs pixel), cache, field, kinetic, layout, stored, c (which needs cache, field,
# layout and display). Set it before the include; by default it is pixel and
# display.
INKCELL_FONTGEN ?= inkcell-fontgen
INKCELL_FONTS ?= build/inkcell_fonts
INKCELL_LIBRARIES ?= pixel display
ifneq ($(filter c,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += cache field layout display
endif
ifneq ($(filter display,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += pixel
endif
INKCELL_BUILD ?= build/inkcell

INKCELL_PARTS := $(sort \
  $(addprefix $(INKCELL)/core/,$(filter cache field kinetic layout stored,$(INKCELL_LIBRARIES))) \
  $(addprefix $(INKCELL)/port/,$(filter pixel display c,$(INKCELL_LIBRARIES))))
INKCELL_SOURCES := $(wildcard $(INKCELL)/core/src/*/*.cpp \
  $(addsuffix /src/*.cpp,$(INKCELL_PARTS)))
INKCELL_INCLUDES := -I$(INKCELL)/core/include \
  $(patsubst %,-I%/include,$(INKCELL_PARTS)) -I$(INKCELL_FONTS)
INKCELL_FLAGS := $(INKCELL_INCLUDES) -I$(INKCELL)/core/src -std=c++17 \
  -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
  -ffunction-sections -fdata-sections

INKCELL_OBJECTS := $(patsubst $(INKCELL)/%.cpp,$(INKCELL_BUILD)/%.o,$(INKCELL_SOURCES))
$(INKCELL_BUILD)/%.o: $(INKCELL)/%.cpp
	mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) $(INKCELL_FLAGS) -c $< -o $@

# $(call inkcell_font,<name>,<font file>,<more arguments of inkcell-fontgen>)
define inkcell_font
$(INKCELL_FONTS)/fonts/$(1).hpp: $(2)
	mkdir -p $$(@D)
	$(INKCELL_FONTGEN) --font=$(2) --name=$(1) $(3) --quiet --out=$$@
endef

# The same as a source of C, whose array and size a header declares.
define inkcell_c_font
$(INKCELL_FONTS)/fonts/$(1).c: $(2)
	mkdir -p $$(@D)
	$(INKCELL_FONTGEN) --font=$(2) --name=$(1) $(3) --quiet --out=$$@ --header=$$(@:.c=.h)
$(INKCELL_FONTS)/fonts/$(1).h: $(INKCELL_FONTS)/fonts/$(1).c
endef
