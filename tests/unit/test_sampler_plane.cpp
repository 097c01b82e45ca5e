// Where the walk knows that a glyph is plane around a point, and gradients that
// are steeper than they should be.
#include "check.hpp"
#include "distance/sampler.hpp"
#include "field_record.hpp"
#include "font_builder.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/render.hpp"

namespace {

using namespace inkcell;
using detail::CellSampler;
using detail::GlyphPoint;
using detail::ScreenGradient;

constexpr int32_t kPx = 1 << 10;  // [Q10]

alignas(4) uint8_t bytes[512];
font_builder::Record samples;  // too large for the stack of a small board

TextStyle style_of(int32_t px) {
  TextStyle style;
  CHECK_OK(TextStyle::make(Q26_6::from_int(px), kFilterText, style));
  return style;
}

GlyphPoint position(const CellSampler& walk,
                    const TextStyle& style,
                    int32_t x_u,
                    int32_t y_u) {
  const int32_t px = style.size().raw >> 6;
  return walk.point({0, 0}, 0, 0, {x_u * px - kPx / 2, y_u * px + kPx / 2});
}

// A cell of 256 u whose values, in 1/128 of that, are these above the centre's
// 0, from the lower left to the upper right.
GlyphField field_of_samples(const int8_t (&offsets)[8]) {
  samples.reset();
  samples.tile_log2 = 8;
  samples.tiles_x = 1;
  samples.tiles_y = 1;
  samples.x0_u = 0;
  samples.y0_u = 0;
  samples.reference_count = 1;
  samples.references[0] = samples.add_raw_cell(0, offsets);
  GlyphField field;
  CHECK(samples.size() <= sizeof(bytes));
  samples.write(bytes);
  CHECK_OK(GlyphField::open({bytes, samples.size()}, field));
  return field;
}

bool is_plane(const GlyphField& field, int32_t px, int32_t radius_q10) {
  const TextStyle style = style_of(px);
  CellSampler walk(field, style, detail::kNoReach);
  const GlyphPoint at = position(walk, style, 128, 128);
  walk.distance_q10(at);
  CHECK(!walk.is_saturated());
  return walk.is_plane_around(at, {radius_q10, 0, 0});
}

}  // namespace

TEST(samples_are_plane_up_to_1_32_px) {
  // 256 u are 16 px, and 1 px an eighth of half of them.
  constexpr int32_t kSize = 64;
  for (int place = 0; place < 8; ++place) {
    const bool is_corner = place == 0 || place == 2 || place == 5 || place == 7;
    for (int sign = -1; sign < 2; sign += 2) {
      // 48 to the right and 16 up.
      int8_t offsets[8] = {-64, -16, 32, -48, 48, -32, 16, 64};
      CHECK(is_plane(field_of_samples(offsets), kSize, kPx));
      const int limit = is_corner ? 32 : 16;
      const int plane = offsets[place];
      offsets[place] = static_cast<int8_t>(plane + sign * (limit - 1));
      CHECK(is_plane(field_of_samples(offsets), kSize, kPx));
      offsets[place] = static_cast<int8_t>(plane + sign * limit);
      CHECK(!is_plane(field_of_samples(offsets), kSize, kPx));
    }
  }
}

TEST(samples_are_plane_within_half_a_cell) {
  constexpr int8_t kPlane[8] = {-64, -16, 32, -48, 48, -32, 16, 64};
  const GlyphField field = field_of_samples(kPlane);
  CHECK(is_plane(field, 64, 8 * kPx - 1));
  CHECK(!is_plane(field, 64, 8 * kPx));
}

TEST(what_is_around_must_lie_in_the_cell) {
  constexpr int8_t kPlane[8] = {-64, -16, 32, -48, 48, -32, 16, 64};
  const GlyphField field = field_of_samples(kPlane);
  const TextStyle style = style_of(64);
  CellSampler walk(field, style, detail::kNoReach);
  const auto has_room = [&](int32_t x_u, int32_t y_u, int32_t room_x_u,
                            int32_t room_y_u) {
    const GlyphPoint at = position(walk, style, x_u, y_u);
    walk.distance_q10(at);
    return walk.is_plane_around(at, {kPx, static_cast<uint32_t>(room_x_u) << 16,
                                     static_cast<uint32_t>(room_y_u) << 16});
  };
  CHECK(has_room(100, 60, 100, 60));
  CHECK(!has_room(100, 60, 101, 60));
  CHECK(!has_room(100, 60, 100, 61));
  CHECK(has_room(200, 160, 55, 95));
  CHECK(!has_room(200, 160, 56, 95));
  CHECK(!has_room(200, 160, 55, 96));
  // Nothing is known beyond the grid.
  CHECK(!has_room(300, 60, 1, 1));
}

// Values rise by nearly 2 along both axes, which is 2.8 between them.
TEST(gradients_end_at_2) {
  Direction direction;
  direction.cosine.raw = 759250125;
  direction.sine.raw = 759250125;
  TextStyle style;
  CHECK_OK(TextStyle::make(Q26_6::from_int(64), kFilterText, direction, style));
  for (int sign = -1; sign < 2; sign += 2) {
    const auto steep = static_cast<int8_t>(sign * 127);
    const auto fall = static_cast<int8_t>(-steep);
    const int8_t offsets[8] = {fall, fall, 0, fall, steep, 0, steep, steep};
    const GlyphField field = field_of_samples(offsets);
    CellSampler walk(field, style, detail::kNoReach);
    // 132 u along both axes: straight up.
    constexpr int32_t kUp = 11947;  // 132 / 16 px times the root of 2
    const ScreenGradient found =
        walk.gradient(walk.point({0, 0}, 0, 0, {-kPx / 2, kUp + kPx / 2}));
    CHECK_EQ(found.up_q14, sign < 0 ? INT16_MIN : INT16_MAX);
    CHECK(found.right_q14 > -4000 && found.right_q14 < 4000);
  }
}

#if INKCELL_EDGE_CELLS

namespace {

FieldRecord record;

// At 1024 px a unit is a px. Upright edges, so that each field has one of these
// values in the middle of the tile.
void make_lines(Span<const int32_t> values_u) {
  record = FieldRecord();
  for (const int32_t value_u : values_u) {
    record.fields[record.line_count++] = {16384, 0, 16 * (value_u - 128), 0, 0};
  }
}

GlyphField open_record(uint16_t reference) {
  record.references[0] = reference;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  GlyphField field;
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

constexpr int32_t kRadius = 8 * kPx;  // fields that are 16 px apart never meet

bool is_pair_plane(int32_t first, int32_t second, bool is_greatest) {
  const int32_t values[] = {first, second};
  make_lines(values);
  record.pair_count = 1;
  record.pairs[0][is_greatest ? 0 : 1] = 1;
  return is_plane(open_record(record.pair_reference(0)), 1024, kRadius);
}

bool is_triple_plane(Csg op, int32_t a, int32_t b, int32_t c) {
  const int32_t values[] = {a, b, c};
  make_lines(values);
  record.triple_count = 1;
  record.triples[0][0] = static_cast<uint16_t>(op);
  record.triples[0][2] = 1;
  record.triples[0][3] = 2;
  return is_plane(open_record(record.triple_reference(0)), 1024, kRadius);
}

}  // namespace

TEST(a_field_is_plane_if_it_is_bent_by_less_than_1_32_px) {
  for (int sign = -1; sign < 2; sign += 2) {
    for (int is_bent = 0; is_bent < 2; ++is_bent) {
      record = FieldRecord();
      record.arc_count = 1;
      // 2^-19 k 8^2: 1/32 px of 256.
      const int32_t bend = is_bent != 0 ? 272 : 240;
      record.fields[0] = {16384, 0, -16 * 128, 0, sign * bend};
      const GlyphField field = open_record(record.field_reference(0));
      CHECK_EQ(is_plane(field, 1024, kRadius), is_bent == 0);
    }
  }
}

TEST(two_fields_are_plane_where_they_do_not_meet) {
  for (int is_greatest = 0; is_greatest < 2; ++is_greatest) {
    for (int sign = -1; sign < 2; sign += 2) {
      CHECK(is_pair_plane(0, sign * 16, is_greatest != 0));
      CHECK(!is_pair_plane(0, sign * 15, is_greatest != 0));
    }
  }
}

// The two that are not the least, or the greatest, may be equal.
TEST(three_fields_are_plane_where_the_one_that_decides_meets_none) {
  for (int sign = -1; sign < 2; sign += 2) {
    const Csg op = sign > 0 ? Csg::intersection : Csg::union_;
    CHECK(is_triple_plane(op, 0, sign * 16, sign * 16));
    CHECK(is_triple_plane(op, sign * 16, 0, sign * 17));
    CHECK(is_triple_plane(op, sign * 17, sign * 16, 0));
    CHECK(!is_triple_plane(op, 0, sign * 15, sign * 40));
    CHECK(!is_triple_plane(op, 0, sign * 40, sign * 15));
    CHECK(!is_triple_plane(op, sign * 15, 0, sign * 40));
    CHECK(!is_triple_plane(op, sign * 40, 0, sign * 15));
    CHECK(!is_triple_plane(op, sign * 15, sign * 40, 0));
    CHECK(!is_triple_plane(op, sign * 40, sign * 15, 0));
  }
}

TEST(nested_fields_are_plane_where_no_two_meet) {
  constexpr Csg kOps[] = {Csg::intersection_of_union,
                          Csg::union_of_intersection};
  for (const Csg op : kOps) {
    CHECK(is_triple_plane(op, 0, 16, 32));
    CHECK(is_triple_plane(op, 32, 0, 16));
    CHECK(!is_triple_plane(op, 0, 15, 40));
    CHECK(!is_triple_plane(op, 0, 40, 15));
    CHECK(!is_triple_plane(op, 40, 0, 15));
  }
}

#endif  // INKCELL_EDGE_CELLS
