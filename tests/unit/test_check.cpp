// The harness itself: what would make every other test pass in silence.
#include "check.hpp"
#include "ink.hpp"
#include "picture.hpp"
#include "pixels.hpp"

namespace {

using inkcell::Sink;

// Draws a wedge: full, two partial coverages, and a row apart.
void draw_wedge(const Sink& sink) {
  const uint8_t row[3] = {255, 128, 1};
  sink.solid(sink.context, 10, 20, 2);
  sink.coverage(sink.context, 11, 21, row, 3);
}

TEST(picture_shows_what_was_drawn) {
  Picture<4, 3> picture(10, 20);
  draw_wedge(picture.sink());
  CHECK_PICTURE(picture,
                "##..\n"
                ".#+:\n");
  CHECK_EQ(picture.at(12, 21), 128);
  CHECK_EQ(picture.calls(), 2);
}

TEST(picture_tells_apart) {
  Picture<4, 3> picture(10, 20);
  draw_wedge(picture.sink());
  CHECK(!picture.matches("##..\n"));
  CHECK(!picture.matches("##..\n.#+.\n"));
  CHECK(!picture.matches("##..\n.#+:\n...:\n"));
  CHECK(!picture.matches("##..\n.#+:\n....\n....\n"));
  CHECK(picture.matches("##..\n.#+:\n....\n"));
  CHECK(!picture.matches("##..\n.#+:\n", 1, 0));
  CHECK(!picture.matches(".#+:\n", 0, 1));
  Picture<4, 3> below(9, 19);
  below.sink().solid(&below, 11, 20, 2);
  CHECK_PICTURE_AT(below, 2, 1, "##\n");
  CHECK(!below.matches("##\n", 1, 1) && !below.matches("##\n", 2, 0));
}

TEST(pictures_compare_and_measure) {
  Picture<4, 3> picture(10, 20);
  draw_wedge(picture.sink());
  CHECK_EQ(picture.ink(), 3 * 255 + 128 + 1);
  CHECK_EQ(picture.ink({11, 21, 13, 99}), 255 + 128);
  CHECK(picture.lies_in({10, 20, 14, 22}));
  CHECK(!picture.lies_in({11, 20, 14, 22}));
  Picture<4, 3> other = picture;
  CHECK(picture == other);
  other.next_glyph();
  const uint8_t brighter = 100;
  const Sink sink = other.sink({13, 21, 14, 22});
  sink.coverage(sink.context, 13, 21, &brighter, 1);
  CHECK_EQ(picture.difference(other), 99);
  CHECK_EQ(other.difference(picture), 99);
  CHECK(!(picture == other));
  other.clear({10, 20, 14, 21});
  CHECK_EQ(other.ink(), 255 + 128 + 100);
  other.clear();
  CHECK_EQ(other.ink(), 0);
}

TEST(parts_of_pictures_are_all_of_them) {
  Picture<5, 4> picture(-2, 7);
  int32_t parts = 0;
  const auto fill = [&](const Sink& sink) {
    ++parts;
    for (int32_t y = sink.window.y0; y < sink.window.y1; ++y) {
      sink.solid(sink.context, sink.window.x0, y,
                 sink.window.x1 - sink.window.x0);
    }
  };
  picture.draw_parts(3, 2, fill);
  CHECK_EQ(parts, 4);
  CHECK_EQ(picture.ink(), 255 * 5 * 4);
  picture.clear_at(0, 0);
  picture.draw_strips(3, fill);
  CHECK_EQ(parts, 6);
  CHECK_EQ(picture.ink({0, 0, 5, 4}), 255 * 5 * 4);
}

TEST(overlaps_keep_the_greatest_or_add_light) {
  const uint8_t first[] = {0, 100, 255};
  const uint8_t second[] = {51, 51, 51};
  Picture<3, 1, Overlap::greatest> greatest;
  Picture<3, 1, Overlap::light> light;
  const Sink sinks[] = {greatest.sink(), light.sink()};
  for (const Sink& sink : sinks) {
    sink.coverage(sink.context, 0, 0, first, 3);
    sink.coverage(sink.context, 0, 0, second, 3);
  }
  constexpr uint8_t kGreatest[] = {51, 100, 255};
  constexpr uint8_t kLight[] = {51, 131, 255};
  for (int32_t x = 0; x < 3; ++x) {
    CHECK_EQ(greatest.at(x, 0), kGreatest[x]);
    CHECK_EQ(light.at(x, 0), kLight[x]);
  }
}

TEST(ink_is_summed_and_boxed) {
  Ink ink;
  draw_wedge(ink.sink());
  CHECK_EQ(ink.sum, 3 * 255 + 128 + 1);
  Ink same = ink;
  CHECK(same == ink);
  const uint8_t pixel[] = {0, 0, 9};
  const Sink sink = same.sink();
  sink.coverage_rgb(sink.context, 50, 60, pixel, 1);
  sink.coverage(sink.context, 70, 80, pixel, 2);
  CHECK_EQ(same.sum, ink.sum + 9);
  CHECK(is_same(same.box, {10, 20, 51, 61}));
  CHECK(!(same == ink));
}

TEST(shades) {
  CHECK_EQ(shade(0), '.');
  CHECK_EQ(shade(1), ':');
  CHECK_EQ(shade(85), ':');
  CHECK_EQ(shade(86), '+');
  CHECK_EQ(shade(170), '+');
  CHECK_EQ(shade(171), '*');
  CHECK_EQ(shade(254), '*');
  CHECK_EQ(shade(255), '#');
}

}  // namespace
