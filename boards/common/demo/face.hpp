// One face at four sizes, from a font in any memory: on a board from a TrueType
// file on its card, and on the host from the same file. Both show the same.
#pragma once

#include "canvas.hpp"
#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// Draws the page and passes it on to board::display_write(), whose status it
/// returns.
Status show_face(const Font& font) noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
