// Glyph records of cells, in place.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {
namespace detail {

// GlyphField::open into a field that is as it was constructed. Its content has
// no meaning unless the result is Status::ok.
Status read_record(Span<const uint8_t> record, GlyphField& field) noexcept;

}  // namespace detail
}  // namespace inkcell
