// What is sent to a board: INKCELL_SERIAL in its board.cmake.
#pragma once

namespace inkcell::board {

/// Waits for the next byte that the board's UART receives.
char console_read() noexcept;

}  // namespace inkcell::board
