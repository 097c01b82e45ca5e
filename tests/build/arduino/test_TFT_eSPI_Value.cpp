// The panel holds a label and the second value alone, in either order of bytes.
#include "TFT_eSPI_Value.ino"
#include "expected.hpp"

static uint16_t wanted[240 * 240];

// Values one after the other, and the second as text: the second alone is left.
static const struct {
  float first;
  float second;
  const char* text;
} kValues[] = {{21.5f, 21.1f, "21.1"},
               {10.3f, 9.9f, "9.9"},
               {100.5f, 9.5f, "9.5"},
               {-10.1f, 0.4f, "0.4"}};

int main() {
  const Expected small(fonts::dejavu_sans_latin1, 24, false);
  const Expected large(fonts::dejavu_sans_latin1, 48, false);
  int result = !small.is_good || !large.is_good;
  for (int round = 0; round < 8; ++round) {
    const auto& value = kValues[round / 2];
    tft.setSwapBytes(round % 2 == 1);
    setup();
    temperature = value.first;
    loop();
    temperature = value.second;
    loop();
    for (uint16_t& pixel : wanted) {
      pixel = TFT_NAVY;
    }
    const auto canvas =
        inkcell::port::gfx_canvas16(wanted, 240, 240, TFT_WHITE);
    small.draw(canvas, 16, 48, "Living room");
    large.draw(canvas, 16, 150, value.text, " \u00B0C ");
    result |= compare("TFT_eSPI", tft.memory, wanted, 240 * 240);
  }
  return result;
}
