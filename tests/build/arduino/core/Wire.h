// I2C that goes nowhere.
#pragma once

#include "Arduino.h"

struct TwoWire {
  void begin() {}
  void setClock(uint32_t) {}
  void beginTransmission(int) {}
  size_t write(uint8_t) { return 1; }
  uint8_t endTransmission() { return 0; }
};
extern TwoWire Wire;
