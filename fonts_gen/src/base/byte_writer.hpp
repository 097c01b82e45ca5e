// Numbers as the bytes that lie in ROM, little end first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkcell::gen {

using Bytes = std::vector<uint8_t>;

inline void put_u8(Bytes& out, unsigned value) {
  out.push_back(static_cast<uint8_t>(value));
}

inline void put_u16(Bytes& out, unsigned value) {
  put_u8(out, value & 0xff);
  put_u8(out, value >> 8 & 0xff);
}

inline void put_i16(Bytes& out, int value) {
  put_u16(out, static_cast<uint16_t>(value));
}

inline void put_u32(Bytes& out, uint32_t value) {
  put_u16(out, value & 0xffff);
  put_u16(out, value >> 16);
}

inline void set_u16(Bytes& out, size_t at, unsigned value) {
  out[at] = static_cast<uint8_t>(value);
  out[at + 1] = static_cast<uint8_t>(value >> 8);
}

inline void set_i16(Bytes& out, size_t at, int value) {
  set_u16(out, at, static_cast<uint16_t>(value));
}

inline void set_u32(Bytes& out, size_t at, uint32_t value) {
  set_u16(out, at, value & 0xffff);
  set_u16(out, at + 2, value >> 16);
}

// To a multiple of 2^log2 bytes.
inline void pad(Bytes& out, unsigned log2) {
  while ((out.size() & ((size_t{1} << log2) - 1)) != 0) {
    out.push_back(0);
  }
}

}  // namespace inkcell::gen
