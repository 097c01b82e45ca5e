#include "inkcell/layers/colour_glyphs.hpp"

#include "inkcell/motion/fade.hpp"
#include "layer_call.hpp"
#include "layer_table.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {

using detail::GlyphRun;
using detail::Layer;
using detail::LayerTable;

namespace {

// A run that another drawer takes.
struct InnerRun {
  const Painter painter;
  GlyphRun run;

  InnerRun(const GlyphRun& from, const detail::GlyphDrawer& drawer) noexcept
      : painter(from.painter.with(drawer)),
        run{painter, from.font, from.style, from.state} {}

  void draw(uint16_t glyph, const detail::Placed& placed) noexcept {
    painter.drawer().draw(run, glyph, placed);
  }
};

// Not inline: opaque layers do not take its part of the stack.
__attribute__((noinline)) void draw_faded(
    InnerRun& inner,
    uint8_t opacity,
    uint16_t glyph,
    const detail::Placed& placed) noexcept {
  const motion::Fade fade = {&inner.painter.sink(), opacity};
  const Sink sink = motion::make_sink(fade);
  const Painter painter = inner.painter.with(sink);
  GlyphRun run = {painter, inner.run.font, inner.run.style, inner.run.state};
  painter.drawer().draw(run, glyph, placed);
  inner.run.state = run.state;
}

}  // namespace

LayerColour ColourGlyphs::colour_of(const LayerTable& table,
                                    uint16_t number) const noexcept {
  return number < colours_.size ? colours_[number]
                                : table.colour(palette_, number);
}

// What layers name is drawn by the inner drawer, which knows no layers: no
// glyph leads back to itself.
void ColourGlyphs::draw_layers(GlyphRun& run,
                               uint16_t glyph,
                               const detail::Placed& at) noexcept {
  const auto& self = static_cast<const ColourGlyphs&>(run.painter.drawer());
  const detail::Placed placed = detail::at_phase(at, self.phase_shift);
  if (self.draw_picture_ != nullptr &&
      self.draw_picture_({self, run, glyph, placed})) {
    return;
  }
  InnerRun inner(run, *self.glyphs_);
  const LayerTable table(*run.font, self.stored_);
  LayerTable::Range range = table.layers_of(glyph);
  if (range.first == range.end || run.painter.sink().levels != nullptr) {
    inner.draw(glyph, placed);
    run.state = inner.run.state;
    return;
  }
  const CanvasColour& canvas = self.canvas_;
  const uint32_t ink = canvas.exchange(canvas.canvas, 0);
  for (; range.first != range.end; ++range.first) {
    const Layer layer = table.layer(range.first);
    uint32_t pixel = ink;
    int32_t opacity =
        255 - (layer.colour - static_cast<int32_t>(table.colours));
    if (layer.colour < table.colours) {
      const LayerColour colour = self.colour_of(table, layer.colour);
      pixel = canvas.pixel_of(colour);
      opacity = colour.opacity;
    }
    canvas.exchange(canvas.canvas, pixel);
    if (opacity == 255) {
      inner.draw(layer.glyph, placed);
    } else if (opacity > 0) {
      draw_faded(inner, static_cast<uint8_t>(opacity), layer.glyph, placed);
    }
  }
  canvas.exchange(canvas.canvas, ink);
  run.state = inner.run.state;
}

}  // namespace inkcell
