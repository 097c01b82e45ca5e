// Distance fields of outline glyphs, generated on the device.
//
//   alignas(4) static uint8_t ram[16384];
//   GlyphField field;
//   INKCELL_TRY(generate_field(font, glyph, {}, ram, field));
//   draw_field(field, style, origin, sink);
//
// Perry and Frisken, section 3.3.2: a font stores outlines, and a quadtree of
// cells with nine samples each is made of them on demand. The field serves all
// that takes a GlyphField: distance_at() and gradient_at() at any point,
// supersampling, splats, motion blur, effects far from the edge. To draw text,
// draw outlines themselves: that is faster and takes less RAM.
#pragma once

#include <stdint.h>

#include "inkcell/field/glyph_field.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// How good a generated field is, and where.
struct FieldLimits {
  static constexpr int32_t kMaxBand = 256;
  static constexpr int32_t kMaxFar = 480;
  static constexpr Q22_10 kMinTolerance = Q22_10::from_raw(64);
  static constexpr Q22_10 kMaxTolerance = Q22_10::from_int(64);

  /// A cell is divided while it differs by more than this from the distance at
  /// one of 16 points between its samples; down to 2 u. Between these points it
  /// may differ by about twice as much. 1/16..64 u.
  Q22_10 tolerance = Q22_10::from_int(1);
  /// Distances are good up to here on both sides of the edge; beyond, a query
  /// may answer kSaturatedDistanceQ10 with the right sign. 1..kMaxBand u.
  int32_t band_u = 32;
  /// Distances are good in all of the em box as well, 0..1024 u across and
  /// -256..768 u up, and around the ink: beyond the band within the tolerance
  /// and 1/64 of the distance, up to kMaxFar u. Farther away point_at() bounds
  /// the distance by the box of the ink. For simulations.
  bool fills_em = false;
};

/// Generates the field of a glyph of a font of outlines. `buffer` begins at a
/// multiple of 4. All of it is written to; afterwards its first record_bytes()
/// hold the field, as a glyph record of samples (docs/FORMAT.md), and must
/// outlive it. A glyph without ink needs no buffer.
///
/// Curves become chords that keep within tolerance / 4 of them. Coordinates are
/// of 1/64 u if ink and band fit 1024 u, of 1/32 u if they fit 2048 u, and so
/// on. What this costs, and how true fields are: docs/DESIGN.md.
///
/// Work is bounded whatever the font's bytes are: at most size / 2 squares (and
/// the tiles) are looked at, each at 26 points and from 32 max_points edges at
/// most, or size / 10 if those are fewer. The stack does not depend on the
/// glyph.
///
/// no_glyph: there is no glyph of this id. unsupported: the glyph is no
/// outline. bad_argument: the limits. misaligned: the buffer. buffer_small:
/// outline, field and 720 bytes do not fit. corrupt: the box of the glyph is
/// empty or leaves +-15000 u. `out` is untouched unless the result is ok.
Status generate_field(const Font& font,
                      uint16_t glyph,
                      const FieldLimits& limits,
                      Span<uint8_t> buffer,
                      GlyphField& out) noexcept;

/// The field of a glyph of any coding, for point_at(). Of outlines it is
/// generated in `buffer`; cells are a view of the font, and need none.
///
/// Errors: those of generate_field() and GlyphField::open(). beyond_band: cells
/// do not know all that the limits ask for: a font of outlines does, and of
/// cells one that was generated with a larger --band-px. The tolerance of cells
/// is the font's.
Status open_field(const Font& font,
                  uint16_t glyph,
                  const FieldLimits& limits,
                  Span<uint8_t> buffer,
                  GlyphField& out) noexcept;

}  // namespace inkcell
