// Expansion of the rows of a packed glyph, one after the other.
#pragma once

#include <stdint.h>

#include "inkcell/packed.hpp"

namespace inkcell {
namespace detail {

// PackedGlyph::open, into a glyph that is as it was constructed, for those who
// look at the result only if it is Status::ok.
Status read_packed(const Font& font, uint16_t glyph, PackedGlyph& out) noexcept;

// The fields that all rows of a glyph share, as an expansion left them in the
// workspace.
struct SharedFields {
  uint32_t bytes = 0;  // of their stream
  uint16_t units = 0;  // of the heap, with the references of the tiles
  uint16_t arcs = 0;   // a bit for each field
  uint8_t count = 0;
  uint8_t rows = 0;  // that were expanded with them; 0: they are not there
};

// inkcell::expand. The shared fields are read only once for all expansions of
// as many rows, of the same glyph into the same workspace, which nobody else
// writes to.
Status expand_rows(const PackedGlyph& glyph,
                   uint32_t first_row,
                   uint32_t row_count,
                   Workspace workspace,
                   SharedFields& shared,
                   GlyphField& out) noexcept;

}  // namespace detail
}  // namespace inkcell
