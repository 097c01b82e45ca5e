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

Log run(int32_t height, int32_t rows) {
  static uint8_t buffer[24];
  Log log;
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
  run_strips(loop);
  return log;
}

}  // namespace

TEST(strips_cover_the_screen_once) {
  for (int32_t rows = 1; rows <= 20; ++rows) {
    for (int32_t height = 0; height <= 20; ++height) {
      const Log log = run(height, rows);
      CHECK_EQ(log.next_y, height);
      CHECK_EQ(log.draws, (height + rows - 1) / rows);
    }
  }
  CHECK_EQ(run(10, INT32_MAX).next_y, 10);
}

TEST(nothing_to_loop_over) {
  CHECK_EQ(run(10, 0).draws, 0);
  CHECK_EQ(run(10, -1).draws, 0);
  CHECK_EQ(run(0, 8).draws, 0);
  CHECK_EQ(run(-5, 8).draws, 0);
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
