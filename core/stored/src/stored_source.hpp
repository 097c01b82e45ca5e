// Draws glyphs of stored fonts: by the source of outlines, from their page.
#pragma once

#include "inkcell/coding.hpp"

namespace inkcell::detail {

/// The coding of a stored font.
extern const Coding kStoredCoding;

}  // namespace inkcell::detail
