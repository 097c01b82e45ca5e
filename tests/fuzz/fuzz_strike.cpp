// Strikes from a fuzzer: bytes in, and the promises of exercise.hpp checked.
//
// The last 16 bytes of an input choose how a glyph is drawn. The rest is the
// section of a font of strikes alone, and of one that has outlines too.
#include <algorithm>
#include <cstring>
#include <vector>

#include "exercise.hpp"
#include "front_ends.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/strike/verify.hpp"
#include "outline_record.hpp"
#include "strike_font.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::get_u32;

constexpr size_t kChoiceBytes = 16;

// The sample font with the section; in a block of its size.
std::vector<uint8_t> font_of(Span<const uint8_t> section,
                             bool is_alone,
                             const uint8_t* choice) {
  std::vector<uint8_t> rom(2 * outline_record::kSampleFontBytes + section.size +
                           64);
  size_t size = outline_record::build_sample_font({rom.data(), rom.size()});
  hostile::require(size != 0, "the font fits its buffer");
  size = strike_font::add_section(
      {rom.data(), rom.size()}, size,
      is_alone ? format::section::kGlyphs : format::section::kStrikes, section);
  hostile::require(size != 0, "the section fits its buffer");
  if (is_alone) {
    strike_font::set_coding({rom.data(), size}, 12);
    // The choice has a box for all glyphs.
    const int32_t left = static_cast<int8_t>(choice[13]);
    const int32_t sides[] = {left, 0, left + choice[14], choice[15]};
    const uint32_t glyphs = get_u16(rom.data() + format::header::kGlyphCount);
    for (uint32_t glyph = 0; glyph != glyphs; ++glyph) {
      for (uint32_t i = 0; i != 4; ++i) {
        font_builder::put_u16(
            strike_font::box_of({rom.data(), size}, glyph) + 2 * i,
            static_cast<uint32_t>(sides[i]) & 0xffff);
      }
    }
  }
  return {rom.begin(), rom.begin() + static_cast<ptrdiff_t>(size)};
}

void draw(Span<const uint8_t> section,
          const Coding& coding,
          const Style& style,
          const uint8_t* choice) {
  const bool is_alone =
      coding.number == static_cast<uint8_t>(format::Coding::strike);
  const std::vector<uint8_t> rom = font_of(section, is_alone, choice);
  Font font;
  // Some sections do not fit as GLYF.
  if (Font::open({rom.data(), rom.size()}, coding, font) != Status::ok) {
    return;
  }
  static_cast<void>(verify_strikes(font));
  const auto glyph = static_cast<uint16_t>(get_u16(choice + 2) % 9);
  const uint32_t shift = choice[4] % 24;
  const Point origin = {
      Q26_6::from_raw(static_cast<int32_t>(get_u32(choice + 5)) >> shift),
      Q26_6::from_raw(static_cast<int32_t>(get_u32(choice + 9)) >> shift)};
  if (font.check(style) == Status::ok) {
    hostile::draw_checked(font, glyph, style, origin);
  }
  static_cast<void>(Painter().glyph_box(font, style, origin, glyph));
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size <= kChoiceBytes) {
    return;
  }
  const uint8_t* const choice = data + size - kChoiceBytes;
  const Span<const uint8_t> section = {data, size - kChoiceBytes};
  draw(section, kStrikeCoding, Style(Q26_6::from_int(12 * (choice[0] % 86))),
       choice);
  draw(section, kOutlineStrikeCoding,
       (choice[1] & 1) != 0 ? strike_style(12_px) : Style(12_px).clear_fit(),
       choice);
}
