// How effects draw: for effects of one's own, with fonts of any coding.
//
// A glyph is drawn band by band. A band is some of its rows, a byte a pixel,
// with a margin of pixels around them if a mixer asks for one. What draws the
// font fills it; the mixer makes coverage of it, and hands that to the sink.
// docs/DRAW.md has an example, "An effect of your own".
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

class GlyphBand;
struct BandPlan;

/// The functions of an effect; in ROM. The effect that they are given is of the
/// type whose constructor names this mixer: cast it.
struct Mixer {
  /// What bands are filled with. Null: with what the style's filter takes, for
  /// GlyphBand::cover(). Else kDistances or kAreas, whatever the filter is.
  const detail::BandKind* band_kind;
  /// Changes the plan that the style's filter asks for.
  void (*plan)(const Effect& effect,
               const Style& style,
               BandPlan& plan) noexcept;
  /// Draws band.pixels() into band.sink().
  void (*mix)(const Effect& effect, GlyphBand& band) noexcept;
  /// Whether it draws glyphs of a field, or of outlines, with this style.
  /// False: Font::check() answers `unsupported`, and nothing is drawn. Null:
  /// always.
  bool (*can_draw)(const Effect& effect,
                   const Style& style,
                   bool is_field) noexcept = nullptr;
};

/// For Mixer::band_kind: distances, as far as the plan asks for.
inline constexpr const detail::BandKind* kDistances =
    &detail::kWideDistanceBand;
/// Exact coverage, in 1 or 3 samples a pixel, for cover().
inline constexpr const detail::BandKind* kAreas = &detail::kAreaBand;

/// What a mixer asks for; it finds here what the style's filter asks for, with
/// the kind of its bands. A picture must not depend on how a glyph
/// is cut into bands, so that a mixer reads no farther than the margins.
struct BandPlan {
  const detail::BandKind* band_kind = nullptr;
  /// How far from the edge distances are told apart, outside and inside: at
  /// most 4 px and a little, and one of them above 0. [px, Q8]
  int32_t outside_q8 = 0;
  int32_t inside_q8 = 0;
  /// How far outside of the edge a pixel's centre may show something. [px, Q8]
  int32_t ink_margin_q8 = 0;
  /// Samples a pixel, 1 or 3: columns of a band and rows. Only kAreas has 3, in
  /// one direction.
  uint8_t columns = 1;
  uint8_t rows = 1;
  /// Samples around the pixels that are drawn, 0 to 2.
  uint8_t margin_x = 0;
  uint8_t margin_y = 0;
  /// RAM for each sample, 1 to 3: the band's own byte, and those of
  /// GlyphBand::memory(). Three take no margins. [bytes]
  uint8_t sample_bytes = 1;
  /// How far GlyphBand::repaint() moves the glyph at most, to the sides and up
  /// and down. [px, Q8]
  int16_t moved_x_q8 = 0;
  int16_t moved_y_q8 = 0;

  /// Tells distances apart as far as the ramp of a filter reaches.
  void widen(const Filter& filter) noexcept {
    constexpr int32_t kRounding = 1;
    const int32_t outside = (-filter.outside_q10 >> 2) + kRounding;
    const int32_t inside = (filter.inside_q10 >> 2) + kRounding;
    outside_q8 = outside > outside_q8 ? outside : outside_q8;
    inside_q8 = inside > inside_q8 ? inside : inside_q8;
  }
  /// Shows pixels as far as a filter covers them.
  void show(const Filter& filter) noexcept {
    constexpr int32_t kRounding = 4;
    const int32_t outside = filter.outside_q10 < 0 ? -filter.outside_q10 : 0;
    ink_margin_q8 = (outside >> 2) + kRounding;
  }
};

/// The signed distances of a row that kDistances filled, from left to right.
class DistanceRow {
 public:
  /// The byte to begin at, of a row's first pixel, and the band's reach.
  DistanceRow(const uint8_t* at, int32_t reach_q8) noexcept
      : at_(at), step_q8_(reach_q8 * 1024 / 254) {}

  /// Passes over pixels.
  void skip(int32_t count) noexcept {
    for (; count != 0; --count) {
      inside_ ^= 0u - (*at_++ & 1u);
    }
  }
  /// The same of four whose bytes are 0.
  void skip_empty_word() noexcept { at_ += 4; }

  /// The distance of the next pixel, positive inside, clamped to the band's
  /// reach: in 254ths of that, and in px, Q10. For Filter::coverage().
  int32_t next_steps() noexcept {
    const uint32_t byte = *at_++;
    inside_ ^= 0u - (byte & 1);
    // The middle of a step.
    const auto steps = static_cast<int32_t>(255 - (byte & 254));
    return inside_ != 0 ? steps : -steps;
  }
  int32_t next_q10() noexcept { return next_steps() * step_q8_ >> 8; }

 private:
  const uint8_t* at_;
  int32_t step_q8_;      // a 254th of the reach [px, Q18]
  uint32_t inside_ = 0;  // all ones: the pixel to the left is inside
};

/// A band that is filled, for Mixer::mix().
class GlyphBand {
 public:
  const Style& style() const noexcept;
  const Sink& sink() const noexcept;

  /// The pixels to draw. They lie in the sink's window.
  const Rect& pixels() const noexcept;

  /// The sample of the row's first pixel, pixels().x0, of a band of one row a
  /// pixel. `y` may be in the margin, above or below. Rows are `stride()` bytes
  /// apart. Mixers may write to all that they may read.
  uint8_t* row(int32_t y) const noexcept;
  int32_t stride() const noexcept;

  /// The distances of a row of kDistances, from its first pixel on.
  DistanceRow distances(int32_t y) const noexcept;

  /// Makes coverage, 0 to 255, of what the band was filled with: by the style's
  /// filter, or exact. In place, margins included.
  void cover() const noexcept;

  /// Fills the band again, with the glyph moved by so much from where it was
  /// last. [px, Q8]
  void repaint(int32_t right_q8, int32_t down_q8) noexcept;

  /// The RAM that BandPlan::sample_bytes asked for: one or two bytes for each
  /// byte of the band, from a multiple of 4 on. Its bytes have no values.
  uint8_t* memory() const noexcept;

  /// Hands the bytes of pixels() to the sink as coverage.
  void emit() const noexcept;

 protected:
  GlyphBand() noexcept = default;
};

}  // namespace inkcell
