// Draws the cells between samples, each 2^scale_log2 px wide.
//
//   tl ---- tr    samples; pixel centres lie at (k + 1/2) / 2^scale_log2
//    |  px   |    between them
//   bl ---- br
//
// A cell is bilinear, so it is blank or full if its four samples are. Only
// cells near an edge are interpolated.
#include "inkcell/motion/grid_draw.hpp"

#include "base/known_span.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kMostGainQ8 = 2 << 8;
constexpr int32_t kLeastGainQ8 = 192;
// [px] At most kMaxSpan; a multiple of every cell width.
constexpr int32_t kBlock = 24;

// One over the slope of a cell, from doubled differences of its sides. [1/32 of
// a sample a sample -> Q8]
int32_t gain_q8(int32_t x_twice, int32_t y_twice) noexcept {
  const int32_t length = detail::near_length(abs(x_twice), abs(y_twice));
  constexpr uint32_t kUnit = 64u << 8;
  if (length <= static_cast<int32_t>(kUnit) / kMostGainQ8) {
    return kMostGainQ8;
  }
  const auto gain = static_cast<int32_t>(kUnit / static_cast<uint32_t>(length));
  return gain < kLeastGainQ8 ? kLeastGainQ8 : gain;
}

// The kind of a column of two samples: a cell is blank or full if both of its
// columns are.
enum : uint8_t { kMixed = 0, kBlank = 1, kFull = 2 };

// Parameters for drawing cells.
struct CellPaint {
  const Filter& filter;
  int32_t scale_log2;
  int32_t off_q13;  // from a sample's middle to the edge, less half a step
  int32_t slope_q8;
  int32_t blank;  // samples <= blank have no coverage at any slope
  int32_t full;   // samples >= full have full coverage

  CellPaint(const Filter& f, const GridLook& look, int32_t scale) noexcept
      : filter(f),
        scale_log2(scale),
        off_q13(128 - clamp(look.cutoff.raw, -(1 << 15), 1 << 15)),
        slope_q8(clamp(look.slope_q8, 0, 256)) {
    // [px, Q10 -> 1/32 of a sample] With the least or greatest gain.
    const auto level = [&](int32_t px_q10, bool is_least) {
      const int32_t gain = slope_q8 == 0 ? 256
                           : is_least    ? kLeastGainQ8
                                         : kMostGainQ8;
      return (px_q10 * 8 >> scale) * 256 / gain - off_q13;
    };
    blank = level(filter.outside_q10, filter.outside_q10 < 0) >> 8;
    full = (level(filter.inside_q10, filter.inside_q10 > 0) + 255) >> 8;
  }

  uint32_t kind_of(int32_t a, int32_t b) const noexcept {
    return a <= blank && b <= blank ? kBlank
           : a >= full && b >= full ? kFull
                                    : kMixed;
  }
};

// Pixels of a part of a row of cells.
struct Block {
  uint8_t coverage[1 << DistanceGrid::kMaxScaleLog2][kBlock];
};

// The four samples of a cell. [1/32 of a sample]
struct Corners {
  int32_t top_left;
  int32_t top_right;
  int32_t bottom_left;
  int32_t bottom_right;
};

// A cell of 2 x 2 px: the weights are 9, 3, 3 and 1 of 16.
void paint_square(const CellPaint& paint,
                  const Corners& at,
                  Block& block,
                  int32_t column) noexcept {
  const auto px = [&](int32_t near, int32_t far) {
    return paint.filter.coverage(((3 * near + far) * 16 + paint.off_q13) >> 2);
  };
  const int32_t top[] = {3 * at.top_left + at.bottom_left,
                         3 * at.top_right + at.bottom_right};
  block.coverage[0][column] = px(top[0], top[1]);
  block.coverage[0][column + 1] = px(top[1], top[0]);
  const int32_t bottom[] = {at.top_left + 3 * at.bottom_left,
                            at.top_right + 3 * at.bottom_right};
  block.coverage[1][column] = px(bottom[0], bottom[1]);
  block.coverage[1][column + 1] = px(bottom[1], bottom[0]);
}

// Bilinear, in steps of half a pixel. With a sample a pixel, the centre is that
// of the upper left sample.
void paint_cell(const CellPaint& paint,
                const Corners& at,
                Block& block,
                int32_t column) noexcept {
  const int32_t top_step = at.top_right - at.top_left;
  const int32_t bottom_step = at.bottom_right - at.bottom_left;
  const int32_t left_step = at.bottom_left - at.top_left;
  int32_t gain = 256;
  if (paint.slope_q8 != 0) {
    const int32_t right_step = at.bottom_right - at.top_right;
    const int32_t all = gain_q8(top_step + bottom_step, left_step + right_step);
    gain += (all - 256) * paint.slope_q8 >> 8;
  }
  const int32_t shift = paint.scale_log2 + 1;
  const int32_t to_px = 11 - paint.scale_log2;
  const int32_t side = 1 << paint.scale_log2;
  const int32_t first = side > 1 ? 1 : 0;
  for (int32_t row = 0; row < side; ++row) {
    const int32_t down = 2 * row + first;
    const int32_t left = at.top_left * 256 + (left_step * 256 * down >> shift);
    const int32_t step =
        top_step * 256 + ((bottom_step - top_step) * 256 * down >> shift);
    // At the first pixel, and the step to the next. [px, Q(10 + to_px)]
    int32_t field = (left + (step * first >> shift) + paint.off_q13) * gain;
    const int32_t field_step = (step >> paint.scale_log2) * gain;
    uint8_t* to = block.coverage[row] + column;
    for (int32_t i = 0; i < side; ++i, field += field_step) {
      to[i] = paint.filter.coverage(field >> to_px);
    }
  }
}

// A row of cells on the screen.
struct CellRow {
  const Sink& sink;
  int32_t x;  // of cell 0 [px]
  int32_t y;
  int32_t side;  // of a cell [px]

  // The pixels of the cells [first, end) that are in the window.
  Rect shown(int32_t first, int32_t end) const noexcept {
    return intersect({x + first * side, y, x + end * side, y + side},
                     sink.window);
  }

  // Emits the first `cells` cells of a block, from cell `first` on.
  void emit(const Block& block, int32_t first, int32_t cells) const noexcept {
    const Rect box = shown(first, first + cells);
    for (int32_t row = box.y0; row < box.y1 && !is_empty(box); ++row) {
      sink.coverage(sink.context, box.x0, row,
                    block.coverage[row - y] + (box.x0 - x - first * side),
                    box.x1 - box.x0);
    }
  }

  // Fills the cells [first, end).
  void fill(int32_t first, int32_t end) const noexcept {
    const Rect box = shown(first, end);
    for (int32_t row = box.y0; row < box.y1 && !is_empty(box); ++row) {
      sink.solid(sink.context, box.x0, row, box.x1 - box.x0);
    }
  }
};

// Two adjacent rows of samples; null outside of the grid.
struct RowPair {
  const int8_t* top;
  const int8_t* bottom;
  int32_t width;

  int32_t top_at(int32_t x) const noexcept { return at(top, x); }
  int32_t bottom_at(int32_t x) const noexcept { return at(bottom, x); }

  uint32_t kind_of(int32_t x, const CellPaint& paint) const noexcept {
    return paint.kind_of(top_at(x), bottom_at(x));
  }

  // The first column in [x, end) that is not of this kind, or `end`.
  int32_t end_of(int32_t x,
                 int32_t end,
                 uint32_t kind,
                 const CellPaint& paint) const noexcept {
    if (top != nullptr && bottom != nullptr) {
      const int32_t last = min(end, width);
      while (x < last && paint.kind_of(top[x], bottom[x]) == kind) {
        ++x;
      }
    }
    while (x < end && kind_of(x, paint) == kind) {
      ++x;
    }
    return x;
  }

 private:
  int32_t at(const int8_t* row, int32_t x) const noexcept {
    return row != nullptr && x >= 0 && x < width ? row[x]
                                                 : DistanceGrid::kOutside;
  }
};

// Paints cells from `first` on until one is blank or full, at most a block.
// Returns how many.
__attribute__((noinline)) int32_t paint_block(const RowPair& rows,
                                              const CellPaint& paint,
                                              int32_t first,
                                              int32_t end,
                                              Block& block) noexcept {
  const int32_t most = min(end - first, kBlock >> paint.scale_log2);
  Corners at;
  at.top_right = rows.top_at(first - 1);
  at.bottom_right = rows.bottom_at(first - 1);
  int32_t cells = 0;
  while (cells < most) {
    at.top_left = at.top_right;
    at.bottom_left = at.bottom_right;
    at.top_right = rows.top_at(first + cells);
    at.bottom_right = rows.bottom_at(first + cells);
    const uint32_t kind = paint.kind_of(at.top_left, at.bottom_left);
    if (kind != kMixed &&
        kind == paint.kind_of(at.top_right, at.bottom_right)) {
      break;
    }
    const int32_t column = cells << paint.scale_log2;
    if (paint.scale_log2 == 1 && paint.slope_q8 == 0) {
      paint_square(paint, at, block, column);
    } else {
      paint_cell(paint, at, block, column);
    }
    ++cells;
  }
  return cells;
}

// Draws the cells [first, end) of a row, in runs that are blank, full or
// neither. Not inline, to keep its frame off the stack during the search for
// rows.
__attribute__((noinline)) void draw_cells(const RowPair& rows,
                                          const CellPaint& paint,
                                          const CellRow& row,
                                          int32_t first,
                                          int32_t end) noexcept {
  for (int32_t cell = first; cell < end;) {
    const uint32_t kind = rows.kind_of(cell - 1, paint);
    if (kind != kMixed) {
      const int32_t begin = cell;
      cell = rows.end_of(cell, end, kind, paint);
      if (kind == kFull && cell != begin) {
        row.fill(begin, cell);
      }
    }
    if (cell < end) {
      Block block;
      const int32_t cells = paint_block(rows, paint, cell, end, block);
      row.emit(block, cell, cells);
      cell += cells;
    }
  }
}

}  // namespace

void draw_grid(const DistanceGrid& grid,
               const GridLook& look,
               int32_t x,
               int32_t y,
               const Filter& filter,
               const Sink& sink) noexcept {
  constexpr int32_t kFar = 32767;  // the range of windows
  if (grid.width() == 0 || x > kFar || x < -kFar || y > kFar || y < -kFar) {
    return;
  }
  const CellPaint paint(filter, look, grid.scale_log2());
  const int32_t side = 1 << paint.scale_log2;
  // The first cells begin half a sample before the grid; with a sample a pixel,
  // a whole one.
  const int32_t before = (side + 1) / 2;
  const int32_t left = x - before;
  const int32_t first = max(0, (sink.window.x0 - left) >> paint.scale_log2);
  const int32_t end = min(
      grid.width() + 1, (sink.window.x1 - left + side - 1) >> paint.scale_log2);
  // The rows of cells [from, to) touch the window.
  const int32_t from =
      max(0, (sink.window.y0 - y + before) >> paint.scale_log2);
  const int32_t to =
      min(grid.height() + 1,
          (sink.window.y1 - y + before + side - 1) >> paint.scale_log2);
  // Cells outside of the known samples of both rows are blank, as a rule.
  const bool is_blank = DistanceGrid::kOutside <= paint.blank;
  detail::KnownSpan above = is_blank
                                ? detail::known_span(grid, from - 1, from - 1)
                                : detail::KnownSpan();
  for (int32_t row = from; row < to; ++row) {
    const int32_t top = y + row * side - before;
    const RowPair rows = {row > 0 ? grid.row(row - 1) : nullptr,
                          row < grid.height() ? grid.row(row) : nullptr,
                          grid.width()};
    detail::KnownSpan cells = {first, end};
    if (is_blank) {
      const detail::KnownSpan below = detail::known_span(grid, row, row);
      const detail::KnownSpan known = united(above, below);
      cells = {max(first, known.first), min(end, known.end + 1)};
      above = below;
    }
    draw_cells(rows, paint, {sink, left, top, side}, cells.first, cells.end);
  }
}

void draw_offset(const DistanceGrid& grid,
                 Q26_6 offset,
                 int32_t x,
                 int32_t y,
                 const Filter& filter,
                 const Sink& sink) noexcept {
  const int32_t reach_q6 = 4 * 64 << grid.scale_log2();  // [px]
  const int32_t offset_q6 = clamp(offset.raw, -reach_q6, reach_q6);
  GridLook look;
  look.cutoff.raw = -(offset_q6 * 128 >> grid.scale_log2());
  draw_grid(grid, look, x, y, filter, sink);
}

}  // namespace inkcell::motion
