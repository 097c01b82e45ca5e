// Whether the shaping of a font is whole: for a factory test or after an
// update.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// Reads all of section SHAP, which Font::verify() does not: docs/FORMAT.md
/// says what it finds. Never needed for safety. ok for a font without it;
/// corrupt: something does not fit.
Status verify_shaping(const Font& font) noexcept;

}  // namespace inkcell
