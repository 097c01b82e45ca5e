// Rectangles, and the loop over strips.
#include "inkcell/strip.hpp"

#include "check.hpp"

namespace {

using namespace inkcell;

// What the loop was seen to do: draw and flush in turn, from top to bottom.
struct Log {
  int32_t next_y = 0;
  int32_t draws = 0;
  int32_t flushes = 0;
  uint8_t* buffer = nullptr;
};

void draw(void* context, const Strip& strip) {
  Log& log = *static_cast<Log*>(context);
  CHECK_EQ(log.draws, log.flushes);
  CHECK_EQ(strip.x0, 0);
  CHECK_EQ(strip.y0, log.next_y);
  CHECK_EQ(strip.width, 20);
  CHECK_EQ(strip.stride, 24);
  CHECK(strip.pixels.data == log.buffer);
  ++log.draws;
}

void flush(void* context, const Strip& strip) {
  Log& log = *static_cast<Log*>(context);
  ++log.flushes;
  CHECK_EQ(log.draws, log.flushes);
  CHECK_EQ(strip.y0, log.next_y);
  log.next_y += strip.height;
}

uint8_t buffer[20 * 24];

StripLoop make_loop(int32_t height, int32_t rows, Log& log) {
  log.buffer = buffer;
  StripLoop loop;
  loop.buffer = buffer;
  loop.width = 20;
  loop.height = height;
  loop.rows = rows;
  loop.stride = 24;
  loop.context = &log;
  loop.draw = draw;
  loop.flush = flush;
  return loop;
}

// Nothing is called unless all is well.
void check_refused(const StripLoop& loop, Status status) {
  const Log& log = *static_cast<const Log*>(loop.context);
  CHECK_EQ(run_strips(loop), status);
  CHECK_EQ(log.draws, 0);
}

}  // namespace

TEST(strips_cover_the_screen_once) {
  for (int32_t rows = 1; rows <= 20; ++rows) {
    for (int32_t height = 1; height <= 20; ++height) {
      Log log;
      CHECK_EQ(run_strips(make_loop(height, rows, log)), Status::ok);
      CHECK_EQ(log.next_y, height);
      CHECK_EQ(log.draws, (height + rows - 1) / rows);
    }
  }
  Log log;
  CHECK_EQ(run_strips(make_loop(10, INT32_MAX, log)), Status::ok);
  CHECK_EQ(log.next_y, 10);
}

TEST(sizes_and_functions_are_checked) {
  Log log;
  check_refused(make_loop(10, 0, log), Status::bad_argument);
  check_refused(make_loop(10, -1, log), Status::bad_argument);
  check_refused(make_loop(0, 8, log), Status::bad_argument);
  check_refused(make_loop(32768, 8, log), Status::bad_argument);
  StripLoop loop = make_loop(10, 8, log);
  loop.width = 0;
  check_refused(loop, Status::bad_argument);
  loop = make_loop(10, 8, log);
  loop.draw = nullptr;
  check_refused(loop, Status::bad_argument);
  loop = make_loop(10, 8, log);
  loop.flush = nullptr;
  check_refused(loop, Status::bad_argument);
  loop = make_loop(10, 4, log);
  loop.rows_per_stride = 8;
  check_refused(loop, Status::bad_argument);
}

TEST(strides_are_checked) {
  Log log;
  constexpr int32_t kNone[] = {0, -1};
  for (const int32_t none : kNone) {
    StripLoop loop = make_loop(10, 8, log);
    loop.stride = none;
    check_refused(loop, Status::bad_argument);
    loop = make_loop(10, 8, log);
    loop.rows_per_stride = none;
    check_refused(loop, Status::bad_argument);
  }
}

TEST(screens_have_up_to_32767_rows_and_columns) {
  Log log;
  CHECK_EQ(run_strips(make_loop(32767, 20, log)), Status::ok);
  CHECK_EQ(log.next_y, 32767);
  Log wide;
  StripLoop loop = make_loop(10, 8, wide);
  loop.width = 32767;
  loop.draw = [](void* context, const Strip& strip) {
    static_cast<Log*>(context)->draws += strip.width == 32767 ? 1 : 0;
  };
  CHECK_EQ(run_strips(loop), Status::ok);
  CHECK_EQ(wide.draws, 2);
  Log none;
  loop.context = &none;
  loop.width = 32768;
  check_refused(loop, Status::bad_argument);
}

TEST(the_buffer_holds_a_strip) {
  Log log;
  StripLoop loop = make_loop(10, 8, log);
  loop.buffer.size = 8 * 24 - 1;
  check_refused(loop, Status::buffer_small);
  // A page of 8 rows takes one stride, also where the screen ends in it.
  loop.rows_per_stride = 8;
  loop.buffer.size = 23;
  check_refused(loop, Status::buffer_small);
  loop.buffer.size = 24;
  CHECK_EQ(run_strips(loop), Status::ok);
  CHECK_EQ(log.next_y, 10);
  // Two pages hold the screen, and one does not.
  Log pages;
  loop = make_loop(10, 16, pages);
  loop.rows_per_stride = 8;
  loop.buffer.size = 2 * 24 - 1;
  check_refused(loop, Status::buffer_small);
  loop.buffer.size = 2 * 24;
  CHECK_EQ(run_strips(loop), Status::ok);
  CHECK_EQ(pages.draws, 1);
  // No more than the screen is asked for.
  Log low;
  loop = make_loop(3, 8, low);
  loop.buffer.size = 3 * 24;
  CHECK_EQ(run_strips(loop), Status::ok);
  CHECK_EQ(low.draws, 1);
  // However high a page is.
  Log page;
  loop = make_loop(3, INT32_MAX, page);
  loop.rows_per_stride = INT32_MAX;
  loop.buffer.size = 23;
  check_refused(loop, Status::buffer_small);
  loop.buffer.size = 24;
  CHECK_EQ(run_strips(loop), Status::ok);
  CHECK_EQ(page.next_y, 3);
}

TEST(rectangles_intersect) {
  const Rect a = {0, 0, 10, 10};
  const Rect b = {5, -5, 15, 5};
  const Rect both = intersect(a, b);
  CHECK_EQ(both.x0, 5);
  CHECK_EQ(both.y0, 0);
  CHECK_EQ(both.x1, 10);
  CHECK_EQ(both.y1, 5);
  CHECK(!is_empty(both));
  CHECK(is_empty(intersect(a, {10, 0, 20, 10})));
  CHECK(is_empty(intersect(a, {0, 10, 10, 20})));
  CHECK(is_empty({}));
  CHECK(is_empty({3, 0, 2, 5}));
  Strip strip;
  strip.x0 = -3;
  strip.y0 = 7;
  strip.width = 5;
  strip.height = 2;
  CHECK_EQ(strip.rect().x1, 2);
  CHECK_EQ(strip.rect().y1, 9);
}
