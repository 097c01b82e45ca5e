#include "boards.hpp"

#include <fonts/motion.hpp>
#include <stdexcept>

namespace inkcell::tools {
namespace boards {

#define INKCELL_BOARD(name) const BoardDisplay& name();
#include "boards.inc"
#undef INKCELL_BOARD

}  // namespace boards

const std::vector<const BoardDisplay*>& board_displays() {
  static const std::vector<const BoardDisplay*> list = {
#define INKCELL_BOARD(name) &boards::name(),
#include "boards.inc"
#undef INKCELL_BOARD
  };
  return list;
}

const BoardDisplay& find_board(const std::string& name) {
  std::string names;
  for (const BoardDisplay* board : board_displays()) {
    if (name == board->name) {
      return *board;
    }
    names += std::string(" ") + board->name;
  }
  throw std::runtime_error("board '" + name + "' is unknown; there are: none" +
                           names);
}

Span<const uint8_t> board_motion_font() {
  return fonts::motion;
}

}  // namespace inkcell::tools
