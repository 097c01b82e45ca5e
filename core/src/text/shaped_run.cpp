#include "inkcell/shaped_run.hpp"

#include "inkcell/painter.hpp"
#include "text/advances.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {
namespace {

using detail::Advances;
using detail::clamp_to;
using detail::kMaxUnits;

// Walks a run from the left, as TextCursor walks text. `font`, the style and
// the run must outlive it.
class RunCursor {
 public:
  // With the advances of the style.
  RunCursor(const Font& font, const Style& style, const ShapedRun& run) noexcept
      : run_(run) {
    if (style.has_whole_advances()) {
      font_ = &font;
      style_ = &style;
    }
  }

  bool is_in_whole_px() const noexcept { return style_ != nullptr; }

  // The next glyph; false: there is none.
  bool next(PositionedGlyph& at) noexcept {
    if (next_ == run_.glyphs.size) {
      return false;
    }
    const ShapedGlyph& glyph = run_.glyphs[next_++];
    x_ = clamp_to(x_ + glyph.x, kMaxUnits);
    at.x = style_ == nullptr ? x_ : whole_x(glyph.glyph);
    at.y = glyph.y;
    at.glyph = glyph.glyph;
    return true;
  }

  // The width of the run, behind its last glyph. Not inline, likewise.
  __attribute__((noinline)) int32_t advance() const noexcept {
    if (style_ == nullptr) {
      return run_.advance;
    }
    RunCursor end = *this;
    return advances().to_units(end.next_letter_px(run_.advance, letter_));
  }

 private:
  // Where a glyph at x_ stands, which may be a mark on the letter before it.
  // Not inline, for its part of the stack.
  __attribute__((noinline)) int32_t whole_x(uint16_t glyph) noexcept {
    const Advances advances = this->advances();
    const int32_t gap = x_ - letter_x_;
    if (has_letter_ && 2 * gap < font_->advance(letter_)) {
      return advances.to_units(
          clamp_to(letter_px_ + to_px(gap), detail::kMaxPx));
    }
    letter_px_ = next_letter_px(x_, glyph);
    letter_x_ = x_;
    letter_ = glyph;
    has_letter_ = true;
    return advances.to_units(letter_px_);
  }

  Advances advances() const noexcept {
    return {*font_, style_, style_->fitter()};
  }

  // Where a letter at `x` stands.
  int32_t next_letter_px(int32_t x, uint16_t letter) noexcept {
    int32_t px = letter_px_;
    int32_t gap = clamp_to(x, kMaxUnits) - letter_x_;
    if (has_letter_) {
      const Advances advances = this->advances();
      gap -= font_->advance(letter_);
      px += advances.advance(letter_) +
            advances.join({letter_, letter, gap}, drift_q6_);
    } else {
      px += to_px(gap);
    }
    return clamp_to(px, detail::kMaxPx);
  }

  // To the nearest.
  int32_t to_px(int32_t units) const noexcept {
    const int64_t px_q10 = detail::UnitScale(*font_, *style_).to_px_q10(units);
    return static_cast<int32_t>((px_q10 + 512) >> 10);
  }

  const ShapedRun& run_;
  size_t next_ = 0;
  const Font* font_ = nullptr;
  const Style* style_ = nullptr;  // null: as designed
  int32_t x_ = 0;                 // of the glyph, as designed
  int32_t letter_x_ = 0;          // of the last one that is no mark
  int32_t letter_px_ = 0;
  int32_t drift_q6_ = 0;  // of OutlineFitter
  uint16_t letter_ = 0;
  bool has_letter_ = false;
};

}  // namespace

// Here, so that text without runs does not link their cursor.
void Painter::text(const Font& font,
                   const Style& style,
                   Point origin,
                   const ShapedRun& run) const noexcept {
  detail::RunDrawer drawer(*this, font, style);
  RunCursor cursor(font, drawer.style(), run);
  drawer.draw_line(origin, cursor);
}

Status Painter::lay_out(const Font& font,
                        const Style& style,
                        const ShapedRun& run,
                        Span<PositionedGlyph> out,
                        Span<const PositionedGlyph>& glyphs) const noexcept {
  detail::StyleRoom room;
  RunCursor cursor(font, adapted(style, room.style()), run);
  return detail::lay_out_line(cursor, out, glyphs);
}

PixelMeasure Painter::measure(const Font& font,
                              const Style& style,
                              const ShapedRun& run) const noexcept {
  detail::StyleRoom room;
  RunCursor cursor(font, adapted(style, room.style()), run);
  return to_px(font, style, detail::measure_line(font, cursor));
}

}  // namespace inkcell
