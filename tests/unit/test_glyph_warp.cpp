// Maps of coordinates: monotone, exact at their knots, safe with any numbers.
#include "check.hpp"
#include "inkcell/glyph_warp.hpp"
#include "random.hpp"
#include "rounds.hpp"

using namespace inkcell;

TEST(points_go_where_the_knots_say) {
  AxisMap map = {};
  map.clear();
  CHECK_EQ(map.map(1234), 1234);
  CHECK(map.add(-256, -512));
  CHECK(map.add(256, 512));
  CHECK(map.add(512, 576));
  CHECK_EQ(map.map(-256), -512);
  CHECK_EQ(map.map(0), 0);
  CHECK_EQ(map.map(256), 512);
  CHECK_EQ(map.map(384), 544);
  CHECK_EQ(map.map(512), 576);
  // Beyond the ends they shift.
  CHECK_EQ(map.map(-1000), -1256);
  CHECK_EQ(map.map(1000), 1064);
  CHECK_EQ(map.map(INT32_MIN), INT32_MIN - int64_t{256} + (int64_t{1} << 32));
}

TEST(knots_ascend) {
  AxisMap map = {};
  map.clear();
  CHECK(map.add(0, 100));
  CHECK(!map.add(0, 200));
  CHECK(!map.add(-1, 200));
  CHECK_EQ(map.count, 1);
  // One that would descend goes where the one before goes.
  CHECK(map.add(50, 60));
  CHECK_EQ(map.knots[1].to_q8, 100);
  CHECK_EQ(map.map(25), 100);
  CHECK(!map.add(AxisMap::kReachQ8 + 1, 200));
  CHECK(!map.add(100, AxisMap::kReachQ8 + 1));
  CHECK(map.add(AxisMap::kReachQ8, AxisMap::kReachQ8));
  CHECK_EQ(map.count, 3);
}

TEST(maps_are_monotone_from_wherever_they_begin) {
  for (Random& random : Rounds(5, 200)) {
    AxisMap map = {};
    map.clear();
    for (int i = 0; i < 40; ++i) {
      static_cast<void>(map.add(random.between(-40000, 40000),
                                random.between(-40000, 40000)));
    }
    CHECK(map.count > 0 && map.count <= AxisMap::kMaxKnots);
    for (int32_t i = 0; i < map.count; ++i) {
      CHECK_EQ(map.map(map.knots[i].from_q8), map.knots[i].to_q8);
    }
    int32_t last = INT32_MIN;
    int32_t knot = 0;
    for (int32_t at = -50000; at < 50000; at += random.between(1, 300)) {
      const int32_t to = map.map(at);
      CHECK(to >= last);
      CHECK_EQ(map.map(at, knot), to);
      last = to;
    }
  }
}
