#include "base/crc.hpp"

namespace inkcell::detail {
uint32_t crc32(uint32_t crc, Span<const uint8_t> bytes) noexcept {
  crc = ~crc;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) {
      crc = (crc >> 1) ^ (0xedb88320 & (0u - (crc & 1)));
    }
  }
  return ~crc;
}

}  // namespace inkcell::detail
