// The display of a board that has one.
//
// board.cmake says its size and its formats. The size arrives as the macros
// INKCELL_DISPLAY_WIDTH and INKCELL_DISPLAY_HEIGHT [px].
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace board {

/// Switches the display on. False if it is not there or does not have this
/// format.
bool display_init(port::PixelFormat format) noexcept;

/// Copies a strip in the display's format to its place on the screen, and
/// returns when it has been sent. The strip lies on the screen; its left edge
/// and width are whole bytes, its top and height whole pages.
void display_write(const Strip& strip) noexcept;

}  // namespace board
}  // namespace inkcell
