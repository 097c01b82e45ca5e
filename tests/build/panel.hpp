// The panel of a sample that shows a value on 240 x 240 pixels, by its Screen
// and draw(): it must show the picture of the whole screen.
#pragma once

#include <stdio.h>
#include <stdlib.h>

static uint16_t panel[240 * 240], wanted[240 * 240];
static int pixels_sent = 0;

// Ends the program if the panel shows anything else than the value that is read
// now, or after two rounds: the second sends what changed alone.
static void check_round() {
  static int round_number = 0;
  Screen screen;
  const bool is_open =
      Font::open(fonts::dejavu_sans_latin1, screen.font) == Status::ok;
  screen.value = read_temperature();
  const Strip whole = {
      {reinterpret_cast<uint8_t*>(wanted), sizeof wanted}, 0, 0, 240, 240, 480};
  const bool is_drawn = draw(&screen, whole) == Status::ok;
  int others = 0;
  int inked = 0;
  for (int i = 0; i < 240 * 240; ++i) {
    others += panel[i] != wanted[i];
    inked += wanted[i] != kPaper;
  }
  printf("%d pixels sent, %d with ink, %d differ\n", pixels_sent, inked,
         others);
  if (!is_open || !is_drawn || others != 0 || inked < 1000) {
    exit(1);
  }
  if (++round_number == 2) {
    exit(pixels_sent > 240 * 240 + 240 * 240 / 3);
  }
}
