// Rectangles, strips, and what changed on the screen.
#include "inkcell/strip.hpp"

#include "check.hpp"
#include "inkcell/dirty_rects.hpp"
#include "pixels.hpp"

using namespace inkcell;

TEST(rectangles_intersect) {
  const Rect a = {0, 0, 10, 10};
  const Rect b = {5, -5, 15, 5};
  const Rect both = intersect(a, b);
  CHECK(is_same(both, {5, 0, 10, 5}));
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

TEST(a_bounding_box_holds_both) {
  const Rect a = {0, 4, 10, 10};
  CHECK(is_same(bounding_box(a, {5, -5, 15, 5}), {0, -5, 15, 10}));
  CHECK(is_same(bounding_box(a, {-3, 5, 2, 12}), {-3, 4, 10, 12}));
  // An empty one adds nothing, wherever it lies.
  CHECK(is_same(bounding_box(a, {90, 90, 90, 95}), a));
  CHECK(is_same(bounding_box({90, 90, 95, 80}, a), a));
}

constexpr Rect kScreen = {0, 0, 100, 100};

TEST(what_changed_is_cut_to_the_screen) {
  Rect room[2];
  DirtyRects dirty(room);
  dirty.add({90, 90, 110, 120}, kScreen);
  dirty.add({100, 0, 120, 10}, kScreen);
  CHECK_EQ(dirty.rects().size, 1);
  CHECK(is_same(dirty.rects()[0], {90, 90, 100, 100}));
  dirty.clear();
  CHECK_EQ(dirty.rects().size, 0);
}

TEST(rectangles_that_are_close_become_one) {
  Rect room[3];
  DirtyRects dirty(room);
  dirty.add({0, 0, 10, 10}, kScreen);
  dirty.add({50, 50, 60, 60}, kScreen);
  CHECK_EQ(dirty.rects().size, 2);
  dirty.add({5, 2, 12, 8}, kScreen);     // overlaps the first
  dirty.add({60, 50, 70, 60}, kScreen);  // ends where the second ends
  CHECK_EQ(dirty.rects().size, 2);
  int32_t found = 0;
  for (const Rect& rect : dirty.rects()) {
    found += is_same(rect, {0, 0, 12, 10}) ? 1 : 0;
    found += is_same(rect, {50, 50, 70, 60}) ? 2 : 0;
  }
  CHECK_EQ(found, 3);
  // Without room the pair that wastes least is merged.
  dirty.add({0, 90, 5, 95}, kScreen);
  dirty.add({90, 0, 95, 5}, kScreen);
  CHECK_EQ(dirty.rects().size, 3);
  DirtyRects none({});
  none.add({0, 0, 10, 10}, kScreen);
  CHECK_EQ(none.rects().size, 0);
}
