// Code lengths of the packed coding's prefix codes (docs/FORMAT.md, "Glyph
// record, type 3"): the decoder and the generator build their tables from
// these. Codes are canonical: ascending by length, then by symbol. Made by
// inkcell-train-codes.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace packed_codes {

inline constexpr uint32_t kNodeContexts = 7;
inline constexpr uint32_t kNodeSymbols = 10;
inline constexpr uint32_t kNodeMaxBits = 7;
inline constexpr uint32_t kKindContexts = 6;
inline constexpr uint32_t kKindSymbols = 5;
inline constexpr uint32_t kKindMaxBits = 5;
inline constexpr uint32_t kRankContexts = 2;
inline constexpr uint32_t kRankSymbols = 16;
inline constexpr uint32_t kRankMaxBits = 8;

/// Bits of each symbol; 0: the symbol does not occur.
inline constexpr uint8_t kNodeLengths[kNodeContexts][kNodeSymbols] = {
    {1, 4, 7, 4, 3, 5, 3, 7, 4, 6}, {2, 4, 7, 2, 2, 5, 4, 7, 4, 6},
    {3, 5, 7, 2, 2, 3, 4, 7, 3, 6}, {3, 4, 7, 2, 2, 3, 5, 7, 3, 6},
    {3, 4, 6, 2, 3, 3, 7, 7, 2, 5}, {4, 7, 7, 2, 3, 2, 7, 7, 2, 5},
    {6, 7, 7, 2, 4, 1, 7, 7, 3, 6}};

inline constexpr uint8_t kKindLengths[kKindContexts][kKindSymbols] = {
    {1, 4, 4, 3, 2}, {0, 2, 2, 2, 2}, {1, 4, 4, 3, 2},
    {0, 3, 3, 2, 1}, {1, 2, 4, 3, 4}, {0, 3, 3, 2, 1}};

inline constexpr uint8_t kRankLengths[kRankContexts][kRankSymbols] = {
    {1, 2, 3, 4, 6, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8},
    {1, 2, 3, 5, 5, 6, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8}};

}  // namespace packed_codes
}  // namespace inkcell
