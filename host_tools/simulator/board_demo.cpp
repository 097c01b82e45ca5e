// The demo of one board's display; compiled for each, with its macros.
#include "boards.hpp"
#include "scene.hpp"

#define INKCELL_TEXT_OF(name) #name
#define INKCELL_TEXT(name) INKCELL_TEXT_OF(name)

namespace inkcell::tools::boards {
namespace {

demo::Scene scene;

}  // namespace

const BoardDisplay& INKCELL_DEMO_NAME();

const BoardDisplay& INKCELL_DEMO_NAME() {
  static const BoardDisplay display = {
      INKCELL_BOARD_NAME,
      INKCELL_TEXT(INKCELL_DEMO_FORMAT),
      demo::kWidth,
      demo::kHeight,
      INKCELL_DEMO_ROWS,
      sizeof scene,
      []() noexcept { return scene.open(); },
      [](uint32_t frame) noexcept { scene.set_frame(frame); },
      [](const Strip& strip) noexcept { scene.draw(strip); }};
  return display;
}

}  // namespace inkcell::tools::boards
