// What a font says about the edges of its glyphs, for grid fitting.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// A height at which glyphs have horizontal edges.
struct HintLevel {
  int32_t height_u;
  /// The number of the zone it belongs to, and 1; 0: none.
  uint32_t zone;
};

/// A height that the font's glyphs share, such as that of the lower case.
struct HintZone {
  int32_t height_u;  // of flat edges; others pass it outwards
  bool is_bottom;    // ink is above it
};

/// An edge of a glyph: the number of its level.
struct HintEdge {
  uint8_t level;
  bool is_bar;  // a horizontal stroke begins here, and ends at an edge above
};

/// The vertical stems of a glyph: the middle of the left-most one, and how much
/// farther to the right the second and the third stand. [u]
struct HintStems {
  int32_t first_u = 0;
  int32_t gap_u = 0;
  uint8_t count = 0;  // 0..3
};

/// The section HINT of a font, read in place: any bytes are safe, also those
/// that change. Without the section it is empty.
class Hints {
 public:
  constexpr Hints() noexcept = default;

  /// corrupt: the tables do not fit the section; `out` is then untouched.
  static Status open(const Font& font, Hints& out) noexcept;

  bool empty() const noexcept { return level_count_ == 0; }
  uint32_t level_count() const noexcept { return level_count_; }
  uint32_t zone_count() const noexcept { return zone_count_; }

  /// `i` is below the count.
  HintLevel level(uint32_t i) const noexcept;
  HintZone zone(uint32_t i) const noexcept;

  /// The edges of a glyph from low to high, a byte each. False if there is no
  /// such glyph or they leave the section; `out` is then empty.
  bool edges(uint32_t glyph, Span<const uint8_t>& out) const noexcept;

  /// What such a byte says. Its level may not exist.
  static HintEdge edge(uint8_t byte) noexcept;

  /// None if there is no such glyph.
  HintStems stems(uint32_t glyph) const noexcept;

  /// How wide most vertical stems are. [u]
  int32_t stem_width_u() const noexcept { return stem_width_u_; }

 private:
  friend class GlyphFit;

  Span<const uint8_t> section_;
  uint32_t rows_ = 0;  // where they begin in the section
  uint32_t lists_ = 0;
  uint16_t glyph_count_ = 0;
  uint16_t row_bits_ = 0;
  int16_t stem_base_u_ = 0;
  uint8_t level_count_ = 0;
  uint8_t zone_count_ = 0;
  uint8_t stem_width_u_ = 0;
  uint8_t start_bits_ = 0;
  uint8_t count_bits_ = 0;
  uint8_t stem_bits_ = 0;
  uint8_t gap_bits_ = 0;
};

}  // namespace inkcell
