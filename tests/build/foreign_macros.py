"""Macros of other projects that a program may have included before Inkcell: names,
not values, so that any use of a name is an error. Those with () take arguments.
"""
NAMES = """
# Arduino.h of AVR, SAMD, ESP8266, ESP32, RP2040, STM32 and Teensy.
DEG_TO_RAD RAD_TO_DEG radians() degrees() min() max() abs() round() constrain()
sq() F() PSTR() PROGMEM PI HALF_PI TWO_PI EULER HIGH LOW INPUT OUTPUT
INPUT_PULLUP CHANGE FALLING RISING LSBFIRST MSBFIRST SERIAL DISPLAY DEFAULT
INTERNAL EXTERNAL B0 B00 B1 B01 B10 B11111111 bit() _BV() lowByte() highByte()
bitRead() bitSet() bitClear() bitWrite() bitToggle() interrupts() noInterrupts()
word() swap() isnan() isinf() DEC HEX OCT BIN
# Adafruit_GFX, Adafruit_SSD1306 and TFT_eSPI.
BLACK WHITE INVERSE RED GREEN BLUE TL_DATUM MC_DATUM
# CMSIS, and the HAL of STM32.
__I __O __IO __IM __OM __IOM __ASM __INLINE __STATIC_INLINE __NO_RETURN __USED
__WEAK __PACKED __ALIGNED() __RESTRICT UNUSED() SET RESET ENABLE DISABLE ERROR
SUCCESS OK FAIL READ_REG() WRITE_REG() SET_BIT() CLEAR_BIT() READ_BIT() SPI1
I2C1 RCC PWR FLASH RTC
# Zephyr.
BIT() BIT64() BIT_MASK() GENMASK() MIN() MAX() CLAMP() IN_RANGE() ARRAY_SIZE()
ARRAY_INDEX() CONTAINER_OF() ROUND_UP() ROUND_DOWN() DIV_ROUND_UP()
SIZEOF_FIELD() IS_ENABLED() POINTER_TO_UINT() BUILD_ASSERT() KB() MB() KHZ()
MHZ() likely() unlikely() popcount() ALWAYS_INLINE FUNC_NORETURN __packed
__aligned() __weak __unused __used __deprecated LIST_HEAD() STRINGIFY() CONCAT()
FOR_EACH()
# ESP-IDF.
BIT0 BIT1 BIT31 IRAM_ATTR DRAM_ATTR RTC_DATA_ATTR ESP_OK ESP_FAIL
# <ctype.h> of newlib, <sys/param.h>, and what firmware has of its own.
_U _L _N _S _P _C _X _B major() minor() ABS() TRUE FALSE NONE I2C SPI N U L C S
X Y W H
"""

# What C's headers need comes first.
INCLUDED = ("limits.h", "stdbool.h", "stddef.h", "stdint.h")


def write(header):
    """Writes a header that defines them all."""
    names = [name for line in NAMES.splitlines() if not line.startswith("#")
             for name in line.split()]
    header.write_text(
        "#pragma once\n" +
        "".join(f"#include <{name}>\n" for name in INCLUDED) +
        "".join(f"#define {name.replace('()', '(...)')} @\n" for name in names))
