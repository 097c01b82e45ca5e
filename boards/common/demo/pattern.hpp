// A test picture: every ink with every coverage, and a window in the middle.
#pragma once

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// Shows the picture, then sends the window with inverted coverage as a strip
/// of its own, whose left edge is not that of the screen.
void show_pattern() noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
