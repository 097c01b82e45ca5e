// ssd1681.cpp in C99: a temperature on e-paper of 200 x 200 px. The first
// picture is a full refresh; then only the box of the value is sent and
// refreshed.
//
// Coming from GxEPD2:
//
//   display.init()                       inkcell_ssd1680_init(&display)
//   display.setPartialWindow(x, y, w, h) the second argument of
//                                        inkcell_run_strips()
//   do ... while (display.nextPage())    inkcell_run_strips(), then
//                                        inkcell_ssd1680_refresh()
//   display.hibernate()                  inkcell_ssd1680_sleep(&display)
#include <fonts/paper_c.h>
#include <inkcell/inkcell.h>

#include "your_board.h"

#define TRY INKCELL_RETURN_ON_ERROR

static uint8_t pixels[200 / 8 * 200];

typedef struct screen_t {
  inkcell_font_t font;
  inkcell_style_t label;
  inkcell_style_t large;
  const char* value;
} screen_t;

static inkcell_status_t draw(void* context, const inkcell_strip_t* strip) {
  const screen_t* const screen = context;
  inkcell_mono_rows_target_t target = {*strip, 128, 1,
                                       INKCELL_HIGH_LEFT};  // white
  inkcell_sink_t sink;
  inkcell_status_t status = inkcell_mono_rows_sink(&target, &sink);
  inkcell_fill(&sink);
  target.level = 0;  // black
  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_draw_text(&painter, &screen->font,
                    "Outside, in \xC2\xB0"
                    "C",
                    INKCELL_TERMINATED, &screen->label, INKCELL_Q6(10),
                    INKCELL_Q6(40));
  inkcell_draw_text(&painter, &screen->font, screen->value, INKCELL_TERMINATED,
                    &screen->large, INKCELL_Q6(10), INKCELL_Q6(120));
  return status;
}

static inkcell_status_t send_shown(void* display,
                                   const inkcell_strip_t* strip) {
  return inkcell_ssd1680_write_plane(display, strip, INKCELL_PLANE_SHOWN);
}

static inkcell_status_t run(void) {
  inkcell_ssd1680_t display = {.bus = {.command = write_command,
                                       .data = write_data,
                                       .reset = pulse_reset,
                                       .wait_idle = wait_idle},
                               .controller = INKCELL_SSD1681,
                               .width = 200,
                               .height = 200};
  screen_t screen;
  TRY(inkcell_font_open(paper_c, paper_c_size, &screen.font));
  TRY(inkcell_ssd1680_init(&display));
  TRY(inkcell_style_make(INKCELL_Q6(20), &inkcell_filter_area, &screen.label));
  TRY(inkcell_style_make(INKCELL_Q6(72), &inkcell_filter_area, &screen.large));
  inkcell_style_fit_levels(&screen.label, 2);  // of 1 bit, also where nothing
  inkcell_style_fit_levels(&screen.large, 2);  // is drawn
  inkcell_strip_loop_t loop = {.buffer = pixels,
                               .size = sizeof pixels,
                               .format = INKCELL_MONO_ROWS,
                               .width = 200,
                               .height = 200,
                               .context = &screen,
                               .draw = draw,
                               .display = &display};
  inkcell_rect_t last = {0, 0, 200, 200};
  for (uint32_t count = 0;; ++count) {
    screen.value = read_temperature();
    inkcell_rect_t box;
    inkcell_box(NULL, &screen.font, screen.value, INKCELL_TERMINATED,
                &screen.large, INKCELL_Q6(10), INKCELL_Q6(120), &box);
    const bool is_full = count % 100 == 0;
    inkcell_rect_t part;
    inkcell_bounding_box(&last, &box, &part);
    loop.flush = inkcell_ssd1680_write;
    TRY(inkcell_run_strips(&loop, is_full ? NULL : &part));
    TRY(inkcell_ssd1680_refresh(
        &display, is_full ? INKCELL_REFRESH_FULL : INKCELL_REFRESH_PARTIAL));
    loop.flush = send_shown;
    TRY(inkcell_run_strips(&loop, is_full ? NULL : &part));
    last = box;
    wait_ms(NULL, 60000);
  }
}

int main(void) {
  return run();  // returns if something is wrong
}
