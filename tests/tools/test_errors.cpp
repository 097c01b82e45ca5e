// What the accuracy table says about errors that are known.
#include "errors.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "comparison.hpp"
#include "pictures.hpp"
#include "size_list.hpp"
#include "table.hpp"

namespace inkcell::tools {
namespace {

ErrorPlace place(int drawn, double exact, char32_t code_point = U'a') {
  ErrorPlace result;
  result.code_point = code_point;
  result.drawn = drawn;
  result.exact = exact;
  return result;
}

// A glyph of `pixels` pixels, the first of them wrong.
GlyphErrors glyph(char32_t code_point, int error, int pixels) {
  GlyphErrors errors;
  for (int i = 0; i < pixels; ++i) {
    errors.add(place(i == 0 ? error : 0, 0, code_point), true);
  }
  return errors;
}

TEST(GlyphErrors, MeanCountsTheBoxOnly) {
  GlyphErrors errors;
  errors.add(place(10, 0), true);
  errors.add(place(0, 0), true);
  errors.add(place(100, 0), false);
  EXPECT_DOUBLE_EQ(errors.mean(), 5);
  EXPECT_DOUBLE_EQ(errors.worst(), 100);
  EXPECT_EQ(errors.pixels(), 2);
}

TEST(GlyphErrors, TooLittleIsAsWrongAsTooMuch) {
  GlyphErrors errors;
  errors.add(place(90, 100.5), true);
  errors.add(place(110, 100.5), true);
  EXPECT_DOUBLE_EQ(errors.worst(), 10.5);
  EXPECT_EQ(errors.worst_place().drawn, 90);
  EXPECT_DOUBLE_EQ(errors.mean(), 10);
}

TEST(ErrorSummary, EachGlyphWithInkCountsTheSame) {
  ErrorSummary summary;
  summary.add(glyph(U'a', 10, 100));
  summary.add(glyph(U'b', 8, 2));
  GlyphErrors space;
  space.add(place(0, 0, U' '), false);
  summary.add(space);
  EXPECT_DOUBLE_EQ(summary.mean(), (0.1 + 4) / 2);
  EXPECT_DOUBLE_EQ(summary.worst(), 10);
  EXPECT_EQ(summary.worst_place().code_point, U'a');
  EXPECT_DOUBLE_EQ(summary.worst_mean(), 4);
  EXPECT_EQ(summary.worst_mean_character(), U'b');
}

TEST(ErrorSummary, AddsUp) {
  ErrorSummary first;
  first.add(glyph(U'a', 10, 10));
  ErrorSummary second;
  second.add(glyph(U'b', 30, 10));
  second.add(glyph(U'c', 20, 2));
  first.add(second);
  EXPECT_DOUBLE_EQ(first.mean(), (1 + 3 + 10) / 3.0);
  EXPECT_EQ(first.worst_place().code_point, U'b');
  EXPECT_EQ(first.worst_mean_character(), U'c');
  EXPECT_EQ(ErrorSummary().mean(), 0);
}

TEST(ErrorTable, FindsTheWorstGlyphs) {
  ErrorTable table;
  table.request.sizes = {10, 20};
  table.request.filters = {exact_filter("text"), exact_filter("motion")};
  table.characters = {{U'a', 1}, {U'b', 2}, {U'c', 3}};
  // [size * filters + filter]
  table.errors = {{glyph(U'a', 1, 2), glyph(U'a', 2, 2), glyph(U'a', 9, 2),
                   glyph(U'a', 4, 2)},
                  {glyph(U'b', 1, 2), glyph(U'b', 1, 2), glyph(U'b', 1, 2),
                   glyph(U'b', 1, 2)},
                  {glyph(U'c', 5, 2), glyph(U'c', 12, 2), glyph(U'c', 7, 2),
                   glyph(U'c', 8, 2)}};
  EXPECT_EQ(table.summary(0, 0).worst(), 5);
  EXPECT_EQ(table.summary(1, 1).worst_place().code_point, U'c');
  EXPECT_EQ(table.total(0).worst(), 9);
  EXPECT_DOUBLE_EQ(table.total(0).mean(), (1 + 9 + 1 + 1 + 5 + 7) / 12.0);
  const std::vector<WorstOfGlyph> worst = worst_glyphs(table, 2);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0].character, 2u);
  EXPECT_EQ(worst[0].size, 0u);
  EXPECT_EQ(worst[0].filter, 1u);
  EXPECT_EQ(worst[0].place.drawn, 12);
  EXPECT_EQ(worst[1].character, 0u);
  EXPECT_EQ(worst[1].size, 1u);
  EXPECT_EQ(worst[1].filter, 0u);
  EXPECT_EQ(worst_glyphs(table, 10).size(), 3u);
}

TEST(SizeList, ReadsRangesAndNumbers) {
  EXPECT_EQ(read_sizes({"8-11", "12.5", "64"}),
            (std::vector<double>{8, 9, 10, 11, 12.5, 64}));
  EXPECT_EQ(read_sizes({"9-9"}), std::vector<double>{9});
  // To what the device can draw.
  EXPECT_EQ(read_sizes({"10.01"}), std::vector<double>{10 + 1 / 64.0});
  for (const char* wrong : {"", "-", "8-", "-8", "9-8", "8-9.5", "3", "1025",
                            "nan", "12px", "8-9-10"}) {
    EXPECT_THROW(read_sizes({wrong}), std::runtime_error) << wrong;
  }
}

TEST(Exhibits, ShowWhatIsTooMuchAndTooLittle) {
  Exhibit exhibit;
  exhibit.px = 12;
  exhibit.filter = "text";
  exhibit.picture.drawn = Image(2, 1);
  *exhibit.picture.drawn.at(0, 0) = 200;
  exhibit.picture.exact = {190, 10};
  exhibit.worst = place(200, 190);
  // A font without glyphs writes no captions.
  const Image image = draw_exhibits(Font(), {exhibit});
  int red = 0;
  int blue = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const uint8_t* c = image.at(x, y);
      red += c[0] == 255 && c[1] == 175 && c[2] == 175 ? 1 : 0;
      blue += c[0] == 175 && c[1] == 175 && c[2] == 255 ? 1 : 0;
    }
  }
  // A pixel is a square of 14; the frame around the first one lies on the
  // second one's border.
  EXPECT_EQ(red, 14 * 14);
  EXPECT_EQ(blue, 13 * 14);
}

TEST(ExactFilter, AgreesWithTheDeviceTables) {
  for (const NamedFilter& named : kFilters) {
    const ExactFilter exact = exact_filter(named.name);
    for (int q10 = -1200; q10 <= 1200; ++q10) {
      // The table has 256 entries: at exponent 1.1 a step is up to 1.1 levels,
      // its middle half of that away, and rounding adds half a level. Cutoffs
      // are rounded to 1/1024 px.
      EXPECT_NEAR(named.filter->coverage(q10), exact.coverage(q10 / 1024.0),
                  1.5)
          << named.name << " " << q10;
    }
  }
  EXPECT_THROW(exact_filter("none"), std::runtime_error);
}

}  // namespace
}  // namespace inkcell::tools
