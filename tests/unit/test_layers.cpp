// Glyphs of several colours: layers, palettes, opacity, the form of one colour.
#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/layers/verify.hpp"
#include "inkcell/motion/fade.hpp"
#include "inkcell/port/colour.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "layer_font.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using namespace layer_font;

constexpr int32_t kSide = 24;
constexpr uint32_t kInk = 0x123456;
constexpr Point kPen = {2_px, 20_px};

// A picture of three bytes a pixel, on a background of its own.
struct Paper {
  uint8_t bytes[kSide * kSide * 3];

  Paper() { clear(); }
  void clear() { __builtin_memset(bytes, 0x60, sizeof bytes); }
  Strip strip(int32_t y0 = 0, int32_t rows = kSide) {
    Strip out;
    out.stride = kSide * 3;
    out.pixels = {bytes + y0 * out.stride,
                  static_cast<size_t>(rows * out.stride)};
    out.y0 = y0;
    out.width = kSide;
    out.height = rows;
    return out;
  }
  bool operator==(const Paper& other) const {
    return __builtin_memcmp(bytes, other.bytes, sizeof bytes) == 0;
  }
};

// What glyph A of kRows is, layer by layer, in two colours.
void draw_by_hand(const Font& font,
                  const Style& style,
                  uint32_t first,
                  uint32_t second,
                  uint8_t opacity,
                  Paper& paper) {
  Rgb888Canvas canvas(paper.strip(), first);
  Painter(canvas).glyph(font, style, kPen, kDisc);
  canvas.set_colour(second);
  const motion::Fade half = {&canvas, opacity};
  Painter(motion::make_sink(half)).glyph(font, style, kPen, kLeaf);
  canvas.set_colour(kInk);
  Painter(canvas).glyph(font, style, kPen, kEll);
  const motion::Fade faint = {&canvas, 100};
  Painter(motion::make_sink(faint)).glyph(font, style, kPen, kLeaf);
}

Paper drawn;
Paper wanted;

// The example of docs/DRAW.md.
void draw_forecast(port::Rgb565Canvas& canvas, const Font& font) noexcept {
  const ColourGlyphs colours(port::colour_of(canvas));
  const Painter painter(canvas, {}, &colours);
  painter.text(font, Style(24_px), {4_px, 28_px}, "sun \u2600");
}

TEST(layers_of_text_in_rgb565) {
  const Font font = font_with(kRows);
  drawn.clear();
  Strip strip = drawn.strip();
  strip.stride = 2 * kSide;
  Rgb565Canvas canvas(strip, 0x1234);
  draw_forecast(canvas, font);
  wanted.clear();
  CHECK(!(drawn == wanted));
  CHECK_EQ(canvas.pixels().colour, 0x1234);
}

TEST(layers_lie_over_each_other) {
  const Font font = font_with(kRows);
  CHECK_OK(verify_layers(font));
  Direction turned;
  turned.cosine = Fixed<int32_t, 30>::from_raw(858993459);  // 0.8
  turned.sine = Fixed<int32_t, 30>::from_raw(644245094);
  const Style styles[] = {Style(20_px), Style(16_px, kFilterText),
                          Style(18_px, kFilterArea, turned)};
  for (const Style& style : styles) {
    drawn.clear();
    wanted.clear();
    Rgb888Canvas canvas(drawn.strip(), kInk);
    const ColourGlyphs colours(colour_of(canvas));
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
    draw_by_hand(font, style, 0xffc800, 0x003cc8, 128, wanted);
    CHECK(drawn == wanted);
    CHECK_EQ(canvas.pixels().colour, kInk);
  }
}

TEST(layers_are_the_same_in_strips) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  wanted.clear();
  draw_by_hand(font, style, 0xffc800, 0x003cc8, 128, wanted);
  drawn.clear();
  Rgb888Canvas canvas({}, kInk);
  const ColourGlyphs colours(colour_of(canvas));
  for (int32_t y = 0; y < kSide; y += 5) {
    canvas.set_strip(drawn.strip(y, y + 5 > kSide ? kSide - y : 5));
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
  }
  CHECK(drawn == wanted);
}

TEST(layers_take_other_palettes) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  Rgb888Canvas canvas(drawn.strip(), kInk);
  ColourGlyphs colours(colour_of(canvas));
  const Painter painter(canvas, {}, &colours);
  // The last one serves for all that the font does not have.
  const uint8_t numbers[] = {1, 7};
  for (const uint8_t number : numbers) {
    drawn.clear();
    wanted.clear();
    colours.set_palette(number);
    painter.text(font, style, kPen, "A");
    draw_by_hand(font, style, 0x090807, 0x28323c, 255, wanted);
    CHECK(drawn == wanted);
  }
  // The program's own go before.
  const LayerColour own[] = {{1, 2, 3, 255}};
  colours.set_colours(own);
  drawn.clear();
  wanted.clear();
  painter.text(font, style, kPen, "A");
  draw_by_hand(font, style, 0x010203, 0x28323c, 255, wanted);
  CHECK(drawn == wanted);
}

TEST(layers_leave_other_glyphs_alone) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  drawn.clear();
  wanted.clear();
  Rgb888Canvas canvas(drawn.strip(), kInk);
  const ColourGlyphs colours(colour_of(canvas));
  Painter(canvas, {}, &colours).text(font, style, kPen, "BD");
  Painter(Rgb888Canvas(wanted.strip(), kInk)).text(font, style, kPen, "BD");
  CHECK(drawn == wanted);
  // Nor do fonts without layers have any.
  const Font plain = font_with(Span<const uint8_t>());
  CHECK_OK(verify_layers(plain));
  drawn.clear();
  wanted.clear();
  Painter(canvas, {}, &colours).text(plain, style, kPen, "AB");
  Painter(Rgb888Canvas(wanted.strip(), kInk)).text(plain, style, kPen, "AB");
  CHECK(drawn == wanted);
}

TEST(layers_are_kept_by_a_cache) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  wanted.clear();
  draw_by_hand(font, style, 0xffc800, 0x003cc8, 128, wanted);
  alignas(8) static uint8_t ram[2048];
  GlyphCache cache;
  CHECK_OK(GlyphCache::make(ram, {8, 1, 1}, cache));
  Rgb888Canvas canvas(drawn.strip(), kInk);
  const ColourGlyphs colours(colour_of(canvas), &cache);
  for (int32_t i = 0; i < 2; ++i) {
    drawn.clear();
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
    CHECK(drawn == wanted);
  }
  CHECK_EQ(cache.stats().misses, 3u);
  CHECK_EQ(cache.stats().hits, 5u);
}

TEST(layers_have_the_box_of_their_glyph) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  Rgb888Canvas canvas(drawn.strip(), kInk);
  const ColourGlyphs colours(colour_of(canvas));
  const Rect box = Painter(canvas, {}, &colours).box(font, style, kPen, "AB");
  const Rect plain = Painter(canvas).box(font, style, kPen, "AB");
  CHECK(__builtin_memcmp(&box, &plain, sizeof box) == 0 && !is_empty(box));
}

TEST(layers_are_one_colour_where_levels_are_few) {
  const Font font = font_with(kRows);
  const Style style(20_px);
  uint8_t seen[2][kSide * 3] = {};
  for (int32_t i = 0; i < 2; ++i) {
    Strip strip;
    strip.pixels = seen[i];
    strip.width = strip.height = kSide;
    strip.stride = 3;
    const MonoRowsCanvas canvas(strip);
    Rgb888Canvas other;
    const ColourGlyphs colours(colour_of(other));
    Painter(canvas, {}, i == 0 ? nullptr : &colours)
        .text(font, style, kPen, "A");
  }
  CHECK(__builtin_memcmp(seen[0], seen[1], sizeof seen[0]) == 0);
}

template <typename Canvas>
uint32_t pixel_of(Canvas& canvas, const LayerColour& colour) {
  const CanvasColour of = colour_of(canvas);
  const uint32_t pixel = of.pixel_of(colour);
  const uint32_t before = of.exchange(of.canvas, pixel);
  CHECK_EQ(of.exchange(of.canvas, before), pixel);
  return pixel;
}

TEST(layers_have_the_colours_of_each_canvas) {
  const LayerColour colour = {255, 128, 8, 40};
  Rgb565Canvas rgb565;
  Rgb888Canvas rgb888;
  Xrgb8888Canvas xrgb8888;
  Grey8Canvas grey8;
  Grey4Canvas grey4;
  CHECK_EQ(pixel_of(rgb565, colour), 0xfc01u);
  CHECK_EQ(pixel_of(rgb888, colour), 0xff8008u);
  CHECK_EQ(pixel_of(xrgb8888, colour), 0xffff8008u);
  CHECK_EQ(pixel_of(grey8, colour), 152u);
  CHECK_EQ(pixel_of(grey4, colour), 9u);
}

// A reader does not go where lists lead nowhere.
TEST(layers_of_wrong_lists_are_not_drawn) {
  const Style style(20_px);
  Rgb888Canvas canvas(drawn.strip(), kInk);
  const ColourGlyphs colours(colour_of(canvas));
  const Painter painter(canvas, {}, &colours);
  // Glyphs that are not there, and a colour far beyond.
  const Row nowhere[] = {{31, 0}, {kDisc, 511}};
  Font font = font_with(nowhere);
  CHECK_EQ(verify_layers(font), Status::corrupt);
  drawn.clear();
  wanted.clear();
  painter.text(font, style, kPen, "A");
  CHECK(drawn == wanted);
  // More than a reader takes: the form of one colour.
  static Row many[format::layers::kMaxLayers + 1];
  for (Row& row : many) {
    row = {kDisc, 0};
  }
  font = font_with(many);
  CHECK_EQ(verify_layers(font), Status::corrupt);
  painter.text(font, style, kPen, "A");
  Painter(Rgb888Canvas(wanted.strip(), kInk)).text(font, style, kPen, "A");
  CHECK(drawn == wanted);
}

// Any bytes: nothing happens outside of the picture, which the sanitizers see.
TEST(layers_of_any_bytes_are_safe) {
  const LayerWriter good(kDisc, kPalettes, kColours, kRows);
  const Style style(12_px);
  Rgb888Canvas canvas(drawn.strip(), kInk);
  const ColourGlyphs colours(colour_of(canvas));
  uint32_t whole = 0;
  uint32_t state = 1;
  for (int32_t round = 0; round < 500; ++round) {
    alignas(4) uint8_t bytes[256];
    __builtin_memcpy(bytes, good.bytes().data, good.bytes().size);
    for (int32_t i = 0; i < round % 4; ++i) {
      state = state * 1664525 + 1013904223;
      bytes[(state >> 16) % good.bytes().size] =
          static_cast<uint8_t>(state >> 8);
    }
    state = state * 1664525 + 1013904223;
    const size_t size = round % 3 == 0 ? (state >> 8) % (good.bytes().size + 1)
                                       : good.bytes().size;
    const Font font = font_with({bytes, size});
    whole += verify_layers(font) == Status::ok ? 1u : 0u;
    Painter(canvas, {}, &colours).text(font, style, kPen, "A");
    CHECK_EQ(canvas.pixels().colour, kInk);
  }
  CHECK(whole > 50 && whole < 450);
}

}  // namespace
