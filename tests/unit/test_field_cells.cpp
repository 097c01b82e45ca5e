// Cells of primitives: finding them, and their distances against double.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/render.hpp"
#include "rounds.hpp"

#if INKCELL_EDGE_CELLS

namespace {

using namespace inkcell;
using field_equation::Value;
namespace edges = format::edges;

alignas(4) uint8_t bytes[1024];
FieldRecord record;  // too large for the stack of a small board

Status open_bytes(size_t size) {
  GlyphField field;
  field.tiles_x = 77;
  const Status status = GlyphField::open({bytes, size}, field);
  CHECK(status == Status::ok || field.tiles_x == 77);  // out untouched
  return status;
}

GlyphField open() {
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

// One line, one arc, one pair, one triple, in four squares.
void make_small(bool linked) {
  record = FieldRecord();
  record.linked = linked;
  record.node_count = 1;
  record.arc_count = 1;
  record.line_count = 2;
  record.pair_count = 2;
  record.triple_count = 1;
  record.fields[0] = {16384, 0, -100 * 16, -128 * 16, 1000};
  record.fields[1] = {0, 16384, -90 * 16, 0, 0};
  record.fields[2] = {-16384, 0, 140 * 16, 0, 0};
  record.pairs[0][0] = 1;
  record.pairs[0][1] = 2;
  record.pairs[1][0] = 2;
  record.pairs[1][1] = 1;
  record.triples[0][0] = 2;
  record.triples[0][1] = 1;
  record.triples[0][2] = 0;
  record.triples[0][3] = 2;
  record.references[0] = format::glyph::kFirstNode;
  record.references[1] = record.field_reference(0);
  record.references[2] = record.pair_reference(0);
  record.references[3] = record.pair_reference(1);
  record.references[4] = record.triple_reference(0);
}

double magnitude(double value) {
  return value < 0 ? -value : value;
}

int64_t thousandths(double value) {
  return static_cast<int64_t>(value * 1000);
}

// Whether the fields of a cell keep the limits of docs/FORMAT.md at a point.
bool within_limits(const FieldRecord& of,
                   const Cell& cell,
                   double x,
                   double y) {
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    const FieldRecord::Field& f = of.fields[of.number_of(cell.fields[i])];
    const bool is_arc = of.number_of(cell.fields[i]) < of.arc_count;
    const double w = (f.nx * y - f.ny * x) / 16384 + f.along / 16.0;
    const double sag = f.bend / 524288.0 * w * w;
    const Value value = field_equation::value(f, is_arc, x, y);
    if (magnitude(value.f) >= 512 ||
        (is_arc && (magnitude(w) >= 512 || magnitude(sag) >= 256))) {
      return false;
    }
  }
  return true;
}

// Whether small errors cannot change which field decides, or whether a vertex
// is rounded.
bool is_decided(const FieldRecord& of, const Cell& cell, double x, double y) {
  for (uint32_t i = 1; i < cell.field_count; ++i) {
    for (uint32_t j = 0; j < i; ++j) {
      const uint32_t numbers[] = {of.number_of(cell.fields[i]),
                                  of.number_of(cell.fields[j])};
      Value v[2];
      for (int k = 0; k < 2; ++k) {
        v[k] = field_equation::value(of.fields[numbers[k]],
                                     numbers[k] < of.arc_count, x, y);
      }
      const double c = v[0].gx * v[1].gx + v[0].gy * v[1].gy;
      if (magnitude(v[0].f - v[1].f) < 0.1 ||
          magnitude(1 - c * c - 0.022) < 0.001) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST(refuses_field_records_that_do_not_fit) {
  for (int linked = 0; linked < 2; ++linked) {
    make_small(linked != 0);
    open();
    const uint32_t fields_bytes = 10 + 12;
    const uint32_t units = 4 + 4 + 5;
    CHECK_EQ(record.size(), linked != 0 ? 10 + fields_bytes + 2 * units
                                        : 18 + fields_bytes + units);
    CHECK_EQ(open_bytes(record.size()), Status::ok);
    CHECK_EQ(open_bytes(record.size() - 1), Status::corrupt);
    const size_t header = linked != 0 ? 10 : 18;
    CHECK_EQ(open_bytes(header - 1), Status::corrupt);
    CHECK_EQ(open_bytes(9), Status::corrupt);
    CHECK_EQ(open_bytes(0), Status::corrupt);
    bytes[1] ^= 0x40;
    CHECK_EQ(open_bytes(record.size()), Status::corrupt);
    bytes[1] = static_cast<uint8_t>(12 | (bytes[1] & 0x80));
    CHECK_EQ(open_bytes(sizeof(bytes)), Status::corrupt);
    for (uint32_t count = 8; count < header; count += 2) {
      open();
      bytes[count] = static_cast<uint8_t>(bytes[count] + 1);
      CHECK_EQ(open_bytes(record.size()), Status::corrupt);
      font_builder::put_u16(bytes + count, 0xffff);
      CHECK_EQ(open_bytes(sizeof(bytes)), Status::corrupt);
    }
  }
}

TEST(refuses_grids_beyond_1984_u) {
  make_small(false);
  const int16_t starts[] = {-1985, -1984, 1728, 1729};
  for (const int16_t start : starts) {
    const bool fits = start == -1984 || start == 1728;
    record.x0_u = start;
    record.y0_u = 0;
    record.write(bytes);
    CHECK_EQ(open_bytes(record.size()), fits ? Status::ok : Status::corrupt);
    record.x0_u = 0;
    record.y0_u = start;
    record.write(bytes);
    CHECK_EQ(open_bytes(record.size()), fits ? Status::ok : Status::corrupt);
  }
}

TEST(locates_every_kind_of_leaf) {
  for (int linked = 0; linked < 2; ++linked) {
    make_small(linked != 0);
    const GlyphField field = open();
    const Cell lone = locate(field, 127, 127);
    CHECK_EQ(lone.field_count, 1);
    CHECK_EQ(record.number_of(lone.fields[0]), 0);
    CHECK_EQ(lone.size_log2, 7);
    const Cell least = locate(field, 128, 0);
    CHECK(least.field_count == 2 && least.op == Csg::intersection);
    CHECK(record.number_of(least.fields[0]) == 1 &&
          record.number_of(least.fields[1]) == 2);
    CHECK(least.x0_u == 128 && least.y0_u == 0);
    const Cell greatest = locate(field, 0, 128);
    CHECK(greatest.field_count == 2 && greatest.op == Csg::union_);
    const Cell triple = locate(field, 255, 255);
    CHECK_EQ(triple.field_count, 3);
    CHECK(triple.op == Csg::intersection_of_union);
    CHECK(record.number_of(triple.fields[0]) == 1 &&
          record.number_of(triple.fields[1]) == 0);
    CHECK_EQ(record.number_of(triple.fields[2]), 2);
    CHECK(!triple.is_saturated() && triple.samples == nullptr);
  }
}

TEST(leaves_that_do_not_exist_are_outside) {
  for (int linked = 0; linked < 2; ++linked) {
    make_small(linked != 0);
    const uint32_t last = linked != 0 ? 0xffff : 0xff;
    const uint32_t beyond[] = {record.triple_reference(1), last};
    for (const uint32_t reference : beyond) {
      record.references[1] = static_cast<uint16_t>(reference);
      const Cell cell = locate(open(), 0, 0);
      CHECK(cell.is_saturated() && !cell.inside);
    }
    record.references[1] = format::glyph::kInside;
    CHECK(locate(open(), 0, 0).inside);
    record.pairs[0][1] = 3;  // of three fields
    CHECK(locate(open(), 128, 0).is_saturated());
    record.triples[0][0] = 4;
    CHECK(locate(open(), 255, 255).is_saturated());
    record.triples[0][0] = 0;
    CHECK_EQ(locate(open(), 255, 255).field_count, 3);
    record.triples[0][3] = 3;
    CHECK(locate(open(), 255, 255).is_saturated());
    record.pairs[1][0] = record.pairs[1][1] = 2;
    CHECK_EQ(locate(open(), 0, 128).field_count, 1);
    record.tile_log2 = 0;  // cannot be divided
    CHECK(locate(open(), 0, 0).is_saturated());
  }
}

TEST(refuses_heaps_that_cannot_be) {
  make_small(true);
  record.node_count = 0;
  record.tiles_x = 3;
  for (uint32_t units = 0; units < 5; ++units) {  // fewer than tiles
    record.write(bytes);
    font_builder::put_u16(bytes + 8, units);
    CHECK_EQ(open_bytes(sizeof(bytes)),
             units < 3 ? Status::corrupt : Status::ok);
  }
  // As if there were as many bytes: `open` reads none of the heap.
  for (uint32_t units = 8192; units <= 8193; ++units) {
    font_builder::put_u16(bytes + 8, units);
    CHECK_EQ(open_bytes(10 + 2 * units),
             units == 8192 ? Status::ok : Status::corrupt);
    CHECK_EQ(open_bytes(10 + 2 * units - 1), Status::corrupt);
  }
}

// Every reference that there can be, in a heap where fields, pairs and triples
// may begin anywhere: all is found that does not leave it.
TEST(linked_references_stay_in_the_heap) {
  constexpr uint32_t kUnits = 24;
  const uint32_t sizes[8] = {0, 4, 3, 5, 2, 2, 4, 0};
  for (uint32_t reference = 2; reference < 0x10000; ++reference) {
    record = FieldRecord();
    record.linked = true;
    record.write(bytes);
    font_builder::put_u16(bytes + 8, kUnits);
    font_builder::put_u16(bytes + 10, reference);
    for (uint32_t i = 1; i < kUnits; ++i) {
      font_builder::put_u16(bytes + 10 + 2 * i, 0);
    }
    GlyphField field;
    CHECK_OK(GlyphField::open({bytes, 10 + 2 * kUnits}, field));
    const Cell cell = locate(field, 3, 200);
    const uint32_t tag = reference >> 13;
    const uint32_t unit = reference & 0x1fff;
    if (unit == 0) {
      continue;  // the reference itself, read as something else
    }
    const bool exists = sizes[tag] != 0 && unit + sizes[tag] <= kUnits;
    // Pairs are of one field twice, the line at unit 0.
    const uint32_t fields_found = tag == 6 ? 3 : tag > 1 ? 1 : 0;
    CHECK_EQ(cell.field_count, exists ? fields_found : 0);
    CHECK_EQ(cell.size_log2, exists && tag == 1 ? 7 : 8);
    CHECK(!cell.inside);
    if (check::failed()) {
      break;
    }
  }
}

TEST(distances_of_a_corner_are_rounded) {
  make_small(false);
  // In the lower right square: min(y - 90, 140 - x), its corner at (140, 90).
  const GlyphField field = open();
  const auto at = [&field](int32_t x, int32_t y) {
    return distance_at(field, Q16_16::from_int(x), Q16_16::from_int(y)).raw;
  };
  CHECK_EQ(at(130, 120), 10 << 10);
  CHECK_EQ(at(135, 91), 1 << 10);
  CHECK_EQ(at(160, 100), -20 * 1024);
  CHECK_EQ(at(130, 50), -40 * 1024);
  CHECK(at(170, 50) >= -50 * 1024 - 60 && at(170, 50) <= -50 * 1024 + 60);
  // In the upper left square: max, whose inside is rounded.
  const GlyphField other = open();
  const int32_t inside =
      distance_at(other, Q16_16::from_int(100), Q16_16::from_int(128)).raw;
  CHECK(inside >= 1024 * 55 && inside < 1024 * 56);  // hypot(40, 38)
}

// The bounds that field.hpp states, at points of 1/256 u, where nothing but
// the arithmetic errs.
TEST(distances_follow_their_equations) {
  double plain_worst = 0;
  double bent_worst = 0;
  double round_worst = 0;
  double gradient_worst = 0;
  uint32_t rounded = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 200 : 4000;
  for (Rounds rounds(3, round_count); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    record = FieldRecord();
    record.linked = (round & 1) != 0;
    record.x0_u = static_cast<int16_t>(random.between(-300, 300));
    record.y0_u = static_cast<int16_t>(random.between(-300, 300));
    record.make(random, 100);
    const GlyphField field = open();
    for (int i = 0; i < 10; ++i) {
      const int32_t x = 256 * record.x0_u + random.between(0, 65535);
      const int32_t y = 256 * record.y0_u + random.between(0, 65535);
      const Cell cell = locate(field, x >> 8, y >> 8);
      if (cell.is_saturated() ||
          !within_limits(record, cell, x / 256.0, y / 256.0)) {
        continue;
      }
      const Value value =
          field_equation::cell(record, cell, x / 256.0, y / 256.0);
      if (magnitude(value.f) > 64) {
        continue;
      }
      const Q16_16 x_u = Q16_16::from_raw(x * 256);
      const Q16_16 y_u = Q16_16::from_raw(y * 256);
      const double found = distance_at(field, x_u, y_u).raw / 1024.0;
      const double error = magnitude(found - value.f);
      bool is_bent = false;
      bool is_field = false;
      for (uint32_t j = 0; j < cell.field_count; ++j) {
        const uint32_t number = record.number_of(cell.fields[j]);
        const bool is_arc = number < record.arc_count;
        is_bent = is_bent || is_arc;
        const double f = field_equation::value(record.fields[number], is_arc,
                                               x / 256.0, y / 256.0)
                             .f;
        is_field = is_field || magnitude(f - value.f) < 1e-9;
      }
      double& worst =
          is_field ? (is_bent ? bent_worst : plain_worst) : round_worst;
      const double part = is_field ? error : error / magnitude(value.f);
      worst = part > worst ? part : worst;
      rounded += is_field ? 0 : 1;
      if (!is_decided(record, cell, x / 256.0, y / 256.0)) {
        continue;
      }
      const Gradient gradient = gradient_at(field, x_u, y_u);
      const double length =
          field_equation::root(value.gx * value.gx + value.gy * value.gy);
      const double dx = magnitude(gradient.x.raw / 16384.0 - value.gx / length);
      const double dy = magnitude(gradient.y.raw / 16384.0 - value.gy / length);
      const double turn = dx > dy ? dx : dy;
      gradient_worst = turn > gradient_worst ? turn : gradient_worst;
    }
  }
  check::write("largest errors [u / 1000]: planes ");
  check::write_number(thousandths(plain_worst));
  check::write(", bent ");
  check::write_number(thousandths(bent_worst));
  check::write(", of vertices ");
  check::write_number(thousandths(round_worst));
  check::write(" / 1000 of the distance, of gradients ");
  check::write_number(thousandths(gradient_worst));
  check::write(" / 1000\n");
  CHECK(plain_worst <= 1.0 / 1024);
  CHECK(bent_worst <= 1.0 / 64);
  CHECK(round_worst <= 1.0 / 128);
  CHECK(gradient_worst <= 1.0 / 64);
  CHECK(rounded > (INKCELL_BOARD_FIRMWARE ? 10u : 300u));
}

#else

TEST(fields_are_left_out) {
  FieldRecord record;
  uint8_t bytes[64];
  record.write(bytes);
  inkcell::GlyphField field;
  CHECK_EQ(inkcell::GlyphField::open({bytes, record.size()}, field),
           inkcell::Status::unsupported);
}

#endif
