// Layers from a fuzzer: bytes in, and what ColourGlyphs promises checked.
//
// The last 8 bytes of an input choose what is drawn. The rest is section COLR
// of a font of outlines.
#include <vector>

#include "exercise.hpp"
#include "front_ends.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/layers/verify.hpp"
#include "outline_record.hpp"
#include "strike_font.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;

constexpr size_t kChoiceBytes = 8;
constexpr uint32_t kInk = 0xffffffff;

// A canvas that knows its colour, and how often that changed.
struct Canvas {
  uint32_t colour = kInk;
  uint32_t changes = 0;

  static uint32_t exchange(void* canvas, uint32_t pixel) noexcept {
    auto& self = *static_cast<Canvas*>(canvas);
    const uint32_t before = self.colour;
    self.colour = pixel;
    ++self.changes;
    return before;
  }
};

Sink sink_of(const Rect& window) {
  Sink sink;
  sink.window = window;
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t*, int32_t count) {
    hostile::require(count >= 1 && count <= kMaxSpan, "length of the span");
  };
  sink.solid = [](void*, int32_t, int32_t, int32_t count) {
    hostile::require(count >= 1, "length of the run");
  };
  return sink;
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size <= kChoiceBytes) {
    return;
  }
  const uint8_t* const choice = data + size - kChoiceBytes;
  const size_t bytes = size - kChoiceBytes;
  std::vector<uint8_t> rom(2 * outline_record::kSampleFontBytes + bytes + 64);
  rom.resize(strike_font::add_section(
      {rom.data(), rom.size()},
      outline_record::build_sample_font({rom.data(), rom.size()}),
      format::section::kLayers, {data, bytes}));
  // In a block of its size: the section ends where it ends.
  const std::vector<uint8_t> block(rom.begin(), rom.end());
  Font font;
  hostile::require(Font::open({block.data(), block.size()}, font) == Status::ok,
                   "the section does not keep a font from being opened");
  static_cast<void>(verify_layers(font));
  Canvas canvas;
  ColourGlyphs colours({&canvas, Canvas::exchange,
                        [](const LayerColour& colour) noexcept -> uint32_t {
                          return colour.red;
                        }});
  const LayerColour own[] = {{1, 2, 3, choice[1]}};
  colours.set_palette(choice[0]).set_colours(
      {own, static_cast<size_t>(choice[2] & 1)});
  const Sink sink = sink_of({0, 0, 1 + choice[3] % 64, 1 + choice[4] % 64});
  const auto glyph = static_cast<uint16_t>(get_u16(choice + 5) % 9);
  Painter(sink, {}, &colours)
      .glyph(font, Style(Q26_6::from_int(4 + choice[7] % 60)),
             {0_px, 40_px}, glyph);
  hostile::require(canvas.colour == kInk, "the colour of the text is back");
  hostile::require(canvas.changes <= format::layers::kMaxLayers + 2,
                   "no more layers than the format has");
}
