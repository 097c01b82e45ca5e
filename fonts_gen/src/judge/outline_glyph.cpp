#include "judge/outline_glyph.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "inkcell/format/rom.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/text.hpp"
#include "outlines/curves.hpp"
#include "outlines/outline_code.hpp"
#include "outlines/outline_steps.hpp"
#include "outlines/unite.hpp"
#include "rom/outline_font.hpp"
#include "rom/rom_font.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Attempts with one tolerance, each with more care than the one before.
constexpr int kRounds = 4;

// Shares of the tolerance. Curves are tried with both of a pair before chords.
constexpr double kShares[][2] = {{1, 0.6}, {0.35, 0.2}};

// At 64 px and a tolerance of 16/255 this is half a u: about half of the
// tolerance. The rest is the painter's.
constexpr double kShare = 32.0 / 16.0;

// A grid this much coarser than the tolerance still serves: its points are
// rounded by half of a unit.
constexpr double kCoarsest = 1.1;

// From a contour to the next, and from the corner of the box to the first; the
// box may be wider than the outline by a unit at each side. [grid units]
constexpr double kLongestStep =
    (1 << (kMostStepBits - 1)) - (1 << (1 - format::outline::kMinGridShift));

// Places for which more care is asked a round.
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
    encode_outlines(content);
    PartBytes parts;
    bytes_ = write_rom_font(content, parts);
    if (Font::open({bytes_.data(), bytes_.size()}, font_) != Status::ok) {
      throw GeometryError(GeometryError::Kind::too_complex,
                          "the outline does not fit the format");
    }
  }

  LoopGlyph loop_glyph() {
    return {[this](const TextStyle& style, inkcell::Point origin) {
              PreparedGlyph glyph;
              static_cast<void>(PreparedGlyph::make(font_, 1, style, origin,
                                                    workspace(), glyph));
              return glyph.box();
            },
            [this](const TextStyle& style, inkcell::Point origin,
                   const Sink& sink) {
              draw_glyph(font_, 1, style, origin, sink, workspace());
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

void add_places(const Shape& shape,
                const std::vector<LoopMiss>& misses,
                std::vector<Point>& places) {
  for (const LoopMiss& miss : misses) {
    const Point place = border_at(shape, miss);
    if (!is_near(places, place)) {
      places.push_back(place);
    }
  }
}

// Asks for more care where pixels miss. False if all that can be asked was.
bool take_care(const Shape& shape,
               const std::vector<LoopMiss>& misses,
               RefitOptions& options) {
  std::vector<Point> careful;
  std::vector<Point> exact;
  for (const LoopMiss& miss : misses) {
    const Point place = border_at(shape, miss);
    if (!is_near(options.careful_u, place)) {
      if (careful.size() < kMostPlaces && !is_near(careful, place)) {
        careful.push_back(place);
      }
    } else if (!is_near(options.exact_u, place) && !is_near(exact, place) &&
               exact.size() < kMostPlaces) {
      exact.push_back(place);
    }
  }
  options.careful_u.insert(options.careful_u.end(), careful.begin(),
                           careful.end());
  options.exact_u.insert(options.exact_u.end(), exact.begin(), exact.end());
  return !careful.empty() || !exact.empty();
}

// Chords that stand for curves stray no farther, in shares of the tolerance of
// the refit: what is tried for places that miss, and for the whole outline.
constexpr double kChordShare = 0.6;
constexpr double kPolygonShares[] = {0.6, 0.8, 1, 0.5, 0.7, 0.9, 1.2, 0.4};

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

// Whether a segment passes within the reach of one of the places.
bool passes(const Segment& segment, const std::vector<Point>& places) {
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    const Point at =
        i == 0 ? segment.p[0]
               : end_of(part_of(segment, 0, static_cast<double>(i) / kSteps));
    if (std::any_of(places.begin(), places.end(), [&](const Point& place) {
          return length(at - place) < kCareRadius_u;
        })) {
      return true;
    }
  }
  return false;
}

// The outline with chords, whose corners are kept, for the curves that pass the
// places, or for all of them if that is null: what the device draws most
// exactly, at the price of more points.
MinimalOutline outline_of_chords(const Outline& united,
                                 const std::vector<Point>* places,
                                 double share,
                                 RefitOptions options,
                                 ChainMemo& memo) {
  Outline chords;
  for (const Contour& contour : united.contours) {
    Contour polygon;
    for (const Segment& segment : contour.segments) {
      if (places != nullptr && !passes(segment, *places)) {
        polygon.segments.push_back(segment);
        continue;
      }
      const size_t first = polygon.segments.size();
      add_chords(segment, share * options.tolerance_u, polygon);
      for (size_t i = first; i < polygon.segments.size(); ++i) {
        const Point at = polygon.segments[i].p[0];
        if (!is_near(options.exact_u, at)) {
          options.exact_u.push_back(at);
        }
      }
    }
    chords.contours.push_back(polygon);
  }
  return minimal_outline(chords, options, memo);
}

// Options, and the pixels that miss with them.
struct Attempt {
  RefitOptions options;
  std::vector<LoopMiss> misses;
};

// Draws outlines of a glyph and keeps the best.
class Trials {
 public:
  Trials(const Shape& shape,
         const GlyphMetrics& metrics,
         const RefitOptions& options,
         const LoopOptions& loop_options)
      : shape_(shape),
        metrics_(metrics),
        options_(options),
        loop_(shape, strict(loop_options)) {}

  RefittedGlyph best() { return std::move(*best_); }

  // Curves, with more care from round to round. Whether no pixel misses.
  bool try_curves(const Outline& source, Attempt& attempt) {
    bool may_improve = true;
    for (int round = 0; round < kRounds && may_improve; ++round) {
      attempt.misses = draw(minimal_outline(source, attempt.options, memo_));
      if (attempt.misses.empty()) {
        return true;
      }
      may_improve = take_care(shape_, attempt.misses, attempt.options);
    }
    return false;
  }

  // Chords where pixels miss, in more places from round to round.
  bool try_chords(const Outline& united, Attempt& attempt) {
    std::vector<Point> places;
    for (int round = 0; round < kRounds; ++round) {
      add_places(shape_, attempt.misses, places);
      attempt.misses = draw(outline_of_chords(united, &places, kChordShare,
                                              attempt.options, memo_));
      if (attempt.misses.empty()) {
        return true;
      }
      take_care(shape_, attempt.misses, attempt.options);
    }
    return false;
  }

  // Chords everywhere.
  void try_polygons(const Outline& united) {
    for (const double share : kPolygonShares) {
      if (draw(outline_of_chords(united, nullptr, share, options_, memo_))
              .empty()) {
        return;
      }
    }
  }

 private:
  static LoopOptions strict(LoopOptions options) {
    options.tolerance -= kPositionReserve;
    return options;
  }

  // Returns the pixels that miss.
  std::vector<LoopMiss> draw(MinimalOutline outline) {
    RefittedGlyph glyph;
    glyph.outline = std::move(outline);
    if (!glyph.outline.contours.empty()) {
      OneGlyphFont font(glyph.outline, metrics_, options_);
      glyph.errors = loop_.draw_and_compare(font.loop_glyph());
    }
    std::vector<LoopMiss> misses = glyph.errors.misses;
    if (!best_ || misses.empty() || glyph.errors.worst < best_->errors.worst) {
      best_ = std::move(glyph);
    }
    return misses;
  }

  const Shape& shape_;
  const GlyphMetrics& metrics_;
  const RefitOptions& options_;
  ClosedLoop loop_;
  ChainMemo memo_;
  std::optional<RefittedGlyph> best_;
};

}  // namespace

RefitOptions refit_options(const Target& options,
                           int units_per_em,
                           double largest_u) {
  RefitOptions refit;
  refit.units_per_em = units_per_em;
  refit.tolerance_u = kShare * options.tolerance / options.max_px;
  const double unit_u = 1024.0 / units_per_em;
  refit.grid_shift = format::outline::kMinGridShift;
  while (refit.grid_shift < format::outline::kMaxGridShift &&
         (std::ldexp(unit_u, refit.grid_shift + 1) <=
              kCoarsest * refit.tolerance_u ||
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
  Trials trials(shape, metrics, options, loop_options);
  const Outline united = unite(source);
  for (const auto& shares : kShares) {
    std::vector<Attempt> attempts;
    for (const double share : shares) {
      attempts.push_back({options, {}});
      attempts.back().options.tolerance_u *= share;
      if (trials.try_curves(source, attempts.back())) {
        return trials.best();
      }
    }
    // What is left are turns so tight that only chords draw them truly.
    for (Attempt& attempt : attempts) {
      if (trials.try_chords(united, attempt)) {
        return trials.best();
      }
    }
  }
  trials.try_polygons(united);
  return trials.best();
}

}  // namespace inkcell::gen
