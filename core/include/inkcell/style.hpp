// How a run of glyphs is drawn: size, direction and filter.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/matrix.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

class Style;
class Font;
struct FinePoint;
struct GlyphMetrics;
struct GlyphWarp;
struct Sink;

/// Grid fitting (fit.hpp has one). `options` is what Style::set_fitter was
/// given.
struct Fitter {
  /// Fills in `warp` for a glyph of outlines and of an upright style whose
  /// origin is at `origin`, and may move the origin.
  void (*fit)(uint16_t glyph,
              const GlyphMetrics& metrics,
              const void* options,
              FinePoint& origin,
              GlyphWarp& warp) noexcept;
  /// Whether fitted glyphs have advances of their own, in whole pixels.
  bool (*has_advances)(const void* options) noexcept;
  /// Such an advance. [px]
  int32_t (*advance_px)(const Font& font,
                        uint16_t glyph,
                        const void* options) noexcept;
};

namespace detail {
struct Mixer;
struct OutlineFitter;
struct BandPainter;
struct Slant;

// What filters take; linked with the Style::make that names them.
extern const BandPainter kPaintPixelRamp;      // Filter::is_linear_pixel()
extern const BandPainter kPaintDistances;      // up to half a pixel
extern const BandPainter kPaintWideDistances;  // any filter
extern const BandPainter kPaintAreas;

// Inlined with make(), so that a filter that is known when the program is
// compiled links one of the three.
__attribute__((always_inline)) inline const BandPainter& painter_of(
    const Filter& filter) noexcept {
  if (filter.is_linear_pixel()) {
    return kPaintPixelRamp;
  }
  return filter.outside_q10 >= -512 && filter.inside_q10 <= 512
             ? kPaintDistances
             : kPaintWideDistances;
}

// Grid fitting of outlines.
extern const OutlineFitter kOutlineFitter;

// What glyphs need that are not upright.
extern const Slant kSlant;
}  // namespace detail

/// Draws glyphs in another way than one sample a pixel. Made by functions
/// beside the options that they take: outline_effect(), lcd_effect() and
/// others.
struct Effect {
  const detail::Mixer* mixer = nullptr;  // null: one sample a pixel
  const void* options = nullptr;
  /// How much farther than plain drawing it reaches on each side of a glyph, in
  /// pixels and in samples.
  uint8_t reach_px = 0;
};

/// Smallest and largest size: 4 and 1024 px to the em.
inline constexpr Q26_6 kMinSize = Q26_6::from_int(4);
inline constexpr Q26_6 kMaxSize = Q26_6::from_int(1024);

/// Size, direction and filter of a style. Built once, constant afterwards, in
/// the caller's memory; shared by any number of drawing calls. The filter must
/// outlive it, unchanged.
class Style {
 public:
  /// 16 px/em, upright. Draws nothing: make() selects the painter, so that a
  /// program links no other.
  constexpr Style() noexcept = default;

  /// An upright style of `size` px to the em. bad_argument: the size is outside
  /// kMinSize..kMaxSize; `out` is then untouched.
  __attribute__((always_inline)) static Status make(Q26_6 size,
                                                    const Filter& filter,
                                                    Style& out) noexcept {
    INKCELL_TRY(make_upright(size, filter, out));
    out.set_painter(detail::painter_of(filter));
    return Status::ok;
  }

  /// A style that is turned. bad_argument: also if the direction is not a unit
  /// vector within 1/1000.
  __attribute__((always_inline)) static Status make(Q26_6 size,
                                                    const Filter& filter,
                                                    Direction direction,
                                                    Style& out) noexcept {
    INKCELL_TRY(make_turned(size, filter, direction, out));
    out.set_painter(detail::painter_of(filter));
    return Status::ok;
  }

  /// A style that maps glyphs by `matrix`. bad_argument: the least or the
  /// greatest stretch of the matrix, over all directions, is outside [kMinSize,
  /// kMaxSize]. Distances are measured on the screen, so edges are equally
  /// sharp in all directions. Pictures keep the font's tolerance if both
  /// stretches lie in its range of sizes.
  ///
  /// Costs as much as turned text; about twice that where the two stretches
  /// differ.
  __attribute__((always_inline)) static Status make(const Matrix& matrix,
                                                    const Filter& filter,
                                                    Style& out) noexcept {
    INKCELL_TRY(make_mapped(matrix, filter, out));
    out.set_painter(detail::painter_of(filter));
    return Status::ok;
  }

  /// Styles with which glyphs of outlines are drawn with exact coverage: how
  /// much of each pixel lies inside. Fields take the ramp of a straight edge.
  static Status make(Q26_6 size, AreaFilter, Style& out) noexcept {
    INKCELL_TRY(make_upright(size, kFilterText, out));
    out.set_painter(detail::kPaintAreas);
    return Status::ok;
  }
  static Status make(Q26_6 size,
                     AreaFilter,
                     Direction direction,
                     Style& out) noexcept {
    INKCELL_TRY(make_turned(size, kFilterText, direction, out));
    out.set_painter(detail::kPaintAreas);
    return Status::ok;
  }
  static Status make(const Matrix& matrix, AreaFilter, Style& out) noexcept {
    INKCELL_TRY(make_mapped(matrix, kFilterText, out));
    out.set_painter(detail::kPaintAreas);
    return Status::ok;
  }

  /// make() without set_painter(), for filters that come with theirs.
  static Status make_upright(Q26_6 size,
                             const Filter& filter,
                             Style& out) noexcept;
  static Status make_turned(Q26_6 size,
                            const Filter& filter,
                            Direction direction,
                            Style& out) noexcept;
  static Status make_mapped(const Matrix& matrix,
                            const Filter& filter,
                            Style& out) noexcept;

  /// A filter made in the argument would be gone before the style is used.
  static Status make(Q26_6, const Filter&&, Direction, Style&) = delete;
  static Status make(Q26_6, const Filter&&, Style&) = delete;
  static Status make(const Matrix&, const Filter&&, Style&) = delete;

  /// Fits glyphs of outlines to the grid of pixels, if the style is upright;
  /// other styles ignore it. Fitter and options must outlive the style. Null,
  /// the default: glyphs stay as designed.
  void set_fitter(const Fitter* fitter, const void* options) noexcept {
    if (is_upright()) {
      fitter_ = fitter;
      outline_fitter_ = &detail::kOutlineFitter;
    }
    fitter_options_ = options;
  }
  bool is_fitted() const noexcept { return fitter() != nullptr; }
  const Fitter* fitter() const noexcept {
    return is_upright() ? fitter_ : nullptr;
  }
  const void* fitter_options() const noexcept { return fitter_options_; }

  /// Whether the advances of glyphs are whole pixels, by fitting.
  bool has_whole_advances() const noexcept {
    return is_fitted() && fitter_->has_advances(fitter_options_);
  }

  /// Sets the effect that draws the glyphs. `{}`, the default, takes one sample
  /// at the centre of each pixel and is the fastest. The effect's options must
  /// outlive the style. The linker drops the effects that a program does not
  /// name. check_effect() refuses pairs of font and effect that draw nothing.
  void set_effect(const Effect& effect) noexcept { effect_ = effect; }
  const Effect& effect() const noexcept { return effect_; }

  /// Px to the em; of a matrix the greatest stretch.
  Q26_6 size() const noexcept { return Q26_6::from_raw(size_q6_); }
  const Filter& filter() const noexcept { return *filter_; }
  bool is_upright() const noexcept { return !is_slanted_; }

  /// What the filter takes; null before make().
  const detail::BandPainter* painter() const noexcept { return painter_; }
  void set_painter(const detail::BandPainter& painter) noexcept {
    painter_ = &painter;
  }

  /// The functions that fit glyphs of outlines (a fitted style), or slant them
  /// (a style that is not upright). set_fitter() and make() link them.
  const detail::OutlineFitter& outline_fitter() const noexcept {
    INKCELL_ASSERT(is_fitted());
    return *outline_fitter_;
  }
  const detail::Slant& slant() const noexcept {
    INKCELL_ASSERT(!is_upright());
    return *slant_;
  }

  /// Whether edges of different directions are stretched differently, and the
  /// least stretch over the greatest.
  bool is_stretched() const noexcept { return least_gain_q15_ != 1 << 15; }
  int32_t least_gain_q15() const noexcept { return least_gain_q15_; }

  /// The glyph's axes on the screen, as vectors to the right and up. (x_right,
  /// x_up) is the direction of the baseline. Both have unit length unless the
  /// style comes from a matrix. [Q30]
  struct Axes {
    Fixed<int32_t, 30> x_right = Fixed<int32_t, 30>::from_raw(1 << 30);
    Fixed<int32_t, 30> x_up;
    Fixed<int32_t, 30> y_right;
    Fixed<int32_t, 30> y_up = Fixed<int32_t, 30>::from_raw(1 << 30);
  };
  const Axes& axes() const noexcept { return axes_; }
  Direction direction() const noexcept { return {axes_.x_right, axes_.x_up}; }

  /// The inverse: the step in the glyph for one pixel to the right on the
  /// screen, and for one pixel up.
  const GlyphStep& right() const noexcept { return right_; }
  const GlyphStep& up() const noexcept { return up_; }

  /// Without a matrix the step to the right is {along, -across} and the step up
  /// is {across, along}; upright styles have along = 1024 / size and across =
  /// 0. [u per px, Q16]
  int32_t step_along_q16() const noexcept { return right_.x_q16; }
  int32_t step_across_q16() const noexcept { return up_.x_q16; }

  /// Converts a distance from u to px; clamps it to [-32, 32] px. [Q10 -> Q10]
  int32_t to_px_q10(int32_t distance_u_q10) const noexcept {
    // The clamp keeps the product below 2^31 at every size.
    const int32_t limit = limit_u_q10_;
    distance_u_q10 = distance_u_q10 > limit ? limit : distance_u_q10;
    distance_u_q10 = distance_u_q10 < -limit ? -limit : distance_u_q10;
    return (distance_u_q10 * size_q6_) >> 16;
  }

  friend bool is_same(const Style& a, const Style& b) noexcept;

 private:
  struct Stretch;
  Status set_size(const Stretch& stretch, const Filter& filter) noexcept;
  void set_slanted() noexcept {
    is_slanted_ = true;
    slant_ = &detail::kSlant;
  }

  int32_t size_q6_ = 16 << 6;      // [px/em]
  int32_t limit_u_q10_ = 2097151;  // what 32 px are at this size
  uint16_t least_gain_q15_ = 1 << 15;
  bool is_slanted_ = false;
  GlyphStep right_ = {64 << 16, 0, 1 << 20, 0};
  GlyphStep up_ = {0, 64 << 16, 0, 1 << 20};
  Axes axes_;
  const Filter* filter_ = &kFilterText;
  const detail::BandPainter* painter_ = nullptr;
  const Fitter* fitter_ = nullptr;
  union {  // only upright text is fitted
    const detail::OutlineFitter* outline_fitter_ = nullptr;
    const detail::Slant* slant_;
  };
  const void* fitter_options_ = nullptr;
  Effect effect_;
};

/// Equal sizes and directions; the same filter, fitter and effect, by address.
bool is_same(const Style& a, const Style& b) noexcept;

}  // namespace inkcell
