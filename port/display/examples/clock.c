// clock.cpp in C99: a clock whose digits turn into each other, on a colour
// panel of 240 x 320 px, ILI9341 on SPI.
//
// Coming from u8g2 or TFT_eSPI in C: there is no such call. A digit is
//
//   u8g2_DrawGlyph(&u8g2, x, y, '7')   inkcell_outline_morph_draw(), which
//   takes
//                                      x and y in 1/64 px, and the progress
//   tft.setRotation(1)                 .rotation = INKCELL_ROTATION_QUARTER
//   tft.fillScreen(paper)              inkcell_run_strips(&loop, NULL)
#include <fonts/digits_c.h>
#include <inkcell/inkcell.h>

#include "your_board.h"

#define INK INKCELL_RGB565_OF(255, 217, 160)
#define PAPER INKCELL_RGB565_OF(11, 15, 22)
#define BASELINE 155
#define FRAMES 20  // of a change
#define TRY INKCELL_RETURN_ON_ERROR

static const int32_t digit_x[] = {20, 82, 176, 238};
static const inkcell_rect_t digits = {20, 81, 300, 159};
static uint32_t pixels[INKCELL_STRIP_BYTES(INKCELL_RGB565, 320, 8) / 4];
static uint32_t points[1024];

typedef struct screen_t {
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_outline_morph_t digits[4];
  int32_t progress_q16;
} screen_t;

static inkcell_status_t draw(void* context, const inkcell_strip_t* strip) {
  const screen_t* const screen = context;
  inkcell_rgb565_target_t target = {.strip = *strip, .colour = PAPER};
  inkcell_sink_t sink;
  const inkcell_status_t status = inkcell_rgb565_sink(&target, &sink);
  inkcell_fill(&sink);
  target.colour = INK;
  const inkcell_painter_t painter = {.sink = &sink,
                                     .ram = {(uint8_t*)points, sizeof points}};
  inkcell_draw_text(&painter, &screen->font, ":", INKCELL_TERMINATED,
                    &screen->style, INKCELL_Q6(144), INKCELL_Q6(BASELINE - 9));
  for (int i = 0; i < 4; ++i) {
    inkcell_outline_morph_draw(&screen->digits[i], &painter, &screen->style,
                               INKCELL_Q6(digit_x[i]), INKCELL_Q6(BASELINE),
                               screen->progress_q16);
  }
  return status;
}

// The digits of one time become those of another.
static inkcell_status_t set(screen_t* screen, uint32_t from, uint32_t to) {
  static const uint32_t minutes[] = {600, 60, 10, 1};  // of a step of a digit
  static const uint32_t steps[] = {10, 10, 6, 10};
  for (int i = 0; i < 4; ++i) {
    uint16_t a;
    uint16_t b;
    TRY(inkcell_font_glyph_of(&screen->font, '0' + from / minutes[i] % steps[i],
                              &a));
    TRY(inkcell_font_glyph_of(&screen->font, '0' + to / minutes[i] % steps[i],
                              &b));
    // A pair that the font does not hold changes at once.
    if (inkcell_outline_morph_open(&screen->font, a, b, &screen->digits[i]) !=
        INKCELL_OK) {
      TRY(inkcell_outline_morph_open(&screen->font, b, b, &screen->digits[i]));
    }
  }
  return INKCELL_OK;
}

static inkcell_status_t run(void) {
  inkcell_dcs_panel_t display = {.bus = {.command = write_command,
                                         .data = write_data,
                                         .reset = pulse_reset,
                                         .wait_ms = wait_ms},
                                 .width = 240,
                                 .height = 320,
                                 .rotation = INKCELL_ROTATION_QUARTER,
                                 .mirror_columns = true,  // as most modules
                                 .blue_first = true};
  screen_t screen = {.progress_q16 = 0};
  TRY(inkcell_ili9341_init(&display));
  TRY(inkcell_font_open(digits_c, digits_c_size, &screen.font));
  TRY(inkcell_style_make(INKCELL_Q6(96), &inkcell_filter_motion,
                         &screen.style));
  if (inkcell_outline_morph_workspace_bytes(&screen.font) > sizeof points) {
    return INKCELL_BUFFER_SMALL;
  }
  const inkcell_strip_loop_t loop = {.buffer = (uint8_t*)pixels,
                                     .size = sizeof pixels,
                                     .format = INKCELL_RGB565,
                                     .order = INKCELL_HIGH_FIRST,
                                     .width = 320,
                                     .height = 240,
                                     .context = &screen,
                                     .draw = draw,
                                     .display = &display,
                                     .flush = inkcell_ili9341_write};
  uint32_t shown = read_minutes();
  TRY(set(&screen, shown, shown));
  TRY(inkcell_run_strips(&loop, NULL));
  for (;;) {
    const uint32_t now = read_minutes();
    TRY(set(&screen, shown, now));
    for (int i = 1; now != shown && i <= FRAMES; ++i) {
      screen.progress_q16 = inkcell_ease_in_out(INKCELL_Q16(1) * i / FRAMES);
      TRY(inkcell_run_strips(&loop, &digits));
      wait_ms(NULL, 20);
    }
    shown = now;
    wait_ms(NULL, 1000);
  }
}

int main(void) {
  return run();  // returns if something is wrong
}
