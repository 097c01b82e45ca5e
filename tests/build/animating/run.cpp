// Runs the complete file of docs/ANIMATING.md with a screen in memory and a
// clock that only waits move: at the end the screen shows what a full
// redraw of the last number does.
#include <stdio.h>

#include <inkcell/port/framebuffer.hpp>

#define main animating_main
#include "main.cpp"
#undef main

alignas(2) static uint8_t shown[2 * 240 * 240], wanted[sizeof shown];
static uint32_t time_ms = 0;
static int strips = 0;

uint32_t ticks_ms() {
  return time_ms;
}

void wait_ms(uint32_t ms) {
  time_ms += ms;
}

Status send(void*, const Strip& strip) {
  const port::Framebuffer display = {
      {shown, sizeof shown}, port::PixelFormat::rgb565, 240, 240, 2 * 240};
  ++strips;
  return port::write(display, strip);
}

int main() {
  for (uint8_t& byte : shown) {
    byte = 0x55;
  }
  const int result = animating_main();
  Font font;
  if (result != 0 || Font::open(fonts::sans, font) != Status::ok) {
    return 1;
  }
  const Strip all = {{wanted, sizeof wanted}, 0, 0, 240, 240, 2 * 240};
  const port::Rgb565Canvas canvas(all, kInk, kPaper);
  Counter number(font, style, {8, 30}, 4);
  number.roll(1250, 1250, {});
  number.at(0);
  number.draw(Painter(canvas, Workspace(painter_ram)));
  int inked = 0;
  for (const uint8_t byte : wanted) {
    inked += byte != 0;
  }
  printf("%d strips in %u ms, %d bytes with ink\n", strips, time_ms, inked);
  const bool same = __builtin_memcmp(shown, wanted, sizeof shown) == 0;
  return same && inked > 500 && strips > 75 && time_ms < 2700 ? 0 : 2;
}
