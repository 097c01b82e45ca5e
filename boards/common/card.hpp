// The memory card of a board, if it has one: INKCELL_CARD in its board.cmake.
#pragma once

#include <stdint.h>

#include "inkcell/status.hpp"

namespace inkcell::board {

/// Starts the card. Call display_init() first: they may share their wires.
Status card_init() noexcept;

/// Reads from the card: Storage::read of a StoredFont that begins with the
/// card's first byte. Offset and count are multiples of 512.
bool card_read(void* context,
               uint32_t offset,
               uint8_t* bytes,
               uint32_t count) noexcept;

}  // namespace inkcell::board
