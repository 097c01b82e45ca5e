#include "inkcell/strike/verify.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"
#include "picture.hpp"

namespace inkcell {
namespace {

namespace at = format::strike;

constexpr detail::Placed kOrigin = {0, 0};

// Whether an entry and its table keep to the format, and the pictures of its
// glyphs lie in the section.
bool is_whole(const Span<const uint8_t>& strikes,
              const uint8_t* entry,
              uint32_t glyph_count) noexcept {
  constexpr uint8_t kMostBits[at::kColumns] = {9, 9, 8, 8, 25};
  const uint32_t first = detail::load_u16(entry + at::kFirst);
  const uint32_t glyphs = detail::load_u16(entry + at::kGlyphs);
  const uint32_t px = detail::load_u16(entry + at::kPx);
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    const uint32_t bits = entry[at::kColumnBits + i];
    if (bits > kMostBits[i]) {
      return false;
    }
    row_bits += bits;
  }
  if (px < 4 || px > format::strikes::kMaxSide ||
      entry[at::kFit] > static_cast<uint8_t>(format::StrikeFit::source) ||
      detail::load_u16(entry + at::kReserved) != 0 ||
      first + glyphs > glyph_count ||
      !detail::bits_fit(strikes, detail::load_u32(entry + at::kBoxes),
                        row_bits * (glyphs + 1))) {
    return false;
  }
  const detail::StrikeKey key = {~uint32_t{0}, detail::load_u32(entry)};
  const uint32_t box = detail::load_u32(entry + at::kBoxes) * 8;
  const uint32_t before = entry[at::kColumnBits] + entry[at::kColumnBits + 1];
  for (uint32_t i = 0; i != glyphs; ++i) {
    detail::Picture picture;
    const detail::PictureCall call = {key, first + i, 1, kOrigin};
    const bool is_blank =
        detail::read_bits(strikes, box + row_bits * i + before,
                          entry[at::kColumnBits + 2]) == 0;
    if (!is_blank && !detail::find_picture(strikes, call, picture)) {
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
    if (entry == nullptr || !is_whole(strikes, entry, font.glyph_count())) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
