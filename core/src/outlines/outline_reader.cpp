#include "outlines/outline_reader.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell {
namespace detail {
namespace {

namespace word = format::outline;

// The first `width` bits, 1 to 16, as two's complement.
inline uint32_t signed_top(uint32_t window, uint32_t width) noexcept {
  return static_cast<uint32_t>(static_cast<int32_t>(window) >> (32 - width));
}

}  // namespace

uint32_t last_bits_from(const uint8_t* bytes,
                        uint32_t size,
                        uint32_t first) noexcept {
  if (first >= size) {
    return 0;
  }
  if (size >= 4) {
    return load_big_u32(bytes + size - 4) << 8 * (first + 4 - size);
  }
  uint32_t window = 0;
  for (uint32_t i = first; i != first + 4; ++i) {
    window = window << 8 | (i < size ? bytes[i] : 0u);
  }
  return window;
}

ScreenPoint* OutlineReader::read(const OutlineCoding& coding,
                                 const OutlineMap& map,
                                 ScreenPoint* out,
                                 int32_t room) noexcept {
  const uint8_t* const record = record_;
  const uint32_t size = size_;
  const uint32_t shift = 32u - coding.code_bits;
  const uint8_t* const table = coding.table;
  const OutlineMap::Axis& right = map.axes[0];
  const OutlineMap::Axis& down = map.axes[1];
  uint32_t bit = bit_;
  uint32_t x = x_q18_;
  uint32_t y = y_q18_;
  const int32_t count = min(room, budget_);
  budget_ -= count;
  ScreenPoint* last = out + count;
  while (out != last) {
    // A contour's first point in a round of its own.
    const bool is_start = start_.kind() == kStart;
    ScreenPoint* const stop = is_start ? out + 1 : last;
    do {
      uint32_t window = bits_from(record, size, bit);
      const uint32_t code = load_u16(table + 2 * (window >> shift));
      const uint32_t length = code & word::kLengthMask;
      const uint32_t kind = code >> word::kKindShift & word::kKindMask;
      window <<= length;
      if (__builtin_expect(kind == word::kEndOfContour, 0)) {
        bit += length + 1;
        *out++ = {start_.x_q8, start_.y_q8_kind | int32_t{kCorner}};
        start_.y_q8_kind = kStart;
        if (window >> 31 == 0) {
          record_ = nullptr;
          budget_ += static_cast<int32_t>(last - out);
          last = out;
        }
        break;
      }
      const uint32_t x_bits = code >> word::kXBitsShift & word::kWidthMask;
      const uint32_t y_bits = code >> word::kYBitsShift & word::kWidthMask;
      const uint32_t bits = length + x_bits + y_bits;
      bit += bits;
      if (x_bits != 0) {
        const uint32_t dx = signed_top(window, x_bits);
        x += dx * static_cast<uint32_t>(right.per_x);
        y += dx * static_cast<uint32_t>(down.per_x);
        window <<= x_bits;
      }
      if (y_bits != 0) {
        if (__builtin_expect(bits > 25, 0)) {
          window = bits_from(record, size, bit - y_bits);
        }
        const uint32_t dy = signed_top(window, y_bits);
        x += dy * static_cast<uint32_t>(right.per_y);
        y += dy * static_cast<uint32_t>(down.per_y);
      }
      *out++ = ScreenPoint::at(static_cast<int32_t>(x) >> 10,
                               static_cast<int32_t>(y) >> 10, kind);
    } while (out != stop);
    ScreenPoint& start = out[-1];
    // An empty contour has none: its end is kind kStart already.
    if (is_start && start.kind() != kStart) {
      start_ = {start.x_q8, start.y_q8_kind & ~3};
      start.y_q8_kind |= int32_t{kStart};
    }
  }
  bit_ = bit;
  x_q18_ = x;
  y_q18_ = y;
  return out;
}

}  // namespace detail
}  // namespace inkcell
