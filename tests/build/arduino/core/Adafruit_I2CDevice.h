// Adafruit_BusIO, which nothing here calls.
#pragma once

class Adafruit_I2CDevice;
