#include "inkcell/strike/verify.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "find_picture.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

namespace at = format::strike;

constexpr detail::Placed kOrigin = {0, 0};

// Whether metrics of a font of strikes alone are in pixels or halves of them,
// and boxes in whole ones.
bool has_boxes(const Font& font, uint32_t px) noexcept {
  const uint32_t units = font.units_per_em() / px;
  if (units * px != font.units_per_em() || units - 1 > 1) {
    return false;
  }
  GlyphMetrics box;
  for (uint32_t i = 0; i != font.glyph_count(); ++i) {
    static_cast<void>(font.glyph_metrics(static_cast<uint16_t>(i), box));
    if (units == 2 && ((box.x_min | box.y_min | box.x_max | box.y_max) & 1)) {
      return false;
    }
  }
  return true;
}

// Whether an entry and its table keep to the format, and the pictures of its
// glyphs lie in the section.
bool is_whole(const Font& font,
              const Span<const uint8_t>& strikes,
              const uint8_t* entry,
              bool is_alone) noexcept {
  constexpr uint8_t kMostBits[][at::kColumns] = {{9, 9, 8, 8, 25},
                                                 {0, 0, 0, 0, 25}};
  const uint32_t first = detail::load_u16(entry + at::kFirst);
  const uint32_t glyphs = detail::load_u16(entry + at::kGlyphs);
  const uint32_t px = detail::load_u16(entry + at::kPx);
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    const uint32_t bits = entry[at::kColumnBits + i];
    if (bits > kMostBits[is_alone ? 1 : 0][i]) {
      return false;
    }
    row_bits += bits;
  }
  if (px < 4 || px > format::strikes::kMaxSide ||
      entry[at::kFit] > static_cast<uint8_t>(format::StrikeFit::source) ||
      detail::load_u16(entry + at::kReserved) != 0 ||
      first + glyphs > font.glyph_count() ||
      !detail::bits_fit(strikes, detail::load_u32(entry + at::kBoxes),
                        row_bits * (glyphs + 1)) ||
      (is_alone && !has_boxes(font, px))) {
    return false;
  }
  // Pictures follow each other.
  const uint32_t offset = detail::load_u32(entry + at::kBoxes) * 8 + row_bits -
                          entry[at::kColumnBits + at::kColumns - 1];
  const uint32_t step = detail::load_u16(entry + at::kStep);
  uint32_t end = 0;
  for (uint32_t i = 0; i <= glyphs; ++i) {
    const uint32_t begin =
        detail::load_u32(entry + at::kPictures) + (i * step >> 8) +
        detail::read_bits(strikes, offset + row_bits * i,
                          entry[at::kColumnBits + at::kColumns - 1]);
    if (begin < end || begin > strikes.size) {
      return false;
    }
    end = begin;
  }
  const detail::StrikeKey key = {~uint32_t{0}, detail::load_u32(entry)};
  const uint32_t box = detail::load_u32(entry + at::kBoxes) * 8;
  const uint32_t before = entry[at::kColumnBits] + entry[at::kColumnBits + 1];
  for (uint32_t i = 0; i != glyphs; ++i) {
    detail::Picture picture;
    GlyphMetrics metrics;
    static_cast<void>(
        font.glyph_metrics(static_cast<uint16_t>(first + i), metrics));
    const detail::PictureCall call = {key, first + i, 1, kOrigin};
    const bool is_blank =
        is_alone ? metrics.x_min == metrics.x_max
                 : detail::read_bits(strikes, box + row_bits * i + before,
                                     entry[at::kColumnBits + 2]) == 0;
    if (!is_blank &&
        !(is_alone ? detail::StrikeAlone::find_picture(font, call, picture)
                   : detail::find_picture(strikes, call, picture))) {
      return false;
    }
  }
  return true;
}

}  // namespace

Status verify_strikes(const Font& font) noexcept {
  namespace head = format::strikes;
  if (font.rom().size == 0) {
    return Status::corrupt;
  }
  const bool is_alone = font.rom().data[format::header::kCoding] ==
                        static_cast<uint8_t>(format::Coding::strike);
  const Span<const uint8_t> strikes =
      is_alone ? font.glyph_table() : font.section(format::section::kStrikes);
  if (strikes.size == 0) {
    return Status::ok;
  }
  if (strikes.size < head::kBytes || detail::load_u16(strikes.data) != 0) {
    return Status::corrupt;
  }
  const uint32_t count = detail::load_u16(strikes.data + head::kCount);
  for (uint32_t i = 0; i != count; ++i) {
    const uint8_t* const entry = detail::strike_at(strikes, i);
    if (entry == nullptr || !is_whole(font, strikes, entry, is_alone)) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
