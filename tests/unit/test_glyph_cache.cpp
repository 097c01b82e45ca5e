// The cache of drawn glyphs: the same pictures, and which glyphs it keeps.
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/field/draw.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "ink.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shadow.hpp"
#include "outline_record.hpp"
#include "picture.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;

alignas(8) uint8_t rom[font_builder::kSampleFontBytes];
alignas(8) uint8_t outline_rom[1024];
alignas(8) uint8_t ram[4096];

Font sample_font() {
  Font font;
  const size_t size = font_builder::build_sample_font(rom);
  CHECK_OK(open_any_font({rom, size}, font));
  return font;
}

// .notdef, a wedge (A), a wide bar (B) and a space (C).
Font outline_font() {
  using namespace outline_record;
  constexpr OutlinePoint kWedge[] = {
      {start, 40, 512}, {corner, 210, 0}, {corner, 300, 0}, {corner, 470, 512}};
  constexpr OutlinePoint kBar[] = {{start, 30, 100},
                                   {corner, 930, 100},
                                   {corner, 930, 250},
                                   {corner, 30, 250}};
  const OutlineSource glyphs[] = {
      {600}, {510, {kWedge, 4}}, {960, {kBar, 4}}, {300}};
  const size_t size = build_outline_font({glyphs, 4}, 0, 'A',
                                         {outline_rom, sizeof outline_rom}, {});
  Font font;
  CHECK_OK(open_any_font({outline_rom, size}, font));
  return font;
}

Style style_of(int32_t px) {
  return Style(Q26_6::from_int(px), kFilterText);
}

GlyphCache cache_of(size_t bytes, const GlyphCacheOptions& options) {
  GlyphCache cache;
  CHECK_OK(GlyphCache::make({ram, bytes}, options, cache));
  return cache;
}

GlyphCacheOptions exact(uint8_t styles = 1) {
  GlyphCacheOptions options;
  options.bits = 8;
  options.phases = 64;
  options.styles = styles;
  return options;
}

constexpr int32_t kWidth = 48;
constexpr int32_t kHeight = 26;

using Page = Picture<kWidth, kHeight, Overlap::greatest>;
Page cached;
Page plain;

// The sink of an empty picture.
Sink clear(Page& page, bool takes_blocks = false, bool takes_rgb = false) {
  page.clear();
  Sink sink = page.sink();
  sink.block = takes_blocks ? Page::block : nullptr;
  sink.coverage_rgb = takes_rgb ? Page::coverage_rgb : nullptr;
  return sink;
}

// Draws a glyph with the cache and without; the greatest difference.
int32_t compare(GlyphCache& cache,
                const Font& font,
                uint16_t glyph,
                const Style& style,
                Point origin,
                bool takes_blocks = false,
                bool takes_rgb = false) {
  Painter(clear(cached, takes_blocks, takes_rgb), {}, &cache)
      .glyph(font, style, origin, glyph);
  Painter(clear(plain, takes_blocks, takes_rgb))
      .glyph(font, style, origin, glyph);
  return cached.difference(plain);
}

// As docs/DRAW.md shows it.
Status draw_clock(const Font& font,
                  const Style& style,
                  Point origin,
                  const Sink& sink) {
  alignas(8) static uint8_t kept[2048];
  GlyphCache cache;
  INKCELL_TRY(GlyphCache::make(kept, {}, cache));
  Painter(sink, {}, &cache).text(font, style, origin, "12:34");
  return Status::ok;
}

TEST(the_example_draws) {
  const Font font = sample_font();
  CHECK_OK(draw_clock(font, style_of(20), {2, 20}, clear(cached)));
  CHECK(cached.ink() > 0);
}

TEST(options_out_of_range_are_refused) {
  GlyphCache cache;
  constexpr uint8_t kBits[] = {0, 1, 5, 16};
  for (const uint8_t bits : kBits) {
    GlyphCacheOptions options;
    options.bits = bits;
    CHECK_EQ(GlyphCache::make({ram, 2048}, options, cache),
             Status::bad_argument);
  }
  constexpr uint8_t kPhases[] = {0, 3, 65, 128};
  for (const uint8_t phases : kPhases) {
    GlyphCacheOptions options;
    options.phases = phases;
    CHECK_EQ(GlyphCache::make({ram, 2048}, options, cache),
             Status::bad_argument);
  }
  GlyphCacheOptions options;
  options.styles = 0;
  CHECK_EQ(GlyphCache::make({ram, 2048}, options, cache), Status::bad_argument);
  options.styles = 17;
  CHECK_EQ(GlyphCache::make({ram, 4096}, options, cache), Status::bad_argument);
  options.styles = 4;
  CHECK_EQ(GlyphCache::make({ram, 2047}, options, cache), Status::buffer_small);
  CHECK_EQ(GlyphCache::make({ram + 1, 2048}, {}, cache), Status::misaligned);
  CHECK_EQ(cache.stats().capacity, 0u);
}

TEST(without_ram_it_draws_all_the_same) {
  const Font font = outline_font();
  const Style style = style_of(20);
  GlyphCache cache;
  CHECK_EQ(compare(cache, font, 1, style, {8, 20}), 0);
  CHECK(cached.ink() > 0);
  CHECK_EQ(cache.stats().hits + cache.stats().misses, 0u);
}

TEST(eight_bits_and_all_phases_are_exact) {
  const Font fonts[] = {sample_font(), outline_font()};
  const Style style = style_of(21);
  GlyphCache cache = cache_of(sizeof ram, exact());
  for (const Font& font : fonts) {
    for (int32_t i = 0; i < 40; ++i) {
      const Point origin = {Q26_6::from_raw(300 + i * 29),
                            Q26_6::from_raw(1200 - i * 13)};
      const auto glyph = static_cast<uint16_t>(1 + i % 3);
      CHECK_EQ(compare(cache, font, glyph, style, origin), 0);
      CHECK_EQ(compare(cache, font, glyph, style, origin), 0);
    }
  }
  CHECK(cache.stats().hits > 40);
}

TEST(four_bits_are_near) {
  const Font font = sample_font();
  const Style style = style_of(21);
  GlyphCacheOptions options = exact();
  options.bits = 4;
  GlyphCache cache = cache_of(sizeof ram, options);
  for (int32_t i = 0; i < 64; i += 7) {
    const Point origin = {Q26_6::from_raw(640 + i), Q26_6::from_raw(1280)};
    CHECK(compare(cache, font, 2, style, origin) <= 8);
  }
}

TEST(glyphs_are_drawn_at_the_nearest_phase) {
  const Font font = outline_font();
  const Style style = style_of(20);
  GlyphCacheOptions options = exact();
  options.phases = 4;
  GlyphCache cache = cache_of(sizeof ram, options);
  for (int32_t raw = 576; raw < 704; ++raw) {
    const Q26_6 y = 20_px;
    Painter(clear(cached), {}, &cache)
        .glyph(font, style, {Q26_6::from_raw(raw), y}, 1);
    Painter(clear(plain))
        .glyph(font, style, {Q26_6::from_raw((raw + 8) & ~15), y}, 1);
    CHECK(cached == plain);
  }
  CHECK_EQ(cache.stats().misses, 4u);
  CHECK_EQ(cache.stats().hits, 124u);
}

TEST(strips_and_windows_do_not_matter) {
  const Font font = sample_font();
  const Style style = style_of(20);
  const Text text = "ABCA";
  GlyphCache whole = cache_of(2048, exact());
  Painter(clear(plain), {}, &whole).text(font, style, {-3, 18}, text);
  CHECK(plain.ink() > 0);
  for (int32_t rows = 1; rows < 9; ++rows) {
    GlyphCache cache = cache_of(2048, exact());
    cached.clear();
    cached.draw_parts(rows, 5 * rows, [&](Sink sink) {
      sink.block = rows % 2 == 0 ? Page::block : nullptr;
      Painter(sink, {}, &cache).text(font, style, {-3, 18}, text);
    });
    CHECK(cached == plain);
  }
}

TEST(glyphs_outside_the_window_are_not_recorded) {
  const Font font = sample_font();
  const Style style = style_of(20);
  GlyphCache cache = cache_of(2048, exact());
  const Sink sink = clear(cached);
  const Painter painter(sink, {}, &cache);
  painter.glyph(font, style, {500, 18}, 2);
  painter.glyph(font, style, {10, 18}, 1);  // a space
  CHECK_EQ(cache.stats().misses, 0u);
  CHECK_EQ(cache.stats().glyphs, 0u);
  CHECK_EQ(cached.ink(), 0);
}

TEST(the_glyph_unused_for_the_longest_time_leaves) {
  const Font font = outline_font();
  const Style style = style_of(24);
  GlyphCache cache = cache_of(1024, exact());
  const Sink sink = clear(cached);
  const Painter painter(sink, {}, &cache);
  // Phase by phase until one had to leave, with the first always in use.
  int32_t drawn = 0;
  while (cache.stats().evictions == 0 && drawn < 60) {
    painter.glyph(font, style, {10, 20}, 1);
    const Point origin = {Q26_6::from_raw(641 + drawn), 20_px};
    painter.glyph(font, style, origin, 1);
    ++drawn;
  }
  CHECK(drawn > 2 && drawn < 60);
  const GlyphCacheStats before = cache.stats();
  painter.glyph(font, style, {10, 20}, 1);
  CHECK_EQ(cache.stats().hits, before.hits + 1);
  const Point second = {Q26_6::from_raw(641), 20_px};
  painter.glyph(font, style, second, 1);
  CHECK_EQ(cache.stats().misses, before.misses + 1);
  CHECK(cache.stats().bytes <= cache.stats().capacity);
}

TEST(glyphs_that_are_too_large_are_drawn_and_not_kept) {
  const Font font = sample_font();
  GlyphCache cache = cache_of(512, exact());
  CHECK_EQ(compare(cache, font, 2, style_of(40), {4, 24}), 0);
  CHECK(cached.ink() > 0);
  CHECK_EQ(cache.stats().bypasses, 1u);
  CHECK_EQ(cache.stats().misses, 0u);
}

TEST(styles_are_told_apart_by_value) {
  const Font font = outline_font();
  GlyphCache cache = cache_of(4096, exact(2));
  Style style = style_of(20);
  CHECK_EQ(compare(cache, font, 1, style, {10, 20}), 0);
  // In the same place, as on a stack.
  style = style_of(16);
  CHECK_EQ(compare(cache, font, 1, style, {10, 20}), 0);
  const Style other = style_of(20);
  CHECK_EQ(compare(cache, font, 1, other, {10, 20}), 0);
  CHECK_EQ(cache.stats().hits, 1u);
  CHECK_EQ(cache.stats().misses, 2u);
  // A third one takes the slot of 16 px.
  CHECK_EQ(compare(cache, font, 1, style_of(12), {10, 20}), 0);
  CHECK_EQ(cache.stats().glyphs, 2u);
  CHECK_EQ(compare(cache, font, 1, other, {10, 20}), 0);
  CHECK_EQ(cache.stats().hits, 2u);
}

TEST(boxes_of_text_are_where_the_cache_draws_it) {
  const Font font = outline_font();
  const Style style = style_of(16);
  GlyphCacheOptions options = exact();
  options.phases = 1;
  GlyphCache cache = cache_of(2048, options);
  for (int32_t raw = 0; raw < 64; raw += 7) {
    const Point origin = {Q26_6::from_raw(2 * 64 + raw),
                          Q26_6::from_raw(19 * 64 - raw)};
    Ink ink;
    const Sink sink = ink.sink({0, 0, kWidth, kHeight});
    const Painter painter(sink, {}, &cache);
    const Rect box = painter.box(font, style, origin, "AA");
    painter.text(font, style, origin, "AA");
    const Rect touched = ink.box;
    CHECK(touched.x0 >= box.x0 && touched.x0 <= box.x0 + 1);
    CHECK(touched.y0 >= box.y0 && touched.y0 <= box.y0 + 1);
    CHECK(touched.x1 <= box.x1 && touched.x1 >= box.x1 - 1);
    CHECK(touched.y1 <= box.y1 && touched.y1 >= box.y1 - 1);
  }
}

TEST(glyphs_of_other_faces_are_drawn_with_their_styles) {
  const Font fonts[] = {outline_font(), sample_font()};
  const Style styles[] = {style_of(20), style_of(14)};
  const Face face = {&fonts[0], &styles[0]};
  const Face fallback[] = {{&fonts[1], &styles[1]}};
  PositionedGlyph run[2];
  run[0].glyph = 1;
  run[1].glyph = 2;
  run[1].x = 512;
  run[1].face = 1;
  GlyphCache cache = cache_of(4096, exact(2));
  for (int32_t round = 0; round < 2; ++round) {
    Painter(clear(cached), {}, &cache).glyphs(face, fallback, {6, 20}, run);
    Painter(clear(plain)).glyphs(face, fallback, {6, 20}, run);
    CHECK(cached == plain);
  }
  CHECK_EQ(cache.stats().misses, 2u);
  CHECK_EQ(cache.stats().hits, 2u);
}

TEST(faces_without_a_glyph_take_no_slot) {
  const Font fonts[] = {outline_font(), sample_font()};
  const Style styles[] = {style_of(20), style_of(14)};
  const Face fallback[] = {{&fonts[1], &styles[1]}};
  PositionedGlyph run[1];
  run[0].glyph = 1;
  GlyphCache cache = cache_of(2048, exact());
  for (int32_t round = 0; round < 3; ++round) {
    Painter(clear(cached), {}, &cache)
        .glyphs({&fonts[0], &styles[0]}, fallback, {6, 20}, run);
  }
  CHECK_EQ(cache.stats().hits, 2u);
  CHECK_EQ(cache.stats().evictions, 0u);
}

TEST(sub_pixels_are_kept_by_channel) {
  const Font font = outline_font();
  const Lcd lcd;
  Style style = style_of(20);
  style.set_effect(lcd);
  GlyphCache cache = cache_of(4096, exact(2));
  for (int32_t round = 0; round < 2; ++round) {
    CHECK_EQ(compare(cache, font, 1, style, {10, 20}, false, true), 0);
    CHECK_EQ(compare(cache, font, 2, style, {10, 20}, false, true), 0);
    // A sink without channels has an entry of its own.
    CHECK_EQ(compare(cache, font, 1, style, {10, 20}), 0);
  }
  CHECK_EQ(cache.stats().hits, 3u);
  CHECK_EQ(cache.stats().misses, 3u);
}

TEST(effects_fit_their_box) {
  const Font font = outline_font();
  const Filter glow = glow_filter(Q6_10::from_int(3));
  Style style(14_px, glow);
  GlyphCache cache = cache_of(4096, exact());
  CHECK_EQ(compare(cache, font, 1, style, {12, 18}), 0);
  CHECK_EQ(cache.stats().misses, 1u);
  CHECK_EQ(compare(cache, font, 1, style, {12, 18}), 0);
  CHECK_EQ(cache.stats().hits, 1u);
}

TEST(clear_forgets_everything) {
  const Font font = outline_font();
  const Style style = style_of(20);
  GlyphCache cache = cache_of(2048, exact());
  const uint32_t empty = cache.stats().bytes;
  CHECK_EQ(compare(cache, font, 1, style, {10, 20}), 0);
  CHECK(cache.stats().bytes > empty);
  cache.clear();
  CHECK_EQ(cache.stats().bytes, empty);
  CHECK_EQ(cache.stats().glyphs, 0u);
  CHECK_EQ(compare(cache, font, 1, style, {10, 20}), 0);
  CHECK_EQ(cache.stats().misses, 2u);
}

// Small caches, in which almost every glyph makes others leave.
TEST(random_calls_draw_as_without_a_cache) {
  const Font fonts[] = {sample_font(), outline_font()};
  for (Random& random : Rounds(20261123, 12)) {
    GlyphCacheOptions options =
        exact(static_cast<uint8_t>(random.between(1, 3)));
    options.bits = random.below(2) == 0 ? 4 : 8;
    const auto bytes = static_cast<size_t>(
        random.between(options.styles * int32_t{GlyphCache::kMinBytes}, 4096));
    GlyphCache cache = cache_of(bytes, options);
    for (int32_t call = 0; call < 60 && !check::failed(); ++call) {
      const Style style = style_of(random.between(8, 30));
      const Font& font = fonts[random.below(2)];
      const Point origin = {Q26_6::from_raw(random.between(-640, 2560)),
                            Q26_6::from_raw(random.between(0, 2048))};
      const auto glyph = static_cast<uint16_t>(random.below(6));
      const int32_t limit = options.bits == 4 ? 8 : 0;
      CHECK(compare(cache, font, glyph, style, origin, random.below(2) == 0) <=
            limit);
      CHECK(cache.stats().bytes <= cache.stats().capacity);
    }
  }
}

}  // namespace
