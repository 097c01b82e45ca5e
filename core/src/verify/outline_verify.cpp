// Checks code words and outlines as a device would read them.
#include "verify/verify_parts.hpp"

#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"
#include "outlines/component.hpp"
#include "outlines/outline_glyph.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell::detail {
namespace {

namespace word = format::outline;

uint32_t entry(const OutlineCoding& coding, uint32_t i) noexcept {
  return load_u16(coding.tables + 2 * i);
}

uint32_t kind_of(uint32_t code) noexcept {
  return code >> word::kKindShift & word::kKindMask;
}
uint32_t width_of(uint32_t code) noexcept {
  return (code >> word::kXBitsShift & word::kWidthMask) +
         (code >> word::kYBitsShift & word::kWidthMask);
}

bool is_mirrored(const int32_t* matrix_q14) noexcept {
  return int64_t{matrix_q14[0]} * matrix_q14[3] <=
         int64_t{matrix_q14[1]} * matrix_q14[2];
}

// Points of a simple outline, ends of contours included; more than max_points
// if it does not end. `bit` is set to where it ends.
uint32_t count_points(Span<const uint8_t> record,
                      const OutlineCoding& coding,
                      uint32_t& bit) noexcept {
  bit = 1;
  uint32_t table = 0;
  bool is_start = true;
  for (uint32_t points = 1; points <= coding.max_points; ++points) {
    const uint32_t code =
        entry(coding, (table << coding.code_bits) +
                          bits_at(record, bit, coding.code_bits));
    table ^= code >> word::kTableShift & coding.last_table;
    bit += (code & word::kLengthMask) + width_of(code);
    if (kind_of(code) != word::kEndOfContour) {
      if (is_start && kind_of(code) != kCorner) {
        break;
      }
      is_start = false;
      continue;
    }
    if (is_start) {
      break;  // a contour without points
    }
    is_start = true;
    if (bits_at(record, bit++, 1) == 0) {
      return points;
    }
  }
  return uint32_t{coding.max_points} + 1;
}

}  // namespace

bool code_fits(const OutlineCoding& coding) noexcept {
  const uint32_t count = (coding.last_table + 1u) << coding.code_bits;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t code = entry(coding, i);
    const uint32_t length = code & word::kLengthMask;
    if (length == 0 || length > coding.code_bits ||
        code >> word::kTableShift > coding.last_table ||
        (kind_of(code) == word::kEndOfContour && width_of(code) != 0)) {
      return false;
    }
    // All that begin with the word are in a row; with numbers the first bit of
    // them may tell words of the same bits apart.
    const uint32_t after = coding.code_bits - length;
    const uint32_t same =
        1u << (after != 0 && width_of(code) != 0 ? after - 1 : after);
    if ((i & (same - 1)) != 0 && entry(coding, i - 1) != code) {
      return false;
    }
  }
  return true;
}

bool outline_fits(const Font& font,
                  Span<const uint8_t> record,
                  const OutlineCoding& coding,
                  uint32_t& bits) noexcept {
  if (record.data[0] != format::composite::kType) {
    return count_points(record, coding, bits) <= coding.max_points;
  }
  bits = 8 * format::composite::kTypeBytes;
  ComponentReader components;
  components.begin();
  Component component;
  uint32_t points = 0;
  while (components.next(record, component)) {
    const Span<const uint8_t> part = font.record(component.glyph);
    if (!is_outline(part) || part.data[0] == format::composite::kType ||
        (component.has_matrix && is_mirrored(component.matrix_q14()))) {
      return false;
    }
    uint32_t end;
    points += count_points(part, coding, end);
  }
  return points != 0 && points <= coding.max_points;
}

}  // namespace inkcell::detail
