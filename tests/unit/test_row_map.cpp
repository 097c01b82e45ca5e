// The map from heights on the screen to heights in the glyph.
#include "check.hpp"
#include "inkcell/row_map.hpp"
#include "random.hpp"

using namespace inkcell;

TEST(without_knots_it_is_the_identity) {
  RowMap map;
  constexpr int32_t kHeights[] = {-(1 << 30), -1, 0, 7, 1 << 30};
  for (const int32_t height : kHeights) {
    CHECK_EQ(map.glyph_height_q10(height), height);
  }
}

TEST(knots_are_met_and_what_is_between_them_is_divided_evenly) {
  RowMap map;
  CHECK(map.add(0, 100));
  CHECK(map.add(1024, 612));
  CHECK(map.add(3072, 3684));
  CHECK_EQ(map.glyph_height_q10(0), 100);
  CHECK_EQ(map.glyph_height_q10(512), 356);
  CHECK_EQ(map.glyph_height_q10(1024), 612);
  CHECK_EQ(map.glyph_height_q10(2048), 2148);
  CHECK_EQ(map.glyph_height_q10(3072), 3684);
  // Beyond the outer ones it shifts as they do.
  CHECK_EQ(map.glyph_height_q10(-5000), -4900);
  CHECK_EQ(map.glyph_height_q10(5000), 5612);
}

TEST(knots_that_break_the_contract_are_refused) {
  RowMap map;
  CHECK(!map.add(0, RowMap::kMaxShiftQ10 + 1));
  CHECK(!map.add(RowMap::kReachQ10 + 1, RowMap::kReachQ10));
  CHECK(map.add(0, 0));
  CHECK(!map.add(15, 1000));
  CHECK(!map.add(1000, 15));
  CHECK(!map.add(-1000, -1000));
  CHECK_EQ(map.count, 1);
  for (int32_t i = 1; i < RowMap::kMaxKnots; ++i) {
    CHECK(map.add(i * 16, i * 16));
  }
  CHECK(!map.add(5000, 5000));
  CHECK_EQ(map.count, RowMap::kMaxKnots);
}

// Whatever is added: it never turns back, and moves nothing by more than 1 px.
TEST(it_is_monotone_and_near_the_identity) {
  Random random(31);
  int refused = 0;
  for (int round = 0; round < 2000 && !check::failed(); ++round) {
    RowMap map;
    int32_t at = random.between(-(60 << 10), 0);
    const int32_t scale = round % 3 == 0 ? 40 << 10 : 3 << 10;
    for (int i = 0; i < 12; ++i) {
      at += random.between(-20, scale);
      refused += map.add(at, at + random.between(-1100, 1100)) ? 0 : 1;
    }
    int32_t last = INT32_MIN;
    for (int32_t height = -(64 << 10); height < (96 << 10); height += 37) {
      const int32_t in_glyph = map.glyph_height_q10(height);
      CHECK(in_glyph >= last);
      CHECK(in_glyph - height <= RowMap::kMaxShiftQ10);
      CHECK(height - in_glyph <= RowMap::kMaxShiftQ10);
      last = in_glyph;
    }
    for (uint32_t i = 0; i < map.count; ++i) {
      CHECK_EQ(map.glyph_height_q10(map.knots[i].screen_q10),
               map.knots[i].glyph_q10);
    }
  }
  CHECK(refused > 1000 && refused < 22000);
}
