// What a core of Arduino offers, as far as sketches and the libraries for
// displays use it. Macros are those that real cores define.
#pragma once

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEG_TO_RAD 0.017453292519943295769236907684886
#define RAD_TO_DEG 57.295779513082320876798154814105
#define radians(deg) ((deg)*DEG_TO_RAD)
#define degrees(rad) ((rad)*RAD_TO_DEG)
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define B0 0
#define B1 1
#define PI 3.1415926535897932384626433832795
#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define MSBFIRST 1
#define DEC 10
#define PROGMEM
#define PGM_P const char*
#define pgm_read_byte(p) (*(const uint8_t*)(p))
#define pgm_read_word(p) (*(const uint16_t*)(p))
#define pgm_read_dword(p) (*(const uint32_t*)(p))
#define pgm_read_pointer(p) ((void*)*(void* const*)(p))

class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper*>(text))

typedef bool boolean;
typedef uint8_t byte;

class String {
 public:
  String(const char* text = "") { strncpy(text_, text, sizeof text_ - 1); }
  const char* c_str() const { return text_; }
  unsigned length() const { return static_cast<unsigned>(strlen(text_)); }

 private:
  char text_[80] = {};
};

class Print {
 public:
  virtual size_t write(uint8_t) = 0;
  virtual size_t write(const uint8_t* bytes, size_t count) {
    size_t written = 0;
    while (written < count && write(bytes[written]) == 1) {
      ++written;
    }
    return written;
  }
  size_t write(const char* text) {
    return write(reinterpret_cast<const uint8_t*>(text), strlen(text));
  }
  size_t write(const char* text, size_t count) {
    return write(reinterpret_cast<const uint8_t*>(text), count);
  }
  size_t print(const char* text) { return write(text); }
  size_t print(const String& text) { return write(text.c_str()); }
  size_t print(const __FlashStringHelper* text) {
    return write(reinterpret_cast<const char*>(text));
  }
  size_t print(char c) { return write(static_cast<uint8_t>(c)); }
  size_t print(int value) { return print(static_cast<long>(value)); }
  size_t print(unsigned value) { return print(static_cast<long>(value)); }
  size_t print(long value) {
    char text[24] = {};
    char* digit = text + sizeof text - 1;
    unsigned long rest = value < 0 ? 0ul - value : value;
    do {
      *--digit = static_cast<char>('0' + rest % 10);
    } while ((rest /= 10) > 0);
    return (value < 0 ? print('-') : 0) + write(digit);
  }
  size_t print(double value, int digits = 2) {
    char text[40];
    snprintf(text, sizeof text, "%.*f", digits, value);
    return write(text);
  }
  // As in real cores: the end of a line is a call of its own.
  size_t println() { return write("\r\n"); }
  template <typename Value>
  size_t println(const Value& value) {
    const size_t count = print(value);
    return count + println();
  }
  int getWriteError() const { return error_; }

 protected:
  void setWriteError(int error = 1) { error_ = error; }

 private:
  int error_ = 0;
};

struct Port : Print {
  void begin(long) {}
  size_t write(uint8_t) override { return 1; }
};
extern Port Serial;

inline void delay(unsigned long) {}
inline unsigned long millis() {
  return 1500;
}
inline void delayMicroseconds(unsigned) {}
inline void yield() {}
inline void pinMode(int, int) {}
inline void digitalWrite(int, int) {}
inline int digitalRead(int) {
  return 0;
}

void setup();
void loop();
