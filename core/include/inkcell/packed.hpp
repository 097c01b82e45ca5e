// Packed glyphs: streams of bits in ROM, and their expansion into RAM.
//
// A packed glyph is expanded whole, or only those rows of its tiles that a
// strip touches. What is expanded is a GlyphField like any other; text.hpp does
// this for whole runs.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

/// 0 leaves the decoder out of the library: packed fonts are unsupported.
#ifndef INKCELL_PACKED
#  define INKCELL_PACKED INKCELL_FIELD_CELLS
#endif

namespace inkcell {

/// RAM for the expansion of one glyph at a time, lent by the caller. `data`
/// lies at a multiple of 2. Font::workspace_bytes says how much holds every
/// glyph. Tasks that draw at the same time need one each.
struct Workspace {
  uint8_t* data = nullptr;
  size_t size = 0;  // [bytes]

  constexpr Workspace() noexcept = default;
  constexpr Workspace(uint8_t* first, size_t bytes) noexcept
      : data(first), size(bytes) {}
  constexpr Workspace(Span<uint8_t> bytes) noexcept
      : data(bytes.data), size(bytes.size) {}
};

/// The kind of a field that a stream brings: bit 0 is set in arcs, bit 1 where
/// the direction is any and not one of the axes.
enum class FieldKind : uint8_t { axis = 0, axis_arc = 1, line = 2, arc = 3 };

constexpr bool is_bent(FieldKind kind) noexcept {
  return (static_cast<uint8_t>(kind) & 1) != 0;
}
constexpr bool has_angle(FieldKind kind) noexcept {
  return (static_cast<uint8_t>(kind) & 2) != 0;
}

/// Steps and widths of the numbers of new fields: `quantisation` of the font's
/// header. Any bytes are allowed.
struct PackedCoding {
  uint8_t d0_step = 0;    // [u/64]
  uint8_t bend_step = 0;  // [u/64]
  uint8_t d0_base = 0;    // [bits]
  uint8_t d0_log2 = 0;
  uint8_t angle_base = 0;  // [bits]
  uint16_t bend_k = 0;     // four bits for each level

  /// From the 8 bytes at `quantisation`.
  static PackedCoding read(const uint8_t* quantisation) noexcept;

  /// Bits of the numbers of a field that is new in a square of 2^log2 u.
  constexpr uint32_t d0_bits(uint32_t log2) const noexcept {
    return at_most_16(d0_base + (log2 > d0_log2 ? log2 - d0_log2 : 0));
  }
  constexpr uint32_t angle_bits(uint32_t log2) const noexcept {
    return at_most_16(angle_base + (log2 > 5 ? log2 - 5 : 0));
  }
  /// Bits of the bend behind its unary part.
  constexpr uint32_t bend_bits(uint32_t log2) const noexcept {
    const uint32_t level = log2 > 8 ? 0 : 8 - log2;
    return (uint32_t{bend_k} >> 4 * (level < 3 ? level : 3)) & 15;
  }

 private:
  static constexpr uint32_t at_most_16(uint32_t bits) noexcept {
    return bits < 16 ? bits : 16;
  }
};

/// A new field as the stream states it.
struct FieldCode {
  FieldKind kind = FieldKind::axis;
  int32_t d0 = 0;      // the distance at the anchor [d0_step]
  uint32_t angle = 0;  // quarters of a turn, or of 2^angle_bits a turn
  int32_t bend = 0;    // [bend_step]; 0 unless bent
};

/// A field as a record of cells of fields states it (format::fields).
struct FieldNumbers {
  int16_t nx_q14 = 0;
  int16_t ny_q14 = 0;
  int16_t c_q4 = 0;      // [u]
  int16_t along_q4 = 0;  // [u], 0 unless bent
  int16_t bend = 0;      // [2^-19 / u], 0: a line
};

/// The numbers of a field that is new in a square of 2^log2 u, log2 up to 12,
/// with its anchor at (x_u, y_u), at most 2^13 in magnitude. What decoders
/// compute, so that a generator can know it, bit by bit. Any code is allowed;
/// numbers that do not fit are clamped.
FieldNumbers expand_field(const FieldCode& code,
                          const PackedCoding& coding,
                          uint32_t log2,
                          int32_t x_u,
                          int32_t y_u) noexcept;

/// One packed glyph, in ROM. Owns nothing: the bytes must outlive it.
/// A default-constructed one has no tiles.
struct PackedGlyph {
  Span<const uint8_t> record;
  PackedCoding coding;
  int16_t x0_u = 0;  // lower left corner of the grid
  int16_t y0_u = 0;
  uint8_t tiles_x = 0;  // of 256 u, 15 at most
  uint8_t tiles_y = 0;
  bool wide_rows = false;  // lengths of rows take two bytes
  uint16_t glyph = GlyphField::kNoGlyph;
  InkBox ink;

  /// A view of the glyph record `record` (docs/FORMAT.md, "Glyph record,
  /// type 3"), at any address. Any content is safe afterwards.
  ///
  /// corrupt: the grid leaves +-1984 u or has no tiles, or the rows do not fit
  /// `record`. unsupported: the record is of another type, or this build has
  /// no decoder. `out` is untouched unless the result is ok.
  static Status open(Span<const uint8_t> record,
                     const PackedCoding& coding,
                     PackedGlyph& out) noexcept;

  /// The glyph of a packed font; without tiles if it has no ink. As above, and
  /// no_glyph: there is no glyph of this id.
  static Status open(const Font& font,
                     uint16_t glyph,
                     PackedGlyph& out) noexcept;

  /// An empty field with the grid of `row_count` rows of tiles from `first_row`
  /// on, 0 the lowest: to see where they lie, with field_box.
  GlyphField grid(uint32_t first_row, uint32_t row_count) const noexcept;
};

/// Expands `row_count` rows of tiles from `first_row` on. `out` is the field of
/// just these: the same pictures as from the whole glyph where they lie, and
/// nothing elsewhere. It refers to `workspace`, whose content must stay as
/// long as `out` is used.
///
/// Needs 2 x out.heap_units bytes of the workspace, and about 500 bytes of
/// stack. Time is bounded by the workspace, whatever the stream says: a square
/// takes two bytes of it, at most format::linked::kMaxUnits squares fit, and no
/// square has more than three fields. Rows below `first_row` cost nothing.
///
/// corrupt: the stream does not make sense. buffer_small: the workspace does
/// not hold the rows. bad_argument: no such rows, or a misaligned workspace.
/// `out` is untouched unless the result is ok.
Status expand(const PackedGlyph& glyph,
              uint32_t first_row,
              uint32_t row_count,
              Workspace workspace,
              GlyphField& out) noexcept;

}  // namespace inkcell
