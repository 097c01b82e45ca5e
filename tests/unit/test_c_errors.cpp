// The interface for C: macros, names, and what calls that fail leave behind.
#include "check.hpp"
#include "inkcell/inkcell.h"
#include "inkcell/port/pixel.hpp"

using namespace inkcell;

namespace {

inkcell_sink_t no_sink() {
  inkcell_sink_t sink = {};
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t*, int32_t) {};
  sink.solid = [](void*, int32_t, int32_t, int32_t) {};
  return sink;
}

bool is_name(inkcell_status_t status, const char* expected) {
  const char* name = inkcell_status_name(status);
  while (*name != '\0' && *name == *expected) {
    ++name;
    ++expected;
  }
  return *name == *expected;
}

}  // namespace

TEST(status_names) {
  CHECK(is_name(INKCELL_OK, "ok"));
  CHECK(is_name(INKCELL_BUFFER_SMALL, "buffer_small"));
  CHECK(is_name(INKCELL_BEYOND_BAND, "beyond_band"));
  CHECK(is_name(INKCELL_READ_FAILED, "read_failed"));
  CHECK(is_name(INKCELL_NEEDS_SHAPING, "needs_shaping"));
  CHECK(is_name(13, "unknown"));
  CHECK(is_name(255, "unknown"));
}

TEST(bytes_of_strips_are_those_of_cpp) {
  for (int format = 0; format <= INKCELL_XRGB8888; ++format) {
    const auto same = static_cast<port::PixelFormat>(format);
    CHECK_EQ(INKCELL_ROWS_PER_STRIDE(format), port::rows_per_stride(same));
    for (int32_t width = 0; width < 40; ++width) {
      CHECK_EQ(INKCELL_STRIDE_BYTES(format, width),
               port::stride_bytes(same, width));
      CHECK_EQ(INKCELL_STRIP_BYTES(format, width, width / 2),
               port::strip_bytes(same, width, width / 2));
    }
  }
}

TEST(a_font_that_is_refused_is_empty) {
  inkcell_font_t font;
  __builtin_memset(&font, 0xff, sizeof font);
  alignas(4) const uint8_t bytes[64] = {9};
  CHECK_EQ(inkcell_font_open(bytes, sizeof bytes, &font), INKCELL_BAD_MAGIC);
  CHECK_EQ(inkcell_font_glyph_count(&font), 0);
  uint16_t glyph = 7;
  CHECK_EQ(inkcell_font_glyph_of(&font, 'A', &glyph), INKCELL_NO_GLYPH);
  CHECK_EQ(glyph, 0);
  inkcell_glyph_metrics_t metrics;
  CHECK_EQ(inkcell_font_glyph_metrics(&font, 0, &metrics), INKCELL_NO_GLYPH);
  CHECK_EQ(metrics.advance, 0);
  size_t size = 1;
  inkcell_font_name(&font, &size);
  CHECK_EQ(size, 0);
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(16 << 6, &inkcell_filter_text, &style),
           INKCELL_OK);
  const inkcell_sink_t sink = no_sink();
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  inkcell_draw_text(&painter, &font, "A", 1, &style, 0, 0);
}

TEST(styles_out_of_range_are_refused) {
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(3 << 6, &inkcell_filter_area, &style),
           INKCELL_BAD_ARGUMENT);
  CHECK_EQ(inkcell_style_size(&style), 0);
  CHECK_EQ(inkcell_style_make_turned(16 << 6, &inkcell_filter_text, 1 << 30,
                                     1 << 29, &style),
           INKCELL_BAD_ARGUMENT);
  CHECK_EQ(inkcell_style_make_turned(1025 << 6, &inkcell_filter_text, 1 << 30,
                                     0, &style),
           INKCELL_BAD_ARGUMENT);
  CHECK_EQ(inkcell_style_make_turned(16 << 6, &inkcell_filter_text, INT32_MIN,
                                     INT32_MIN, &style),
           INKCELL_BAD_ARGUMENT);
  const inkcell_matrix_t flat = {16 << 16, 0, 0, 0};
  CHECK_EQ(inkcell_style_make_mapped(&flat, &inkcell_filter_motion, &style),
           INKCELL_BAD_ARGUMENT);
  const inkcell_matrix_t lean = {16 << 16, 0, 4 << 16, 16 << 16};
  CHECK_EQ(inkcell_style_make_mapped(&lean, &inkcell_filter_motion, &style),
           INKCELL_OK);
}

TEST(sinks_that_do_not_fit_are_refused) {
  uint8_t pixels[16] = {};
  inkcell_mono_rows_target_t rows = {
      {pixels, sizeof pixels, 0, 0, 32, 4, 4, 0}, 0, 1, INKCELL_HIGH_LEFT};
  inkcell_sink_t sink;
  CHECK_EQ(inkcell_mono_rows_sink(&rows, &sink), INKCELL_BAD_ARGUMENT);
  CHECK_EQ(sink.window.x1, 0);
  rows.threshold = 128;
  CHECK_EQ(inkcell_mono_rows_sink(&rows, &sink), INKCELL_OK);
  CHECK_EQ(sink.window.x1, 32);
  inkcell_grey8_target_t grey = {{pixels, sizeof pixels, 0, 0, 5, 4, 5, 0},
                                 255};
  CHECK_EQ(inkcell_grey8_sink(&grey, &sink), INKCELL_BUFFER_SMALL);
  grey.strip.stride = 4;
  CHECK_EQ(inkcell_grey8_sink(&grey, &sink), INKCELL_BAD_ARGUMENT);
}

TEST(caches_and_loops_are_checked) {
  alignas(8) static uint8_t ram[1024];
  inkcell_glyph_cache_t cache;
  inkcell_glyph_cache_options_t options = {};
  CHECK_EQ(inkcell_glyph_cache_make(ram, 100, nullptr, &cache),
           INKCELL_BUFFER_SMALL);
  CHECK_EQ(inkcell_glyph_cache_make(ram + 1, 1000, nullptr, &cache),
           INKCELL_MISALIGNED);
  options.bits = 5;
  CHECK_EQ(inkcell_glyph_cache_make(ram, sizeof ram, &options, &cache),
           INKCELL_BAD_ARGUMENT);
  inkcell_glyph_cache_clear(&cache);
  inkcell_glyph_cache_stats_t stats;
  inkcell_glyph_cache_stats(&cache, &stats);
  CHECK_EQ(stats.capacity, 0);
  options.bits = 8;
  CHECK_EQ(inkcell_glyph_cache_make(ram, sizeof ram, &options, &cache),
           INKCELL_OK);

  uint8_t buffer[8];
  inkcell_strip_loop_t loop = {};
  loop.buffer = buffer;
  loop.size = sizeof buffer;
  loop.width = 4;
  loop.height = 3;
  loop.format = INKCELL_GREY8;
  CHECK_EQ(inkcell_run_strips(&loop, nullptr), INKCELL_BAD_ARGUMENT);
  int32_t rows[2] = {};
  loop.context = rows;
  loop.display = rows;
  loop.draw = [](void* context, const inkcell_strip_t* strip) {
    static_cast<int32_t*>(context)[0] += strip->height;
    return inkcell_status_t{INKCELL_OK};
  };
  loop.flush = [](void* context, const inkcell_strip_t* strip) {
    static_cast<int32_t*>(context)[1] += strip->y0;
    return strip->width == 1 ? inkcell_status_t{INKCELL_NO_GLYPH}
                             : inkcell_status_t{INKCELL_OK};
  };
  CHECK_EQ(inkcell_run_strips(&loop, nullptr), INKCELL_OK);
  CHECK_EQ(rows[0], 3);
  CHECK_EQ(rows[1], 2);
  const inkcell_rect_t part = {3, 1, 9, 9};
  CHECK_EQ(inkcell_run_strips(&loop, &part), INKCELL_NO_GLYPH);
  CHECK_EQ(rows[0], 5);
  CHECK_EQ(rows[1], 3);
  loop.second = buffer;
  CHECK_EQ(inkcell_run_strips(&loop, nullptr), INKCELL_BAD_ARGUMENT);
  loop.second = nullptr;
  loop.size = 3;
  CHECK_EQ(inkcell_run_strips(&loop, nullptr), INKCELL_BUFFER_SMALL);
}

TEST(motions_and_splats_are_checked) {
  static inkcell_motion_blur_t blur;
  CHECK_EQ(inkcell_motion_blur_make(33 << 6, 0, &blur), INKCELL_BAD_ARGUMENT);
  static uint32_t sums[64];
  inkcell_splat_t splat;
  CHECK_EQ(inkcell_splat_make(sums, 63, 1331, &splat), INKCELL_BUFFER_SMALL);
  CHECK_EQ(inkcell_splat_make(sums, 64, 100, &splat), INKCELL_BAD_ARGUMENT);
}
