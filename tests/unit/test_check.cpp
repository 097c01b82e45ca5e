// The harness itself: what would make every other test pass in silence.
#include "check.hpp"
#include "picture.hpp"

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
