// A test picture: every ink with every coverage, and a window in the middle.
#pragma once

namespace inkcell {
namespace demo {

/// Shows the picture, then sends the window with inverted coverage as a strip
/// of its own, whose left edge is not that of the screen.
void show_pattern() noexcept;

}  // namespace demo
}  // namespace inkcell
