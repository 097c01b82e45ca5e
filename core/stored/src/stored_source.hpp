// Draws glyphs of stored fonts: by the source of outlines, from their page.
#pragma once

#include "inkcell/coding.hpp"

namespace inkcell {
namespace detail {

/// The coding of a stored font.
extern const Coding kStoredCoding;

}  // namespace detail
}  // namespace inkcell
