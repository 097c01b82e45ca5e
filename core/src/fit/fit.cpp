#include "inkcell/fit.hpp"

#include "base/math.hpp"
#include "fit/across_fit.hpp"
#include "fit/fit_units.hpp"
#include "fit/height_fit.hpp"

namespace inkcell {

using namespace detail;

// Lengths as in fit_units.hpp.
namespace {

// Fractions of an x-height from 1/8 px on are rounded up.
constexpr int32_t kRoundUp = kPx - kPx / 8;
// Shorter x-heights are not scaled.
constexpr int32_t kLeastHeight = 96;
// Round edges overshoot their zone from this height on.
constexpr int32_t kLeastOvershoot = 38;
// From this size on serifs are whole pixels, below it they are dropped.
constexpr int32_t kSerifsFrom = 16 << 6;
// Bends with moved control points are made fuller by this. [px, Q10]
constexpr int32_t kFuller = 30;
// Fractions of advances up to 9/16 px are rounded down: spaces can become wider
// by any length.
constexpr int32_t kRoundDown = kPx * 7 / 16;

}  // namespace

// Not inline for its size.
__attribute__((noinline)) bool AxisMap::add(int32_t from_q8,
                                            int32_t to_q8) noexcept {
  const auto is_near = [](int32_t value) noexcept {
    return static_cast<uint32_t>(value + kReachQ8) <= 2 * kReachQ8;
  };
  if (count >= kMaxKnots || !is_near(from_q8) || !is_near(to_q8)) {
    return false;
  }
  if (count != 0) {
    Knot& last = knots[count - 1];
    const int32_t length = from_q8 - last.from_q8;
    if (length <= 0) {
      return false;
    }
    to_q8 = to_q8 < last.to_q8 ? last.to_q8 : to_q8;
    // At most 2^30. Rounded down, so that no point passes the knot.
    last.slope_q14 =
        static_cast<int32_t>((static_cast<uint32_t>(to_q8 - last.to_q8) << 14) /
                             static_cast<uint32_t>(length));
  }
  knots[count] = {static_cast<int16_t>(from_q8), static_cast<int16_t>(to_q8),
                  kNoSlope};
  ++count;
  return true;
}

// Font units to u, clamped to 32 em.
inline int32_t Fit::u_of(int32_t units) const noexcept {
  constexpr int32_t kMost_u = (1 << 15) - 1;
  // In two parts, because the product may exceed 2^31.
  const int32_t whole = units * (u_per_unit_q14_ >> 14);
  const int32_t part = units * (u_per_unit_q14_ & ((1 << 14) - 1));
  const int32_t u = whole + ((part + (1 << 13)) >> 14);
  return min(max(u, -kMost_u), kMost_u);
}

inline void Fit::add_knot(AxisMap& map,
                          int32_t at_u,
                          int32_t to_q6) const noexcept {
  const int32_t from_q8 = (at_u * size_q6_ + (1 << 7)) >> 8;
  static_cast<void>(
      map.add(from_q8, from_q8 + ((to_q6 * 4 - from_q8) * strength_q8_ >> 8)));
}

inline void Fit::set_zones() noexcept {
  y_scale_q16_ = size_q6_ * (1 << 6);
  const uint32_t count = hints_.zone_count();
  if (hints_.x_zone() < count) {
    const int32_t natural = px_q6(hints_.zone(hints_.x_zone()).flat_u);
    if (natural >= kLeastHeight) {
      const int32_t fitted = (natural + kRoundUp) & ~(kPx - 1);
      // At most 40 px, plus a half.
      y_scale_q16_ = static_cast<int32_t>(static_cast<uint32_t>(size_q6_) * 64 *
                                          static_cast<uint32_t>(fitted) /
                                          static_cast<uint32_t>(natural));
    }
  }
  for (uint32_t i = 0; i != count; ++i) {
    const GridZone read = hints_.zone(i);
    const int32_t flat = round_px(height_q6(read.flat_u));
    const int32_t beyond = px_q6(read.overshoot_u);
    zones_[i] = {static_cast<int16_t>(flat),
                 static_cast<int16_t>(
                     abs(beyond) < kLeastOvershoot ? flat : flat + beyond)};
  }
}

Q6_10 Fit::bilevel_weight() const noexcept {
  if (strength_q8_ == 0 || hints_.stem_width_u() == 0) {
    return {};
  }
  // Half of what stems gain in width. [px, Q10]
  const int32_t more = (whole_width(stem_q6_) - stem_q6_) * 8;
  const int32_t weight = hints_.has_contrast()
                             ? min(max(more, 0), 51)
                             : min(max(more - kFuller, -256), 123);
  return Q6_10::from_raw(static_cast<int16_t>(-weight));
}

Status Fit::make(const Font& font,
                 const Style& style,
                 const FitOptions& options,
                 Fit& out) noexcept {
  if (options.strength_q8 > FitOptions::kAll || options.levels > 4 ||
      options.levels % 2 != 0) {
    return Status::bad_argument;
  }
  INKCELL_TRY(GridHints::open(font, out.hints_));
  FitOptions faded = options;
  const int32_t size_q6 = style.size().raw;
  if (options.levels == 0 && size_q6 > kFades.raw && size_q6 < kEnds.raw) {
    faded.strength_q8 =
        static_cast<uint16_t>(uint32_t{options.strength_q8} *
                              static_cast<uint32_t>(kEnds.raw - size_q6) /
                              static_cast<uint32_t>(kEnds.raw - kFades.raw));
  }
  out.set(font, style.size(), faded);
  return Status::ok;
}

// With the hints that were opened.
void Fit::set(const Font& font,
              Q26_6 size,
              const FitOptions& options) noexcept {
  is_across_ = false;
  size_q6_ = size.raw;
  strength_q8_ = size.raw < kEnds.raw ? options.strength_q8 : 0;
  if (strength_q8_ == 0) {
    return;
  }
  levels_ = options.levels;
  is_across_ = options.across && !hints_.empty();
  drops_serifs_ = options.levels == 2 && size.raw < kSerifsFrom;
  u_per_unit_q14_ =
      static_cast<int32_t>((uint32_t{1024} << 14) / font.units_per_em());
  stem_q6_ = px_q6(hints_.stem_width_u());
  bar_q6_ = px_q6(hints_.bar_width_u());
  set_zones();
}

// A place to the nearest pixel.
__attribute__((noinline)) void Fit::to_grid(int64_t& at_q10) const noexcept {
  const int32_t part =
      static_cast<int32_t>((static_cast<uint32_t>(at_q10) + 512) & 1023) - 512;
  at_q10 -= part * strength_q8_ >> 8;
}

// The entry points of grid fitting.
class GridFit {
 public:
  static void fit(const Font& font,
                  const Style& style,
                  uint16_t glyph,
                  const GlyphMetrics& metrics,
                  FinePoint& origin,
                  GlyphWarp& warp) noexcept {
    fit_both(fit_of(style), font, glyph, metrics, origin, warp);
  }

  static void heights(const Font& font,
                      const Style& style,
                      uint16_t glyph,
                      const GlyphMetrics&,
                      FinePoint& origin,
                      GlyphWarp& warp) noexcept {
    const Fit& fit = fit_of(style);
    GlyphHints hints(fit.hints_, font.record(glyph));
    fit_heights(fit, hints, origin, warp);
  }

  static bool has_advances(const Style& style) noexcept {
    return fit_of(style).has_advances();
  }
  static bool has_none(const Style&) noexcept { return false; }

  // Glyphs that are equally wide as designed stay so.
  static int32_t advance_px(const Font& font,
                            const Style& style,
                            uint16_t glyph) noexcept {
    return whole_advance(font, fit_of(style).size_q6_, font.advance(glyph)) >>
           6;
  }

  static FitGap gap(const Font& font,
                    const Style& style,
                    uint16_t left,
                    uint16_t right) noexcept {
    return gap_between(fit_of(style), font, left, right);
  }

  // The same for displays of few levels.
  template <uint8_t kLevels>
  static void fit_levels(const Font& font,
                         const Style& style,
                         uint16_t glyph,
                         const GlyphMetrics& metrics,
                         FinePoint& origin,
                         GlyphWarp& warp) noexcept {
    Fit fit;
    set(font, style, kLevels, fit);
    // Fonts without hints too, as advances are whole.
    fit.to_grid(origin.x_q10);
    fit_both(fit, font, glyph, metrics, origin, warp);
  }

  static void grey_heights(const Font& font,
                           const Style& style,
                           uint16_t glyph,
                           const GlyphMetrics& metrics,
                           FinePoint& origin,
                           GlyphWarp& warp) noexcept {
    Fit fit;
    set(font, style, 0, fit);
    fit.to_grid(origin.x_q10);
    fit.is_across_ = false;
    fit_both(fit, font, glyph, metrics, origin, warp);
  }

  static bool is_small(const Style& style) noexcept {
    return style.size().raw < Fit::kEnds.raw;
  }

  static int32_t level_advance_px(const Font& font,
                                  const Style& style,
                                  uint16_t glyph) noexcept {
    return whole_advance(font, style.size().raw, font.advance(glyph)) >> 6;
  }

  template <uint8_t kLevels>
  static FitGap level_gap(const Font& font,
                          const Style& style,
                          uint16_t left,
                          uint16_t right) noexcept {
    Fit fit;
    set(font, style, kLevels, fit);
    return gap_between(fit, font, left, right);
  }

 private:
  static const Fit& fit_of(const Style& style) noexcept {
    return *static_cast<const Fit*>(style.fit_options());
  }

  // Broken hints are none.
  __attribute__((noinline)) static void set(const Font& font,
                                            const Style& style,
                                            uint8_t levels,
                                            Fit& fit) noexcept {
    static_cast<void>(GridHints::open(font, fit.hints_));
    FitOptions options;
    options.across = true;
    options.levels = levels;
    fit.set(font, style.size(), options);
  }

  static void fit_both(const Fit& fit,
                       const Font& font,
                       uint16_t glyph,
                       const GlyphMetrics& metrics,
                       FinePoint& origin,
                       GlyphWarp& warp) noexcept {
    GlyphHints hints(fit.hints_, font.record(glyph));
    fit_heights(fit, hints, origin, warp);
    if (fit.is_across_) {
      fit.to_grid(origin.x_q10);
      fit_across(fit, metrics, hints,
                 whole_advance(font, fit.size_q6_, metrics.advance), warp.x);
    }
  }

  // To the nearest pixel. [px, Q6]
  static int32_t whole_advance(const Font& font,
                               int32_t size_q6,
                               int32_t units) noexcept {
    const int32_t em = font.units_per_em();
    return quotient(units * size_q6 + em * kRoundDown, em * 64) << 6;
  }

  __attribute__((noinline)) static FitGap gap_between(const Fit& fit,
                                                      const Font& font,
                                                      uint16_t left,
                                                      uint16_t right) noexcept {
    FitGap sum = {0, 0};
    for (uint32_t i = 0; i != 2; ++i) {
      uint32_t id = i == 0 ? left : right;
      const Font* const page = font.page_of(id);
      if (page == nullptr) {
        continue;
      }
      const auto own = static_cast<uint16_t>(id);
      GlyphMetrics metrics;
      static_cast<void>(page->glyph_metrics(own, metrics));
      GlyphHints hints(fit.hints_, page->record(own));
      for (uint32_t j = hints.y_count(); j != 0; --j) {
        static_cast<void>(hints.next_y());
      }
      AcrossFit across(fit);
      across.fit(metrics, whole_advance(font, fit.size_q6_, metrics.advance),
                 hints);
      const FitGap& room = i == 0 ? across.right() : across.left();
      sum.fitted_q6 += room.fitted_q6;
      sum.designed_q6 += room.designed_q6;
    }
    return sum;
  }

  // Separate frames, so that their stacks do not add up.
  __attribute__((noinline)) static void fit_heights(const Fit& fit,
                                                    GlyphHints& hints,
                                                    FinePoint& origin,
                                                    GlyphWarp& warp) noexcept {
    warp.clear();
    if (fit.strength_q8_ == 0) {
      return;
    }
    // The baseline lies between two rows.
    fit.to_grid(origin.y_q10);
    HeightFit heights(fit);
    heights.read(hints);
    heights.fit_free();
    heights.write(warp.y);
  }

  __attribute__((noinline)) static void fit_across(const Fit& fit,
                                                   const GlyphMetrics& metrics,
                                                   GlyphHints& hints,
                                                   int32_t advance,
                                                   AxisMap& map) noexcept {
    AcrossFit across(fit);
    across.fit(metrics, advance, hints);
    across.write(map);
  }
};

const Fitter kGridFit = {GridFit::fit, GridFit::has_advances,
                         GridFit::advance_px, GridFit::gap};
const Fitter kFitHeights = {GridFit::heights, GridFit::has_none, nullptr,
                            nullptr};
const Fitter kFitTwoLevels = {GridFit::fit_levels<2>, GridFit::is_small,
                              GridFit::level_advance_px, GridFit::level_gap<2>};
const Fitter kFitFourLevels = {GridFit::fit_levels<4>, GridFit::is_small,
                               GridFit::level_advance_px,
                               GridFit::level_gap<4>};
const Fitter kFitGrey = {GridFit::fit_levels<0>, GridFit::is_small,
                         GridFit::level_advance_px, GridFit::level_gap<0>};
const Fitter kFitGreyHeights = {GridFit::grey_heights, GridFit::is_small,
                                GridFit::level_advance_px,
                                GridFit::level_gap<0>};

}  // namespace inkcell
