# Inkcell in a Makefile; port/make/example/Makefile is a whole one. Set INKCELL to its
# folder and include this file. Link $(INKCELL_OBJECTS), which $(CXX) makes with your
# $(CXXFLAGS), with -Wl,--gc-sections; compile your sources with $(INKCELL_INCLUDES).
# Objects keep the folders of their sources, some of which have the same name.
#
#   INKCELL := inkcell
#   include $(INKCELL)/port/make/inkcell.mk
#   $(eval $(call inkcell_font,dejavu_sans,DejaVuSans.ttf,--chars=0x20-0x7E))
#
# The font is $(INKCELL_FONTS)/fonts/dejavu_sans.hpp; name it as a prerequisite of
# the objects that include it. In C it is a source and a header:
#
#   $(eval $(call inkcell_c_font,dejavu_sans,DejaVuSans.ttf,--chars=0x20-0x7E,U+B0))
#
# $(INKCELL_FONTS)/fonts/dejavu_sans.c is yours to compile, with your C flags. For
# storage that is not mapped it is a file, and a header of what StoredFont needs:
#
#   $(eval $(call inkcell_stored_font,hanzi,NotoSansCJK-Regular.ttc,--set=gb2312-1 --paged=1024))
#
# $(INKCELL_FONTS)/fonts/hanzi.bin and hanzi.hpp; the library is `stored`.
#
# Fonts are made anew when their options change, or a file that they are made of:
# faces, texts, strings, icons. An icon that is new counts, unless it is in the folder
# of the Makefile.
#
# INKCELL_LIBRARIES names what is compiled besides the core: pixel, display (which
# needs pixel), cache, field, layout, motion, figures, layers and simulation (which need
# motion), stored, shaping, strike, truetype, c (which needs cache, field, layout, motion,
# figures, layers, shaping, strike, truetype and display), and lvgl, fonts for LVGL 9 (which needs
# cache, layers, strike, truetype, pixel, and LVGL_PATH, the folder of lvgl.mk). Set it before the
# include; by default it is pixel and display.
#
# The interface for C is made in $(INKCELL_BUILD)/port/c by $(INKCELL_PYTHON), before
# Make goes on. A release and an installation have it made.
INKCELL_FONTGEN ?= inkcell-fontgen
INKCELL_FONTS ?= build/inkcell_fonts
INKCELL_PYTHON ?= python3
INKCELL_LIBRARIES ?= pixel display
INKCELL_KNOWN := pixel display cache field layout motion figures layers shaping simulation stored strike truetype c lvgl
ifneq ($(filter-out $(INKCELL_KNOWN),$(INKCELL_LIBRARIES)),)
  $(error INKCELL_LIBRARIES: there is no $(filter-out $(INKCELL_KNOWN),\
    $(INKCELL_LIBRARIES)); there are $(INKCELL_KNOWN))
endif
ifneq ($(filter c,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += cache field layout figures layers shaping strike truetype display
endif
ifneq ($(filter lvgl,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += cache layers strike truetype pixel
  ifeq ($(wildcard $(LVGL_PATH)/lvgl.h),)
    $(error LVGL_PATH is '$(LVGL_PATH)', where LVGL is not: INKCELL_LIBRARIES has lvgl)
  endif
endif
ifneq ($(filter figures layers simulation,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += motion
endif
ifneq ($(filter display,$(INKCELL_LIBRARIES)),)
  override INKCELL_LIBRARIES += pixel
endif
INKCELL_BUILD ?= build/inkcell

INKCELL_PARTS := $(sort \
  $(addprefix $(INKCELL)/core/,$(filter cache field layout motion figures layers shaping simulation stored strike truetype,$(INKCELL_LIBRARIES))) \
  $(addprefix $(INKCELL)/port/,$(filter pixel display lvgl,$(INKCELL_LIBRARIES))))
ifneq ($(filter c,$(INKCELL_LIBRARIES)),)
  ifneq ($(wildcard $(INKCELL)/port/c/include),)
    INKCELL_PARTS += $(INKCELL)/port/c
  else
    INKCELL_PARTS += $(INKCELL_BUILD)/port/c
    inkcell_made := $(INKCELL_BUILD)/port/c/made.mk
  endif
endif
INKCELL_SOURCES := $(wildcard $(INKCELL)/core/src/*/*.cpp \
  $(addsuffix /src/*.cpp,$(INKCELL_PARTS)))
ifeq ($(INKCELL_SOURCES),)
  $(error INKCELL is $(INKCELL), where Inkcell is not)
endif
INKCELL_INCLUDES := -I$(INKCELL)/core/include \
  $(patsubst %,-I%/include,$(INKCELL_PARTS)) -I$(INKCELL_FONTS) \
  $(if $(filter lvgl,$(INKCELL_LIBRARIES)),-I$(LVGL_PATH))
INKCELL_FLAGS := $(INKCELL_INCLUDES) -I$(INKCELL)/core/src -std=c++17 \
  -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
  -ffunction-sections -fdata-sections

INKCELL_OBJECTS := $(patsubst $(INKCELL)/%.cpp,$(INKCELL_BUILD)/%.o, \
  $(INKCELL_SOURCES:$(INKCELL_BUILD)/%.cpp=$(INKCELL_BUILD)/%.o))
define inkcell_compile
	mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) $(INKCELL_FLAGS) -MMD -MP -c $< -o $@
endef
$(INKCELL_BUILD)/%.o: $(INKCELL)/%.cpp
	$(inkcell_compile)
$(INKCELL_BUILD)/%.o: $(INKCELL_BUILD)/%.cpp
	$(inkcell_compile)
inkcell_goal := $(.DEFAULT_GOAL)
-include $(INKCELL_OBJECTS:.o=.d)
# Make makes a file that it includes, and then begins anew: it finds the sources.
include $(inkcell_made)
$(INKCELL_BUILD)/port/c/made.mk: $(INKCELL)/port/c/make_api.py \
    $(wildcard $(INKCELL)/port/c/*.* $(INKCELL)/port/display/c_api.txt)
	@command -v $(INKCELL_PYTHON) > /dev/null || { echo >&2 "inkcell.mk: there is no" \
	  "$(INKCELL_PYTHON), which makes the interface for C: install Python 3.9 or newer," \
	  "or name it by INKCELL_PYTHON"; exit 1; }
	$(INKCELL_PYTHON) -B $< $(@D)
	touch $@
.DEFAULT_GOAL := $(inkcell_goal)

# $(call inkcell_font,<name>,<font file>,<more arguments of inkcell-fontgen>). Make
# takes what follows a comma in the arguments as more parameters.
inkcell_comma := ,
inkcell_empty :=
inkcell_space := $(inkcell_empty) $(inkcell_empty)
inkcell_more = $(foreach more,4 5 6 7 8 9 10 11 12 13 14 15 16,$(if $($(more)),$(inkcell_comma)$($(more))))
inkcell_options = $(strip $(subst $(inkcell_space)$(inkcell_comma),$(inkcell_comma),$(3)$(inkcell_more)))
inkcell_font = $(call inkcell_rule,$(1),$(2),$(inkcell_options),hpp,)
# The same as a source of C, whose array and size a header declares; and as a file.
inkcell_c_font = $(call inkcell_rule,$(1),$(2),$(inkcell_options),c,h)
inkcell_stored_font = $(call inkcell_rule,$(1),$(2),$(inkcell_options),bin,hpp)

# $(call inkcell_rule,<name>,<font file>,<arguments>,<suffix>,<suffix of its header, if
# that is another file>): rules that do not become the default goal.
define inkcell_rule
inkcell_goal := $$(.DEFAULT_GOAL)
$(INKCELL_FONTS)/fonts/$(1).$(4): $(2) $(INKCELL_FONTS)/fonts/$(1).options \
    $(filter-out inkcell-fontgen,$(INKCELL_FONTGEN))
	$(INKCELL_FONTGEN) --font=$(2) --name=$(1) $(3) $(if $(5),--header=$$(@:.$(4)=.$(5))) --quiet \
	  --out=$$@ --depfile=$$@.d
-include $(INKCELL_FONTS)/fonts/$(1).$(4).d
$(if $(5),$(INKCELL_FONTS)/fonts/$(1).$(5): $(INKCELL_FONTS)/fonts/$(1).$(4))
$(INKCELL_FONTS)/fonts/$(1).options: inkcell_always
	@mkdir -p $$(@D)
	@echo '$(subst ','\'',$(3))' | cmp -s - $$@ || echo '$(subst ','\'',$(3))' > $$@
.DEFAULT_GOAL := $$(inkcell_goal)
endef
.PHONY: inkcell_always
