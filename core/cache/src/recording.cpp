#include "recording.hpp"

#include <stddef.h>

namespace inkcell {
namespace detail {
namespace {

// Four of `count` values, from the `first` on, as they are drawn; what is
// behind the last one is empty.
uint32_t four_of(const uint8_t* values,
                 int32_t first,
                 int32_t count,
                 uint32_t bits) noexcept {
  uint32_t four = 0;
  for (int32_t i = 0; i != 4 && first + i < count; ++i) {
    const uint32_t value = values[first + i];
    four |= (bits == 4 ? (value + 8) / 17 * 17 : value) << 8 * i;
  }
  return four;
}

uint32_t kind_of(uint32_t pair) noexcept {
  return pair == 0 ? kEmpty : pair == 0xffff ? kSolid : kMixed;
}

// The code of two fours.
uint32_t code_of(uint32_t first, uint32_t second, bool by_pairs) noexcept {
  const uint32_t pairs[4] = {kind_of(first & 0xffff), kind_of(first >> 16),
                             kind_of(second & 0xffff), kind_of(second >> 16)};
  const uint32_t wanted = kinds(pairs[0], pairs[1], pairs[2], pairs[3]);
  for (uint32_t code = 0; by_pairs && code != 16; ++code) {
    if (kKinds[code] == wanted) {
      return code;
    }
  }
  const auto half = [&pairs](int32_t i) noexcept {
    return pairs[i] == pairs[i + 1] ? pairs[i] : kMixed;
  };
  return half(0) | half(2) << 2;
}

uint8_t* put_bytes(uint32_t word, uint32_t count, uint8_t* out) noexcept {
  for (; count != 0; --count) {
    *out++ = static_cast<uint8_t>(word);
    word >>= 8;
  }
  return out;
}

// Writes the values of two fours that follow a code.
uint8_t* put_eight(uint32_t first,
                   uint32_t second,
                   uint32_t code,
                   uint32_t bits,
                   uint8_t* out) noexcept {
  if (bits == 4 && code == kAllMixed) {
    return put_bytes((first & kLowHalves) | (second & ~kLowHalves), 4, out);
  }
  const uint32_t pairs[4] = {first & 0xffff, first >> 16, second & 0xffff,
                             second >> 16};
  for (uint32_t i = 0; i != 4; ++i) {
    if ((kKinds[code] >> 2 * i & 3) == kMixed) {
      const uint32_t pair = pairs[i];
      out = bits == 8 ? put_bytes(pair, 2, out)
                      : put_bytes((pair & 15) | (pair >> 8 & 0xf0), 1, out);
    }
  }
  return out;
}

}  // namespace

int32_t most_row_bytes(int32_t width, Packing packing) noexcept {
  const int32_t eights = eights_of(width, packing);
  return 1 + (eights >> 1) + eights * packing.bits;
}

uint8_t* record_row(const uint8_t* coverage,
                    int32_t width,
                    Packing packing,
                    uint8_t* last,
                    uint8_t* end) noexcept {
  uint8_t* codes = end;
  uint8_t* out = end + 1;
  *codes = 0;
  uint32_t shift = 4;
  const int32_t values = width * packing.channels;
  const bool by_pairs = is_wide(eights_of(width, packing));
  for (int32_t i = 0; i < values; i += 8) {
    if (shift == 8) {
      shift = 0;
      codes = out++;
      *codes = 0;
    }
    const uint32_t first = four_of(coverage, i, values, packing.bits);
    const uint32_t second = four_of(coverage, i + 4, values, packing.bits);
    const uint32_t code = code_of(first, second, by_pairs);
    *codes = static_cast<uint8_t>(*codes | code << shift);
    out = put_eight(first, second, code, packing.bits, out);
    shift += 4;
  }
  const auto bytes = static_cast<int32_t>(out - end);
  if (last != nullptr && rows_of(last) != kMostEqual && end - last == bytes &&
      ((*last ^ *end) & ~kRowsMask) == 0 &&
      __builtin_memcmp(last + 1, end + 1, static_cast<size_t>(bytes - 1)) ==
          0) {
    ++*last;
    return end;
  }
  return out;
}

}  // namespace detail
}  // namespace inkcell
