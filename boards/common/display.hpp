// The display of a board, if it has one.
//
// board.cmake sets its size and formats. The size is passed as the macros
// INKCELL_DISPLAY_WIDTH and INKCELL_DISPLAY_HEIGHT [px].
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::board {

/// Switches the display on. False if it does not exist or lacks this format.
bool display_init(port::PixelFormat format) noexcept;

/// Copies a strip in the display's format to its place on the screen, and
/// returns when it has been sent. The strip must be on the screen; its left
/// edge and width must be whole bytes, its top and height whole pages: else the
/// driver says bad_argument or buffer_small, and nothing changes.
Status display_write(const Strip& strip) noexcept;

}  // namespace inkcell::board
