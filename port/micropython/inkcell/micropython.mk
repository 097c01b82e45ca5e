# The module `inkcell` in a port of MicroPython that is built by make:
#
#   make -C ports/unix USER_C_MODULES=port/micropython
#
# inkcell_module.c says how it is used.
INKCELL_MOD := $(USERMOD_DIR)
INKCELL := $(INKCELL_MOD)/../../..
INKCELL_MOD_PARTS := $(INKCELL)/core/cache $(INKCELL)/core/field \
  $(INKCELL)/core/layout $(INKCELL)/core/motion $(INKCELL)/port/pixel $(INKCELL)/port/display \
  $(INKCELL)/port/c

SRC_USERMOD_C += $(INKCELL_MOD)/inkcell_module.c
# Relative to vpath: objects keep the folders of their sources.
vpath %.cpp $(INKCELL)
SRC_USERMOD_LIB_CXX += $(patsubst $(INKCELL)/%,%,$(wildcard \
  $(INKCELL)/core/src/*/*.cpp $(addsuffix /src/*.cpp,$(INKCELL_MOD_PARTS))))

INKCELL_MOD_INCLUDES := -I$(INKCELL)/core/include \
  $(patsubst %,-I%/include,$(INKCELL_MOD_PARTS))
CFLAGS_USERMOD += -I$(INKCELL)/port/c/include
CXXFLAGS_USERMOD += $(INKCELL_MOD_INCLUDES) -I$(INKCELL)/core/src -std=c++17 \
  -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
  -ffunction-sections -fdata-sections
