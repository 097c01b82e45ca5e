// Fonts of fields as a whole: for a factory test or after an update.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// Font::verify(), of a font of any coding, and all cells of one of fields:
/// every reference names a node or a cell that exists, nodes are numbered in
/// the order in which one meets them, and none divides a square of 1 u.
/// corrupt: something does not fit.
Status verify_fields(const Font& font) noexcept;

}  // namespace inkcell
