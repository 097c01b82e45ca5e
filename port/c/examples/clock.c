// A clock, strip by strip in RGB565. All strips but those that show a digit for
// the first time take it from the cache.
#include "examples.h"

typedef struct screen_t {
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_glyph_cache_t cache;
  const char* text;
  void (*send)(void* display, const inkcell_strip_t* strip);
  void* display;
} screen_t;

static inkcell_status_t draw_strip(void* context,
                                   const inkcell_strip_t* strip) {
  screen_t* screen = context;
  for (size_t i = 0; i < strip->size; ++i) {
    strip->pixels[i] = 0;
  }
  inkcell_rgb565_target_t target = {.strip = *strip,
                                    .colour = INKCELL_RGB565_OF(255, 200, 0)};
  inkcell_sink_t sink;
  const inkcell_status_t status = inkcell_rgb565_sink(&target, &sink);
  const inkcell_painter_t painter = {.sink = &sink, .cache = &screen->cache};
  inkcell_draw_text(&painter, &screen->font, screen->text, INKCELL_TERMINATED,
                    &screen->style, INKCELL_Q6(4), INKCELL_Q6(32));
  return status;
}

static inkcell_status_t send_strip(void* display,
                                   const inkcell_strip_t* strip) {
  const screen_t* screen = display;
  screen->send(screen->display, strip);
  return INKCELL_OK;
}

inkcell_status_t draw_clock(const void* rom,
                            size_t rom_size,
                            const char* text,
                            void (*send)(void* display,
                                         const inkcell_strip_t* strip),
                            void* display,
                            inkcell_glyph_cache_stats_t* stats) {
  static uint64_t ram[256];  // of the cache
  static uint8_t
      buffer[INKCELL_STRIP_BYTES(INKCELL_RGB565, CLOCK_WIDTH, CLOCK_ROWS)];
  screen_t screen;
  screen.text = text;
  screen.send = send;
  screen.display = display;
  inkcell_status_t status = inkcell_font_open(rom, rom_size, &screen.font);
  if (status == INKCELL_OK) {
    status =
        inkcell_style_make(INKCELL_Q6(30), &inkcell_filter_area, &screen.style);
  }
  if (status == INKCELL_OK) {
    status = inkcell_glyph_cache_make(ram, sizeof ram, NULL, &screen.cache);
  }
  if (status != INKCELL_OK) {
    return status;
  }

  const inkcell_strip_loop_t loop = {.buffer = buffer,
                                     .size = sizeof buffer,
                                     .format = INKCELL_RGB565,
                                     .width = CLOCK_WIDTH,
                                     .height = CLOCK_HEIGHT,
                                     .context = &screen,
                                     .draw = draw_strip,
                                     .display = &screen,
                                     .flush = send_strip};
  status = inkcell_run_strips(&loop, NULL);
  inkcell_glyph_cache_stats(&screen.cache, stats);
  return status;
}
