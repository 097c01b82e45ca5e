// What ESP8266 has in ROM, and Debian's libgcc for lx106 therefore lacks.
#include <stdint.h>

namespace {

struct Division {
  uint64_t quotient;
  uint64_t rest;
};

Division divide(uint64_t number, uint64_t by) {
  Division result = {0, 0};
  for (int32_t bit = 63; bit >= 0; --bit) {
    result.rest = result.rest << 1 | (number >> bit & 1);
    result.quotient <<= 1;
    if (result.rest >= by) {
      result.rest -= by;
      result.quotient |= 1;
    }
  }
  return result;
}

uint64_t magnitude(int64_t number) {
  const auto bits = static_cast<uint64_t>(number);
  return number < 0 ? 0 - bits : bits;
}

}  // namespace

extern "C" {

uint32_t __udivsi3(uint32_t number, uint32_t by);
uint32_t __udivsi3(uint32_t number, uint32_t by) {
  return static_cast<uint32_t>(divide(number, by).quotient);
}

uint32_t __umodsi3(uint32_t number, uint32_t by);
uint32_t __umodsi3(uint32_t number, uint32_t by) {
  return static_cast<uint32_t>(divide(number, by).rest);
}

uint64_t __udivdi3(uint64_t number, uint64_t by);
uint64_t __udivdi3(uint64_t number, uint64_t by) {
  return divide(number, by).quotient;
}

int64_t __divdi3(int64_t number, int64_t by);
int64_t __divdi3(int64_t number, int64_t by) {
  const uint64_t quotient = divide(magnitude(number), magnitude(by)).quotient;
  return static_cast<int64_t>((number < 0) != (by < 0) ? 0 - quotient
                                                       : quotient);
}

int32_t __divsi3(int32_t number, int32_t by);
int32_t __divsi3(int32_t number, int32_t by) {
  return static_cast<int32_t>(__divdi3(number, by));
}

int32_t __modsi3(int32_t number, int32_t by);
int32_t __modsi3(int32_t number, int32_t by) {
  return number - __divsi3(number, by) * by;
}

uint64_t __muldi3(uint64_t a, uint64_t b);
uint64_t __muldi3(uint64_t a, uint64_t b) {
  uint64_t product = 0;
  for (; a != 0; a >>= 1, b += b) {
    product += (a & 1) != 0 ? b : 0;
  }
  return product;
}

}  // extern "C"
