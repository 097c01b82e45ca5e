// CRC-32 as in Ethernet and PNG (polynomial 0xedb88320, reflected).
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {
namespace detail {

/// The checksum of what `crc` covers followed by `bytes`; begin with 0. Four
/// bits a step: a table of 64 bytes instead of 1 KB.
uint32_t crc32(uint32_t crc, Span<const uint8_t> bytes) noexcept;

}  // namespace detail
}  // namespace inkcell
