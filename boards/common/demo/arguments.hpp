// The arguments of a demo firmware.
#pragma once

#include <stdint.h>

namespace inkcell::demo {

/// Finds `name`=number among the arguments; `name` ends with '='.
inline bool find_number(int count,
                        char** arguments,
                        const char* name,
                        uint32_t& value) noexcept {
  for (int i = 0; i < count; ++i) {
    const char* at = arguments[i];
    const char* expected = name;
    while (*expected != '\0' && *at == *expected) {
      ++at;
      ++expected;
    }
    if (*expected == '\0') {
      value = 0;
      while (*at >= '0' && *at <= '9') {
        value = value * 10 + static_cast<uint32_t>(*at++ - '0');
      }
      return true;
    }
  }
  return false;
}

}  // namespace inkcell::demo
