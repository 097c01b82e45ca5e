// Every test here must fail: CTest expects exactly that many failures.
#include "check.hpp"
#include "picture.hpp"
#include "rounds.hpp"

namespace {

TEST(condition) {
  CHECK(1 > 2);
}

TEST(values) {
  CHECK_EQ(-1, 2);
}

TEST(overdraw) {
  Picture<4, 1> picture;
  picture.sink().solid(&picture, 0, 0, 3);
  picture.sink().solid(&picture, 2, 0, 1);
}

TEST(out_of_bounds) {
  Picture<4, 1> picture;
  picture.sink().solid(&picture, 2, 0, 3);
}

TEST(long_span) {
  Picture<40, 1> picture;
  const uint8_t coverage[33] = {};
  picture.sink().coverage(&picture, 0, 0, coverage, 33);
}

TEST(picture) {
  Picture<2, 1> picture;
  picture.sink().solid(&picture, 0, 0, 1);
  CHECK_PICTURE(picture, "##\n");
}

}  // namespace

TEST(a_round_fails) {
  Rounds rounds(1, 9);
  for ([[maybe_unused]] Random& random : rounds) {
    CHECK(rounds.number != 4);
  }
}
