// The panel holds a label and the second value alone, in either order of bytes.
#include "TFT_eSPI_Value.ino"
#include "expected.hpp"

static uint16_t wanted[240 * 240];

int main() {
  const Expected small(fonts::dejavu_sans_latin1, 24, false);
  const Expected large(fonts::dejavu_sans_latin1, 48, false);
  int result = !small.is_good || !large.is_good;
  for (int round = 0; round < 2; ++round) {
    tft.setSwapBytes(round == 1);
    setup();
    temperature = 21.5f;
    loop();
    loop();
    for (uint16_t& pixel : wanted) {
      pixel = TFT_NAVY;
    }
    const auto canvas =
        inkcell::port::gfx_canvas16(wanted, 240, 240, TFT_WHITE);
    small.draw(canvas, 16, 48, "Living room");
    large.draw(canvas, 16, 150, "21.1", " \u00B0C ");
    result |= compare("TFT_eSPI", tft.memory, wanted, 240 * 240);
  }
  return result;
}
