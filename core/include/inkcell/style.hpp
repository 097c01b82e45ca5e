// How a run of glyphs is drawn: size, direction and filter.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/matrix.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

class Fit;
class Font;
class Style;
struct FinePoint;
struct GlyphMetrics;
struct GlyphWarp;

namespace detail {
struct OutlineFitter;
struct Slant;
struct StyleParts;

// Grid fitting of outlines.
extern const OutlineFitter kOutlineFitter;

// What glyphs need that are not upright.
extern const Slant kSlant;
}  // namespace detail

/// Between the ink of two glyphs, without kerning. [px]
struct FitGap {
  int32_t fitted_q6;
  int32_t designed_q6;
};

/// Grid fitting (fit.hpp has some). Styles are those that name it, with what
/// Style::set_fit() was given as their fit_options().
struct Fitter {
  /// Fills in `warp` for a glyph of outlines and of an upright style whose
  /// origin is at `origin`, and may move the origin.
  void (*fit)(const Font& font,
              const Style& style,
              uint16_t glyph,
              const GlyphMetrics& metrics,
              FinePoint& origin,
              GlyphWarp& warp) noexcept;
  /// Whether fitted glyphs have advances of their own, in whole pixels.
  bool (*has_advances)(const Style& style) noexcept;
  /// Such an advance. [px]
  int32_t (*advance_px)(const Font& font,
                        const Style& style,
                        uint16_t glyph) noexcept;
  /// What lies between the ink of two glyphs that follow each other.
  FitGap (*gap)(const Font& font,
                const Style& style,
                uint16_t left,
                uint16_t right) noexcept;
  /// What moves the points of outlines, linked with the fitter.
  const detail::OutlineFitter* outlines = &detail::kOutlineFitter;
};

/// Smallest and largest size: 4 and 1024 px to the em.
inline constexpr Q26_6 kMinSize = Q26_6::from_int(4);
inline constexpr Q26_6 kMaxSize = Q26_6::from_int(1024);

/// The least and the greatest stretch of a matrix, over all directions. [px to
/// the em]
struct Stretch {
  Q26_6 least;
  Q26_6 greatest;

  /// Whether a style has the matrix as it is.
  constexpr bool is_in_range() const noexcept {
    return least.raw >= kMinSize.raw && greatest.raw <= kMaxSize.raw;
  }
};
/// The least and the greatest size at which a matrix draws.
Stretch stretch_of(const Matrix& matrix) noexcept;

/// Size, direction and filter of text. Cannot fail, and can be a constant:
///
///   constexpr Style kTitle = Style(24_px);
///
/// Shared by any number of drawing calls. The filter must outlive it,
/// unchanged; the linker drops the filters that a program does not name.
class Style {
 public:
  /// 16 px/em, upright, exact coverage.
  constexpr Style() noexcept : Style(16_px) {}

  /// An upright style of `size` px to the em. The size is clamped to
  /// kMinSize..kMaxSize.
  constexpr explicit Style(Q26_6 size,
                           const Filter& filter = kFilterArea) noexcept
      : filter_(&filter) {
    size_q6_ = detail::clamp(size.raw, kMinSize.raw, kMaxSize.raw);
    const auto size_q6 = static_cast<uint32_t>(size_q6_);
    // All else takes 2^32 over the size. [Q32] Of a power of two that is one
    // more than what 32 bits make of it.
    uint32_t over_q32 = UINT32_MAX / size_q6;
    limit_u_q10_ = static_cast<int32_t>(over_q32 >> 1);
    over_q32 += (size_q6 & (size_q6 - 1)) == 0 ? 1 : 0;
    // u to the px. 1024 u over size/64 px: 2^10 2^6 2^16 / size. [Q16]
    right_.x_q16 = static_cast<int32_t>(over_q32);
    up_.y_q16 = right_.x_q16;
  }

  /// A style that is turned. The direction is brought to a unit vector, unless
  /// it is one within 1/1000. {0, 0} is upright.
  Style(Q26_6 size, const Filter& filter, Direction direction) noexcept;

  /// A style that maps glyphs by `matrix`. A matrix that is not
  /// Stretch::is_in_range() is scaled; if its greatest stretch is more than 256
  /// times the least, the style is upright and has the greatest as its size.
  /// Distances are measured on the screen, so edges are equally sharp in all
  /// directions. Pictures keep the font's tolerance if both stretches lie in
  /// its range of sizes.
  ///
  /// Costs as much as turned text; about twice that where the two stretches
  /// differ.
  explicit Style(const Matrix& matrix,
                 const Filter& filter = kFilterArea) noexcept;

  /// Upright styles of the size at which capitals, or digits, are `height` px
  /// high from the baseline: H, or the highest digit; FontMetrics::cap_height
  /// where the font lacks them; the em where that is 0. Px to the em are no
  /// height: capitals take about seven tenths of it.
  static Style for_cap_height(const Font& font,
                              Q26_6 height,
                              const Filter& filter = kFilterArea) noexcept;
  static Style for_digit_height(const Font& font,
                                Q26_6 height,
                                const Filter& filter = kFilterArea) noexcept;

  /// A filter made in the argument would be gone before the style is used.
  static Style for_cap_height(const Font&, Q26_6, const Filter&&) = delete;
  static Style for_digit_height(const Font&, Q26_6, const Filter&&) = delete;
  Style(Q26_6, const Filter&&) = delete;
  Style(Q26_6, const Filter&&, Direction) = delete;
  Style(const Matrix&, const Filter&&) = delete;

  /// Fits glyphs of outlines to the grid of pixels, if the style is upright;
  /// other styles ignore it. Fitter and options must outlive the style. Before
  /// a call of set_fit() or clear_fit() the canvas decides: those of 1 and 2
  /// bits fit text (few_levels.hpp).
  constexpr Style& set_fit(const Fitter& fitter, const void* options) noexcept {
    is_fit_open_ = false;
    if (is_upright()) {
      fitter_ = &fitter;
    }
    fit_options_ = options;
    return *this;
  }
  /// The same with kGridFit: defined in fit.hpp.
  constexpr Style& set_fit(const Fit& fit) noexcept;
  Style& set_fit(const Fit&&) = delete;
  /// Glyphs stay as designed, on any canvas.
  constexpr Style& clear_fit() noexcept {
    is_fit_open_ = false;
    fitter_ = nullptr;
    return *this;
  }

  bool is_fitted() const noexcept { return fitter() != nullptr; }
  const Fitter* fitter() const noexcept { return fitter_; }
  const void* fit_options() const noexcept { return fit_options_; }

  /// Whether the advances of glyphs are whole pixels, by fitting.
  bool has_whole_advances() const noexcept {
    return is_fitted() && fitter_->has_advances(*this);
  }

  /// Sets the effect that draws the glyphs (effect.hpp), which must outlive the
  /// style. Without one, the default, the filter alone makes coverage, which is
  /// the fastest. Font::check() refuses pairs of font and effect that draw
  /// nothing.
  constexpr Style& set_effect(const Effect& effect) noexcept {
    effect_ = &effect;
    return *this;
  }
  Style& set_effect(const Effect&&) = delete;
  constexpr Style& clear_effect() noexcept {
    effect_ = nullptr;
    return *this;
  }
  /// Null: none.
  constexpr const Effect* effect() const noexcept { return effect_; }

  /// Px to the em; of a matrix the greatest stretch.
  Q26_6 size() const noexcept { return Q26_6::from_raw(size_q6_); }
  const Filter& filter() const noexcept { return *filter_; }
  constexpr bool is_upright() const noexcept { return !is_slanted_; }
  /// Whether edges of different directions are stretched differently.
  bool is_stretched() const noexcept { return least_gain_q15_ != 1 << 15; }

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
  /// screen, and for one pixel up. Without a matrix these are {along, -across}
  /// and {across, along}; upright styles have along = 1024 / size, across = 0.
  const GlyphStep& right() const noexcept { return right_; }
  const GlyphStep& up() const noexcept { return up_; }

  /// Converts a distance from u to px; clamps it to [-32, 32] px. [Q10 -> Q10]
  int32_t to_px_q10(int32_t distance_u_q10) const noexcept {
    // The clamp keeps the product below 2^31 at every size.
    const int32_t limit = limit_u_q10_;
    return detail::clamp(distance_u_q10, -limit, limit) * size_q6_ >> 16;
  }

  /// Equal sizes and directions; the same filter, fitter and effect, by
  /// address.
  friend bool is_same(const Style& a, const Style& b) noexcept;

 private:
  friend struct detail::StyleParts;

  void set_slanted() noexcept {
    is_slanted_ = true;
    slant_ = &detail::kSlant;
  }

  int32_t size_q6_ = 0;      // [px/em]
  int32_t limit_u_q10_ = 0;  // what 32 px are at this size
  uint16_t least_gain_q15_ = 1 << 15;
  bool is_slanted_ = false;
  bool is_fit_open_ = true;
  GlyphStep right_ = {0, 0, 1 << 20, 0};
  GlyphStep up_ = {0, 0, 0, 1 << 20};
  Axes axes_;
  const Filter* filter_;
  const Fitter* fitter_ = nullptr;        // only of upright text
  const detail::Slant* slant_ = nullptr;  // only of other text
  const void* fit_options_ = nullptr;
  const Effect* effect_ = nullptr;
};

}  // namespace inkcell
