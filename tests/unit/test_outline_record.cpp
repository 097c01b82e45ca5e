// Whether fonts that outline_record.hpp makes are read as they were meant.
#include "check.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shadow.hpp"
#include "outline_record.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;

alignas(4) uint8_t bytes[outline_record::kSampleFontBytes];

bool open(Font& font) {
  const size_t size = outline_record::build_sample_font({bytes, sizeof(bytes)});
  return size != 0 && Font::open({bytes, size}, font) == Status::ok;
}

template <int32_t kWidth, int32_t kHeight>
void draw(Picture<kWidth, kHeight>& picture, const Font& font, uint16_t glyph) {
  Style style(16_px, kFilterText);
  Painter(picture.sink()).glyph(font, style, {0, kHeight - 1}, glyph);
}

TEST(outlines_are_drawn) {
  Font font;
  CHECK(open(font));
  Picture<13, 13> disc;
  draw(disc, font, 1);
  CHECK_PICTURE(disc,
                ".............\n"
                "...:+**+:....\n"
                "..:*####*:...\n"
                ".:*######*:..\n"
                ".+########+..\n"
                ".*########*..\n"
                ".*########*..\n"
                ".+########+..\n"
                ".:*######*:..\n"
                "..:*####*:...\n"
                "...:+**+:....\n");
  Picture<14, 13> frame;
  draw(frame, font, 4);
  CHECK_PICTURE(frame,
                "..............\n"
                "............+.\n"
                "...........::.\n"
                "...........+..\n"
                ".:::::::...+..\n"
                ":######:..::..\n"
                ":#++++#:..+...\n"
                ":#+..+#:..:...\n"
                ":#+..+#:.:....\n"
                ":#++++#:.+....\n"
                ":######:::....\n"
                ".::::::.+.....\n");
  Picture<13, 13> leaf;
  draw(leaf, font, 5);
  CHECK_PICTURE(leaf,
                ".............\n"
                "......::+**..\n"
                ".....+*###*..\n"
                "...:*#####+..\n"
                "...*######:..\n"
                "..+######*:..\n"
                "..*######+...\n"
                ".:######*:...\n"
                ".+#####*:....\n"
                ".*####*:.....\n"
                ".***+:.......\n");
}

TEST(components_are_drawn) {
  Font font;
  CHECK(open(font));
  Picture<18, 13> parts;
  draw(parts, font, 6);
  CHECK_PICTURE(parts,
                "..................\n"
                "...:+**+:..::.....\n"
                "..:*####*:.:#*+...\n"
                ".:*######*::*##+..\n"
                ".+########+.+###:.\n"
                ".*########*..*##+.\n"
                ".*########*...:++.\n"
                ".+########+.......\n"
                ".:*######*:.......\n"
                "..:*####*:........\n"
                "...:+**+:.........\n");
}

TEST(a_grid_may_be_finer_or_coarser) {
  // The bar in units of half and of four.
  static constexpr outline_record::OutlinePoint kFine[] = {
      {outline_record::start, 400, 0},
      {outline_record::corner, 880, 0},
      {outline_record::corner, 880, 1280},
      {outline_record::corner, 400, 1280}};
  static constexpr outline_record::OutlinePoint kCoarse[] = {
      {outline_record::start, 50, 0},
      {outline_record::corner, 110, 0},
      {outline_record::corner, 110, 160},
      {outline_record::corner, 50, 160}};
  const Span<const outline_record::OutlinePoint> bars[] = {{kFine, 4},
                                                           {kCoarse, 4}};
  const int8_t shifts[] = {-1, 2};
  for (uint32_t i = 0; i < 2; ++i) {
    const outline_record::OutlineSource glyphs[] = {{600, bars[i]},
                                                    {600, bars[i]}};
    Font font;
    const size_t size = outline_record::build_outline_font(
        {glyphs, 2}, shifts[i], 'A', {bytes, sizeof(bytes)});
    CHECK(size != 0);
    CHECK_OK(Font::open({bytes, size}, font));
    GlyphMetrics metrics;
    CHECK_OK(font.glyph_metrics(1, metrics));
    CHECK_EQ(metrics.x_min, 200);
    CHECK_EQ(metrics.y_max, 640);
    Picture<9, 12> bar;
    draw(bar, font, 1);
    CHECK_PICTURE(bar,
                  ".........\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n"
                  "...*##*..\n");
  }
}

TEST(distances_of_outlines_reach_everywhere) {
  Font font;
  CHECK(open(font));
  CHECK_OK(check_reach(font.range(), 4_px, glow_filter(Q6_10::from_int(4))));
}

}  // namespace
