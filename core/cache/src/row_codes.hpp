// Rows of coverage as a cache keeps them: eight values at a time, without pairs
// that are empty or solid, and each row once where rows are equal.
//
//   glyph  group...
//   group  equal rows: a byte, and eight values; then for each sixteen further
//          ones a byte, and the values. The first byte holds the number of rows
//          less 1 (low 4 bits) and a code, the others two.
//   code   4 bits, the first one lowest: which pairs of an eight are empty,
//          solid, or mixed. The values of mixed pairs follow.
//   pair   a byte (values of 4 bits, low ones first) or two (8 bits)
//
// Where all pairs are mixed the values of 4 bits are four bytes, 0 to 3 in the
// low halves and 4 to 7 in the high ones. A pixel has one value, or one a
// channel. A row is filled up with empty ones.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace detail {

// How a pixel is kept.
struct Packing {
  uint8_t bits;      // 4 or 8
  uint8_t channels;  // 1, or 3 for sub-pixels
};

// The most values of a row.
inline constexpr int32_t kMostRowValues = 192;

// Of a pair.
inline constexpr uint32_t kEmpty = 0;
inline constexpr uint32_t kSolid = 1;
inline constexpr uint32_t kMixed = 2;

constexpr uint8_t kinds(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  return static_cast<uint8_t>(a | b << 2 | c << 4 | d << 6);
}

// What the codes say. Two bits are for a four whose pairs are alike, the first
// one lowest. Codes with 3 are the most frequent other eights of text of 24 to
// 48 px.
inline constexpr uint8_t kKinds[16] = {
    kinds(kEmpty, kEmpty, kEmpty, kEmpty),
    kinds(kSolid, kSolid, kEmpty, kEmpty),
    kinds(kMixed, kMixed, kEmpty, kEmpty),
    kinds(kMixed, kEmpty, kEmpty, kEmpty),  // 3
    kinds(kEmpty, kEmpty, kSolid, kSolid),
    kinds(kSolid, kSolid, kSolid, kSolid),
    kinds(kMixed, kMixed, kSolid, kSolid),
    kinds(kEmpty, kEmpty, kEmpty, kMixed),  // 7
    kinds(kEmpty, kEmpty, kMixed, kMixed),
    kinds(kSolid, kSolid, kMixed, kMixed),
    kinds(kMixed, kMixed, kMixed, kMixed),  // kAllMixed
    kinds(kSolid, kMixed, kEmpty, kEmpty),  // 11
    kinds(kMixed, kSolid, kMixed, kEmpty),  // 12
    kinds(kEmpty, kMixed, kSolid, kMixed),  // 13
    kinds(kEmpty, kMixed, kMixed, kEmpty),  // 14
    kinds(kEmpty, kEmpty, kMixed, kSolid),  // 15
};
inline constexpr uint32_t kAllMixed = 10;

// Whether one of the two halves of a code is 3.
constexpr bool is_by_pairs(uint32_t code) noexcept {
  return (code & code >> 1 & 5) != 0;
}

// Whether a row of so many eights has these: they take longer.
constexpr bool is_wide(int32_t eights) noexcept {
  return eights > 2;
}

inline constexpr int32_t kMostEqual = 16;

// The bits of a group's first byte that count its rows.
inline constexpr uint32_t kRowsMask = kMostEqual - 1;

inline constexpr uint32_t kLowHalves = 0x0f0f0f0f;

inline int32_t rows_of(const uint8_t* group) noexcept {
  return static_cast<int32_t>(*group & kRowsMask) + 1;
}

inline int32_t eights_of(int32_t width, Packing packing) noexcept {
  return (width * packing.channels + 7) >> 3;
}

}  // namespace detail
}  // namespace inkcell
