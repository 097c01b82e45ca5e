// What ESPHome would write for a program with a display, for its own sources.
#pragma once

#define USE_DISPLAY
#define USE_HOST
#define ESPHOME_BOARD "host"
