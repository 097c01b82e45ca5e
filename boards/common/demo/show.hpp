// Draws a whole screen strip by strip, and sends each to the display.
#pragma once

#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// Calls `draw` for every strip of the screen, of INKCELL_DEMO_ROWS rows each,
/// and passes the strip on to board::display_write().
void show(Status (*draw)(void*, const Strip&)) noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
