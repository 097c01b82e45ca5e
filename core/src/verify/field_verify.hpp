// Whether all of a glyph's record makes sense.
#pragma once

#include "inkcell/field.hpp"

namespace inkcell {
namespace detail {

// Every reference names a node or a leaf that exists, nodes are numbered in the
// order in which one meets them, none divides a square of 1 u, and fields have
// unit normals and existing numbers.
bool field_fits(const GlyphField& field) noexcept;

}  // namespace detail
}  // namespace inkcell
