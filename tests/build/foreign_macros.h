// Macros of other projects that a program may have included before Inkcell:
// names, not values, so that any use of a name is an error. What C's headers
// need comes first.
#ifndef FOREIGN_MACROS_H
#define FOREIGN_MACROS_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Arduino.h of AVR, SAMD, ESP8266, ESP32, RP2040, STM32 and Teensy. */
#define DEG_TO_RAD @
#define RAD_TO_DEG @
#define radians(deg) @
#define degrees(rad) @
#define min(a, b) @
#define max(a, b) @
#define abs(x) @
#define round(x) @
#define constrain(amount, low, high) @
#define sq(x) @
#define F(text) @
#define PSTR(text) @
#define PROGMEM @
#define PI @
#define HALF_PI @
#define TWO_PI @
#define EULER @
#define HIGH @
#define LOW @
#define INPUT @
#define OUTPUT @
#define INPUT_PULLUP @
#define CHANGE @
#define FALLING @
#define RISING @
#define LSBFIRST @
#define MSBFIRST @
#define SERIAL @
#define DISPLAY @
#define DEFAULT @
#define INTERNAL @
#define EXTERNAL @
#define B0 @
#define B00 @
#define B1 @
#define B01 @
#define B10 @
#define B11111111 @
#define bit(b) @
#define _BV(b) @
#define lowByte(w) @
#define highByte(w) @
#define bitRead(value, b) @
#define bitSet(value, b) @
#define bitClear(value, b) @
#define bitWrite(value, b, x) @
#define bitToggle(value, b) @
#define interrupts() @
#define noInterrupts() @
#define word(...) @
#define swap(a, b) @
#define isnan(x) @
#define isinf(x) @
#define DEC @
#define HEX @
#define OCT @
#define BIN @

/* Adafruit_GFX, Adafruit_SSD1306 and TFT_eSPI. */
#define BLACK @
#define WHITE @
#define INVERSE @
#define RED @
#define GREEN @
#define BLUE @
#define TL_DATUM @
#define MC_DATUM @

/* CMSIS, and the HAL of STM32. */
#define __I @
#define __O @
#define __IO @
#define __IM @
#define __OM @
#define __IOM @
#define __ASM @
#define __INLINE @
#define __STATIC_INLINE @
#define __NO_RETURN @
#define __USED @
#define __WEAK @
#define __PACKED @
#define __ALIGNED(x) @
#define __RESTRICT @
#define UNUSED(x) @
#define SET @
#define RESET @
#define ENABLE @
#define DISABLE @
#define ERROR @
#define SUCCESS @
#define OK @
#define FAIL @
#define READ_REG(reg) @
#define WRITE_REG(reg, value) @
#define SET_BIT(reg, b) @
#define CLEAR_BIT(reg, b) @
#define READ_BIT(reg, b) @
#define SPI1 @
#define I2C1 @
#define RCC @
#define PWR @
#define FLASH @
#define RTC @

/* Zephyr. */
#define BIT(n) @
#define BIT64(n) @
#define BIT_MASK(n) @
#define GENMASK(h, l) @
#define MIN(a, b) @
#define MAX(a, b) @
#define CLAMP(value, low, high) @
#define IN_RANGE(value, low, high) @
#define ARRAY_SIZE(array) @
#define ARRAY_INDEX(array, p) @
#define CONTAINER_OF(p, type, field) @
#define ROUND_UP(x, align) @
#define ROUND_DOWN(x, align) @
#define DIV_ROUND_UP(n, d) @
#define SIZEOF_FIELD(type, member) @
#define IS_ENABLED(option) @
#define POINTER_TO_UINT(x) @
#define BUILD_ASSERT(...) @
#define KB(x) @
#define MB(x) @
#define KHZ(x) @
#define MHZ(x) @
#define likely(x) @
#define unlikely(x) @
#define popcount(x) @
#define ALWAYS_INLINE @
#define FUNC_NORETURN @
#define __packed @
#define __aligned(x) @
#define __weak @
#define __unused @
#define __used @
#define __deprecated @
#define LIST_HEAD(...) @
#define STRINGIFY(s) @
#define CONCAT(...) @
#define FOR_EACH(...) @

/* ESP-IDF. */
#define BIT0 @
#define BIT1 @
#define BIT31 @
#define IRAM_ATTR @
#define DRAM_ATTR @
#define RTC_DATA_ATTR @
#define ESP_OK @
#define ESP_FAIL @

/* <ctype.h> of newlib, <sys/param.h>, and what firmware has of its own. */
#define _U @
#define _L @
#define _N @
#define _S @
#define _P @
#define _C @
#define _X @
#define _B @
#define major(x) @
#define minor(x) @
#define ABS(x) @
#define TRUE @
#define FALSE @
#define NONE @
#define I2C @
#define SPI @
#define N @
#define U @
#define L @
#define C @
#define S @
#define X @
#define Y @
#define W @
#define H @

#endif
