// CRC-32 as in Ethernet and PNG (polynomial 0xedb88320, reflected).
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell::detail {

/// The checksum of what `crc` covers followed by `bytes`; begin with 0. Bit by
/// bit, without a table: opening a font takes it of the header only.
uint32_t crc32(uint32_t crc, Span<const uint8_t> bytes) noexcept;

}  // namespace inkcell::detail
