// Records of glyphs as fields, in place: for those who look at the result only
// if it is Status::ok.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {
namespace detail {

// GlyphField::open, into a field that is as it was constructed.
Status read_record(Span<const uint8_t> record, GlyphField& field) noexcept;

// Font::field, likewise.
Status read_field(const Font& font, uint16_t glyph, GlyphField& field) noexcept;

}  // namespace detail
}  // namespace inkcell
