// For each pixel of a row: distance and gradient, then light, then lines.
//
// Lines are periods of a phase of 32 bits that wraps: 0 is the middle of a
// line.
#include "inkcell/simulation/print_draw.hpp"

#include "base/known_span.hpp"
#include "base/math.hpp"
#include "limits.hpp"
#include "pixel_run.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kBlack = 255;

// Half of sqrt(n / 16). [Q16]
struct HalfRoots {
  uint16_t of[17];
};

constexpr HalfRoots make_half_roots() noexcept {
  HalfRoots roots = {};
  for (uint32_t n = 0; n < 17; ++n) {
    roots.of[n] = static_cast<uint16_t>(detail::root_of(n << 26));
  }
  return roots;
}

constexpr HalfRoots kHalfRoots = make_half_roots();

// Half of sqrt(part / 256), on chords. [Q16]
int32_t half_root_q16(int32_t part_q8) noexcept {
  const uint16_t* const from = kHalfRoots.of + (part_q8 >> 4);
  return from[0] + ((from[1] - from[0]) * (part_q8 & 15) >> 4);
}

// Steps of a phase for each px. [2^-32 periods]
struct Wave {
  uint32_t right;  // a pixel to the right
  uint32_t down;

  uint32_t at(int32_t x, int32_t y) const noexcept {
    return right * static_cast<uint32_t>(x) + down * static_cast<uint32_t>(y);
  }
};

Wave wave_of(Angle angle, uint32_t to_phase) noexcept {
  // The phase of lines grows at right angles to them.
  const auto step = [to_phase](int32_t part_q14) {
    const int64_t px = int64_t{to_phase} * 1024;
    return static_cast<uint32_t>(px * part_q14 >> 14);
  };
  return {step(sine(angle).raw), step(cosine(angle).raw)};
}

struct Printer {
  PrintStyle style;
  int32_t pitch_q10;  // [px]
  int32_t slope_q10;
  int32_t to_steep;   // [1/1024 px -> Q24]
  uint32_t to_phase;  // [1/1024 px -> 2^-32 periods]
  int32_t light_x_q14;
  int32_t light_y_q14;  // y down
  int32_t tone;
  int32_t contrast;
  Wave along;   // phase across the lines
  Wave across;  // phase across the second set of lines
  uint32_t start;
  int32_t across_x_q13;  // the direction in which the phase of lines grows
  int32_t across_y_q13;
  int32_t screen_x;
  int32_t screen_y;
  int32_t cutoff_q10;  // [px]
  int32_t scale_log2;
  int32_t known_q10;  // distances are clamped beyond it

  Printer(const PrintLook& look, int32_t grid_scale_log2) noexcept;

  // `at` is moved by the cutoff.
  uint32_t ink(const GridPoint& at, int32_t x, int32_t y) const noexcept {
    const int32_t dark = shade(at);
    const int32_t depth_q10 = at.distance_q10;
    int32_t result = dark;
    switch (style) {
      case PrintStyle::rings: {
        // They fade over the last sample whose distance is known.
        const int32_t left_q10 = known_q10 - depth_q10 - cutoff_q10;
        const int32_t part_q8 = clamp(left_q10 >> (2 + scale_log2), 0, 256);
        result = line(to_phase * static_cast<uint32_t>(depth_q10) - start,
                      dark * part_q8 >> 8);
        break;
      }
      case PrintStyle::engraving: {
        // Lines follow the height: a parabola up to the flat part.
        const int32_t left = slope_q10 - clamp(depth_q10, 0, slope_q10);
        const int32_t height_q10 =
            (slope_q10 - (left * steep_q8(depth_q10) >> 8)) * 3 >> 2;
        const uint32_t bent = to_phase * static_cast<uint32_t>(height_q10);
        result = line(along.at(x, y) + bent - start, dark,
                      is_flat(at) ? kOneQ13 : bent_density_q13(at));
        break;
      }
      case PrintStyle::hatching: {
        const int32_t first =
            line(along.at(x, y) - start, min(dark, 127) * 5 >> 3);
        const int32_t second =
            dark > 127 ? line(across.at(x, y) + start, (dark - 127) * 7 >> 3)
                       : 0;
        result = max(first, second);
        break;
      }
      case PrintStyle::halftone:
        result = dot(along.at(x, y) - start, across.at(x, y), dark);
        break;
      case PrintStyle::relief:
        break;
    }
    return static_cast<uint32_t>(result);
  }

 private:
  // Where distances are clamped, deep inside.
  static bool is_flat(const GridPoint& at) noexcept {
    return (at.x_slope_q13 | at.y_slope_q13) == 0;
  }
  // The steepness of the dome: 1 at the edge, 0 at the end of the slope.
  int32_t steep_q8(int32_t distance_q10) const noexcept {
    return 256 - (clamp(distance_q10, 0, slope_q10) * to_steep >> 16);
  }
  int32_t shade(const GridPoint& at) const noexcept;
  // Coverage of a line that is part / 256 of the pitch wide. A line thinner
  // than a pixel is as faint as it is thin, wherever pixels cross it. `density`
  // is the number of periods in a pitch. [of 255]
  int32_t line(uint32_t phase,
               int32_t width_q8,
               int32_t density_q13 = kOneQ13) const noexcept {
    const int32_t from_middle = static_cast<int32_t>(phase) >> 16;  // [Q16]
    const int32_t away_q10 = abs(from_middle) * (pitch_q10 >> 4) >> 12;
    const int32_t half_q10 = pitch_q10 * width_q8 >> 9;
    // Half a pixel.
    const int32_t soft_q10 = density_q13 >> 4;
    const int32_t inside_q10 =
        min(half_q10 - away_q10 + soft_q10, 2 * half_q10);
    return inside_q10 <= 0              ? 0
           : inside_q10 >= 2 * soft_q10 ? kBlack
                                        : inside_q10 * 128 / soft_q10;
  }

  // How dense lines are that bend over the slope: the length of the gradient of
  // their phase. Below 4.
  int32_t bent_density_q13(const GridPoint& at) const noexcept {
    const int32_t steep = steep_q8(at.distance_q10);
    if (steep <= 0) {
      return kOneQ13;
    }
    // Lines across the screen's angle, and 3/2 of the slope of the dome.
    const int32_t x =
        across_x_q13 + (clamp(at.x_slope_q13, -8192, 8192) * steep * 3 >> 9);
    const int32_t y =
        across_y_q13 + (clamp(at.y_slope_q13, -8192, 8192) * steep * 3 >> 9);
    return max(near_length(abs(x), abs(y)), kOneQ13 / 4);
  }

  // Coverage of a dot, which joins its neighbours at half tone.
  int32_t dot(uint32_t phase, uint32_t other, int32_t dark) const noexcept {
    // The sum of two distances from the middle, in half pitches. [Q16]
    const int32_t away = abs(static_cast<int32_t>(phase) >> 16) +
                         abs(static_cast<int32_t>(other) >> 16);
    const int32_t reach = dark <= 127
                              ? half_root_q16(2 * dark)
                              : 65536 - half_root_q16(2 * (kBlack - dark));
    // Across the dot's side: by sqrt(2) slower.
    const int32_t px_q10 = ((reach - away) >> 6) * (pitch_q10 >> 4) * 181 >> 14;
    return clamp((px_q10 + 512) >> 2, 0, kBlack);
  }
};

Printer::Printer(const PrintLook& look, int32_t grid_scale_log2) noexcept
    : style(look.style),
      pitch_q10(clamp(look.pitch.raw, 2 << 6, 64 << 6) * 16),
      slope_q10(clamp(look.slope.raw, 1 << 6, 32 << 6) * 16),
      to_steep((256 << 16) / slope_q10),
      to_phase(UINT32_MAX / static_cast<uint32_t>(pitch_q10)),
      light_x_q14(cosine(look.light).raw),
      light_y_q14(-sine(look.light).raw),
      tone(look.tone),
      contrast(look.contrast),
      along(wave_of(look.screen, to_phase)),
      across(wave_of(Angle::from_raw(static_cast<uint16_t>(
                         look.screen.raw +
                         (style == PrintStyle::halftone ? 0x4000 : 0x3000))),
                     to_phase)),
      start(to_phase * 16 * static_cast<uint32_t>(look.shift.raw)),
      across_x_q13(sine(look.screen).raw >> 1),
      across_y_q13(cosine(look.screen).raw >> 1),
      screen_x(look.screen_x),
      screen_y(look.screen_y),
      cutoff_q10(clamp(look.cutoff.raw, -(1 << 15), 1 << 15) *
                     (1 << grid_scale_log2) >>
                 3),
      scale_log2(grid_scale_log2),
      known_q10((31 << 10 << grid_scale_log2) >> 3) {}

// How dark a place is, on a dome whose slope falls from 1 at the edge to 0.
int32_t Printer::shade(const GridPoint& at) const noexcept {
  if (at.distance_q10 >= slope_q10 || is_flat(at)) {
    return tone;
  }
  // The height grows inwards: the gradient of a lit place points away from the
  // light.
  const int32_t facing = (clamp(at.x_slope_q13, -8192, 8192) * light_x_q14 +
                          clamp(at.y_slope_q13, -8192, 8192) * light_y_q14) >>
                         13;
  const int32_t change =
      (facing * contrast >> 14) * steep_q8(at.distance_q10) >> 8;
  return clamp(tone + change, 0, kBlack);
}

// The pixels of a row that have distances. [px]
detail::KnownSpan shown_span(const DistanceGrid& grid, int32_t line) noexcept {
  const int32_t scale = grid.scale_log2();
  const int32_t above = (2 * line + 1 - (1 << scale)) >> (scale + 1);
  const detail::KnownSpan known =
      grown(detail::known_span(grid, above, above + 1), 1, grid.width());
  return {known.first << scale, known.end << scale};
}

// A line of pixels through a grid, from left to right. Values are those of
// probe() at each centre; pixels of a cell share its two sides.
class GridLine {
 public:
  GridLine(const DistanceGrid& grid, int32_t line, int32_t column) noexcept
      : width_(grid.width()), scale_log2_(grid.scale_log2()) {
    const int32_t down_q8 = on_grid(line);
    const int32_t row = down_q8 >> 8;
    top_ = row >= 0 && row < grid.height() ? grid.row(row) : nullptr;
    bottom_ = row + 1 < grid.height() ? grid.row(row + 1) : nullptr;
    down_ = down_q8 & 255;
    const int32_t right_q8 = on_grid(column);
    column_ = right_q8 >> 8;
    right_ = right_q8 & 255;
    left_side_ = side_at(column_);
    right_side_ = side_at(column_ + 1);
  }

  // [px, Q10]
  int32_t distance() const noexcept {
    const int32_t value = left_side_.value + (x_slope() * right_ >> 8) + 128;
    return value * (1 << scale_log2_) >> 3;
  }
  int32_t x_slope() const noexcept {  // [Q13]
    return right_side_.value - left_side_.value;
  }
  int32_t y_slope() const noexcept {
    return left_side_.step * 256 +
           (right_side_.step - left_side_.step) * right_;
  }
  // Some pixels to the right.
  void advance(int32_t px) noexcept {
    right_ += px << (8 - scale_log2_);
    if (right_ >= 256) {
      const int32_t cells = right_ >> 8;
      right_ &= 255;
      column_ += cells;
      left_side_ = cells == 1 ? right_side_ : side_at(column_);
      right_side_ = side_at(column_ + 1);
    }
  }

 private:
  // A side of a cell, where the line crosses it.
  struct Side {
    int32_t value;  // [1/32 of a sample, Q8]
    int32_t step;   // to the sample below
  };

  // The centre of a pixel from that of the first sample. [samples, Q8]
  int32_t on_grid(int32_t px) const noexcept {
    return ((2 * px + 1) << (7 - scale_log2_)) - 128;
  }
  int32_t at(const int8_t* row, int32_t column) const noexcept {
    return row != nullptr && column >= 0 && column < width_
               ? row[column]
               : DistanceGrid::kOutside;
  }
  Side side_at(int32_t column) const noexcept {
    const int32_t top = at(top_, column);
    const int32_t step = at(bottom_, column) - top;
    return {top * 256 + step * down_, step};
  }

  const int8_t* top_;  // rows of samples; null outside of the grid
  const int8_t* bottom_;
  int32_t width_;
  int32_t scale_log2_;
  int32_t down_;  // [Q8]
  int32_t column_;
  int32_t right_;
  Side left_side_;
  Side right_side_;
};

__attribute__((noinline)) void print_row(const DistanceGrid& grid,
                                         const Printer& printer,
                                         const Filter& filter,
                                         const Rect& part,
                                         const Rect& box,
                                         int32_t y,
                                         const Sink& sink) noexcept {
  const int32_t line = y - box.y0;
  const detail::KnownSpan shown = shown_span(grid, line);
  const int32_t first = max(shown.first, part.x0 - box.x0);
  const int32_t end = min(shown.end, part.x1 - box.x0);
  PixelRun run(sink, y);
  GridLine at(grid, line, first);
  int32_t px = 1;
  for (int32_t column = first; column < end; column += px, at.advance(px)) {
    const int32_t distance_q10 = at.distance() - printer.cutoff_q10;
    const uint32_t body = filter.coverage(distance_q10);
    px = 1;
    if (body == 0) {
      // Slopes are below 2: a pixel changes a distance by less than 2 px.
      px += max(filter.outside_q10 - distance_q10, 0) >> 11;
    } else {
      const GridPoint here = {distance_q10, at.x_slope(), at.y_slope()};
      const uint32_t ink =
          printer.ink(here, column - printer.screen_x, line - printer.screen_y);
      const uint32_t covered = body * ink + 127;
      run.add(box.x0 + column, (covered + (covered >> 8)) >> 8);
    }
  }
  run.flush();
}

}  // namespace

void draw_print(const DistanceGrid& grid,
                const PrintLook& look,
                int32_t x,
                int32_t y,
                const Filter& filter,
                const Sink& sink) noexcept {
  constexpr int32_t kFar = 8191;
  if (grid.width() == 0 || x > kFar || x < -kFar || y > kFar || y < -kFar) {
    return;
  }
  const Printer printer(look, grid.scale_log2());
  const Rect box = {x, y, x + grid.width_px(), y + grid.height_px()};
  const Rect part = intersect(box, sink.window);
  for (int32_t row = part.y0; row < part.y1 && !is_empty(part); ++row) {
    print_row(grid, printer, filter, part, box, row, sink);
  }
}

}  // namespace inkcell::simulation
