// A firmware that plays a scene, or stops at one of its frames.
//
// Arguments: frame=N shows frame N only. READY on the console says that the
// first frame is on the screen.
#include "arguments.hpp"
#include "board.hpp"
#include "canvas.hpp"
#include "display.hpp"
#include "motion.hpp"

int main(int argc, char** argv) {
  namespace board = inkcell::board;
  namespace demo = inkcell::demo;
  if (!board::display_init(demo::kFormat)) {
    board::print("no display\n");
    return 1;
  }
  if (demo::open_motion() != inkcell::Status::ok) {
    board::print("the scene does not open\n");
    return 1;
  }
  uint32_t frame = 0;
  const bool one_frame = demo::find_number(argc, argv, "frame=", frame);
  demo::show_motion(frame);
  board::print("READY\n");
  for (;;) {
    if (!one_frame) {
      demo::show_motion(++frame);
    }
  }
}
