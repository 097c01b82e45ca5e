// Runs boards/example with a display in memory: its screen must become that of
// a full redraw of the last value.
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <inkcell/port/framebuffer.hpp>

#define INKCELL_DISPLAY_WIDTH 128
#define INKCELL_DISPLAY_HEIGHT 64
#define main sample_main
#include "main.cpp"
#undef main

static uint8_t shown[64 * 64], wanted[sizeof shown];
static size_t bytes_sent = 0;

bool board::display_init(port::PixelFormat format) noexcept {
  return format == port::PixelFormat::grey4;
}

Status board::display_write(const Strip& strip) noexcept {
  const port::Framebuffer display = {
      {shown, sizeof shown}, kFormat, kWidth, kHeight, 64};
  INKCELL_TRY(port::write(display, strip));
  bytes_sent += static_cast<size_t>(strip.stride * strip.height);
  if (__builtin_memcmp(shown, wanted, sizeof shown) == 0) {
    printf("20 values by %zu bytes\n", bytes_sent - sizeof shown);
    exit(bytes_sent > 10 * sizeof shown ? 4 : 0);
  }
  return Status::ok;
}

int main() {
  Font font;
  if (Font::open(fonts::sans, font) != Status::ok) {
    return 1;
  }
  Screen whole;
  whole.words = TextBox(font, kText, {0, 0, kWidth, 30}, Align::centre);
  whole.value = ValueLabel(font, kLarge, {kWidth / 2, 58}, Anchor::centre);
  whole.value.set(NumberText(235, 1), {});
  const Strip rows = {{wanted, sizeof wanted}, 0, 0, kWidth, kHeight, 64};
  int inked = 0;
  if (draw(&whole, rows) == Status::ok) {
    for (const uint8_t byte : wanted) {
      inked += byte != 0;
    }
  }
  if (inked < 300) {
    printf("%d bytes of the redraw have ink\n", inked);
    return 2;
  }
  alarm(20);  // the example does not end
  return sample_main() + 100;
}
