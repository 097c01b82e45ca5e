// The loop over the cells between samples, 2^scale_log2 px wide.
//
//   tl ---- tr    samples; pixel centres lie at (k + 1/2) / 2^scale_log2
//    |  px   |    between them
//   bl ---- br
//
// A cell is blank or full if its four samples are: between them the field is
// bilinear. Only cells near an edge take more than that.
#include "inkcell/kinetic/grid_draw.hpp"

#include "limits.hpp"

namespace inkcell {
namespace kinetic {
namespace {

constexpr int32_t kMostGainQ8 = 2 << 8;
constexpr int32_t kLeastGainQ8 = 192;
// Px, at most kMaxSpan; cells of any side fill them.
constexpr int32_t kBlock = 24;

// One over the slope of a cell, whose sides differ by twice as much. [1/32 of a
// sample a sample -> Q8]
int32_t gain_q8(int32_t x_twice, int32_t y_twice) noexcept {
  const int32_t length = rough_length(abs(x_twice), abs(y_twice));
  constexpr uint32_t kUnit = 64u << 8;
  if (length <= static_cast<int32_t>(kUnit) / kMostGainQ8) {
    return kMostGainQ8;
  }
  const auto gain = static_cast<int32_t>(kUnit / static_cast<uint32_t>(length));
  return gain < kLeastGainQ8 ? kLeastGainQ8 : gain;
}

// What cells are drawn with.
struct CellPaint {
  const Filter& filter;
  int32_t scale_log2;
  int32_t off_q13;  // from a sample's middle to the edge: half a quantum less
                    // the cutoff
  int32_t slope_q8;
  int32_t blank;  // a sample up to here has no coverage, whatever the slope
  int32_t full;   // and from here on full coverage

  CellPaint(const Filter& f, const GridLook& look, int32_t scale) noexcept
      : filter(f),
        scale_log2(scale),
        off_q13(128 - clamp(look.cutoff.raw, -(1 << 15), 1 << 15)),
        slope_q8(clamp(look.slope_q8, 0, 256)) {
    // [px, Q10 -> 1/32 of a sample] By the gain that takes a field least far.
    const auto level = [&](int32_t px_q10, bool is_least) {
      const int32_t gain = slope_q8 == 0 ? 256
                           : is_least    ? kLeastGainQ8
                                         : kMostGainQ8;
      return (px_q10 * 8 >> scale) * 256 / gain - off_q13;
    };
    blank = level(filter.outside_q10, filter.outside_q10 < 0) >> 8;
    full = (level(filter.inside_q10, filter.inside_q10 > 0) + 255) >> 8;
  }
};

// The pixels of a part of a row of cells.
struct Block {
  uint8_t coverage[1 << DistanceGrid::kMaxScaleLog2][kBlock];
};

void fill_cell(Block& block, int32_t column, int32_t side) noexcept {
  for (int32_t row = 0; row < side; ++row) {
    for (int32_t i = 0; i < side; ++i) {
      block.coverage[row][column + i] = 255;
    }
  }
}

// The samples around a cell. [1/32 of a sample]
struct Corners {
  int32_t top_left;
  int32_t top_right;
  int32_t bottom_left;
  int32_t bottom_right;
};

// Bilinear, in steps of half a pixel. Where a sample is a pixel, its centre is
// that of the sample at the upper left.
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
  const Filter& filter = paint.filter;
  const int32_t low = filter.outside_q10;
  const int32_t high = filter.inside_q10;
  for (int32_t row = 0; row < side; ++row) {
    const int32_t down = 2 * row + first;
    const int32_t left = at.top_left * 256 + (left_step * 256 * down >> shift);
    const int32_t step =
        top_step * 256 + ((bottom_step - top_step) * 256 * down >> shift);
    // [px, Q10] on the way from pixel to pixel, Q(10 + to_px).
    int32_t field = (left + (step * first >> shift) + paint.off_q13) * gain;
    const int32_t field_step = (step >> paint.scale_log2) * gain;
    uint8_t* to = block.coverage[row] + column;
    for (int32_t i = 0; i < side; ++i, field += field_step) {
      const int32_t px_q10 = field >> to_px;
      to[i] = px_q10 <= low    ? uint8_t{0}
              : px_q10 >= high ? uint8_t{255}
                               : filter.ramp(px_q10);
    }
  }
}

// Passes on the part of a row that has coverage and lies in the window.
void emit_row(const Sink& sink,
              const uint8_t* coverage,
              int32_t x,
              int32_t y,
              int32_t count) noexcept {
  int32_t first = sink.window.x0 > x ? sink.window.x0 - x : 0;
  int32_t end = sink.window.x1 < x + count ? sink.window.x1 - x : count;
  while (first < end && coverage[first] == 0) {
    ++first;
  }
  while (first < end && coverage[end - 1] == 0) {
    --end;
  }
  if (first < end) {
    sink.coverage(sink.context, x + first, y, coverage + first, end - first);
  }
}

void emit_block(const Sink& sink,
                const Block& block,
                const Rect& pixels,
                bool is_full) noexcept {
  const Rect shown = intersect(pixels, sink.window);
  if (is_empty(shown)) {
    return;
  }
  for (int32_t y = shown.y0; y < shown.y1; ++y) {
    if (is_full) {
      sink.solid(sink.context, shown.x0, y, shown.x1 - shown.x0);
    } else {
      emit_row(sink, block.coverage[y - pixels.y0], pixels.x0, y,
               pixels.x1 - pixels.x0);
    }
  }
}

// Two rows of samples above each other; null beyond the grid.
struct RowPair {
  const int8_t* top;
  const int8_t* bottom;
  int32_t width;

  static constexpr int32_t kOutside = DistanceGrid::kOutside;

  int32_t top_at(int32_t x) const noexcept {
    return top != nullptr && x >= 0 && x < width ? top[x] : kOutside;
  }
  int32_t bottom_at(int32_t x) const noexcept {
    return bottom != nullptr && x >= 0 && x < width ? bottom[x] : kOutside;
  }
};

// Whether samples of a row, from `first` to `end`, are all at most `level`, or
// all at least. They end early: most blocks are of one kind from the start.
bool are_at_most(const int8_t* row,
                 int32_t first,
                 int32_t end,
                 int32_t level) noexcept {
  for (const int8_t* at = row + first; at != row + end; ++at) {
    if (*at > level) {
      return false;
    }
  }
  return true;
}

bool are_at_least(const int8_t* row,
                  int32_t first,
                  int32_t end,
                  int32_t level) noexcept {
  for (const int8_t* at = row + first; at != row + end; ++at) {
    if (*at < level) {
      return false;
    }
  }
  return true;
}

// The same of both rows, from `first` to `end`, and beyond the grid.
bool is_blank(const RowPair& rows,
              int32_t first,
              int32_t end,
              int32_t level) noexcept {
  const int32_t low = first < 0 ? 0 : first;
  const int32_t high = end > rows.width ? rows.width : end;
  const bool has_beyond = rows.top == nullptr || rows.bottom == nullptr ||
                          low != first || high != end;
  return (!has_beyond || RowPair::kOutside <= level) &&
         (rows.top == nullptr || are_at_most(rows.top, low, high, level)) &&
         (rows.bottom == nullptr || are_at_most(rows.bottom, low, high, level));
}

bool is_full(const RowPair& rows,
             int32_t first,
             int32_t end,
             int32_t level) noexcept {
  const bool has_beyond = rows.top == nullptr || rows.bottom == nullptr ||
                          first < 0 || end > rows.width;
  return !has_beyond && are_at_least(rows.top, first, end, level) &&
         are_at_least(rows.bottom, first, end, level);
}

__attribute__((noinline)) void paint_block(const RowPair& rows,
                                           const CellPaint& paint,
                                           int32_t first,
                                           int32_t cells,
                                           Block& block) noexcept {
  const int32_t side = 1 << paint.scale_log2;
  __builtin_memset(block.coverage, 0,
                   sizeof block.coverage[0] * static_cast<size_t>(side));
  Corners at;
  at.top_right = rows.top_at(first - 1);
  at.bottom_right = rows.bottom_at(first - 1);
  for (int32_t i = 0; i < cells; ++i) {
    at.top_left = at.top_right;
    at.bottom_left = at.bottom_right;
    at.top_right = rows.top_at(first + i);
    at.bottom_right = rows.bottom_at(first + i);
    if (at.top_left <= paint.blank && at.top_right <= paint.blank &&
        at.bottom_left <= paint.blank && at.bottom_right <= paint.blank) {
      continue;
    }
    if (at.top_left >= paint.full && at.top_right >= paint.full &&
        at.bottom_left >= paint.full && at.bottom_right >= paint.full) {
      fill_cell(block, i * side, side);
    } else {
      paint_cell(paint, at, block, i * side);
    }
  }
}

// A row of cells, block by block. Its upper left pixel is at (x, y). A frame of
// its own: what it holds is not there while rows are sought.
__attribute__((noinline)) void draw_cells(const RowPair& rows,
                                          const CellPaint& paint,
                                          int32_t x,
                                          int32_t y,
                                          const Sink& sink) noexcept {
  const int32_t side = 1 << paint.scale_log2;
  const int32_t most_cells = kBlock >> paint.scale_log2;
  for (int32_t first = 0; first <= rows.width; first += most_cells) {
    const int32_t left = rows.width + 1 - first;
    const int32_t cells = left < most_cells ? left : most_cells;
    const Rect pixels = {x + first * side, y, x + (first + cells) * side,
                         y + side};
    if (is_empty(intersect(pixels, sink.window))) {
      continue;
    }
    if (is_blank(rows, first - 1, first + cells, paint.blank)) {
      continue;
    }
    Block block;
    const bool full = is_full(rows, first - 1, first + cells, paint.full);
    if (!full) {
      paint_block(rows, paint, first, cells, block);
    }
    emit_block(sink, block, pixels, full);
  }
}

}  // namespace

void draw_grid(const DistanceGrid& grid,
               const GridLook& look,
               int32_t x,
               int32_t y,
               const Filter& filter,
               const Sink& sink) noexcept {
  constexpr int32_t kFar = 32767;  // as far as windows go
  if (grid.width() == 0 || x > kFar || x < -kFar || y > kFar || y < -kFar) {
    return;
  }
  const CellPaint paint(filter, look, grid.scale_log2());
  const int32_t side = 1 << paint.scale_log2;
  // The first cells begin half a sample before the grid; where a sample is a
  // pixel, a whole one.
  const int32_t before = (side + 1) / 2;
  for (int32_t row = 0; row <= grid.height(); ++row) {
    const int32_t top = y + row * side - before;
    if (top >= sink.window.y1 || top + side <= sink.window.y0) {
      continue;
    }
    const RowPair rows = {row > 0 ? grid.row(row - 1) : nullptr,
                          row < grid.height() ? grid.row(row) : nullptr,
                          grid.width()};
    draw_cells(rows, paint, x - before, top, sink);
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

}  // namespace kinetic
}  // namespace inkcell
