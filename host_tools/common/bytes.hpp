// Little-endian numbers of a ROM font.
#pragma once

#include <cstdint>

namespace inkcell::tools {

inline uint32_t read_u16(const uint8_t* p) {
  return static_cast<uint32_t>(p[0] | p[1] << 8);
}

inline uint32_t read_u32(const uint8_t* p) {
  return read_u16(p) | read_u16(p + 2) << 16;
}

}  // namespace inkcell::tools
