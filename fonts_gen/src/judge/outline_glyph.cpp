#include "judge/outline_glyph.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "judge/area_bound.hpp"
#include "outlines/curves.hpp"
#include "outlines/outline_code.hpp"
#include "outlines/outline_steps.hpp"
#include "outlines/unite.hpp"
#include "rom/outline_font.hpp"
#include "rom/rom_font.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Outlines that are tried: of curves with one tolerance, and with chords.
constexpr int kCurveTrials = 4;
constexpr int kChordTrials = 10;

// Where few pixels miss, curves within this share of the tolerance may take
// fewer points than chords do.
constexpr double kFinerShare = 0.6;
constexpr size_t kFewMisses = 12;

// Where chords miss too, other points of the grid may not.
constexpr double kLastShares[] = {0.35, 0.2, 0.8};
constexpr int kLastTrials = 6;
static_assert(2 * kCurveTrials + kChordTrials +
                  static_cast<int>(std::size(kLastShares)) * kLastTrials ==
              kMostTrials);

// Chords stand for the curves at places that miss with the source's own points
// too: how far they stray, in shares of the tolerance of the refit.
// The later ones only round the corners to other places.
constexpr double kChordShares[] = {0.6, 0.3, 0.15, 0.45, 0.2};

// What a place asks for, from level to level: kCareful, kExact, then chords.
constexpr size_t kCareful = 0;
constexpr size_t kExact = 1;
constexpr size_t kCurveLevels = 2;
constexpr size_t kLevels = kCurveLevels + std::size(kChordShares);

// At 64 px and a tolerance of 16/255 this is half a u: about half of the
// tolerance. The rest is the painter's.
constexpr double kShare = 32.0 / 16.0;

// Positions at which a glyph that is done is drawn with the filter area: they
// confirm the bound.
constexpr int kAreaPhases = 2;

// A grid this much coarser than the tolerance still serves: its points are
// rounded by half of a unit.
constexpr double kCoarsest = 1.1;

// So does one of font units that is this coarse if the source's points lie on
// them: what lies along an axis is not rounded, and the loop refits what is.
constexpr double kCoarsestOwn = 2.2;

// From a contour to the next, and from the corner of the box to the first; the
// box may be wider than the outline by a unit at each side. [grid units]
constexpr double kLongestStep =
    (1 << (kMostStepBits - 1)) - (1 << (1 - format::outline::kMinGridShift));

// Places of one level that are added after a trial.
constexpr size_t kMostPlaces = 8;

// RAM for any glyph at any size. [bytes]
constexpr size_t kWorkspace = size_t{1} << 18;

// A font of .notdef and one glyph, to draw it with the device's code.
class OneGlyphFont {
 public:
  OneGlyphFont(const MinimalOutline& outline,
               const GlyphMetrics& metrics,
               const RefitOptions& options)
      : ram_(kWorkspace / sizeof(uint32_t)) {
    RomContent content;
    content.metrics.units_per_em = options.units_per_em;
    content.options.coding = Coding::outline;
    content.outlines.grid_shift = options.grid_shift;
    content.glyphs.resize(2);
    content.glyphs[1].outline = outline;
    content.glyphs[1].metrics = metrics;
    encode_outlines_widely(content);
    PartBytes parts;
    bytes_ = write_rom_font(content, parts);
    if (Font::open({bytes_.data(), bytes_.size()}, font_) != Status::ok) {
      throw GeometryError(GeometryError::Kind::too_complex,
                          "the outline does not fit the format");
    }
  }

  LoopGlyph loop_glyph() {
    return {
        [this](const Style& style, inkcell::Point origin) {
          PreparedGlyph glyph;
          static_cast<void>(
              PreparedGlyph::make(font_, 1, style, origin, workspace(), glyph));
          return glyph.box();
        },
        [this](const Style& style, inkcell::Point origin, const Sink& sink) {
          Painter(sink, workspace()).glyph(font_, style, origin, 1);
        }};
  }

 private:
  Workspace workspace() {
    return {reinterpret_cast<uint8_t*>(ram_.data()), kWorkspace};
  }

  std::vector<uint8_t> bytes_;
  std::vector<uint32_t> ram_;
  Font font_;
};

bool is_near(const std::vector<Point>& places, const Point& place) {
  return std::any_of(places.begin(), places.end(), [&](const Point& p) {
    return length(p - place) < kCareRadius_u / 2;
  });
}

// The point of the border that is nearest to the centre of a pixel.
Point border_at(const Shape& shape, const LoopMiss& miss) {
  constexpr double kStep_u = 1.0 / 64;
  const double x = miss.x_u;
  const double y = miss.y_u;
  const Point uphill = direction(
      {shape.distance(x + kStep_u, y) - shape.distance(x - kStep_u, y),
       shape.distance(x, y + kStep_u) - shape.distance(x, y - kStep_u)});
  return Point{x, y} - shape.distance(x, y) * uphill;
}

// Points along a segment but its first, so that chords stray by `bound` at
// most: second differences fall with the square of the number of chords.
void add_chords(const Segment& segment, double bound, Contour& polygon) {
  const int degree = degree_of(segment);
  double second = 0;
  for (int i = 0; i + 2 <= degree; ++i) {
    second = std::max(
        second, length(segment.p[i] - 2 * segment.p[i + 1] + segment.p[i + 2]));
  }
  // n chords of a curve of degree d stray by d (d - 1) / 8 of that over n^2.
  const double strays = second * degree * (degree - 1) / 8;
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(strays / bound))));
  Point at = segment.p[0];
  for (int i = 1; i <= count; ++i) {
    const Point next =
        i == count
            ? end_of(segment)
            : end_of(part_of(segment, 0, static_cast<double>(i) / count));
    polygon.segments.push_back(line_segment(at, next));
    at = next;
  }
}

// Where the refit takes more care, because pixels missed there.
class Places {
 public:
  // Asks for more care where pixels miss, the worst ones first. False if all
  // that can be asked was, up to `levels`.
  bool add(const Shape& shape,
           const std::vector<LoopMiss>& misses,
           size_t levels) {
    std::vector<Point> added[kLevels];
    bool any = false;
    for (const LoopMiss& miss : misses) {
      const Point place = border_at(shape, miss);
      size_t level = 0;
      while (level < levels && is_near(levels_[level], place)) {
        ++level;
      }
      if (level < levels && !is_near(added[level], place) &&
          added[level].size() < kMostPlaces) {
        added[level].push_back(place);
        any = true;
      }
    }
    for (size_t level = 0; level < kLevels; ++level) {
      levels_[level].insert(levels_[level].end(), added[level].begin(),
                            added[level].end());
    }
    return any;
  }

  RefitOptions options(RefitOptions options) const {
    options.careful_u = levels_[kCareful];
    for (size_t level = kExact; level < kLevels; ++level) {
      options.exact_u.insert(options.exact_u.end(), levels_[level].begin(),
                             levels_[level].end());
    }
    return options;
  }

  // The outline with chords for the parts of curves in reach of places that
  // ask for them: what the device draws most exactly, at the price of points.
  Outline with_chords(const Outline& united, double tolerance_u) const {
    Outline result;
    for (const Contour& contour : united.contours) {
      result.contours.emplace_back();
      for (const Segment& segment : contour.segments) {
        add_segment(segment, tolerance_u, result.contours.back());
      }
    }
    return result;
  }

 private:
  // The highest level that a point of the border asks for.
  size_t level_at(const Point& point) const {
    for (size_t level = kLevels; level-- > kExact + 1;) {
      if (std::any_of(
              levels_[level].begin(), levels_[level].end(),
              [&](const Point& p) { return length(p - point) < kChords_u; })) {
        return level;
      }
    }
    return kExact;
  }

  void add_segment(const Segment& segment,
                   double tolerance_u,
                   Contour& contour) const {
    if (segment.kind == Segment::Kind::line) {
      contour.segments.push_back(segment);
      return;
    }
    double size = 0;
    for (int i = 0; i < degree_of(segment); ++i) {
      size += length(segment.p[i + 1] - segment.p[i]);
    }
    const int steps = static_cast<int>(std::ceil(size / kStep_u)) + 1;
    const auto at = [&](int i) { return static_cast<double>(i) / steps; };
    const auto level_of = [&](int step) {
      return level_at(point_on(segment, (at(step) + at(step + 1)) / 2));
    };
    for (int first = 0; first < steps;) {
      const size_t level = level_of(first);
      int last = first + 1;
      while (last < steps && level_of(last) == level) {
        ++last;
      }
      const Segment part = part_of(segment, at(first), at(last));
      if (level == kExact) {
        contour.segments.push_back(part);
      } else {
        add_chords(part, kChordShares[level - kExact - 1] * tolerance_u,
                   contour);
      }
      first = last;
    }
  }

  // Reach of a place for chords, and steps in which curves are looked at.
  // Their corners are in the reach of the same place in RefitOptions.
  static constexpr double kStep_u = 4;
  static constexpr double kChords_u = kCareRadius_u - kStep_u;

  std::vector<Point> levels_[kLevels];
};

// Options, the places that ask for more care, and the pixels that miss.
struct Attempt {
  RefitOptions options;
  Places places;
  LoopResult errors;
};

// Draws outlines of a glyph and keeps the best.
class Trials {
 public:
  Trials(const Outline& source,
         const Shape& shape,
         const GlyphMetrics& metrics,
         const RefitOptions& options,
         const LoopOptions& limits)
      : united_(unite(source, shape)),
        shape_(shape),
        metrics_(metrics),
        options_(options),
        limits_(limits),
        loop_(shape, strict(limits)) {
    for (RefittedGlyph* none : {&best_, &nearest_}) {
      none->errors.promised.worst = kInfinity;
      none->errors.distance.worst = kInfinity;
    }
  }

  RefittedGlyph best() {
    if (best_.errors.promised.worst > limits_.tolerance &&
        !nearest_.outline.contours.empty()) {
      nearest_.errors.promised =
          bound_areas(shape_, nearest_.outline, options_, limits_);
      keep(std::move(nearest_));
    }
    best_.trials = trials_;
    confirm();
    return std::move(best_);
  }

  // Tries outlines with more and more care. True if no pixel misses.
  bool run(size_t levels, int most_trials, Attempt& attempt) {
    for (int trial = 0; trial < most_trials; ++trial) {
      if (attempt.errors.miss_count != 0 &&
          !attempt.places.add(shape_, attempt.errors.misses, levels)) {
        return false;
      }
      if (draw(attempt)) {
        return true;
      }
    }
    return false;
  }

 private:
  static LoopOptions strict(LoopOptions options) {
    options.tolerance -= kPositionReserve;
    return options;
  }

  // True if no pixel misses.
  bool draw(Attempt& attempt) {
    ++trials_;
    const RefitOptions options = attempt.places.options(attempt.options);
    RefittedGlyph glyph;
    glyph.outline = minimal_outline(
        attempt.places.with_chords(united_, options.tolerance_u), shape_,
        options, memo_);
    if (!glyph.outline.contours.empty()) {
      OneGlyphFont font(glyph.outline, metrics_, options_);
      glyph.errors.distance = loop_.draw_and_compare(font.loop_glyph());
    }
    attempt.errors = glyph.errors.distance;
    if (attempt.errors.misses.empty()) {
      attempt.errors = bound_areas(shape_, glyph.outline, options_, limits_);
      glyph.errors.promised = attempt.errors;
      keep(std::move(glyph));
    } else if (glyph.errors.distance.worst < nearest_.errors.distance.worst) {
      nearest_ = std::move(glyph);
    }
    return attempt.errors.misses.empty();
  }

  // Of outlines whose areas hold that with the least distances, else that with
  // the least areas.
  void keep(RefittedGlyph glyph) {
    const auto area_of = [&](const RefittedGlyph& g) {
      return std::max(g.errors.promised.worst, limits_.tolerance);
    };
    if (area_of(glyph) < area_of(best_) ||
        (area_of(glyph) == area_of(best_) &&
         glyph.errors.distance.worst < best_.errors.distance.worst)) {
      best_ = std::move(glyph);
    }
  }

  // Draws the best outline with the filter area.
  void confirm() {
    if (best_.outline.contours.empty()) {
      return;
    }
    LoopOptions options = limits_;
    options.measure = Measure::area;
    options.phases = kAreaPhases;
    OneGlyphFont font(best_.outline, metrics_, options_);
    LoopResult drawn =
        ClosedLoop(shape_, options).draw_and_compare(font.loop_glyph());
    LoopResult& promised = best_.errors.promised;
    if (promised.worst > drawn.worst) {
      drawn.worst = promised.worst;
      drawn.worst_pixel = promised.worst_pixel;
      drawn.misses = std::move(promised.misses);
      drawn.miss_count = promised.miss_count;
    }
    promised = std::move(drawn);
  }

  Outline united_;
  const Shape& shape_;
  const GlyphMetrics& metrics_;
  RefitOptions options_;  // units and grid, which all attempts share
  LoopOptions limits_;
  ClosedLoop loop_;
  RefitMemo memo_;
  RefittedGlyph best_;     // of those that held by distance
  RefittedGlyph nearest_;  // of the others, by distance
  int trials_ = 0;
};

}  // namespace

RefitOptions refit_options(const Target& options,
                           int units_per_em,
                           double largest_u,
                           bool is_on_units) {
  RefitOptions refit;
  refit.units_per_em = units_per_em;
  refit.tolerance_u = kShare * options.tolerance / options.max_px;
  const double unit_u = 1024.0 / units_per_em;
  refit.grid_shift = format::outline::kMinGridShift;
  while (refit.grid_shift < format::outline::kMaxGridShift &&
         (std::ldexp(unit_u, refit.grid_shift + 1) <=
              (is_on_units && refit.grid_shift < 0 ? kCoarsestOwn : kCoarsest) *
                  refit.tolerance_u ||
          largest_u > std::ldexp(unit_u, refit.grid_shift) * kLongestStep)) {
    ++refit.grid_shift;
  }
  return refit;
}

RefittedGlyph refit_glyph(const Outline& source,
                          const Shape& shape,
                          const GlyphMetrics& metrics,
                          const RefitOptions& options,
                          const LoopOptions& loop_options) {
  Trials trials(source, shape, metrics, options, loop_options);
  Attempt attempt{options, {}, {}};
  if (trials.run(kCurveLevels, kCurveTrials, attempt)) {
    return trials.best();
  }
  if (attempt.errors.miss_count <= kFewMisses) {
    Attempt finer{options, {}, {}};
    finer.options.tolerance_u *= kFinerShare;
    if (trials.run(kCurveLevels, kCurveTrials, finer)) {
      return trials.best();
    }
  }
  // What is left are turns so tight that only chords draw them truly.
  if (trials.run(kLevels, kChordTrials, attempt)) {
    return trials.best();
  }
  for (const double share : kLastShares) {
    Attempt last{options, {}, {}};
    last.options.tolerance_u *= share;
    if (trials.run(kLevels, kLastTrials, last)) {
      break;
    }
  }
  return trials.best();
}

}  // namespace inkcell::gen
