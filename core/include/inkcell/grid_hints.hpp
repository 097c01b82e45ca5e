// Reads the hints of a font: where strokes of its glyphs lie, for grid fitting.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// A height that edges of many glyphs share, such as the baseline.
struct GridZone {
  int32_t flat_u;       // height of flat edges
  int32_t overshoot_u;  // how much higher round edges lie
  bool is_top;          // ink is below it
};

/// Something horizontal in a glyph.
struct YHint {
  enum Kind : uint8_t {
    bar,    // a stroke
    serif,  // a thin bar at the end of a stem
    edge,   // in a zone, with nothing on its other side
    end     // of a stroke between two bars, free
  };
  static constexpr uint8_t kNoZone = 255;

  int32_t low_u;  // edges; the same of `edge` and `end`
  int32_t high_u;
  Kind kind;
  uint8_t zone;      // of one edge; kNoZone
  bool is_round;     // that edge passes the zone by its overshoot
  bool is_top;       // that edge is the upper one; edges, ends: ink is below
  bool is_standard;  // as wide as most bars
};

/// A vertical stem.
struct XHint {
  int32_t left_u;
  int32_t right_u;
  bool is_standard;  // as wide as most stems
};

/// The section GRID of a font, read in place: any bytes are safe, also those
/// that change. Without the section it is empty.
class GridHints {
 public:
  constexpr GridHints() noexcept = default;

  /// corrupt: the tables do not fit the section; `out` is then untouched.
  static Status open(const Font& font, GridHints& out) noexcept;

  bool empty() const noexcept { return section_ == nullptr; }
  uint32_t zone_count() const noexcept { return zone_count_; }
  /// `i` is below the count.
  GridZone zone(uint32_t i) const noexcept;
  /// That of the lower case; zone_count() or more: there is none.
  uint32_t x_zone() const noexcept { return x_zone_; }
  /// Widths of most stems and bars, 0 if there are none. [u]
  int32_t stem_width_u() const noexcept { return stem_width_u_; }
  int32_t bar_width_u() const noexcept { return bar_width_u_; }
  /// Whether bars are much thinner than stems.
  bool has_contrast() const noexcept;
  /// Whether glyphs have few bars, as old-style faces do: those gain less.
  bool has_few_bars() const noexcept;

 private:
  friend class GlyphHints;

  const uint8_t* section_ = nullptr;
  uint8_t code_bits_ = 0;
  uint8_t zone_count_ = 0;
  uint8_t x_zone_ = 0;
  uint8_t stem_width_u_ = 0;
  uint8_t bar_width_u_ = 0;
  uint8_t flags_ = 0;
};

/// The hints of one glyph, read one by one: all of y, then those of x.
class GlyphHints {
 public:
  /// There are at most as many.
  static constexpr uint32_t kMostY = 15;
  static constexpr uint32_t kMostX = 7;

  /// `record`: Font::record().
  GlyphHints(const GridHints& hints,
             const Span<const uint8_t>& record) noexcept;

  bool is_symmetric() const noexcept { return (head_ & kSymmetric) != 0; }
  /// How much narrower the ink is on either side without serifs. [u]
  int32_t left_inset_u() const noexcept { return left_inset_u_; }
  int32_t right_inset_u() const noexcept { return right_inset_u_; }
  uint32_t y_count() const noexcept { return head_ >> kYShift & kMostY; }
  uint32_t x_count() const noexcept { return head_ & kMostX; }

  /// At most as often as the counts say.
  YHint next_y() noexcept;
  XHint next_x() noexcept;

  /// Bits that were read.
  uint32_t bits() const noexcept { return bit_; }

 private:
  static constexpr uint32_t kYShift = 3;
  static constexpr uint32_t kSymmetric = 0x100;

  uint32_t window() const noexcept;
  uint32_t take(uint32_t table) noexcept;
  int32_t take_width(uint32_t table, bool& is_standard) noexcept;

  const GridHints& hints_;
  const uint8_t* end_;  // of the record
  uint32_t size_;
  uint32_t bit_ = 0;   // the next one, from the end
  uint32_t y_at_ = 0;  // where the last one ended [2 u]
  uint32_t x_at_ = 0;
  uint32_t head_ = 0;  // as format::grid has it
  uint8_t left_inset_u_ = 0;
  uint8_t right_inset_u_ = 0;
};

}  // namespace inkcell
