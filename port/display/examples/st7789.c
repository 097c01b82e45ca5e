// st7789.cpp in C99: a colour panel of 240 x 240 px, a label with an icon and
// Chinese characters, and a temperature, of which only the box is sent.
//
// Coming from TFT_eSPI or u8g2 in C:
//
//   tft.init()                      inkcell_st7789_init(&display)
//   u8g2_SetFont(&u8g2, font)       inkcell_style_make(INKCELL_Q6(24), ...)
//   u8g2_DrawUTF8(&u8g2, x, y, "A") inkcell_draw_text(), x and y in 1/64 px
//   tft.fillRect(...), print(value) inkcell_run_strips() over the box that
//                                   inkcell_value_label_set() gives
#include <fonts/room_c.h>
#include <inkcell/inkcell.h>

#include "your_board.h"

#define INK INKCELL_RGB565_OF(255, 255, 255)
#define PAPER INKCELL_RGB565_OF(0, 50, 90)
#define STRIP INKCELL_STRIP_BYTES(INKCELL_RGB565, 240, 8)
#define TRY INKCELL_RETURN_ON_ERROR

static uint32_t strips[2][STRIP / 4];

typedef struct screen_t {
  inkcell_font_t font;
  inkcell_style_t label;
  inkcell_style_t large;
  inkcell_value_label_t value;
} screen_t;

static inkcell_status_t draw(void* context, const inkcell_strip_t* strip) {
  const screen_t* const screen = context;
  inkcell_rgb565_target_t target = {.strip = *strip, .colour = PAPER};
  inkcell_sink_t sink;
  const inkcell_status_t status = inkcell_rgb565_sink(&target, &sink);
  inkcell_fill(&sink);
  target.colour = INK;
  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_draw_text(
      &painter, &screen->font, "\xEE\x80\x81 Living \xE5\xAE\xA2\xE5\x8E\x85",
      INKCELL_TERMINATED, &screen->label, INKCELL_Q6(16), INKCELL_Q6(48));
  inkcell_value_label_draw(&screen->value, &painter);
  return status;
}

static inkcell_status_t run(void) {
  inkcell_dcs_panel_t display = {
      .bus = {.command = write_command,
              .data = write_data,
              .start = start_data,
              .wait_sent = wait_sent,
              .reset = pulse_reset,
              .wait_ms = wait_ms},
      .width = 240,
      .height = 240,
      .inverted = true};  // as on most of these panels
  screen_t screen;
  TRY(inkcell_st7789_init(&display));
  TRY(inkcell_font_open(room_c, room_c_size, &screen.font));
  TRY(inkcell_style_make(INKCELL_Q6(24), &inkcell_filter_area, &screen.label));
  TRY(inkcell_style_make(INKCELL_Q6(80), &inkcell_filter_area, &screen.large));
  const inkcell_strip_loop_t loop = {.buffer = (uint8_t*)strips[0],
                                     .second = (uint8_t*)strips[1],
                                     .size = STRIP,
                                     .format = INKCELL_RGB565,
                                     .order = INKCELL_HIGH_FIRST,
                                     .width = 240,
                                     .height = 240,
                                     .context = &screen,
                                     .draw = draw,
                                     .display = &display,
                                     .flush = inkcell_st7789_write,
                                     .wait = inkcell_display_wait};
  inkcell_rect_t changed;
  inkcell_value_label_init(&screen.value, &screen.font, &screen.large,
                           INKCELL_Q6(16), INKCELL_Q6(150),
                           INKCELL_ANCHOR_LEFT);
  inkcell_value_label_set(&screen.value, NULL, read_temperature(),
                          INKCELL_TERMINATED, &changed);
  TRY(inkcell_run_strips(&loop, NULL));
  for (;;) {
    wait_ms(NULL, 1000);
    inkcell_value_label_set(&screen.value, NULL, read_temperature(),
                            INKCELL_TERMINATED, &changed);
    TRY(inkcell_run_strips(&loop, &changed));
  }
}

int main(void) {
  return run();  // returns if something is wrong
}
