# The module `inkcell` in a port of MicroPython that is built by make:
#
#   make -C ports/unix USER_C_MODULES=port/micropython
#
# inkcell_module.c says how it is used.
INKCELL_MOD := $(USERMOD_DIR)
INKCELL := $(INKCELL_MOD)/../../..
INKCELL_LIBRARIES := c
INKCELL_BUILD := $(BUILD)/inkcell
include $(INKCELL)/port/make/inkcell.mk

SRC_USERMOD_C += $(INKCELL_MOD)/inkcell_module.c
# Relative to vpath: objects keep the folders of their sources.
vpath %.cpp $(INKCELL) $(INKCELL_BUILD)
SRC_USERMOD_LIB_CXX += $(patsubst $(INKCELL)/%,%,$(INKCELL_SOURCES:$(INKCELL_BUILD)/%=%))
CFLAGS_USERMOD += $(INKCELL_INCLUDES)
CXXFLAGS_USERMOD += $(INKCELL_FLAGS)
