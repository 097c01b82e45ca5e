// The grids of two glyphs and of their blend.
#include "inkcell/motion/morph.hpp"

#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/style.hpp"
#include "limits.hpp"

namespace inkcell::motion {

GlyphMorph::GlyphMorph(const Font& font,
                       Q26_6 size,
                       const Filter& filter,
                       const MorphBox& box,
                       Span<int8_t> grids) noexcept
    : font_(font), size_(size), filter_(filter), box_(box) {
  const int32_t width = DistanceGrid::samples_of(box.width, box.scale_log2);
  const int32_t height = DistanceGrid::samples_of(box.height, box.scale_log2);
  const size_t part = grids.size / 3;
  const auto grid = [&](size_t i) {
    return DistanceGrid({grids.data + i * part, part}, width, height,
                        box.scale_log2);
  };
  grid_a_ = grid(0);
  grid_b_ = grid(1);
  between_ = grid(2);
}

Point GlyphMorph::origin_of(uint16_t glyph) const noexcept {
  const int32_t advance_q6 =
      to_px_q16(font_, size_, font_.advance(glyph)).raw >> 10;
  return {Q26_6::from_raw((box_.width * 64 - advance_q6) / 2),
          Q26_6::from_int(box_.baseline)};
}

Status GlyphMorph::paint(uint16_t glyph,
                         Workspace ram,
                         DistanceGrid& grid) noexcept {
  grid.clear();
  return grid.paint(font_, glyph, size_, origin_of(glyph), ram);
}

Status GlyphMorph::set(uint16_t from, uint16_t to, Workspace ram) noexcept {
  if (grid_a_.width() == 0) {
    return Status::buffer_small;
  }
  progress_ = {};
  blend_.part_q8 = 0;
  if (from != from_ && (from == to_ || to == from_)) {
    const DistanceGrid grid = grid_a_;
    grid_a_ = grid_b_;
    grid_b_ = grid;
    const uint16_t glyph = from_;
    from_ = to_;
    to_ = glyph;
  }
  if (from != from_) {
    from_ = kNone;
    INKCELL_TRY(paint(from, ram, grid_a_));
    from_ = from;
  }
  if (to != to_) {
    to_ = kNone;
    INKCELL_TRY(paint(to, ram, grid_b_));
    to_ = to;
  }
  const int32_t reach_q10 = max(-filter_.outside_q10, 0);
  const int32_t reach = (reach_q10 + 31) >> (5 + box_.scale_log2);
  blend_.depth_a = grid_a_.depth() + reach;
  blend_.depth_b = grid_b_.depth() + reach;
  blend_.area_a = grid_a_.area();
  blend_.area_b = grid_b_.area();
  return Status::ok;
}

void GlyphMorph::step(Q16_16 progress, GridHistogram& scratch) noexcept {
  constexpr int32_t kOne = 1 << 16;
  progress_.raw = clamp(progress.raw, 0, kOne);
  blend_.part_q8 = progress_.raw >> 8;
  const bool is_end = blend_.part_q8 == 0 || blend_.part_q8 == 256;
  cutoff_ = is_end ? Fixed<int32_t, 13>()
                   : blend(grid_a_, grid_b_, blend_, between_, scratch);
}

void GlyphMorph::draw(int32_t x,
                      int32_t y,
                      const Painter& painter) const noexcept {
  draw(x, y, filter_, painter);
}

void GlyphMorph::draw(int32_t x,
                      int32_t y,
                      const Filter& filter,
                      const Painter& painter) const noexcept {
  constexpr int32_t kFar = 32767;  // the range of windows
  if (x > kFar || x < -kFar || y > kFar || y < -kFar) {
    return;
  }
  Sink clipped = painter.sink();
  clipped.window = intersect(clipped.window, box(x, y));
  if (is_empty(clipped.window)) {
    return;
  }
  if (blend_.part_q8 > 0 && blend_.part_q8 < 256) {
    // At both ends the slope of the distances is 1, even if samples around a
    // corner suggest less. In the middle the actual slope is used.
    const int32_t part = blend_.part_q8;
    GridLook look;
    look.cutoff = cutoff_;
    look.slope_q8 = 4 * (part < 128 ? part : 256 - part);
    draw_grid(between_, look, x, y, filter, clipped);
    return;
  }
  const uint16_t glyph = blend_.part_q8 == 0 ? from_ : to_;
  if (glyph == kNone) {
    return;
  }
  const Style style(size_, filter);
  const Point at = origin_of(glyph);
  painter.with(clipped).for_motion().glyph(
      font_, style,
      {Q26_6::from_raw(at.x.raw + x * 64), Q26_6::from_raw(at.y.raw + y * 64)},
      glyph);
}

}  // namespace inkcell::motion
