// Pictures of glyphs of several colours in a cache.
#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/layers/colour_cache.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion/fade.hpp"
#include "inkcell/port/colour.hpp"
#include "inkcell/port/lcd.hpp"
#include "layer_font.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using namespace layer_font;

constexpr int32_t kSide = 32;
constexpr uint16_t kInk = 0x1234;
constexpr Point kPen = {2_px, 24_px};

// A disc, and half a leaf over it: no colour of the text.
constexpr Row kOwn[] = {{kDisc, 0}, {kLeaf, 1}};
// Another one, with an L of the text's colour.
constexpr Row kOfText[] = {{kDisc, 0}, {kEll, kColours}};

struct Paper {
  alignas(4) uint8_t bytes[2 * kSide * kSide + 2];

  // Of all colours, so that what is below counts.
  void clear() {
    uint32_t state = 7;
    for (uint8_t& byte : bytes) {
      state = state * 1664525 + 1013904223;
      byte = static_cast<uint8_t>(state >> 24);
    }
  }
  // Pixels begin at an odd address if `offset` is 1.
  Strip strip(ByteOrder order = ByteOrder::low_first, size_t offset = 0) {
    Strip out;
    out.stride = 2 * kSide;
    out.pixels = {bytes + offset, 2 * kSide * kSide};
    out.width = out.height = kSide;
    out.order = order;
    return out;
  }
  uint32_t pixel(int32_t i, ByteOrder order, size_t offset) const {
    const uint8_t* const at = bytes + offset + 2 * i;
    return order == ByteOrder::low_first ? at[0] | uint32_t{at[1]} << 8
                                         : at[1] | uint32_t{at[0]} << 8;
  }
  bool operator==(const Paper& other) const {
    return __builtin_memcmp(bytes, other.bytes, sizeof bytes) == 0;
  }
};

Paper drawn;
Paper wanted;
alignas(4) uint8_t ram[12 << 10];

// The largest difference of a channel. [levels]
int32_t distance(ByteOrder order = ByteOrder::low_first, size_t offset = 0) {
  int32_t most = 0;
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    const uint32_t a = drawn.pixel(i, order, offset);
    const uint32_t b = wanted.pixel(i, order, offset);
    constexpr uint32_t kChannels[][2] = {{11, 31}, {5, 63}, {0, 31}};
    for (const auto& channel : kChannels) {
      const auto level = [&](uint32_t pixel) {
        return static_cast<int32_t>(pixel >> channel[0] & channel[1]);
      };
      const int32_t by = level(a) - level(b);
      most = by > most ? by : -by > most ? -by : most;
    }
  }
  return most;
}

ColourCache cache_in(Span<uint8_t> room) {
  ColourCache cache;
  CHECK_OK(ColourCache::make(room, cache));
  return cache;
}

// The same by layers, at quarters of a pixel, as a GlyphCache places them.
void draw_by_layers(const Font& font,
                    const Style& style,
                    Point pen,
                    Text text,
                    const Strip& strip) {
  alignas(8) static uint8_t layers[4096];
  GlyphCache cache;
  CHECK_OK(GlyphCache::make(layers, {8, 4, 1}, cache));
  Rgb565Canvas canvas(strip, kInk);
  const ColourGlyphs colours(colour_of(canvas), &cache);
  Painter(canvas, {}, &colours).text(font, style, pen, text);
}

TEST(pictures_are_those_of_layers) {
  const Font font = font_with(kOwn);
  ColourCache cache = cache_in(ram);
  uint32_t glyphs = 0;
  const Style styles[] = {Style(20_px), Style(13_px, kFilterText)};
  const Point pens[] = {kPen, {Q26_6::from_raw(150), Q26_6::from_raw(1400)}};
  for (const Style& style : styles) {
    for (const Point& pen : pens) {
      for (int32_t round = 0; round < 3; ++round) {
        drawn.clear();
        wanted.clear();
        Rgb565Canvas canvas(drawn.strip(), kInk);
        ColourGlyphs colours(pictures_of(canvas));
        colours.set_cache(cache);
        Painter(canvas, {}, &colours).text(font, style, pen, "AB");
        draw_by_layers(font, style, pen, "AB", wanted.strip());
        CHECK(distance() <= 2);
        CHECK(cache.stats().bypasses == 0);
        ++glyphs;
      }
    }
  }
  CHECK_EQ(cache.stats().misses, 4u);
  CHECK_EQ(cache.stats().hits, glyphs - 4);
  CHECK_EQ(cache.stats().glyphs, 2u);
  CHECK(cache.stats().bytes != 0);
}

TEST(pictures_are_the_same_in_any_memory) {
  const Font font = font_with(kOwn);
  const Style style(20_px);
  ColourCache cache = cache_in(ram);
  const ByteOrder orders[] = {ByteOrder::low_first, ByteOrder::high_first};
  for (const ByteOrder order : orders) {
    for (size_t offset = 0; offset < 2; ++offset) {
      drawn.clear();
      wanted.clear();
      Rgb565Canvas canvas(drawn.strip(order, offset), kInk);
      ColourGlyphs colours(pictures_of(canvas));
      colours.set_cache(cache);
      Painter(canvas, {}, &colours).text(font, style, kPen, "A");
      draw_by_layers(font, style, kPen, "A", wanted.strip(order, offset));
      CHECK(distance(order, offset) <= 2);
    }
  }
}

TEST(pictures_are_clipped_by_strips_and_windows) {
  const Font font = font_with(kOwn);
  const Style style(20_px);
  ColourCache cache = cache_in(ram);
  wanted.clear();
  Rgb565Canvas canvas(wanted.strip(), kInk);
  ColourGlyphs colours(pictures_of(canvas));
  colours.set_cache(cache);
  Painter(canvas, {}, &colours).text(font, style, kPen, "A");
  // In strips of 5 rows, and in windows of columns.
  drawn.clear();
  for (int32_t y = 0; y < kSide; y += 5) {
    Strip strip = drawn.strip();
    strip.y0 = y;
    strip.height = y + 5 > kSide ? kSide - y : 5;
    strip.pixels.data += y * strip.stride;
    strip.pixels.size = static_cast<size_t>(strip.height * strip.stride);
    canvas.set_strip(strip);
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
  }
  CHECK(drawn == wanted);
  drawn.clear();
  canvas.set_strip(drawn.strip());
  for (int32_t x = 0; x < kSide; x += 7) {
    Sink window = canvas;
    window.window.x0 = x;
    window.window.x1 = x + 7 > kSide ? kSide : x + 7;
    Painter(window, {}, &colours).text(font, style, kPen, "A");
  }
  CHECK(drawn == wanted);
}

// Whatever it holds: with little RAM, too.
TEST(pictures_do_not_depend_on_the_ram) {
  const Font font = font_with(kOwn);
  const Style style(20_px);
  uint32_t kept = 0;
  for (size_t size = 512; size <= sizeof ram; size += 252) {
    ColourCache cache = cache_in({ram, size});
    Rgb565Canvas canvas({}, kInk);
    ColourGlyphs colours(pictures_of(canvas));
    colours.set_cache(cache);
    for (int32_t i = 0; i < 12; ++i) {
      const Point pen = {Q26_6::from_raw(128 + i % 5 * 16), 24_px};
      drawn.clear();
      wanted.clear();
      canvas.set_strip(drawn.strip());
      Painter(canvas, {}, &colours).text(font, style, pen, "A");
      draw_by_layers(font, style, pen, "A", wanted.strip());
      CHECK(distance() <= 2);
      CHECK(cache.stats().bytes <= size);
    }
    kept = cache.stats().bypasses == 0 ? kept + 1 : kept;
  }
  CHECK(kept > 20);
}

TEST(pictures_are_those_of_one_palette) {
  const Font font = font_with(kOwn);
  const Style style(20_px);
  ColourCache cache = cache_in(ram);
  const LayerColour own[] = {{10, 250, 90, 255}};
  for (uint8_t palette = 0; palette < 3; ++palette) {
    drawn.clear();
    wanted.clear();
    Rgb565Canvas canvas(drawn.strip(), kInk);
    ColourGlyphs colours(pictures_of(canvas));
    Rgb565Canvas other(wanted.strip(), kInk);
    ColourGlyphs by_layers(colour_of(other));
    if (palette == 2) {
      colours.set_colours(own);
      by_layers.set_colours(own);
    } else {
      colours.set_palette(palette);
      by_layers.set_palette(palette);
    }
    colours.set_cache(cache);
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
    Painter(other, {}, &by_layers).text(font, style, kPen, "A");
    CHECK(distance() <= 2);
  }
  CHECK_EQ(cache.stats().misses, 3u);
  CHECK_EQ(cache.stats().glyphs, 1u);
  cache.clear();
  CHECK_EQ(cache.stats().glyphs, 0u);
}

// By their layers, exactly.
TEST(pictures_are_not_made_where_they_would_differ) {
  const Style style(20_px);
  ColourCache cache = cache_in(ram);
  const auto check = [&](const Font& font, const Style& with, bool is_faded) {
    drawn.clear();
    wanted.clear();
    Rgb565Canvas canvas(drawn.strip(), kInk);
    Rgb565Canvas other(wanted.strip(), kInk);
    set_sub_pixels(canvas);
    set_sub_pixels(other);
    ColourGlyphs colours(pictures_of(canvas));
    colours.set_cache(cache);
    const ColourGlyphs by_layers(colour_of(other));
    const motion::Fade fade = {&canvas, 90};
    const motion::Fade other_fade = {&other, 90};
    const Sink faded = motion::make_sink(fade);
    const Sink other_faded = motion::make_sink(other_fade);
    Painter(is_faded ? faded : canvas, {}, &colours)
        .text(font, with, kPen, "A");
    Painter(is_faded ? other_faded : other, {}, &by_layers)
        .text(font, with, kPen, "A");
    CHECK(drawn == wanted);
    CHECK_EQ(cache.stats().misses, 0u);
  };
  check(font_with(kOwn), style, true);
  CHECK_EQ(cache.stats().bypasses, 0u);
  check(font_with(kOfText), style, false);
  CHECK_EQ(cache.stats().bypasses, 1u);
  Style lcd_style(20_px);
  const Lcd lcd;
  lcd_style.set_effect(lcd);
  check(font_with(kOwn), lcd_style, false);
  // Nor on canvases that take none.
  Grey8Canvas grey(drawn.strip());
  ColourGlyphs colours(colour_of(grey));
  colours.set_cache(cache);
  Painter(grey, {}, &colours).text(font_with(kOwn), style, kPen, "A");
  CHECK_EQ(cache.stats().misses, 0u);
}

TEST(a_colour_cache_says_what_is_wrong) {
  ColourCache cache;
  CHECK_EQ(ColourCache::make({ram + 1, 1024}, cache), Status::misaligned);
  CHECK_EQ(ColourCache::make({ram, 511}, cache), Status::buffer_small);
  CHECK_EQ(cache.stats().bytes, 0u);
  // An empty one keeps nothing.
  const Font font = font_with(kOwn);
  drawn.clear();
  wanted.clear();
  Rgb565Canvas canvas(drawn.strip(), kInk);
  ColourGlyphs colours(pictures_of(canvas));
  colours.set_cache(cache);
  Painter(canvas, {}, &colours).text(font, Style(20_px), kPen, "A");
  draw_by_layers(font, Style(20_px), kPen, "A", wanted.strip());
  CHECK(drawn == wanted);
}

}  // namespace
