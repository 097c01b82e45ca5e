// The boards' displays and demos, compiled from the firmware's sources.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::tools {

struct BoardDisplay {
  const char* name;     // of the board and its display's format
  const char* display;  // for display_of()
  int width;            // [px]
  int height;
  int rows;  // of a strip
  size_t state_bytes;

  // The demo. There is one instance, for one thread.
  Status (*open)() noexcept;
  void (*set_frame)(uint32_t frame) noexcept;
  void (*draw)(const Strip& strip) noexcept;
};

/// All boards with displays; at least one.
const std::vector<const BoardDisplay*>& board_displays();

/// Throws std::runtime_error that lists the names.
const BoardDisplay& find_board(const std::string& name);

/// The font of animated scenes on boards.
Span<const uint8_t> board_motion_font();

}  // namespace inkcell::tools
