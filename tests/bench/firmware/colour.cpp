// Draws a glyph of several colours into RGB565: by its layers, with a cache of
// layers, and with a cache of pictures.
//
//   FIRMWARE FONT PX
//
// Prints for each glyph that has colours of its own the instructions and the
// stack of
//
//   layers GLYPH INSTRUCTIONS STACK    drawing it from the font
//   cached ...                         layers that a GlyphCache holds
//   made ...                           a picture that is made, and drawn
//   picture ...                        one that a ColourCache holds
#include "inkcell/port/colour.hpp"
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/layers/colour_cache.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "rom_file.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kWidth = 128;
alignas(4) uint8_t font_bytes[1 << 20];
alignas(4) uint8_t pixels[2 * kWidth * kWidth];
alignas(8) uint8_t glyph_ram[16 << 10];
alignas(4) uint8_t picture_ram[64 << 10];
alignas(4) uint8_t lent[2560];

Font font;
GlyphCache glyphs;
ColourCache pictures;
port::Rgb565Canvas canvas;

Style style;

// Calls prepare() before each count.
template <typename Prepare>
void measure(const char* what,
             uint16_t glyph,
             const ColourGlyphs& colours,
             const Prepare& prepare) {
  const Point origin = {Q26_6::from_int(4), Q26_6::from_int(kWidth - 24)};
  const auto work = [&] {
    Painter(canvas, {lent, sizeof lent}, &colours)
        .glyph(font, style, origin, glyph);
  };
  prepare(work);
  const size_t stack = board::count_stack(work);
  prepare(work);
  const uint32_t instructions = board::count_instructions(work);
  bench::print_row(what, glyph, instructions, stack);
}

void measure_all(uint16_t glyph) {
  ColourGlyphs colours(port::pictures_of(canvas));
  colours.set_cache(pictures);
  const uint32_t misses = pictures.stats().misses;
  Painter(canvas, {}, &colours).glyph(font, style, {10, 90}, glyph);
  if (pictures.stats().misses == misses) {
    return;
  }
  const auto nothing = [](const auto&) {};
  const auto drawn = [](const auto& work) { work(); };
  measure("layers", glyph, ColourGlyphs(port::colour_of(canvas)), nothing);
  measure("cached", glyph, ColourGlyphs(port::colour_of(canvas), &glyphs),
          drawn);
  measure("made", glyph, colours, [](const auto&) { pictures.clear(); });
  measure("picture", glyph, colours, drawn);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 ||
      !bench::open_font(argv[1], {font_bytes, sizeof font_bytes}, font)) {
    return bench::fail("usage: FONT PX, or the font does not open");
  }
  style = Style(Q26_6::from_int(static_cast<int32_t>(bench::parse(argv[2]))));
  Strip strip;
  strip.pixels = {pixels, sizeof pixels};
  strip.width = strip.height = kWidth;
  strip.stride = 2 * kWidth;
  canvas.set_strip(strip);
  if (GlyphCache::make(glyph_ram, {}, glyphs) != Status::ok ||
      ColourCache::make(picture_ram, pictures) != Status::ok) {
    return bench::fail("no caches");
  }
  for (uint32_t glyph = 0; glyph != font.glyph_count(); ++glyph) {
    measure_all(static_cast<uint16_t>(glyph));
  }
  return 0;
}
