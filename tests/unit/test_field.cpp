// Fields: finding cells, and equations 1 to 3 against their values in double.
#include "inkcell/field/glyph_field.hpp"

#include "any_record.hpp"
#include "check.hpp"
#include "equation.hpp"
#include "font_builder.hpp"
#include "inkcell/field/cell.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using font_builder::put_u16;
using font_builder::Record;
namespace glyph = format::glyph;
namespace samples = format::samples;

alignas(4) uint8_t bytes[2048];

GlyphField open(const Record& record) {
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

Status open_bytes(size_t size) {
  GlyphField field;
  field.tiles_x = 77;
  const Status status = GlyphField::open({bytes, size}, field);
  CHECK(status == Status::ok || field.tiles_x == 77);  // out untouched
  return status;
}

Record disc_record() {
  Record record;
  record.fill(font_builder::disc);
  return record;
}

Q16_16 u(int32_t whole) {
  return Q16_16::from_int(whole);
}

// The reference of the square that holds the point, found by comparing.
struct Found {
  uint32_t reference;
  int32_t x_u;
  int32_t y_u;
  int32_t size_u;
};

Found find(const Record& record, int32_t x_u, int32_t y_u) {
  Found at = {0, record.x0_u, record.y0_u, 1 << record.tile_log2};
  uint32_t tile = 0;
  while (x_u >= at.x_u + at.size_u) {
    at.x_u += at.size_u;
    ++tile;
  }
  while (y_u >= at.y_u + at.size_u) {
    at.y_u += at.size_u;
    tile += record.tiles_x;
  }
  at.reference = record.references[tile];
  const uint32_t tiles = uint32_t{record.tiles_x} * record.tiles_y;
  while (at.reference >= glyph::kFirstNode && at.reference < glyph::kCellFlag) {
    const uint32_t node = at.reference - glyph::kFirstNode;
    if (node >= record.node_count() || at.size_u == 1) {
      at.reference = glyph::kOutside;
      break;
    }
    at.size_u /= 2;
    uint32_t child = 0;
    if (x_u >= at.x_u + at.size_u) {
      at.x_u += at.size_u;
      child += 1;
    }
    if (y_u >= at.y_u + at.size_u) {
      at.y_u += at.size_u;
      child += 2;
    }
    at.reference = record.references[tiles + 4 * node + child];
  }
  return at;
}

void check_cell(const Record& record,
                const GlyphField& field,
                int32_t x_u,
                int32_t y_u) {
  const Found expected = find(record, x_u, y_u);
  const Cell cell = locate(field, x_u, y_u);
  CHECK_EQ(1 << cell.size_log2, expected.size_u);
  CHECK_EQ(cell.x0_u, expected.x_u);
  CHECK_EQ(cell.y0_u, expected.y_u);
  const uint32_t index = expected.reference & 0x7fff;
  const bool has_samples =
      expected.reference >= glyph::kCellFlag && index < record.cell_count;
  CHECK_EQ(cell.samples != nullptr, has_samples);
  if (has_samples) {
    CHECK_EQ(cell.samples - field.cells, samples::kBytes * index);
  } else {
    CHECK_EQ(cell.inside, expected.reference == glyph::kInside);
  }
}

// A cell at `bytes`: random, or every offset at one end of its range.
void make_cell(Random& random, bool extreme) {
  const int32_t centre =
      extreme ? ((random.next() & 1) != 0 ? INT16_MIN : INT16_MAX)
              : random.between(INT16_MIN, INT16_MAX);
  put_u16(bytes, static_cast<uint32_t>(centre));
  for (uint32_t i = 0; i < 8; ++i) {
    bytes[samples::kOffsets + i] = static_cast<uint8_t>(
        extreme ? ((random.next() & 1) != 0 ? -128 : 127) : random.byte());
  }
}

// A position in the cell: anywhere, or at one end.
int32_t make_position(Random& random, int size_log2) {
  const int32_t last = static_cast<int32_t>((1u << (16 + size_log2)) - 1);
  const uint32_t kind = random.below(16);
  if (kind < 2) {
    return kind == 0 ? 0 : last;
  }
  return random.between(0, last);
}

double unit(int32_t position_q16, int size_log2) {
  return position_q16 / (65536.0 * (1 << size_log2));
}

// The largest error over random cells of one size. [u, Q10]
double worst_distance_error(int size_log2, bool extreme, int cells) {
  Random random(static_cast<uint32_t>(size_log2 + 1));
  double worst = 0;
  for (int i = 0; i < cells; ++i) {
    make_cell(random, extreme);
    const int32_t x = make_position(random, size_log2);
    const int32_t y = make_position(random, size_log2);
    const double expected = equation::distance(
        bytes, size_log2, unit(x, size_log2), unit(y, size_log2));
    const Q22_10 distance =
        samples_distance(bytes, static_cast<uint8_t>(size_log2), x, y);
    const double error = expected * 1024 - distance.raw;
    worst = error > worst ? error : worst;
    worst = -error > worst ? -error : worst;
  }
  return worst;
}

}  // namespace

TEST(refuses_records_that_do_not_fit) {
  const Record record = disc_record();
  open(record);
  CHECK_EQ(open_bytes(0), Status::corrupt);
  CHECK_EQ(open_bytes(glyph::kBytes - 1), Status::corrupt);
  CHECK_EQ(open_bytes(record.size() - 1), Status::corrupt);
  CHECK_EQ(open_bytes(record.size()), Status::ok);
  CHECK_EQ(open_bytes(record.size() + 1), Status::ok);
  for (int type = 0; type < 256; ++type) {
    bytes[glyph::kType] = static_cast<uint8_t>(type);
    CHECK_EQ(open_bytes(record.size()),
             type == glyph::kTypeSamples ? Status::ok : Status::unsupported);
  }
  bytes[glyph::kType] = glyph::kTypeSamples;
  bytes[glyph::kTileLog2] = 12;
  CHECK_EQ(open_bytes(record.size()), Status::corrupt);
  for (const uint32_t count : each_of({glyph::kNodeCount, glyph::kCellCount})) {
    open(record);
    put_u16(bytes + count, font_builder::get_u16(bytes + count) + 1u);
    CHECK_EQ(open_bytes(record.size()), Status::corrupt);
    put_u16(bytes + count, 0xffff);
    CHECK_EQ(open_bytes(record.size()), Status::corrupt);
  }
  open(record);
  bytes[glyph::kTilesX] = 255;
  bytes[glyph::kTilesY] = 255;
  CHECK_EQ(open_bytes(record.size()), Status::corrupt);
}

TEST(refuses_grids_beyond_15360_u) {
  const struct {
    int16_t x0_u;
    int16_t y0_u;
    uint8_t tiles_x;
    uint8_t tiles_y;
    Status expected;
  } cases[] = {{-15360, -15360, 15, 1, Status::ok},
               {-15361, 0, 1, 1, Status::corrupt},
               {0, -15361, 1, 1, Status::corrupt},
               {15360 - 2048, 0, 1, 1, Status::ok},
               {15361 - 2048, 0, 1, 1, Status::corrupt},
               {0, 15360 - 2048, 1, 1, Status::ok},
               {0, 15361 - 2048, 1, 1, Status::corrupt},
               {-32768, 0, 0, 0, Status::corrupt},
               {32767, 0, 0, 0, Status::corrupt},
               {0, 0, 0, 0, Status::ok},
               {0, 0, 255, 0, Status::corrupt}};
  for (const auto& c : cases) {
    Record record;
    record.tile_log2 = 11;
    record.x0_u = c.x0_u;
    record.y0_u = c.y0_u;
    record.tiles_x = c.tiles_x;
    record.tiles_y = c.tiles_y;
    record.reference_count = uint32_t{c.tiles_x} * c.tiles_y;
    record.write(bytes);
    CHECK_EQ(open_bytes(record.size()), c.expected);
  }
}

TEST(locates_every_cell_of_a_tree) {
  const Record record = disc_record();
  const GlyphField field = open(record);
  CHECK_EQ(field.x1_u(), 896);
  CHECK_EQ(field.y1_u(), 896);
  for (int32_t y = -128; y < 896; y += 9) {
    for (int32_t x = -128; x < 896; x += 7) {
      check_cell(record, field, x, y);
    }
  }
  const int32_t borders[] = {-128, -65, -64, -1, 0, 63, 64, 127, 128, 895};
  for (const int32_t y : borders) {
    for (const int32_t x : borders) {
      check_cell(record, field, x, y);
    }
  }
}

TEST(locates_down_to_one_unit) {
  Record record;
  record.tile_log2 = 3;
  record.x0_u = -9;
  record.y0_u = 5;
  record.tiles_x = 2;
  record.tiles_y = 1;
  record.reference_count = 2;
  // The second tile is divided towards its upper right corner to the end.
  uint16_t* at = &record.references[1];
  for (uint32_t depth = 0; depth < 3; ++depth) {
    const uint16_t node = record.add_node();
    *at = node;
    const int8_t offsets[8] = {};
    record.child(node, 0) = record.add_raw_cell(640, offsets);
    record.child(node, 1) = glyph::kInside;
    at = &record.child(node, 3);
  }
  *at = record.add_node();  // a node in a square of one unit: outside
  const GlyphField field = open(record);
  for (const auto [x, y] : pixels_of({-9, 5, 7, 13})) {
    check_cell(record, field, x, y);
  }
  CHECK_EQ(locate(field, 6, 12).size_log2, 0);
  CHECK(!locate(field, 6, 12).inside);
}

TEST(locates_in_any_bytes) {
  for (Random& random : Rounds(5, 200)) {
    Record record;
    record.tile_log2 = static_cast<uint8_t>(random.below(7));
    record.tiles_x = static_cast<uint8_t>(1 + random.below(3));
    record.tiles_y = static_cast<uint8_t>(1 + random.below(3));
    const uint32_t tiles = uint32_t{record.tiles_x} * record.tiles_y;
    record.reference_count = tiles + 4 * random.below(20);
    record.cell_count = random.below(20);
    for (uint32_t i = 0; i < record.reference_count; ++i) {
      // Nodes and cells that exist or nearly do: cycles, too.
      const uint32_t index = random.below(22);
      record.references[i] = static_cast<uint16_t>(
          (random.next() & 1) != 0 ? index : glyph::kCellFlag | index);
    }
    const GlyphField field = open(record);
    for (int i = 0; i < 50; ++i) {
      check_cell(record, field, random.between(field.x0_u, field.x1_u() - 1),
                 random.between(field.y0_u, field.y1_u() - 1));
    }
  }
}

TEST(distance_follows_equation_1) {
  double worst = 0;  // of the bound
  for (int size_log2 = 0; size_log2 <= 11; ++size_log2) {
    const int32_t bound =
        samples_error_bound_q10(static_cast<uint8_t>(size_log2));
    const double random_error = worst_distance_error(size_log2, false, 1500);
    const double extreme_error = worst_distance_error(size_log2, true, 1500);
    CHECK(random_error <= bound);
    CHECK(extreme_error <= bound);
    worst = random_error > worst * bound ? random_error / bound : worst;
    worst = extreme_error > worst * bound ? extreme_error / bound : worst;
  }
  check::write("largest error of distances: ");
  check::write_number(static_cast<int64_t>(worst * 100));
  check::write(" % of samples_error_bound_q10\n");
}

// Where all nine weights are exact, only the last shift rounds.
TEST(distance_at_the_nine_samples_is_exact) {
  Random random(9);
  for (uint8_t size_log2 = 0; size_log2 <= 11; ++size_log2) {
    make_cell(random, false);
    const int32_t half = 1 << (15 + size_log2);
    for (int i = 0; i < 4; ++i) {  // the four that lie in the cell
      const int32_t x = i % 2 * half;
      const int32_t y = i / 2 * half;
      const int sample = i % 2 + i / 2 * 3;
      const int32_t offset =
          sample == 4 ? 0
                      : static_cast<int8_t>(
                            bytes[2 + (sample < 4 ? sample : sample - 1)]);
      const int32_t centre = static_cast<int16_t>(font_builder::get_u16(bytes));
      CHECK_EQ(samples_distance(bytes, size_log2, x, y).raw,
               centre * 16 + offset * (1 << (size_log2 + 3)));
    }
  }
}

TEST(a_row_is_the_same_as_its_points) {
  Rounds rounds(11, 300);
  for (Random& random : rounds) {
    const auto size_log2 = static_cast<uint8_t>(random.below(12));
    make_cell(random, (rounds.number & 1) != 0);
    const int32_t y = make_position(random, size_log2);
    SamplesRow row;
    row.set_up(bytes, size_log2, y);
    for (int j = 0; j < 20; ++j) {
      const int32_t x = make_position(random, size_log2);
      CHECK_EQ(row.distance_q10(x),
               samples_distance(bytes, size_log2, x, y).raw);
    }
  }
}

TEST(gradient_is_minus_equations_2_and_3) {
  Record record;
  record.x0_u = 0;
  record.y0_u = 0;
  record.tiles_x = 1;
  record.tiles_y = 1;
  record.reference_count = 1;
  record.references[0] = glyph::kCellFlag;
  record.cell_count = 1;
  double worst = 0;
  Rounds rounds(21, 6000);
  for (Random& random : rounds) {
    const int size_log2 = static_cast<int>(random.below(12));
    make_cell(random, (rounds.number & 7) == 0);
    for (uint32_t j = 0; j < samples::kBytes; ++j) {
      record.cells[0][j] = bytes[j];
    }
    record.tile_log2 = static_cast<uint8_t>(size_log2);
    const GlyphField field = open(record);
    const int32_t x = make_position(random, size_log2);
    const int32_t y = make_position(random, size_log2);
    const Gradient gradient =
        gradient_at(field, Q16_16::from_raw(x), Q16_16::from_raw(y));
    const double expected[2] = {
        equation::slope_x(field.cells, unit(x, size_log2), unit(y, size_log2)),
        equation::slope_y(field.cells, unit(x, size_log2), unit(y, size_log2))};
    const double found[2] = {gradient.x.raw / 16384.0,
                             gradient.y.raw / 16384.0};
    for (int axis = 0; axis < 2; ++axis) {
      double limited = expected[axis] > 2 ? 2 : expected[axis];
      limited = limited < -2 ? -2 : limited;
      const double error = limited - found[axis];
      worst = error > worst ? error : worst;
      worst = -error > worst ? -error : worst;
    }
  }
  CHECK(worst <= 1.0 / 128);
  check::write("largest error of gradients: ");
  check::write_number(static_cast<int64_t>(worst * 1000000));
  check::write(" / 1000000\n");
}

TEST(gradient_points_inwards) {
  const Record record = disc_record();
  const GlyphField field = open(record);
  const struct {
    int32_t x_u;
    int32_t y_u;
    int32_t x;
    int32_t y;
  } cases[] = {{84, 384, 1, 0},   {684, 384, -1, 0}, {384, 84, 0, 1},
               {384, 684, 0, -1}, {204, 144, 3, 4},  {564, 624, -3, -4}};
  for (const auto& c : cases) {
    const Gradient gradient = gradient_at(field, u(c.x_u), u(c.y_u));
    const int32_t length = c.x != 0 && c.y != 0 ? 5 : 1;
    CHECK(magnitude(gradient.x.raw - c.x * 16384 / length) < 16384 / 32);
    CHECK(magnitude(gradient.y.raw - c.y * 16384 / length) < 16384 / 32);
  }
  const Gradient inside = gradient_at(field, u(384), u(384));
  CHECK(inside.x.raw == 0 && inside.y.raw == 0);
  const Gradient outside = gradient_at(field, u(-129), u(384));
  CHECK(outside.x.raw == 0 && outside.y.raw == 0);
}

TEST(distance_saturates) {
  const Record record = disc_record();
  const GlyphField field = open(record);
  CHECK_EQ(distance_at(field, u(384), u(384)).raw, kSaturatedDistanceQ10);
  CHECK_EQ(distance_at(field, u(-128), u(-128)).raw, -kSaturatedDistanceQ10);
  const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -128 * 65536 - 1,
                          896 * 65536, INT32_MAX};
  for (const int32_t end : ends) {
    CHECK_EQ(distance_at(field, Q16_16::from_raw(end), u(384)).raw,
             -kSaturatedDistanceQ10);
    CHECK_EQ(distance_at(field, u(384), Q16_16::from_raw(end)).raw,
             -kSaturatedDistanceQ10);
  }
  const GlyphField empty;
  CHECK_EQ(distance_at(empty, u(0), u(0)).raw, -kSaturatedDistanceQ10);
  CHECK_EQ(gradient_at(empty, u(0), u(0)).x.raw, 0);
}

// In cells of 64 u a disc of 300 u is bi-quadratic within a quantum or so.
TEST(distance_near_the_edge_is_that_of_the_shape) {
  const Record record = disc_record();
  const GlyphField field = open(record);
  for (int32_t y = 50; y < 720; y += 11) {
    for (int32_t x = 50; x < 720; x += 13) {
      const int32_t expected_q6 = font_builder::disc(x, y);
      if (magnitude(expected_q6) < 48 * 64) {
        const int32_t found_q6 = distance_at(field, u(x), u(y)).raw / 16;
        CHECK(magnitude(found_q6 - expected_q6) <= 64);
      }
    }
  }
}

namespace {

// FNV-1a.
uint32_t hash_of(uint32_t hash, int32_t value) {
  return (hash ^ static_cast<uint32_t>(value)) * 16777619u;
}

}  // namespace

// The same answers for ever: simulations and fonts depend on them.
TEST(answers_are_bit_by_bit_what_they_were) {
  uint32_t hash = 2166136261u;
  for (Random& random : Rounds(77, 60)) {
    Record record;
    make_any(record, random);
    GlyphField field = open(record);
    field.band_u = static_cast<uint16_t>(random.below(200));
    for (int32_t i = 0; i < 60; ++i) {
      const int32_t width_u = field.x1_u() - field.x0_u;
      const auto x = Q16_16::from_raw((field.x0_u - 2) * 65536 +
                                      random.between(0, (width_u + 4) * 65536));
      const auto y = Q16_16::from_raw((field.y0_u - 2) * 65536 +
                                      random.between(0, (width_u + 4) * 65536));
      hash = hash_of(hash, distance_at(field, x, y).raw);
      const Gradient gradient = gradient_at(field, x, y);
      hash = hash_of(hash, gradient.x.raw);
      hash = hash_of(hash, gradient.y.raw);
      const FieldPoint point = point_at(field, x, y);
      hash = hash_of(hash, point.distance.raw);
      hash = hash_of(hash, point.gradient.x.raw);
      hash = hash_of(hash, point.gradient.y.raw);
      hash = hash_of(hash, point.is_bound ? 1 : 0);
    }
  }
  CHECK_EQ(hash, 2548733550u);
}
