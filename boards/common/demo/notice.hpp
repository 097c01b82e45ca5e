// Notices as a watch shows them: from whom, and what, in any of some scripts.
// Their words are not known to the program: letters are joined, marks placed,
// syllables ordered as they come.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/text.hpp"
#include "inkcell/word_shaper.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// From whom and what, with a tab in between.
using Notice = Text;

/// The most that fit the screen, and the longest of them. [bytes]
inline constexpr size_t kMostNotices = 5;
inline constexpr size_t kMostNoticeBytes = 255;

/// Opens the fonts of the scripts.
Status open_notices() noexcept;
/// In the order of INKCELL_NOTICE_FONTS (demo.cmake).
Span<const Font> notice_fonts() noexcept;

/// Draws them below each other and passes them on to board::display_write().
void show_notices(Span<const Notice> notices, WordShaper& shaper) noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
