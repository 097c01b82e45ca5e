// The bytes of an input of fuzz_outline.
#pragma once

#include <stdint.h>

/// What an input begins with; numbers of two bytes are little endian. Then, of
/// an input of records: the code tables, and the records of glyphs 1 and 2 and,
/// to its end, of the composite glyph 3, without its type. Of one of points:
/// four bytes a point, kind, dx / 32 in 1/1024 em, dy / 32, both.
namespace outline_input {
inline constexpr uint32_t kFlags = 0;      // kHasPoints and others
inline constexpr uint32_t kCodeBits = 1;   // modulo 7, and 1; tables: 2^(/ 64)
inline constexpr uint32_t kGridShift = 2;  // modulo 8, less 4
inline constexpr uint32_t kEm = 3;         // u16
inline constexpr uint32_t kMaxPoints = 5;  // u16, modulo 512
inline constexpr uint32_t kSize = 7;       // u16 [px, Q6]
inline constexpr uint32_t kFilter = 9;     // modulo kFilterCount
inline constexpr uint32_t kEffect = 10;    // modulo kEffectCount
inline constexpr uint32_t kMap = 11;       // modulo kMapCount
inline constexpr uint32_t kGlyph = 12;     // modulo 5
inline constexpr uint32_t kOrigin = 13;    // x, y: u32 each; shift to the right
inline constexpr uint32_t kShift = 21;     // modulo 24
inline constexpr uint32_t kCut = 22;       // x, y
inline constexpr uint32_t kWorkspaces = 24;  // u16 each, modulo 4096; address
inline constexpr uint32_t kOdd = 28;         // modulo 4
inline constexpr uint32_t kBoxes = 29;       // i16: of glyphs 1 and 2, and of 3
inline constexpr uint32_t kSizes = 45;       // of the records of glyphs 1 and 2
inline constexpr uint32_t kBytes = 47;

inline constexpr uint8_t kHasPoints = 1;
inline constexpr uint8_t kIsFitted = 2;
inline constexpr uint8_t kHasField = 4;  // one is generated, too
}  // namespace outline_input
