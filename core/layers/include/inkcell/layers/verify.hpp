// Whether the layers of a font are whole: for a factory test or after an
// update.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/status.hpp"
#include "inkcell/storage.hpp"

namespace inkcell {

/// Reads all layers of a font, which Font::verify() does not: docs/FORMAT.md
/// says what it finds. Never needed for safety. corrupt: something does not
/// fit. Those of a font in storage are read by `stored`, its own.
Status verify_layers(const Font& font,
                     const StoredLayers* stored = nullptr) noexcept;

}  // namespace inkcell
