// SPI that goes nowhere.
#pragma once

#include "Arduino.h"

#define SPI_MODE0 0

struct SPISettings {
  SPISettings() {}
  SPISettings(uint32_t, int, int) {}
};
struct SPIClass {
  void begin() {}
  void beginTransaction(const SPISettings&) {}
  void endTransaction() {}
  uint8_t transfer(uint8_t) { return 0; }
};
extern SPIClass SPI;
