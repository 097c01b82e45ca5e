// The demo firmware: shows the scene frame by frame, or stops at one of them.
//
// Arguments: frame=N shows frame N only, and says how many instructions it
// cost. READY on the console says that the first frame is on the screen.
#include "arguments.hpp"
#include "board.hpp"
#include "counter.hpp"
#include "display.hpp"
#include "scene.hpp"
#include "show.hpp"

namespace {

namespace board = inkcell::board;
namespace demo = inkcell::demo;

demo::Scene scene;

void show_frame(uint32_t frame) noexcept {
  scene.set_frame(frame);
  demo::show([](void*, const inkcell::Strip& strip) {
    scene.draw(strip);
    return inkcell::Status::ok;
  });
}

// Shows a frame and says what it cost, where the board can count it.
void count_frame(uint32_t frame) noexcept {
#if defined(INKCELL_COUNTER_PICOSECONDS)
  const uint32_t count =
      board::count_instructions([frame] { show_frame(frame); });
  board::print_decimal(count);
  board::print(" instructions for a frame\n");
#else
  show_frame(frame);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (!board::display_init(demo::kFormat)) {
    board::print("no display\n");
    return 1;
  }
  if (scene.open() != inkcell::Status::ok) {
    board::print("the font does not open\n");
    return 1;
  }
  uint32_t frame = 0;
  const bool one_frame = demo::find_number(argc, argv, "frame=", frame);
  if (one_frame) {
    count_frame(frame);
  } else {
    show_frame(frame);
  }
  board::print("READY\n");
  for (;;) {
    if (!one_frame) {
      show_frame(++frame);
    }
  }
}
