// A firmware that shows the test picture. READY on the console says that it is
// on the screen.
#include "board.hpp"
#include "canvas.hpp"
#include "display.hpp"
#include "pattern.hpp"

int main(int, char**) {
  if (!inkcell::board::display_init(inkcell::demo::kFormat)) {
    inkcell::board::print("no display\n");
    return 1;
  }
  inkcell::demo::show_pattern();
  inkcell::board::print("READY\n");
  for (;;) {
  }
}
