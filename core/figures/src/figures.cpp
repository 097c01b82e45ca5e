#include "inkcell/figures/figures.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/source.hpp"
#include "rows/wide_areas.hpp"

namespace inkcell::detail {

using figures::Cap;
using figures::Figure;
using figures::Join;

namespace {

struct DrawnFigure {
  const Figure& figure;
  const figures::Pen* pen;  // null: what lies inside is drawn
};

struct __attribute__((may_alias)) FigureJob : GlyphJob {
  const DrawnFigure* drawn;
};
static_assert(sizeof(FigureJob) <= kMostJob);

// Angles. [1/65536 turn]
constexpr int32_t kTurn = 1 << 16;
constexpr int32_t kRight = kTurn / 4;
// A corner that turns farther is sharper than 29 degrees, and cut off.
constexpr int32_t kMiterLimit = 27497;

// Points and radii reach so far, and half widths: what they make stays within
// 4096 px of the first point, as curves want it (area_painter.hpp). [px, Q6]
constexpr int32_t kReach = 2047 * 64;
constexpr int32_t kMostHalf = 511 * 64;

int32_t sine_of(int32_t angle) noexcept {
  return motion::sine(motion::Angle::from_raw(static_cast<uint16_t>(angle)))
      .raw;
}
int32_t cosine_of(int32_t angle) noexcept {
  return sine_of(angle + kRight);
}

// A length times a factor of up to 4, to the nearest. [px, Q8; Q14]
int32_t scaled_length(int32_t length, int32_t factor) noexcept {
  return ((length >> 8) * factor + ((length & 255) * factor >> 8) + 32) >> 6;
}

// A radius over the cosine of an angle of at most 76 degrees.
int32_t over_cosine(int32_t radius, int32_t angle) noexcept {
  return scaled_length(radius, quotient(1 << 28, cosine_of(angle)));
}

}  // namespace

// Takes contours in Q8 px from the pixel of the figure's first point, y down,
// and paints them into a band; without one, it finds their box.
class FigureTracer {
 public:
  FigureTracer(const DrawnFigure& drawn, Band* band) noexcept
      : pen(drawn.pen), origin_(drawn.figure.ends[0]), band_(band) {
    cursor_.begin(true);
    half = pen == nullptr ? 0 : clamp(pen->width.raw / 2, 0, kMostHalf) * 4;
    if (pen == nullptr || half != 0) {
      drawn.figure.trace(drawn.figure, *this);
    }
  }

  const figures::Pen* const pen;
  int32_t half;          // of its width [px, Q8]
  bool is_hole = false;  // contours are taken off, not added

  PixelPoint point(Point at) const noexcept {
    return {near(at.x, origin_.x), near(at.y, origin_.y)};
  }

  // The next point of a contour. The last one leads to the first.
  void to(const PixelPoint& at) noexcept {
    if (!is_open_) {
      start_ = at;
    }
    add(at, is_open_ ? kCorner : kStart);
    is_open_ = true;
  }
  void to_polar(const PixelPoint& centre,
                int32_t radius,
                int32_t angle) noexcept {
    to(polar(centre, radius, angle));
  }
  void close() noexcept {
    to(start_);
    is_open_ = false;
    paint();
  }

  static PixelPoint polar(const PixelPoint& centre,
                          int32_t radius,
                          int32_t angle) noexcept {
    return {centre.x + scaled_length(radius, cosine_of(angle)),
            centre.y - scaled_length(radius, sine_of(angle))};
  }

  // An arc, with a point at either end. Control points lie where tangents meet:
  // up to radii of 1300 px curves stray from the circle by 1/64 px at most.
  void bend(const PixelPoint& centre,
            int32_t radius,
            int32_t from,
            int32_t sweep) noexcept {
    const int32_t most = radius <= 5 * 256    ? kTurn / 8
                         : radius <= 80 * 256 ? kTurn / 16
                                              : kTurn / 32;
    if (radius == 0) {
      to(centre);
      return;
    }
    // Halves of steps. [Q6]
    const int32_t pieces = max(quotient(abs(sweep) + most - 1, most), 1);
    const int32_t half_step = quotient(sweep * 32, pieces);
    const int32_t outer = over_cosine(radius, half_step >> 6);
    to_polar(centre, radius, from);
    for (int32_t i = 1; i < 2 * pieces; i += 2) {
      add(polar(centre, outer, from + (i * half_step >> 6)), kOffCurve);
    }
    to_polar(centre, radius, from + sweep);
  }

  // The left side of a stroke around a corner; `length`: of the shorter edge.
  void corner(const PixelPoint& at,
              int32_t heading,
              int32_t turn,
              int32_t length,
              bool is_bent) noexcept {
    const int32_t normal = heading + kRight;
    const int32_t part = turn / 2;
    if (turn <= 0 && is_bent) {
      bend(at, half, normal, turn);
      return;
    }
    if (abs(turn) <= kMiterLimit) {
      const int32_t reach = over_cosine(half, part);
      // The inner side meets on both edges, if they are long enough.
      if (2 * scaled_length(reach, sine_of(part)) <= length) {
        to_polar(at, reach, normal + part);
        return;
      }
    }
    to_polar(at, half, normal);
    if (turn > 0) {
      to(at);
    }
    to_polar(at, half, normal + turn);
  }

  // The same around an end.
  void end(const PixelPoint& at, int32_t heading) noexcept {
    if (pen->cap == Cap::square) {
      const int32_t reach = scaled_length(half, 23170);  // the square root of 2
      to_polar(at, reach, heading + kRight / 2);
      to_polar(at, reach, heading - kRight / 2);
    } else {
      corner(at, heading, -kTurn / 2, 0, pen->cap == Cap::round);
    }
  }

  // The contour to the left of a path: to its last point and back with
  // `has_ends`, else around, from the last one on if `is_reversed`.
  void side(const Span<const Point>& points,
            bool has_ends,
            bool is_reversed) noexcept {
    const auto count = static_cast<int32_t>(points.size);
    const int32_t period = has_ends ? 2 * count - 2 : count;
    const auto vertex = [&](int32_t i) noexcept {
      i -= i > period ? period : 0;
      i = i < count ? i : period - i;
      return point(points.data[is_reversed ? count - 1 - i : i]);
    };
    PixelPoint at = vertex(0);
    int32_t reached = 0;  // the first index of `at`
    int32_t heading = 0;
    int32_t length = 0;  // 0: there is no edge yet
    // The corner at the first point comes last.
    for (int32_t i = 1; i <= 2 * period && reached <= period; ++i) {
      const PixelPoint next = vertex(i);
      const int32_t x = next.x - at.x;
      const int32_t y = at.y - next.y;
      if ((x | y) == 0) {
        continue;
      }
      const int32_t angle = motion::angle_of(x, y).raw;
      const int32_t reach = max(abs(x), abs(y));
      if (length != 0) {
        if (has_ends && (i > period || (reached < count && i >= count))) {
          end(at, heading);
        } else {
          corner(at, heading, static_cast<int16_t>(angle - heading),
                 min(length, reach), pen->join == Join::round);
        }
      }
      at = next;
      reached = i;
      heading = angle;
      length = reach;
    }
    if (length == 0 && pen->cap == Cap::round) {
      bend(at, half, 0, kTurn);
    }
    close();
  }

  // The pixels in which contours were; empty if there were none.
  Rect box() const noexcept {
    const int32_t x = origin_.x.floor();
    const int32_t y = origin_.y.floor();
    return {x + (low_.x >> 8), y + (low_.y >> 8), x + ((high_.x + 255) >> 8),
            y + ((high_.y + 255) >> 8)};
  }

 private:
  static constexpr int32_t kRoom = 8;

  // Wraps where Q26_6 does.
  static int32_t near(Q26_6 at, Q26_6 origin) noexcept {
    const auto away =
        static_cast<uint32_t>(at.raw) - static_cast<uint32_t>(origin.raw & ~63);
    return clamp(wrapped(away), -kReach, kReach) * 4;
  }

  void add(const PixelPoint& at, PointKind kind) noexcept {
    low_ = {min(low_.x, at.x), min(low_.y, at.y)};
    high_ = {max(high_.x, at.x), max(high_.y, at.y)};
    points_[count_] = ScreenPoint::at(at.x, at.y, kind);
    if (++count_ == kRoom) {
      paint();
    }
  }

  void paint() noexcept {
    if (band_ != nullptr) {
      band_->is_mirrored = is_hole;
      paint_wide_areas(*band_, cursor_, points_, points_ + count_);
    }
    count_ = 0;
  }

  const Point origin_;
  Band* const band_;
  PixelPoint low_ = {INT32_MAX, INT32_MAX};
  PixelPoint high_ = {INT32_MIN, INT32_MIN};
  PixelPoint start_ = {0, 0};
  bool is_open_ = false;
  int32_t count_ = 0;
  OutlineCursor cursor_;
  ScreenPoint points_[kRoom];
};

void trace_box(const Figure& figure, FigureTracer& tracer) noexcept {
  PixelPoint low = tracer.point(figure.ends[0]);
  PixelPoint high = tracer.point(figure.ends[1]);
  if (low.x > high.x) {
    swap(low.x, high.x);
  }
  if (low.y > high.y) {
    swap(low.y, high.y);
  }
  const int32_t half = tracer.half;
  const int32_t least = min(high.x - low.x, high.y - low.y);
  const int32_t radius =
      min(clamp(figure.radius.raw, 0, kReach) * 4, least / 2);
  const bool is_bent =
      radius != 0 || half == 0 || tracer.pen->join == Join::round;
  // Corners are arcs about points inside of those of the rectangle.
  int32_t inset = is_bent ? radius : -half;
  int32_t bent = is_bent ? radius + half : 0;
  for (;;) {
    PixelPoint at = {high.x - inset, low.y + inset};
    for (int32_t from = 0; from != kTurn; from += kRight) {
      tracer.bend(at, bent, from, kRight);
      if ((from & kRight) == 0) {
        at.x = low.x + high.x - at.x;
      } else {
        at.y = low.y + high.y - at.y;
      }
    }
    tracer.close();
    if (half == 0 || 2 * half >= least || tracer.is_hole) {
      return;
    }
    tracer.is_hole = true;
    inset = max(radius, half);
    bent = max(radius - half, 0);
  }
}

void trace_arc(const Figure& figure, FigureTracer& tracer) noexcept {
  const PixelPoint centre = tracer.point(figure.ends[0]);
  const int32_t radius = clamp(figure.radius.raw, 0, kReach) * 4;
  const int32_t half = tracer.half;
  int32_t sweep = clamp(figure.turns.raw, -kTurn, kTurn);
  int32_t at = figure.from.raw;
  if (sweep == 0) {
    return;
  }
  if (sweep < 0) {
    at += sweep;
    sweep = -sweep;
  }
  // The inner side there, or the centre, and the outer side back. Of a circle
  // both lie between the same points.
  int32_t side = half == 0 ? 0 : max(radius - half, 0);
  for (int32_t i = 0; i != 2; ++i) {
    tracer.bend(centre, side, at, sweep);
    at += sweep;
    if (half != 0 && abs(sweep) != kTurn) {
      tracer.end(tracer.polar(centre, radius, at),
                 at + (i == 0 ? kRight : -kRight));
    }
    sweep = -sweep;
    side = radius + half;
  }
  tracer.close();
}

void trace_path(const Figure& figure, FigureTracer& tracer) noexcept {
  Span<const Point> points = figure.points;
  if (points.size == 0) {
    points = figure.ends;
  }
  points.size = points.size < 65535 ? points.size : 65535;
  if (tracer.pen != nullptr) {
    for (int32_t i = figure.has_ends ? 1 : 0; i != 2; ++i) {
      tracer.side(points, figure.has_ends, i == 0);
    }
    return;
  }
  for (const Point& at : points) {
    tracer.to(tracer.point(at));
  }
  tracer.close();
}

namespace {

bool prepare_figure(GlyphJob& base,
                    const GlyphRef& ref,
                    const Placed&) noexcept {
  static constexpr BandKind kFigureBand = {
      nullptr, cover_wide_areas, BandBytes::area, Painted::other, 128};
  auto& job = static_cast<FigureJob&>(base);
  job.drawn = static_cast<const DrawnFigure*>(ref.from);
  job.plan.band_kind = &kFigureBand;
  job.box = FigureTracer(*job.drawn, nullptr).box();
  return !is_empty(job.box);
}

bool load_figure(GlyphJob& job) noexcept {
  // Rows of 16 bits take as much again as those of bytes.
  job.ram_bytes = (job.ram_bytes / 2) & ~3;
  return true;
}

void fill_figure(GlyphJob& base) noexcept {
  auto& job = static_cast<FigureJob&>(base);
  Band& band = job.band;  // set anew for each
  const int32_t size = band.rows * band.stride;
  clear_pixels(band.bytes + size, size);
  const Point& origin = job.drawn->figure.ends[0];
  band.x_q8 += (first_column(job.box) - origin.x.floor()) * 256;
  band.y_q8 += (job.box.y0 - origin.y.floor()) * 256;
  FigureTracer(*job.drawn, &band);
}

constexpr Source kFigureSource = {prepare_figure,    load_figure,
                                  fill_figure,       sizeof(FigureJob),
                                  SourceKind::areas, nullptr};
constexpr Style kFigureStyle;

}  // namespace

Rect draw_figure(const Figure& figure,
                 const figures::Pen* pen,
                 const Painter* painter) noexcept {
  if (figure.trace == nullptr) {
    return {};
  }
  const DrawnFigure drawn = {figure, pen};
  const Placed anywhere = {0, 0};
  const GlyphCall call = {{&kFigureSource, &drawn, 0},
                          kFigureStyle,
                          anywhere,
                          painter == nullptr ? nullptr : &painter->sink()};
  if (painter == nullptr) {
    return band_box(call);
  }
  draw_bands(call, painter->ram());
  return {};
}

}  // namespace inkcell::detail
