// Runs the tests of a program: on a board through its console, else on stdout.
#include "check.hpp"

#if INKCELL_BOARD_FIRMWARE
#  include "board.hpp"
#else
#  include <stdio.h>
#  include <stdlib.h>
#endif

namespace check {

void write(const char* text, size_t size) {
#if INKCELL_BOARD_FIRMWARE
  inkcell::board::console_write(text, size);
#else
  fwrite(text, 1, size, stdout);
#endif
}

const char* wanted_round() {
#if INKCELL_BOARD_FIRMWARE
  return nullptr;
#else
  return getenv("INKCELL_ROUND");
#endif
}

}  // namespace check

int main(int argc, char** argv) {
  return check::run(argc - 1, argv + 1);
}
