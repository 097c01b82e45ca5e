#include "find_picture.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "font/metrics_row.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {
namespace {

namespace at = format::strike;

int32_t nearest_px(int32_t at_q10) noexcept {
  return (at_q10 + 512) >> 10;
}

bool is_side(int32_t px) noexcept {
  return static_cast<uint32_t>(px) - 1 < format::strikes::kMaxSide;
}

}  // namespace

const uint8_t* strike_at(const Span<const uint8_t>& strikes,
                         uint32_t index) noexcept {
  namespace head = format::strikes;
  const size_t end = head::kBytes + size_t{at::kBytes} * (index + 1);
  // Pages of stored fonts may have them anywhere.
  if (strikes.size < end ||
      reinterpret_cast<uintptr_t>(strikes.data) % 4 != 0 ||
      index >= load_u16(strikes.data + head::kCount)) {
    return nullptr;
  }
  return strikes.data + end - at::kBytes;
}

namespace {

// The first entry of the key that has the glyph, and the index of its row
// there; null: there is none.
__attribute__((always_inline)) inline const uint8_t* find_entry(
    const Span<const uint8_t>& strikes,
    const PictureCall& call,
    uint32_t& index) noexcept {
  for (uint32_t i = 0;; ++i) {
    const uint8_t* const entry = strike_at(strikes, i);
    if (entry == nullptr) {
      return nullptr;
    }
    index = call.glyph - load_u16(entry + at::kFirst);
    if ((load_u32(entry) & call.key.mask) == call.key.word &&
        index < load_u16(entry + at::kGlyphs)) {
      return entry;
    }
  }
}

// By the numbers of a row: left, top, width, height, offset. False: that is no
// picture.
__attribute__((always_inline)) inline bool set_picture(
    const Span<const uint8_t>& strikes,
    const PictureCall& call,
    const uint8_t* entry,
    uint32_t index,
    const int32_t (&row)[at::kColumns],
    Picture& out) noexcept {
  const uint32_t step = load_u16(entry + at::kStep);
  const uint32_t begin = load_u32(entry + at::kPictures) + (index * step >> 8) +
                         static_cast<uint32_t>(row[4]);
  const uint32_t bits = entry[at::kBits];
  const int32_t width = row[2];
  const int32_t height = row[3];
  constexpr uint32_t kBitsAllowed = 1 << 1 | 1 << 2 | 1 << 4;
  if (entry[at::kCoding] != 0 || bits > 4 || (kBitsAllowed >> bits & 1) == 0 ||
      !is_side(width) || !is_side(height) || begin > strikes.size) {
    return false;
  }
  const int32_t scale = call.scale;
  const int32_t x = nearest_px(call.placed.x_q10) + row[0] * scale;
  const int32_t y = nearest_px(call.placed.y_q10) + row[1] * scale;
  out = {{x, y, x + width * scale, y + height * scale},
         scale,
         width,
         bits,
         load_u32(entry + at::kGuesses),
         strikes.data + begin,
         strikes.data + strikes.size};
  return true;
}

}  // namespace

bool find_picture(const Span<const uint8_t>& strikes,
                  const PictureCall& call,
                  Picture& out) noexcept {
  uint32_t index;
  const uint8_t* const entry = find_entry(strikes, call, index);
  if (entry == nullptr) {
    return false;
  }
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    row_bits += entry[at::kColumnBits + i];
  }
  uint32_t bit = load_u32(entry + at::kBoxes) * 8 + row_bits * index;
  int32_t row[at::kColumns];
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    const uint32_t width = entry[at::kColumnBits + i];
    row[i] = static_cast<int32_t>(read_bits(strikes, bit, width));
    bit += width;
  }
  // Hostile numbers are wider.
  constexpr int32_t kMostNumber = 511;
  row[0] = static_cast<int8_t>(entry[at::kLeftBase]) + (row[0] & kMostNumber);
  row[1] = static_cast<int8_t>(entry[at::kTopBase]) + (row[1] & kMostNumber);
  return set_picture(strikes, call, entry, index, row, out);
}

bool StrikeAlone::find_picture(const Font& font,
                               const PictureCall& call,
                               Picture& out) noexcept {
  const Span<const uint8_t>& strikes = font.glyph_table();
  Font::MetricsRow box;
  uint32_t index;
  const uint8_t* const entry = find_entry(strikes, call, index);
  if (entry == nullptr || !font.find_row(call.glyph, box)) {
    return false;
  }
  box.skip_advance();
  const uint32_t shift = font.units_per_em() > load_u16(entry) ? 1 : 0;
  int32_t sides[4];
  for (uint32_t i = 0; i != 4; ++i) {
    sides[i] = static_cast<int16_t>(box.take(i + 1)) >> shift;
  }
  const uint32_t width = entry[at::kColumnBits + at::kColumns - 1];
  const int32_t row[at::kColumns] = {
      sides[0], -sides[3], sides[2] - sides[0], sides[3] - sides[1],
      static_cast<int32_t>(read_bits(
          strikes, load_u32(entry + at::kBoxes) * 8 + width * index, width))};
  return set_picture(strikes, call, entry, index, row, out);
}

}  // namespace inkcell::detail
