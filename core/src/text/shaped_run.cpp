#include "inkcell/shaped_run.hpp"

#include "text/advances.hpp"

namespace inkcell {
namespace {

// Moves `at` from one glyph of a run to the next.
void move_on(const ShapedGlyph& next, PositionedGlyph& at) noexcept {
  at.x = detail::clamp_to(at.x + next.x, detail::kMaxUnits);
  at.y = next.y;
  at.glyph = next.glyph;
}

void widen(int32_t low, int32_t high, int32_t& min, int32_t& max) noexcept {
  min = low < min ? low : min;
  max = high > max ? high : max;
}

}  // namespace

Status layout(const ShapedRun& run,
              Span<PositionedGlyph> out,
              Span<const PositionedGlyph>& glyphs) noexcept {
  if (out.size < run.glyphs.size) {
    return Status::buffer_small;
  }
  PositionedGlyph at;
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    move_on(run.glyphs[i], at);
    out[i] = at;
  }
  glyphs = {out.data, run.glyphs.size};
  return Status::ok;
}

TextMeasure measure(const Font& font, const ShapedRun& run) noexcept {
  TextMeasure sum = {run.advance, INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
  PositionedGlyph at;
  for (const ShapedGlyph& next : run.glyphs) {
    move_on(next, at);
    GlyphMetrics glyph;
    if (font.glyph_metrics(at.glyph, glyph) == Status::ok &&
        glyph.x_max > glyph.x_min) {
      widen(at.x + glyph.x_min, at.x + glyph.x_max, sum.x_min, sum.x_max);
      widen(at.y + glyph.y_min, at.y + glyph.y_max, sum.y_min, sum.y_max);
    }
  }
  return sum.x_max < sum.x_min ? TextMeasure{run.advance, 0, 0, 0, 0} : sum;
}

void draw(const Font& font,
          const ShapedRun& run,
          const TextStyle& style,
          Point origin,
          const Sink& sink,
          Workspace workspace) noexcept {
  PositionedGlyph at;
  for (const ShapedGlyph& next : run.glyphs) {
    move_on(next, at);
    draw(font, {&at, 1}, style, origin, sink, workspace);
  }
}

}  // namespace inkcell
