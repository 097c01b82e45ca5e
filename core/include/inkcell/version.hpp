// Two version numbers: of the library, and of the font format it reads.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

inline constexpr uint8_t kLibraryVersionMajor = 0;
inline constexpr uint8_t kLibraryVersionMinor = 2;
inline constexpr uint8_t kLibraryVersionPatch = 0;

/// Version of the font format that this library reads and the generator of the
/// same release writes. Independent of the library's version. While the major
/// is 0 the format may change with every minor.
inline constexpr uint8_t kFormatMajor = 0;
inline constexpr uint8_t kFormatMinor = 3;

/// Whether this library reads a font of the given format version: from 1.0 on
/// the same major and a minor that is not newer, before that exactly the same.
constexpr bool reads_format(uint8_t major, uint8_t minor) noexcept {
  return major == kFormatMajor &&
         (major == 0 ? minor == kFormatMinor : minor <= kFormatMinor);
}

}  // namespace inkcell
