#include "good_fonts.hpp"

#include "exercise.hpp"
#include "font_builder.hpp"
#include "grid_record.hpp"
#include "outline_record.hpp"
#include "random.hpp"
#include "strike_font.hpp"

namespace hostile {
namespace {

using namespace inkcell;

// Half as large as the shapes of font_builder, so that glyphs are small.
int32_t small_disc(int32_t x_u, int32_t y_u) {
  return font_builder::disc(2 * x_u, 2 * y_u) / 2;
}
int32_t small_ring(int32_t x_u, int32_t y_u) {
  return font_builder::ring(2 * x_u, 2 * y_u) / 2;
}

// .notdef, space, A (disc), B (ring); kerning in classes of one byte, or of
// two if `wide`.
Bytes build_font(bool wide) {
  static font_builder::Record records[2];
  font_builder::Record* record = records;
  for (const font_builder::Shape shape : {small_disc, small_ring}) {
    record->reset();
    record->tile_log2 = 7;
    record->x0_u = -64;
    record->y0_u = -64;
    record->fill(shape);
    ++record;
  }
  const font_builder::CmapEntry cmap[] = {
      {' ', 0, 1}, {'A', 1, 2}, {0x1f600, 0, 3}};
  const font_builder::GlyphSpec glyphs[] = {
      {600, {40, 40, 330, 330}, nullptr, records},
      {300, {}, nullptr, nullptr},
      {400, {40, 40, 330, 330}, nullptr, records},
      {350, {60, 60, 310, 310}, nullptr, records + 1}};
  const uint16_t classes[] = {0, 0, 1, 2};
  const std::vector<int16_t> values(wide ? 512 : 4, -40);
  font_builder::FontSpec spec;
  spec.cmap = cmap;
  spec.glyphs = glyphs;
  spec.kerning.left_classes = 2;
  spec.kerning.right_classes = wide ? 256 : 2;
  spec.kerning.left = classes;
  spec.kerning.right = classes;
  spec.kerning.values = {values.data(), values.size()};
  spec.name = "Hostile";
  GridRecord hints;
  hints.make_usual(4);
  spec.hints = hints.write().section;
  Bytes font(8192);
  font.resize(font_builder::build_font(spec, {font.data(), font.size()}));
  require(!font.empty(), "the font fits its buffer");
  return font;
}

// Those of outline_record.hpp: outlines and a composite, with hints.
Bytes build_outline_font() {
  GridRecord hints;
  hints.make_usual(8);
  Bytes font(2 * outline_record::kSampleFontBytes);
  font.resize(outline_record::build_sample_font({font.data(), font.size()},
                                                hints.write()));
  require(!font.empty(), "the font fits its buffer");
  return font;
}

// A strike of 4 bits, with noise for pictures, alone or beside those outlines.
Bytes build_strike_font(bool is_alone) {
  static strike_font::StrikeWriter<4096> strikes;
  Random random(1);
  strikes.begin(1);
  strikes.add({22, 4, inkcell::format::StrikeFit::none, 0, 7, 500},
              [&](uint16_t, strike_font::Values& values) {
                values.top = -12;
                values.width = 14;
                values.height = 16;
                for (auto& row : values.at) {
                  for (uint8_t& value : row) {
                    value = static_cast<uint8_t>(random.below(16));
                  }
                }
              });
  Bytes font = build_outline_font();
  const size_t size = font.size();
  font.resize(size + 4096);
  font.resize(strike_font::add_section({font.data(), font.size()}, size,
                                       is_alone
                                           ? inkcell::format::section::kGlyphs
                                           : inkcell::format::section::kStrikes,
                                       strikes.bytes()));
  require(!font.empty(), "the font fits its buffer");
  if (is_alone) {
    strike_font::set_alone({font.data(), font.size()}, 22);
  }
  return font;
}

}  // namespace

Bytes good_font(const std::string& kind) {
  if (kind == "1" || kind == "2") {
    return build_font(kind == "2");
  }
  return kind == "outline"   ? build_outline_font()
         : kind == "strikes" ? build_strike_font(true)
         : kind == "both"    ? build_strike_font(false)
                             : Bytes();
}

}  // namespace hostile
