// Pages of Chinese, from a font in any memory: on a board from its card, and on
// the host from a file. Both show the same. A pixel font, which is one of
// strikes alone, shows them at its size, and one of many scripts behind them.
#pragma once

#include <stdint.h>

#include "canvas.hpp"
#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// How many pages there are, with a pixel font one more; the numbers of others
/// are taken modulo that.
inline constexpr uint32_t kPages = 3;

/// Draws a page and passes it on to board::display_write(). Lines are laid out
/// and drawn one by one, so that a stored font still has a line's glyphs.
///
/// no_glyph: the font lacks characters, and .notdef stands there. Others: as
/// Fit::make(), lay_out() and display_write(); nothing is shown.
Status show_page(const Font& font, uint32_t page) noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
