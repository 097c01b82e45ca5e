// The cache of drawn glyphs: the same pictures, and which glyphs it keeps.
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/field/draw.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shadow.hpp"
#include "outline_record.hpp"
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
  Style style(Q26_6::from_int(px), kFilterText);
  return style;
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

// Coverage of one or three channels; each pixel is drawn once by one glyph.
struct Canvas {
  Rect window = {0, 0, kWidth, kHeight};
  int32_t channels = 1;
  bool takes_blocks = false;
  uint8_t pixels[kWidth * kHeight] = {};

  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    const bool fits = count >= 1 && y >= window.y0 && y < window.y1 &&
                      x >= window.x0 && count <= window.x1 - x;
    CHECK(fits && "pixels inside the window");
    for (int32_t i = 0; fits && i < count; ++i) {
      uint32_t sum = 0;
      for (int32_t channel = 0; channel < channels; ++channel) {
        // Channels count differently, so that none can stand for another.
        sum += values == nullptr ? 255u << channel
                                 : uint32_t{*values++} << channel;
      }
      sum /= (1u << channels) - 1;
      uint8_t& pixel = pixels[y * kWidth + x + i];
      pixel = static_cast<uint8_t>(pixel > sum ? pixel : sum);
    }
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    CHECK(count <= kMaxSpan);
    static_cast<Canvas*>(context)->put(x, y, coverage, count);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    static_cast<Canvas*>(context)->put(x, y, nullptr, count);
  }
  static void block(void* context, const CoverageBlock& block) {
    const Rect& pixels = block.pixels;
    CHECK_EQ(block.stride % 4, 0);
    CHECK_EQ((reinterpret_cast<uintptr_t>(block.coverage) -
              static_cast<uintptr_t>(pixels.x0)) %
                 4,
             0u);
    for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
      static_cast<Canvas*>(context)->put(
          pixels.x0, y, block.coverage + (y - pixels.y0) * block.stride,
          pixels.x1 - pixels.x0);
    }
  }
  Sink sink() {
    Sink sink = {window, this, coverage, solid};
    sink.block = takes_blocks ? block : nullptr;
    sink.coverage_rgb = channels == 3 ? coverage : nullptr;
    return sink;
  }
};

Canvas cached;
Canvas plain;

void clear(Canvas& canvas, int32_t channels) {
  for (uint8_t& pixel : canvas.pixels) {
    pixel = 0;
  }
  canvas.channels = channels;
  canvas.window = {0, 0, kWidth, kHeight};
}

int32_t worst_difference() {
  int32_t worst = 0;
  for (int32_t i = 0; i < kWidth * kHeight; ++i) {
    const int32_t difference = cached.pixels[i] - plain.pixels[i];
    worst = difference > worst ? difference : worst;
    worst = -difference > worst ? -difference : worst;
  }
  return worst;
}

int32_t ink(const Canvas& canvas) {
  int32_t sum = 0;
  for (const uint8_t pixel : canvas.pixels) {
    sum += pixel;
  }
  return sum;
}

void draw_cached(GlyphCache& cache,
                 const Font& font,
                 uint16_t glyph,
                 const Style& style,
                 Point origin) {
  Painter(cached.sink(), {}, &cache).glyph(font, style, origin, glyph);
}

// Draws a glyph with the cache and without; the greatest difference.
int32_t compare(GlyphCache& cache,
                const Font& font,
                uint16_t glyph,
                const Style& style,
                Point origin,
                int32_t channels = 1) {
  clear(cached, channels);
  clear(plain, channels);
  draw_cached(cache, font, glyph, style, origin);
  Painter(plain.sink()).glyph(font, style, origin, glyph);
  return worst_difference();
}

Point px(int32_t x, int32_t y) {
  return {Q26_6::from_int(x), Q26_6::from_int(y)};
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
  clear(cached, 1);
  CHECK_OK(draw_clock(font, style_of(20), px(2, 20), cached.sink()));
  CHECK(ink(cached) > 0);
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
  CHECK_EQ(compare(cache, font, 1, style, px(8, 20)), 0);
  CHECK(ink(cached) > 0);
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
    clear(cached, 1);
    clear(plain, 1);
    const Q26_6 y = Q26_6::from_int(20);
    draw_cached(cache, font, 1, style, {Q26_6::from_raw(raw), y});
    Painter(plain.sink())
        .glyph(font, style, {Q26_6::from_raw((raw + 8) & ~15), y}, 1);
    CHECK_EQ(worst_difference(), 0);
  }
  CHECK_EQ(cache.stats().misses, 4u);
  CHECK_EQ(cache.stats().hits, 124u);
}

TEST(strips_and_windows_do_not_matter) {
  const Font font = sample_font();
  const Style style = style_of(20);
  const Text text = "ABCA";
  clear(plain, 1);
  GlyphCache whole = cache_of(2048, exact());
  Painter(plain.sink(), {}, &whole).text(font, style, px(-3, 18), text);
  CHECK(ink(plain) > 0);
  for (int32_t rows = 1; rows < 9; ++rows) {
    GlyphCache cache = cache_of(2048, exact());
    clear(cached, 1);
    cached.takes_blocks = rows % 2 == 0;
    for (int32_t y = 0; y < kHeight; y += rows) {
      const int32_t end = y + rows < kHeight ? y + rows : kHeight;
      const int32_t middle = 5 * rows;
      cached.window = {0, y, middle, end};
      Painter(cached.sink(), {}, &cache).text(font, style, px(-3, 18), text);
      cached.window = {middle, y, kWidth, end};
      Painter(cached.sink(), {}, &cache).text(font, style, px(-3, 18), text);
    }
    CHECK_EQ(worst_difference(), 0);
  }
}

TEST(glyphs_outside_the_window_are_not_recorded) {
  const Font font = sample_font();
  const Style style = style_of(20);
  GlyphCache cache = cache_of(2048, exact());
  clear(cached, 1);
  draw_cached(cache, font, 2, style, px(500, 18));
  draw_cached(cache, font, 1, style, px(10, 18));  // a space
  CHECK_EQ(cache.stats().misses, 0u);
  CHECK_EQ(cache.stats().glyphs, 0u);
  CHECK_EQ(ink(cached), 0);
}

TEST(the_glyph_unused_for_the_longest_time_leaves) {
  const Font font = outline_font();
  const Style style = style_of(24);
  GlyphCache cache = cache_of(1024, exact());
  clear(cached, 1);
  // Phase by phase until one had to leave, with the first always in use.
  int32_t drawn = 0;
  while (cache.stats().evictions == 0 && drawn < 60) {
    draw_cached(cache, font, 1, style, px(10, 20));
    const Point origin = {Q26_6::from_raw(641 + drawn), Q26_6::from_int(20)};
    draw_cached(cache, font, 1, style, origin);
    ++drawn;
  }
  CHECK(drawn > 2 && drawn < 60);
  const GlyphCacheStats before = cache.stats();
  draw_cached(cache, font, 1, style, px(10, 20));
  CHECK_EQ(cache.stats().hits, before.hits + 1);
  const Point second = {Q26_6::from_raw(641), Q26_6::from_int(20)};
  draw_cached(cache, font, 1, style, second);
  CHECK_EQ(cache.stats().misses, before.misses + 1);
  CHECK(cache.stats().bytes <= cache.stats().capacity);
}

TEST(glyphs_that_are_too_large_are_drawn_and_not_kept) {
  const Font font = sample_font();
  GlyphCache cache = cache_of(512, exact());
  CHECK_EQ(compare(cache, font, 2, style_of(40), px(4, 24)), 0);
  CHECK(ink(cached) > 0);
  CHECK_EQ(cache.stats().bypasses, 1u);
  CHECK_EQ(cache.stats().misses, 0u);
}

TEST(styles_are_told_apart_by_value) {
  const Font font = outline_font();
  GlyphCache cache = cache_of(4096, exact(2));
  Style style = style_of(20);
  CHECK_EQ(compare(cache, font, 1, style, px(10, 20)), 0);
  // In the same place, as on a stack.
  style = style_of(16);
  CHECK_EQ(compare(cache, font, 1, style, px(10, 20)), 0);
  const Style other = style_of(20);
  CHECK_EQ(compare(cache, font, 1, other, px(10, 20)), 0);
  CHECK_EQ(cache.stats().hits, 1u);
  CHECK_EQ(cache.stats().misses, 2u);
  // A third one takes the slot of 16 px.
  CHECK_EQ(compare(cache, font, 1, style_of(12), px(10, 20)), 0);
  CHECK_EQ(cache.stats().glyphs, 2u);
  CHECK_EQ(compare(cache, font, 1, other, px(10, 20)), 0);
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
    clear(cached, 1);
    const Sink sink = cached.sink();
    const Painter painter(sink, {}, &cache);
    const Rect box = painter.box(font, style, origin, "AA");
    painter.text(font, style, origin, "AA");
    Rect touched;
    for (int32_t i = 0; i < kWidth * kHeight; ++i) {
      const int32_t x = i % kWidth;
      const int32_t y = i / kWidth;
      if (cached.pixels[i] != 0) {
        touched = is_empty(touched)
                      ? Rect{x, y, x + 1, y + 1}
                      : Rect{touched.x0 < x ? touched.x0 : x, touched.y0,
                             touched.x1 > x ? touched.x1 : x + 1, y + 1};
      }
    }
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
    clear(cached, 1);
    clear(plain, 1);
    Painter(cached.sink(), {}, &cache).glyphs(face, fallback, px(6, 20), run);
    Painter(plain.sink()).glyphs(face, fallback, px(6, 20), run);
    CHECK_EQ(worst_difference(), 0);
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
  clear(cached, 1);
  for (int32_t round = 0; round < 3; ++round) {
    Painter(cached.sink(), {}, &cache)
        .glyphs({&fonts[0], &styles[0]}, fallback, px(6, 20), run);
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
    CHECK_EQ(compare(cache, font, 1, style, px(10, 20), 3), 0);
    CHECK_EQ(compare(cache, font, 2, style, px(10, 20), 3), 0);
    // A sink without channels has an entry of its own.
    CHECK_EQ(compare(cache, font, 1, style, px(10, 20), 1), 0);
  }
  CHECK_EQ(cache.stats().hits, 3u);
  CHECK_EQ(cache.stats().misses, 3u);
}

TEST(effects_fit_their_box) {
  const Font font = outline_font();
  const Filter glow = glow_filter(Q6_10::from_int(3));
  Style style(14_px, glow);
  GlyphCache cache = cache_of(4096, exact());
  CHECK_EQ(compare(cache, font, 1, style, px(12, 18)), 0);
  CHECK_EQ(cache.stats().misses, 1u);
  CHECK_EQ(compare(cache, font, 1, style, px(12, 18)), 0);
  CHECK_EQ(cache.stats().hits, 1u);
}

TEST(clear_forgets_everything) {
  const Font font = outline_font();
  const Style style = style_of(20);
  GlyphCache cache = cache_of(2048, exact());
  const uint32_t empty = cache.stats().bytes;
  CHECK_EQ(compare(cache, font, 1, style, px(10, 20)), 0);
  CHECK(cache.stats().bytes > empty);
  cache.clear();
  CHECK_EQ(cache.stats().bytes, empty);
  CHECK_EQ(cache.stats().glyphs, 0u);
  CHECK_EQ(compare(cache, font, 1, style, px(10, 20)), 0);
  CHECK_EQ(cache.stats().misses, 2u);
}

// Small caches, in which almost every glyph makes others leave.
TEST(random_calls_draw_as_without_a_cache) {
  const Font fonts[] = {sample_font(), outline_font()};
  for (Rounds rounds(20261123, 12); rounds.next();) {
    Random& random = rounds.random;
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
      cached.takes_blocks = random.below(2) == 0;
      CHECK(compare(cache, font, glyph, style, origin) <= limit);
      CHECK(cache.stats().bytes <= cache.stats().capacity);
    }
  }
}

}  // namespace
