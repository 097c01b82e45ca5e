// A cell of samples is set up once: its columns as polynomials of the height,
// and coverage as a function of the parabola's own numbers. Rows and whole
// cells that are saturated are known from bounds; within a row, pixels are
// skipped as far as the slope allows. Distances are those of SamplesRow, bit by
// bit: every rounding of it is kept.
#include "raster/samples_cells.hpp"

#include "base/math.hpp"
#include "cells/cell_access.hpp"
#include "inkcell/format/rom.hpp"
#include "raster/cell_tour.hpp"

namespace inkcell {
namespace detail {
namespace {

// One column of samples, at any height. [1/64 quantum]
struct Column {
  int32_t first_q14;  // with what rounds
  int32_t to_middle;
  int32_t to_last;

  Column(int32_t first, int32_t middle, int32_t last) noexcept
      : first_q14(first * (1 << 14) + 128),
        to_middle(middle - first),
        to_last(last - first) {}

  // By the Lagrange weights of the upper two.
  int32_t at(int32_t w2_q14, int32_t w3_q14) const noexcept {
    return (first_q14 + w2_q14 * to_middle + w3_q14 * to_last) >> 8;
  }
};

// a + X (b + c X), X = position in the cell. [1/64 quantum]
struct Parabola {
  int32_t a;
  int32_t b;
  int32_t c;

  int32_t at(int32_t x_q14) const noexcept {
    return a + ((x_q14 * (b + ((c * x_q14) >> 14))) >> 14);
  }
};

class Painter {
 public:
  Painter(const GlyphField& field,
          const TextStyle& style,
          const Upright& upright,
          const Sink& sink) noexcept
      : tree_{field},
        style_(style),
        sink_(sink),
        step_q16_(style.step_along_q16()),
        x0_(upright.pixels.x0),
        y0_(upright.pixels.y0),
        left_q16_(upright.at.x_q16 - field.x0_u * (1 << 16)),
        top_q16_(upright.at.y_q16 - field.y0_u * (1 << 16)) {}

  uint32_t tile(uint32_t number) const noexcept { return tree_.tile(number); }
  bool is_node(uint32_t reference) const noexcept {
    return tree_.is_node(reference);
  }
  uint32_t child(uint32_t node, uint32_t number) const noexcept {
    return tree_.child(node, number);
  }
  void draw(const TourLeaf& leaf) noexcept {
    const uint8_t* const samples = tree_.samples(leaf.reference);
    if (samples != nullptr) {
      draw_cell(samples, leaf);
    } else if (leaf.reference == format::glyph::kInside) {
      fill(leaf.pixels);
    }
  }

 private:
  void fill(const Rect& pixels) const noexcept {
    for (int32_t row = pixels.y0; row < pixels.y1; ++row) {
      sink_.solid(sink_.context, x0_ + pixels.x0, y0_ + row,
                  pixels.x1 - pixels.x0);
    }
  }
  uint8_t ramp(int32_t f_q6) const noexcept {
    const Filter& filter = style_.filter();
    const uint32_t px =
        static_cast<uint32_t>(f_q6 >> down_) * factor_ + offset_;
    return filter
        .table[static_cast<uint8_t>(((px >> 16) * filter.scale) >> 14)];
  }
  void set_up(const uint8_t* samples, uint32_t log2) noexcept;
  void draw_cell(const uint8_t* samples, const TourLeaf& leaf) noexcept;
  void draw_row(int32_t y, const Parabola& row) noexcept;
  // Hands on what is in the buffer, which ends before `end`.
  void emit(int32_t end, int32_t y) noexcept {
    if (count_ != 0) {
      sink_.coverage(sink_.context, end - count_, y, buffer_, count_);
      count_ = 0;
    }
  }
  void append(uint8_t coverage, int32_t end, int32_t y) noexcept {
    buffer_[count_++] = coverage;
    if (count_ == kMaxSpan) {
      emit(end, y);
    }
  }
  void draw_solid(int32_t x, int32_t y, int32_t count) noexcept {
    // Few of them stay in the span around them.
    constexpr int32_t kMinSolid = 4;
    if (count < kMinSolid) {
      for (const int32_t end = x + count; x < end; ++x) {
        append(255, x + 1, y);
      }
    } else {
      emit(x, y);
      sink_.solid(sink_.context, x, y, count);
    }
  }

  SamplesTree tree_;
  const TextStyle& style_;
  const Sink& sink_;
  int32_t step_q16_;
  int32_t x0_;
  int32_t y0_;
  int32_t left_q16_;
  int32_t top_q16_;
  // What turns the parabolas of a cell into coverage.
  int32_t low_q6_ = 0;   // up to here there is none
  int32_t high_q6_ = 0;  // from here on it is full
  int32_t down_ = 0;     // digits below 1/1024 u
  uint32_t factor_ = 0;  // to px over the filter's outer cutoff [Q26]
  uint32_t offset_ = 0;
  int32_t skip_q16_ = 0;  // to 3/16 px that may be skipped
  uint32_t to_q14_ = 0;   // digits below 1/16384 of the cell
  int32_t x_q16_ = 0;     // its first pixel, from its left edge
  int32_t begin_ = 0;     // of its pixels
  int32_t end_ = 0;
  int32_t count_ = 0;
  uint8_t buffer_[kMaxSpan];
};

// Up to this slope pixels are skipped: distances have 1, and what samples make
// of them is a little steeper at corners. [1/64 quantum a cell]
constexpr int32_t kMaxSlopeQ6 = (128 * 64 * 5) / 4;

// Values are up to two too low, and below this way skipping gains nothing.
// [1/64 quantum]
constexpr int32_t kRounded = 2;
constexpr int32_t kLeastWay = 64;

void Painter::set_up(const uint8_t* samples, uint32_t log2) noexcept {
  const int32_t centre = centre_q10(samples);
  const int32_t low = style_.transparent_u_q10() - centre;
  const int32_t high = style_.opaque_u_q10() - centre;
  const auto size_q6 = static_cast<uint32_t>(style_.size().raw);
  factor_ = size_q6;
  down_ = 0;
  if (log2 >= 3) {
    const uint32_t up = log2 - 3;
    low_q6_ = low >> up;
    high_q6_ = -(-high >> up);
    factor_ <<= up;
  } else {
    down_ = static_cast<int32_t>(3 - log2);
    low_q6_ = (low + 1) * (1 << down_) - 1;
    high_q6_ = high * (1 << down_);
  }
  // Both may wrap, but not their sum within the ramp.
  offset_ = static_cast<uint32_t>(centre) * size_q6 -
            static_cast<uint32_t>(style_.filter().outside_q10) * 65536u;
  // In a pixel the steepest parabola changes by 10240 2^16 / (size 2^log2).
  // Times 3/16, this is a little less than one over that: roundings have room.
  skip_q16_ = static_cast<int32_t>((size_q6 << log2) >> 11);
  to_q14_ = log2 + 2;
}

// Invariant: the pixels before `x` are drawn, but for the last `count_`, which
// are in the buffer.
inline void Painter::draw_row(int32_t y, const Parabola& row) noexcept {
  const int32_t end_slope = row.b + 2 * row.c;
  const int32_t least = min(row.b, end_slope);
  const int32_t most = max(row.b, end_slope);
  // How many pixels behind this one are saturated like it, `way_q6` beyond the
  // ramp.
  const auto skipped = [this, least, most](int32_t way_q6) noexcept -> int32_t {
    if (way_q6 < kLeastWay || most > kMaxSlopeQ6 || least < -kMaxSlopeQ6) {
      return 0;
    }
    return (((min(way_q6, INT16_MAX) * skip_q16_) >> 16) * 3) >> 4;
  };
  const int32_t end = end_;
  int32_t x_q16 = x_q16_;
  int32_t x = begin_;
  while (true) {
    const int32_t f_q6 = row.at(x_q16 >> to_q14_);
    int32_t count = 1;
    if (f_q6 <= low_q6_) {
      emit(x, y);
      const int32_t way_q6 = low_q6_ - f_q6;
      if (most <= 0 && way_q6 >= kRounded) {
        return;
      }
      // No farther than three widths of the cell: positions stay in range.
      count += skipped(way_q6);
    } else if (f_q6 < high_q6_) {
      append(ramp(f_q6), x + 1, y);
    } else {
      const int32_t way_q6 = f_q6 - high_q6_;
      count = least >= 0 && way_q6 >= kRounded
                  ? end - x
                  : min(1 + skipped(way_q6), end - x);
      draw_solid(x, y, count);
    }
    x += count;
    if (x >= end) {
      break;
    }
    x_q16 += count * step_q16_;
  }
  emit(end, y);
}

__attribute__((noinline)) void Painter::draw_cell(
    const uint8_t* samples, const TourLeaf& leaf) noexcept {
  const uint8_t* at = samples + format::samples::kOffsets;
  const auto offset = [at](uint32_t i) noexcept {
    return static_cast<int32_t>(static_cast<int8_t>(at[i]));
  };
  set_up(samples, leaf.log2);
  begin_ = x0_ + leaf.pixels.x0;
  end_ = x0_ + leaf.pixels.x1;
  x_q16_ = left_q16_ + leaf.pixels.x0 * step_q16_ - leaf.x_u * (1 << 16);
  const Column c1(offset(0), offset(3), offset(5));
  const Column c2(offset(1), 0, offset(6));
  const Column c3(offset(2), offset(4), offset(7));
  int32_t y_q16 = top_q16_ - leaf.pixels.y0 * step_q16_ - leaf.y_u * (1 << 16);
  const int32_t end = y0_ + leaf.pixels.y1;
  for (int32_t y = y0_ + leaf.pixels.y0; y < end; ++y, y_q16 -= step_q16_) {
    constexpr int32_t kOne = 1 << 14;
    const int32_t t = y_q16 >> to_q14_;
    const int32_t w2 = (t * (kOne - t)) >> 12;
    const int32_t w3 = (t * (2 * t - kOne)) >> 14;
    const int32_t v1 = c1.at(w2, w3);
    const int32_t v2 = c2.at(w2, w3);
    const int32_t v3 = c3.at(w2, w3);
    const Parabola parabola = {v1, 4 * v2 - 3 * v1 - v3,
                               2 * (v1 - 2 * v2 + v3)};
    const int32_t sag = parabola.c >> 2;
    if (max(v1, v3) - min(sag, 0) <= low_q6_) {
      continue;
    }
    if (min(v1, v3) - max(sag, 0) - 3 >= high_q6_) {
      sink_.solid(sink_.context, begin_, y, end_ - begin_);
    } else {
      draw_row(y, parabola);
    }
  }
}

}  // namespace

void draw_samples_by_cells(const GlyphField& field,
                           const TextStyle& style,
                           const Placed& placed,
                           const Sink& sink) noexcept {
  const Upright upright = place_upright(field, style, placed, sink.window);
  if (is_empty(upright.pixels)) {
    return;
  }
  Painter painter(field, style, upright, sink);
  CellTour<Painter>(field, style, upright, painter).run();
}

}  // namespace detail
}  // namespace inkcell
