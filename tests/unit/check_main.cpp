// Runs the tests of a program: on a board through its console, else on stdout.
#include "check.hpp"

#if INKCELL_BOARD_FIRMWARE
#  include "board.hpp"
#else
#  include <stdio.h>
#endif

namespace check {

void write(const char* text, size_t size) {
#if INKCELL_BOARD_FIRMWARE
  inkcell::board::console_write(text, size);
#else
  fwrite(text, 1, size, stdout);
#endif
}

}  // namespace check

int main(int, char**) {
  return check::run_all();
}
