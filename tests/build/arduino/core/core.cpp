// Its objects.
#include <SPI.h>
#include <Wire.h>

Port Serial;
SPIClass SPI;
TwoWire Wire;
