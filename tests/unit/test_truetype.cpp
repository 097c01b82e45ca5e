// TrueType files: look-up, metrics, kerning, and pictures of squares, whose
// pixels hold all or nothing.
#include "inkcell/truetype/truetype_font.hpp"

#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"
#include "inkcell/text.hpp"
#include "inkcell/truetype/plain_truetype.hpp"
#include "picture.hpp"
#include "sfnt_font.hpp"

namespace {

using namespace inkcell;
using sfnt_font::Options;

constexpr int32_t kWidth = 40;
constexpr int32_t kHeight = 24;
constexpr Point kPen = {4_px, 16_px};

uint8_t file[2048];
alignas(8) uint8_t ram[2560];
uint8_t drawn[kWidth * kHeight];
uint8_t expected[kWidth * kHeight];

Span<const uint8_t> build(const Options& options) {
  const size_t size = sfnt_font::build(file, options);
  CHECK(size <= sizeof file);
  return {file, size};
}

void open(TrueTypeFont& font,
          const Options& options = {},
          const Coding& coding = kTrueTypeCoding) {
  CHECK(font.open(build(options), coding) == Status::ok);
}

// Draws with `draw(painter)` in strips, and compares with the first call.
template <typename Draw>
void draw_strips(uint8_t (&out)[kWidth * kHeight],
                 int32_t rows,
                 Workspace workspace,
                 const Draw& draw) {
  __builtin_memset(out, 0, sizeof out);
  port::A8Canvas canvas;
  for (int32_t y = 0; y < kHeight; y += rows) {
    const int32_t height = y + rows > kHeight ? kHeight - y : rows;
    canvas.set_strip({{out + y * kWidth, static_cast<size_t>(height * kWidth)},
                      0,
                      y,
                      kWidth,
                      height,
                      kWidth});
    draw(Painter(canvas, workspace));
  }
}

int32_t count_different() {
  int32_t count = 0;
  for (uint32_t i = 0; i < sizeof drawn; ++i) {
    count += drawn[i] != expected[i] ? 1 : 0;
  }
  return count;
}

int32_t count_drawn() {
  int32_t count = 0;
  for (const uint8_t value : drawn) {
    count += value != 0 ? 1 : 0;
  }
  return count;
}

// In pixels of a hundred units.
constexpr Style kStyle = Style(10_px);

constexpr uint32_t kAbsent[] = {
    0,   31,     33,      64,      'A' + sfnt_font::kLetters,
    255, 0xffff, 0x10041, 0x1f602, 0xffffffff};

TEST(character_maps_find_glyphs) {
  for (const int32_t format : each_of({0, 4, 6, 12})) {
    Options options;
    options.cmap_format = format;
    TrueTypeFont font;
    open(font, options);
    CHECK_EQ(font.glyph_count(), sfnt_font::kGlyphCount);
    for (uint32_t i = 0; i < sfnt_font::kLetters; ++i) {
      CHECK_EQ(font.font().glyph_or_notdef('A' + i), 2 + i);
    }
    CHECK_EQ(font.font().glyph_or_notdef(' '), format == 6 ? 0 : 1);
    for (const uint32_t code : kAbsent) {
      uint16_t glyph = 7;
      CHECK(font.font().glyph_of(code, glyph) == Status::no_glyph);
      CHECK_EQ(glyph, 0);
    }
    CHECK_EQ(font.font().glyph_or_notdef(0x1f601), format == 12 ? 7 : 0);
  }
}

TEST(a_file_has_metrics) {
  for (const bool is_long : each_of({false, true})) {
    Options options;
    options.is_long = is_long;
    TrueTypeFont opened;
    open(opened, options);
    const Font& font = opened.font();
    const FontMetrics all = font.metrics();
    CHECK_EQ(all.units_per_em, 1000);
    CHECK_EQ(all.ascender, 800);
    CHECK_EQ(all.descender, -200);
    CHECK_EQ(all.line_gap, 90);
    CHECK_EQ(all.x_height, 480);
    CHECK_EQ(all.cap_height, 700);
    CHECK_EQ(all.x_min, -100);
    CHECK_EQ(all.y_max, 900);
    for (uint16_t i = 0; i < sfnt_font::kGlyphCount; ++i) {
      const uint16_t same = i == 13 ? 12 : i;  // the last two share it
      CHECK_EQ(font.advance(i), sfnt_font::kGlyphs[same].advance);
    }
    GlyphMetrics box;
    CHECK(font.glyph_metrics(2, box) == Status::ok);
    CHECK_EQ(box.advance, 600);
    CHECK_EQ(box.x_min, 100);
    CHECK_EQ(box.y_min, 0);
    CHECK_EQ(box.x_max, 500);
    CHECK_EQ(box.y_max, 700);
    CHECK(font.glyph_metrics(1, box) == Status::ok);
    CHECK_EQ(box.advance, 300);
    CHECK_EQ(box.x_max, 0);
    CHECK(font.glyph_metrics(sfnt_font::kGlyphCount, box) == Status::no_glyph);
    CHECK_EQ(font.advance(sfnt_font::kGlyphCount), 0);
    CHECK_EQ(font.range().min_px, 4);
    CHECK_EQ(font.range().max_px, 1024);
    CHECK_EQ(font.name().size, 0u);
    CHECK_EQ(font.record(2).size, 0u);
  }
}

TEST(pairs_kern) {
  for (int32_t gpos = 0; gpos <= 2; ++gpos) {
    for (const bool is_extension : each_of({false, true})) {
      Options options;
      options.gpos_format = gpos;
      options.is_extension = is_extension;
      TrueTypeFont font;
      open(font, options);
      // GPOS goes before `kern`, and says twice as much.
      const int32_t times = gpos == 0 ? 1 : 2;
      for (uint16_t left = 0; left < 16; ++left) {
        for (uint16_t right = 0; right < 16; ++right) {
          int32_t value = 0;
          for (const sfnt_font::Pair& pair : sfnt_font::kPairs) {
            value += pair.left == left && pair.right == right ? pair.value : 0;
          }
          CHECK_EQ(font.font().kerning(left, right), times * value);
        }
      }
    }
  }
  Options options;
  options.has_kern = false;
  TrueTypeFont font;
  open(font, options);
  CHECK_EQ(font.font().kerning(2, 3), 0);
}

// Each glyph at 10 px/em, so that a pixel has a hundred units.
constexpr struct {
  uint16_t glyph;
  const char* picture;
} kPictures[] = {
    // A square.
    {2,
     "..........\n"
     "..........\n"
     "..####....\n"
     "..####....\n"
     "..####....\n"
     "..####....\n"
     "..####....\n"
     "..####....\n"
     "..####....\n"
     "..........\n"},
    // A ring: its hole runs the other way round.
    {3,
     "..........\n"
     "..........\n"
     "..........\n"
     ".######...\n"
     ".######...\n"
     ".##..##...\n"
     ".##..##...\n"
     ".######...\n"
     ".######...\n"
     "..........\n"},
    // Two squares over each other.
    {4,
     "..........\n"
     "..........\n"
     "..........\n"
     "...####...\n"
     "...####...\n"
     ".######...\n"
     ".######...\n"
     ".####.....\n"
     ".####.....\n"
     "..........\n"},
    // A square of the wrong direction.
    {5,
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     ".####.....\n"
     ".####.....\n"
     ".####.....\n"
     ".####.....\n"
     "..........\n"},
    // Four quarters of parabolas, without points on them: the ends are in the
    // middle of sides.
    {6,
     "..........\n"
     "..+****+..\n"
     ".+######+.\n"
     ".*######*.\n"
     ".*######*.\n"
     ".*######*.\n"
     ".*######*.\n"
     ".+######+.\n"
     "..+****+..\n"
     "..........\n"},
    // Two squares of both directions, over each other: they cancel out.
    {8,
     "..........\n"
     "....####..\n"
     "....####..\n"
     "..######..\n"
     "..######..\n"
     ".#...#....\n"
     ".#...#....\n"
     ".####.....\n"
     ".####.....\n"
     "..........\n"},
    // A ring of half the size, and a square turned by a quarter, whose left
    // part lies out of the box that the file tells.
    {9,
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "####......\n"
     "####......\n"
     "####......\n"
     "####......\n"
     ".###......\n"
     "..........\n"},
    // H moved, and moved once more with a square, and so on: four deep. The
    // last one has the reversed square over H.
    {12,
     "..........\n"
     "..........\n"
     "..####....\n"
     "######....\n"
     "#####.....\n"
     "#####.....\n"
     "#####.....\n"
     "..###.....\n"
     "..####....\n"
     "..........\n"},
    // One that is made of itself.
    {13,
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"
     "..........\n"},
};

TEST(glyphs_are_drawn) {
  TrueTypeFont font;
  open(font);
  for (const auto& wanted : kPictures) {
    Picture<10, 10> drawn_glyph;
    Painter(drawn_glyph.sink(), Workspace(ram))
        .glyph(font.font(), kStyle, {1_px, 9_px}, wanted.glyph);
    CHECK_PICTURE(drawn_glyph, wanted.picture);
  }
}

// All letters, at a place between pixels.
void draw_all(const Font& font, const Style& style, const Painter& painter) {
  for (uint16_t glyph = 0; glyph < sfnt_font::kGlyphCount; ++glyph) {
    painter.glyph(font, style,
                  {Q26_6::from_raw(kPen.x.raw + 37 * glyph), kPen.y}, glyph);
  }
}

TEST(strips_and_ram_change_no_picture) {
  const Matrix slanted = {Q16_16::from_int(14), Q16_16::from_int(3),
                          Q16_16::from_int(-2), Q16_16::from_int(17)};
  constexpr Supersample kSampled;
  constexpr EdgeContrast kContrast;
  const Style styles[] = {Style(13_px), Style(slanted),
                          Style(9_px).set_effect(kSampled),
                          Style(12_px).set_effect(kContrast)};
  for (const Coding* const coding :
       each_of({&kTrueTypeCoding, &kPlainTrueTypeCoding})) {
    TrueTypeFont font;
    open(font, {}, *coding);
    for (const Style& style : styles) {
      const auto draw = [&](const Painter& painter) {
        draw_all(font.font(), style, painter);
      };
      draw_strips(expected, kHeight, Workspace(ram), draw);
      for (const int32_t bytes : each_of({0, 700, 900, 1100, 1500})) {
        for (const int32_t rows : each_of<int32_t>({1, 5, kHeight})) {
          draw_strips(drawn, rows, {ram, static_cast<size_t>(bytes)}, draw);
          CHECK_EQ(count_different(), 0);
        }
      }
    }
  }
}

TEST(plain_files_draw_alike_without_overlaps) {
  constexpr Supersample kSampled;
  constexpr EdgeContrast kContrast;
  const Style styles[] = {Style(13_px), Style(9_px).set_effect(kSampled),
                          Style(12_px).set_effect(kContrast)};
  TrueTypeFont wide;
  open(wide);
  TrueTypeFont plain;
  open(plain, {}, kPlainTrueTypeCoding);
  for (const Style& style : styles) {
    // Squares, rings, curves; not those that overlap.
    for (const uint16_t glyph : each_of<uint16_t>({2, 3, 6, 7})) {
      const auto draw_with = [&](uint8_t(&out)[kWidth * kHeight],
                                 const TrueTypeFont& font) {
        draw_strips(out, kHeight, Workspace(ram), [&](const Painter& painter) {
          painter.glyph(font.font(), style, {5_px, 17_px}, glyph);
        });
      };
      draw_with(expected, plain);
      draw_with(drawn, wide);
      CHECK_EQ(count_different(), 0);
    }
  }
}

TEST(distances_are_refused_where_contours_may_overlap) {
  constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1));
  constexpr Supersample kSampled;
  TrueTypeFont wide;
  open(wide);
  TrueTypeFont plain;
  open(plain, {}, kPlainTrueTypeCoding);
  const Style distances = Style(20_px, kFilterText);
  const Style strokes = Style(20_px).set_effect(kStroke);
  for (const Style& style : each_of({distances, strokes})) {
    CHECK(wide.font().check(style) == Status::unsupported);
    CHECK(plain.font().check(style) == Status::ok);
    draw_strips(drawn, 8, Workspace(ram), [&](const Painter& painter) {
      painter.glyph(plain.font(), style, {4_px, 20_px}, 2);
    });
    CHECK(count_drawn() > 50);
  }
  CHECK(wide.font().check(Style(20_px)) == Status::ok);
  CHECK(wide.font().check(two_level_style(20_px)) == Status::ok);
  CHECK(wide.font().check(Style(20_px).set_effect(kSampled)) == Status::ok);
}

// The height of a glyph in whole pixels and in 1/255 of them, by the middle of
// its box; whether only its rows at both ends may be grey. The baseline is at
// 16 px, and a bit.
struct Height {
  int32_t full = 0;
  int32_t grey = 0;
};
Height height_of(const Font& font, const Style& style, uint16_t glyph) {
  draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(font, style, {4_px, Q26_6::from_raw(16 * 64 + 21)}, glyph);
  });
  GlyphMetrics box;
  CHECK_EQ(font.glyph_metrics(glyph, box), Status::ok);
  const int32_t x =
      4 + (to_px(font, style, box.x_min).raw + to_px(font, style, 90).raw) / 64;
  Height height;
  for (int32_t y = 0; y < kHeight; ++y) {
    const int32_t value = drawn[y * kWidth + x];
    height.full += value == 255 ? 1 : 0;
    height.grey += value == 255 ? 0 : value;
  }
  return height;
}

TEST(heights_are_fitted_by_zones) {
  TrueTypeFont opened;
  open(opened);
  const Font& font = opened.font();
  for (int32_t px = 8; px <= 22; ++px) {
    Style style = Style(Q26_6::from_int(px));
    Fit fit;
    CHECK_EQ(Fit::make(font, style, {}, fit), Status::ok);
    // 480 units, rounded up from 1/8 px on; then 700 to the nearest.
    const int32_t rows = (480 * px * 64 / 1000 + 56) / 64;
    const int32_t tall_q6 = rows * 64 * 700 / 480;
    const Height designed = height_of(font, style, 2);
    CHECK(designed.grey > 10);
    for (const Fitter* const fitter : each_of({&kGridFit, &kFitHeights})) {
      style.set_fit(*fitter, &fit);
      const Height capital = height_of(font, style, 2);
      CHECK_EQ(capital.full, (tall_q6 + 32) / 64);
      CHECK(capital.grey <= 8);
    }
  }
  // From 40 px on as designed.
  Style large = Style(40_px);
  draw_strips(expected, kHeight, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(font, large, kPen, 3);
  });
  large.set_fit(kFitTwoLevels, nullptr);
  draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(font, large, kPen, 3);
  });
  CHECK_EQ(count_different(), 0);
  // Fitted strips are those of the whole.
  Style small = Style(14_px);
  small.set_fit(kFitTwoLevels, nullptr);
  const auto draw = [&](const Painter& painter) {
    draw_all(font, small, painter);
  };
  draw_strips(expected, kHeight, Workspace(ram), draw);
  draw_strips(drawn, 3, {}, draw);
  CHECK_EQ(count_different(), 0);
}

TEST(text_is_measured_drawn_and_cached) {
  TrueTypeFont opened;
  open(opened);
  const Font& font = opened.font();
  CHECK_EQ(measure(font, "AB A").advance, 600 - 40 + 700 + 300 + 600);
  const auto draw = [&](const Painter& painter) {
    painter.glyph(font, kStyle, kPen, 3);
    painter.glyph(font, kStyle, {14_px, 16_px}, 4);
    painter.text(font, kStyle, {22_px, 16_px}, "A");
  };
  draw_strips(expected, kHeight, Workspace(ram), draw);
  CHECK_EQ(expected[15 * kWidth + 5], 255);
  CHECK_EQ(Painter().box(font, kStyle, kPen, "ABC").x0, 4);
  alignas(8) static uint8_t cache_ram[4096];
  GlyphCache cache;
  CHECK(GlyphCache::make({cache_ram, sizeof cache_ram}, {}, cache) ==
        Status::ok);
  for (int32_t i = 0; i < 2; ++i) {
    draw_strips(drawn, kHeight, Workspace(ram),
                [&](const Painter& painter) { draw(painter.with(cache)); });
    CHECK_EQ(count_different(), 0);
  }
  CHECK(cache.stats().hits >= 3);
}

TEST(glyphs_are_prepared) {
  TrueTypeFont opened;
  open(opened);
  const Font& font = opened.font();
  const Style style = Style(19_px);
  draw_strips(expected, kHeight, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(font, style, kPen, 4);
  });
  PreparedGlyph glyph;
  CHECK(PreparedGlyph::make(font, 4, style, kPen, Workspace(ram), glyph) ==
        Status::ok);
  draw_strips(drawn, 5, {},
              [&](const Painter& painter) { glyph.draw(painter.sink()); });
  CHECK_EQ(count_different(), 0);
  CHECK(PreparedGlyph::make(font, 200, style, kPen, Workspace(ram), glyph) ==
        Status::ok);
  CHECK(is_empty(glyph.box()));
  CHECK(PreparedGlyph::make(font, 4, style, kPen, {ram, 860}, glyph) ==
        Status::buffer_small);
}

TEST(the_last_glyph_may_end_with_the_file) {
  TrueTypeFont font;
  open(font);
  draw_strips(expected, kHeight, Workspace(ram), [&](const Painter& painter) {
    draw_all(font.font(), Style(11_px), painter);
  });
  Options options;
  options.is_glyf_last = true;
  open(font, options);
  draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
    draw_all(font.font(), Style(11_px), painter);
  });
  CHECK_EQ(count_different(), 0);
}

TEST(what_is_no_truetype_file_is_refused) {
  TrueTypeFont font;
  CHECK_EQ(font.font().glyph_or_notdef('A'), 0);
  CHECK_EQ(font.glyph_count(), 0);
  const Span<const uint8_t> good = build({});
  const auto open_with = [&](uint32_t at, uint8_t value, uint32_t face = 0) {
    const uint8_t before = file[at];
    file[at] = value;
    const Status status = font.open(good, kTrueTypeCoding, face);
    file[at] = before;
    return status;
  };
  CHECK(font.open({}) == Status::bad_magic);
  CHECK(font.open({file, 11}) == Status::corrupt);
  CHECK(open_with(0, 7) == Status::bad_magic);
  CHECK(open_with(5, 2) == Status::corrupt);  // two tables
  CHECK(open_with(0, 0, 1) == Status::no_glyph);
  const uint8_t cff[] = {'O', 'T', 'T', 'O', 0, 0, 0, 0, 0, 0, 0, 0};
  CHECK(font.open({cff, sizeof cff}) == Status::unsupported);
  CHECK(font.open(good) == Status::ok);
}

TEST(collections_have_faces) {
  static uint8_t collection[2048];
  const uint8_t header[] = {'t', 't', 'c', 'f', 0, 1, 0, 0, 0, 0,
                            0,   2,   0,   0,   0, 0, 0, 0, 0, 20};
  const size_t size = sfnt_font::build(file, {});
  // Offsets of tables count from the start of the collection.
  for (uint32_t i = 0; i != 10; ++i) {
    const uint32_t at = 12 + 16 * i + 8;
    const uint32_t offset =
        (uint32_t{file[at + 2]} << 8 | file[at + 3]) + sizeof header;
    file[at + 2] = static_cast<uint8_t>(offset >> 8);
    file[at + 3] = static_cast<uint8_t>(offset);
  }
  __builtin_memcpy(collection, header, sizeof header);
  __builtin_memcpy(collection + sizeof header, file, size);
  const Span<const uint8_t> bytes = {collection, size + sizeof header};
  TrueTypeFont font;
  CHECK(font.open(bytes, kTrueTypeCoding, 1) == Status::ok);
  CHECK_EQ(font.font().glyph_or_notdef('B'), 3);
  CHECK(font.open(bytes, kTrueTypeCoding, 0) == Status::corrupt ||
        font.open(bytes, kTrueTypeCoding, 0) == Status::bad_magic);
  CHECK(font.open(bytes, kTrueTypeCoding, 2) == Status::no_glyph);
}

}  // namespace
