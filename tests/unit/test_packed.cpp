// Packed glyphs: expansion, bit by bit, and what is refused.
#include "check.hpp"
#include "inkcell/packed.hpp"
#include "packed_record.hpp"

#if INKCELL_PACKED

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::put_u16;

constexpr size_t kGuard = 16;
constexpr size_t kRoom = 2 * PackedRecord::kMaxUnits;

// Too large for the stack of a small board.
PackedRecord record;
alignas(4) uint8_t memory[kRoom + kGuard];
alignas(4) uint8_t linked[kRoom + 10];

void set_guards(size_t from) {
  for (size_t i = from; i < sizeof(memory); ++i) {
    memory[i] = 0xa5;
  }
}

bool guards_hold(size_t from) {
  for (size_t i = from; i < sizeof(memory); ++i) {
    if (memory[i] != 0xa5) {
      return false;
    }
  }
  return true;
}

PackedGlyph open_record() {
  PackedGlyph glyph;
  CHECK_OK(
      PackedGlyph::open({record.bytes, record.size}, record.coding, glyph));
  return glyph;
}

// Whether `out` is left alone by what does not succeed.
Status expand_into(const PackedGlyph& glyph,
                   uint32_t first,
                   uint32_t count,
                   size_t room,
                   GlyphField& field) {
  field.tile_log2 = 77;
  const Status status = expand(glyph, first, count, {memory, room}, field);
  CHECK((status == Status::ok) == (field.tile_log2 == 8));
  return status;
}

Status expand_record() {
  PackedGlyph glyph;
  GlyphField field;
  INKCELL_TRY(
      PackedGlyph::open({record.bytes, record.size}, record.coding, glyph));
  return expand_into(glyph, 0, glyph.tiles_y, kRoom, field);
}

Status open_changed(size_t size) {
  PackedGlyph glyph;
  glyph.tiles_x = 99;
  const Status status =
      PackedGlyph::open({record.bytes, size}, record.coding, glyph);
  CHECK((status == Status::ok) == (glyph.tiles_x != 99));
  return status;
}

// A glyph of one tile, up to the bits of its tree; no shared fields.
BitWriter begin_tile(uint32_t shared = 0) {
  record = PackedRecord();
  record.bytes[0] = 3;
  record.bytes[1] = 0x11;
  record.size = sizeof(record.bytes);
  BitWriter bits({record.bytes + 5, sizeof(record.bytes) - 5});
  bits.put(shared, 4);
  if (shared == 0) {
    bits.end_byte();
  }
  return bits;
}

FieldCode some_code() {
  FieldCode code;
  code.kind = FieldKind::arc;
  code.d0 = -3;
  code.angle = 5;
  code.bend = 7;
  return code;
}

double magnitude(double value) {
  return value < 0 ? -value : value;
}

}  // namespace

TEST(expands_to_the_linked_form) {
  Random random(1);
  const int rounds = INKCELL_BOARD_FIRMWARE ? 40 : 3000;
  for (int round = 0; round < rounds && !check::failed(); ++round) {
    record.make(random);
    const PackedGlyph glyph = open_record();
    CHECK(glyph.tiles_x == record.tiles_x && glyph.tiles_y == record.tiles_y);
    const uint32_t first = random.below(record.tiles_y);
    const uint32_t count = 1 + random.below(record.tiles_y - first);
    record.expect(first, count);
    GlyphField field;
    CHECK_OK(expand_into(glyph, first, count, kRoom, field));
    CHECK_EQ(field.heap_units, record.units);
    for (uint32_t i = 0; i < record.units; ++i) {
      if (get_u16(memory + 2 * i) != record.heap[i]) {
        CHECK_EQ(get_u16(memory + 2 * i), record.heap[i]);
        break;
      }
    }
    // The view is that of a linked record with this heap.
    GlyphField direct;
    const size_t size = record.write_linked(first, count, linked);
    CHECK_OK(GlyphField::open({linked, size}, direct));
    CHECK(direct.kind == field.kind && direct.x0_u == field.x0_u);
    CHECK(direct.y0_u == field.y0_u && direct.tiles_x == field.tiles_x);
    CHECK(direct.tiles_y == field.tiles_y &&
          direct.tile_log2 == field.tile_log2);
    CHECK_EQ(direct.heap_units, field.heap_units);
  }
}

TEST(rows_are_the_rows_of_the_whole) {
  Random random(2);
  for (int round = 0; round < (INKCELL_BOARD_FIRMWARE ? 10 : 200); ++round) {
    record.make(random);
    const PackedGlyph glyph = open_record();
    record.expect(0, record.tiles_y);
    GlyphField whole;
    const size_t size = record.write_linked(0, record.tiles_y, linked);
    CHECK_OK(GlyphField::open({linked, size}, whole));
    for (uint32_t row = 0; row < record.tiles_y; ++row) {
      GlyphField part;
      CHECK_OK(expand_into(glyph, row, 1, kRoom, part));
      for (int i = 0; i < 50; ++i) {
        const Q16_16 x = Q16_16::from_raw(
            random.between(part.x0_u * 65536, part.x1_u() * 65536 - 1));
        const Q16_16 y = Q16_16::from_raw(
            random.between(part.y0_u * 65536, part.y1_u() * 65536 - 1));
        CHECK_EQ(distance_at(part, x, y).raw, distance_at(whole, x, y).raw);
      }
    }
  }
}

TEST(takes_no_more_than_the_workspace) {
  Random random(3);
  record.make(random);
  record.shared_count = 3;
  CHECK(record.write());
  const PackedGlyph glyph = open_record();
  GlyphField field;
  const uint32_t bytes = 2 * record.units;
  for (size_t room = 0; room <= bytes + 1; ++room) {
    set_guards(room);
    CHECK_EQ(expand_into(glyph, 0, glyph.tiles_y, room, field),
             room < bytes ? Status::buffer_small : Status::ok);
    CHECK(guards_hold(room));
  }
  CHECK_EQ(expand(glyph, 0, 1, {}, field), Status::buffer_small);
  CHECK_EQ(expand(glyph, 0, 1, {memory + 1, kRoom}, field),
           Status::bad_argument);
}

TEST(expands_rows_that_exist) {
  Random random(4);
  record.make(random);
  const PackedGlyph glyph = open_record();
  GlyphField field;
  const uint32_t rows = glyph.tiles_y;
  CHECK_OK(expand_into(glyph, rows, 0, kRoom, field));
  CHECK_EQ(field.tiles_y, 0);
  CHECK_EQ(expand_into(glyph, rows, 1, kRoom, field), Status::bad_argument);
  CHECK_EQ(expand_into(glyph, 0, rows + 1, kRoom, field), Status::bad_argument);
  CHECK_EQ(expand_into(glyph, rows + 1, 0, kRoom, field), Status::bad_argument);
  CHECK_EQ(expand_into(glyph, 1, 0xffffffff, kRoom, field),
           Status::bad_argument);
  CHECK_OK(expand(PackedGlyph{}, 0, 0, {}, field));
  CHECK_EQ(field.tiles_y, 0);
}

TEST(opens_only_what_fits) {
  begin_tile();
  CHECK_OK(open_changed(record.size));
  CHECK_OK(open_changed(5));
  CHECK_EQ(open_changed(4), Status::corrupt);
  CHECK_EQ(open_changed(0), Status::corrupt);
  for (uint32_t type = 0; type < 256; ++type) {
    record.bytes[0] = static_cast<uint8_t>(type);
    CHECK_EQ(open_changed(100),
             (type & 0x7f) == 3 ? Status::ok : Status::unsupported);
  }
  record.bytes[0] = 3;
  record.bytes[1] = 0x10;
  CHECK_EQ(open_changed(100), Status::corrupt);
  record.bytes[1] = 0x01;
  CHECK_EQ(open_changed(100), Status::corrupt);
  record.bytes[1] = 0xf1;  // 14 lengths
  CHECK_EQ(open_changed(5 + 13), Status::corrupt);
  CHECK_EQ(open_changed(5 + 14), Status::corrupt);  // 3840 u from 0 on
  put_u16(record.bytes + 2, 0);
  record.bytes[4] = 0x84;  // from -1984 u on
  put_u16(record.bytes + 2, 0);
  CHECK_EQ(open_changed(5 + 14), Status::ok);
  CHECK_EQ(open_changed(5 + 13), Status::corrupt);
  record.bytes[0] = 0x83;
  CHECK_EQ(open_changed(5 + 28), Status::ok);
  CHECK_EQ(open_changed(5 + 27), Status::corrupt);
}

TEST(keeps_the_grid_within_1984_u) {
  struct Case {
    int32_t start;
    Status expected;
  };
  const Case cases[] = {{-2048, Status::corrupt}, {-1985, Status::corrupt},
                        {-1984, Status::ok},      {-1, Status::ok},
                        {1728, Status::ok},       {1729, Status::corrupt},
                        {2047, Status::corrupt}};
  for (const Case& c : cases) {
    begin_tile();
    const uint32_t start = static_cast<uint32_t>(c.start) & 0xfff;
    put_u16(record.bytes + 2, start);
    CHECK_EQ(open_changed(100), c.expected);
    put_u16(record.bytes + 2, (start & 15) << 12);
    record.bytes[4] = static_cast<uint8_t>(start >> 4);
    CHECK_EQ(open_changed(100), c.expected);
    if (c.expected == Status::ok) {
      CHECK_EQ(open_record().y0_u, c.start);
      CHECK_EQ(open_record().x0_u, 0);
    }
  }
}

TEST(refuses_rows_behind_the_end) {
  Random random(5);
  do {
    record.make(random);
  } while (record.tiles_y < 3 || record.wide_rows);
  CHECK_OK(expand_record());
  const uint8_t length = record.bytes[6];
  record.bytes[6] = 255;
  record.size = 5 + 2 + 200;
  CHECK_EQ(expand_record(), Status::corrupt);
  record.bytes[6] = length;
  // Shared fields of which the last reads beyond the end.
  BitWriter bits = begin_tile(1);
  bits.put(2, 2);
  FieldCode code = some_code();
  code.kind = FieldKind::line;
  bits.field(code, record.coding, 8);
  bits.end_byte();
  record.size = 5 + bits.bytes();
  CHECK_OK(expand_record());
  --record.size;
  CHECK_EQ(expand_record(), Status::corrupt);
}

TEST(reads_zeros_behind_the_end) {
  Random random(6);
  for (int round = 0; round < 50; ++round) {
    record.make(random);
    size_t used = record.size;
    GlyphField field;
    CHECK_OK(expand_into(open_record(), 0, record.tiles_y, kRoom, field));
    const uint32_t units = field.heap_units;
    for (; used > 0 && record.bytes[used - 1] == 0; --used) {
    }
    if (used == record.size) {
      continue;
    }
    // Zeros that are not there, and other bytes behind the end.
    for (size_t i = used; i < sizeof(record.bytes); ++i) {
      record.bytes[i] = 0xff;
    }
    record.size = used;
    CHECK_OK(expand_into(open_record(), 0, record.tiles_y, kRoom, field));
    CHECK_EQ(field.heap_units, units);
  }
}

TEST(refuses_to_divide_1_u) {
  for (uint32_t last = 0; last < 2; ++last) {
    BitWriter bits = begin_tile();
    for (uint32_t log2 = 8; log2 > 0; --log2) {
      bits.node(log2, 0);
    }
    bits.node(0, last == 0 ? 1 : 0);
    for (uint32_t log2 = 0; log2 < 8; ++log2) {
      for (int i = 0; i < 3; ++i) {
        bits.node(log2, 1);
      }
    }
    CHECK_EQ(expand_record(), last == 0 ? Status::ok : Status::corrupt);
  }
}

TEST(refuses_ranks_behind_the_list) {
  for (uint32_t known = 0; known < 4; ++known) {
    for (uint32_t step = 0; step < 16; ++step) {
      BitWriter bits = begin_tile(known == 0 ? 0 : known);
      for (uint32_t i = 0; i < known; ++i) {
        FieldCode code = some_code();
        bits.put(static_cast<uint32_t>(code.kind), 2);
        bits.field(code, record.coding, 8);
      }
      bits.end_byte();
      bits.node(8, 3);
      bits.kind(0, false, 0);
      bits.rank(true, step);
      CHECK_EQ(expand_record(), step < known ? Status::ok : Status::corrupt);
      // The second of a pair counts from behind the first.
      bits = begin_tile(known);
      for (uint32_t i = 0; i < known; ++i) {
        FieldCode code = some_code();
        bits.put(static_cast<uint32_t>(code.kind), 2);
        bits.field(code, record.coding, 8);
      }
      bits.end_byte();
      bits.node(8, 4);
      bits.kind(0, false, 0);
      bits.rank(true, 0);
      bits.kind(1, false, 0);
      bits.rank(false, step);
      CHECK_EQ(expand_record(),
               step + 1 < known ? Status::ok : Status::corrupt);
    }
  }
}

TEST(refuses_a_field_in_both_groups) {
  for (uint32_t first = 0; first < 3; ++first) {
    for (uint32_t second = 0; second < 3; ++second) {
      for (uint32_t symbol = 8; symbol < 10; ++symbol) {
        BitWriter bits = begin_tile(4);
        for (uint32_t i = 0; i < 4; ++i) {
          bits.put(static_cast<uint32_t>(some_code().kind), 2);
          bits.field(some_code(), record.coding, 8);
        }
        bits.end_byte();
        bits.node(8, symbol);
        const uint32_t ranks[] = {first, second};
        for (uint32_t i = 0; i < 2; ++i) {
          bits.kind(i, false, 0);
          bits.rank(true, ranks[i]);
        }
        bits.kind(2, false, 4);
        bits.field(some_code(), record.coding, 8);
        CHECK_EQ(expand_record(),
                 first == second ? Status::corrupt : Status::ok);
      }
    }
  }
}

TEST(refuses_16_ones) {
  for (uint32_t ones = 14; ones <= 17; ++ones) {
    BitWriter bits = begin_tile();
    bits.node(8, 3);
    bits.kind(0, false, 4);
    bits.put(300, record.coding.d0_bits(8));
    bits.put(77, record.coding.angle_bits(8));
    for (uint32_t i = 0; i < ones; ++i) {
      bits.put(1, 1);
    }
    bits.put(0, 1);
    CHECK_EQ(expand_record(), ones < 16 ? Status::ok : Status::corrupt);
  }
}

TEST(forgets_the_17th_field) {
  // 15 shared fields, two more, and the one that is 15 places back.
  BitWriter bits = begin_tile(15);
  FieldCode code = some_code();
  for (uint32_t i = 0; i < 15; ++i) {
    bits.put(static_cast<uint32_t>(code.kind), 2);
    bits.field(code, record.coding, 8);
  }
  bits.end_byte();
  bits.node(8, 0);
  for (uint32_t i = 0; i < 2; ++i) {
    bits.node(7, 3);
    bits.kind(0, false, 4);
    bits.field(code, record.coding, 7);
  }
  bits.node(7, 3);
  bits.kind(0, false, 0);
  bits.rank(true, 15);
  bits.node(7, 6);  // three fields, of which the oldest is pushed out
  bits.kind(0, false, 0);
  bits.rank(true, 15);
  for (uint32_t i = 1; i < 3; ++i) {
    bits.kind(i, i == 2, 4);
    bits.field(code, record.coding, 7);
  }
  GlyphField field;
  CHECK_OK(expand_into(open_record(), 0, 1, kRoom, field));
  // Shared fields lie behind the tile from unit 1 on, numbers 13 and 12.
  CHECK_EQ(get_u16(memory + 2 * (1 + 75 + 2)), 3 << 13 | (1 + 5 * 13));
  const uint32_t triple = get_u16(memory + 2 * (1 + 75 + 3));
  CHECK_EQ(triple >> 13, 6);
  CHECK_EQ(get_u16(memory + 2 * ((triple & 0x1fff) + 1)),
           0x8000 | (1 + 5 * 12));
}

// Whatever the bits, what does not fit is refused, and what fits is safe.
TEST(any_bytes_are_safe) {
  Random random(7);
  int expanded = 0;
  const int rounds = INKCELL_BOARD_FIRMWARE ? 300 : 20000;
  for (int round = 0; round < rounds; ++round) {
    record.coding = usual_coding();
    if (round % 2 == 0) {
      record.make(random);
      for (uint32_t i = 1 + random.below(4); i > 0; --i) {
        record.bytes[random.below(static_cast<uint32_t>(record.size))] ^=
            static_cast<uint8_t>(1u << random.below(8));
      }
    } else {
      for (uint8_t& byte : record.bytes) {
        byte = static_cast<uint8_t>(random.byte());
      }
      record.bytes[0] = random.below(2) != 0 ? 3 : 0x83;
      record.bytes[1] = static_cast<uint8_t>(record.bytes[1] & 0x33);
      record.size = 5 + random.below(sizeof(record.bytes) - 4);
    }
    if (round % 8 < 2) {
      uint8_t quantisation[8];
      for (uint8_t& byte : quantisation) {
        byte = static_cast<uint8_t>(random.byte());
      }
      record.coding = PackedCoding::read(quantisation);
    }
    PackedGlyph glyph;
    if (PackedGlyph::open({record.bytes, record.size}, record.coding, glyph) !=
        Status::ok) {
      continue;
    }
    const size_t room = random.below(kRoom + 1);
    set_guards(room);
    GlyphField field;
    const uint32_t first = random.below(glyph.tiles_y);
    const Status status = expand_into(
        glyph, first, 1 + random.below(glyph.tiles_y - first), room, field);
    CHECK(guards_hold(room));
    if (status != Status::ok) {
      CHECK(status == Status::corrupt || status == Status::buffer_small);
      continue;
    }
    ++expanded;
    CHECK(2u * field.heap_units <= room);
    for (int i = 0; i < 20; ++i) {
      const int32_t x = random.between(field.x0_u, field.x1_u() - 1);
      const int32_t y = random.between(field.y0_u, field.y1_u() - 1);
      distance_at(field, Q16_16::from_int(x), Q16_16::from_int(y));
    }
  }
  CHECK(expanded > rounds / 50);
}

TEST(reads_its_steps) {
  const uint8_t bytes[] = {1, 2, 3, 4, 5, 6, 0x21, 0x43};
  const PackedCoding coding = PackedCoding::read(bytes);
  CHECK(coding.d0_step == 1 && coding.bend_step == 2);
  CHECK_EQ(coding.d0_bits(4), 3);
  CHECK_EQ(coding.d0_bits(8), 7);
  CHECK_EQ(coding.angle_bits(5), 5);
  CHECK_EQ(coding.angle_bits(12), 12);
  const uint32_t k[] = {4, 4, 4, 4, 4, 4, 3, 2, 1, 1, 1, 1, 1};
  for (uint32_t log2 = 0; log2 <= 12; ++log2) {
    CHECK_EQ(coding.bend_bits(log2), k[log2]);
  }
  PackedCoding widest;
  widest.d0_base = widest.angle_base = 255;
  CHECK_EQ(widest.d0_bits(12), 16);
  CHECK_EQ(widest.angle_bits(12), 16);
}

TEST(directions_are_true_to_1_in_16384) {
  PackedCoding coding;
  coding.angle_base = 16;
  FieldCode code;
  code.kind = FieldKind::line;
  double worst = 0;
  const uint32_t step = INKCELL_BOARD_FIRMWARE ? 97 : 1;
  // Turns by the smallest angle, in double.
  const double small = 6.283185307179586 / 65536 * step;
  const double turn_sine = small - small * small * small / 6;
  const double turn_cosine =
      1 - small * small / 2 + small * small * small * small / 24;
  double cosine = 1;
  double sine = 0;
  for (uint32_t angle = 0; angle < 65536; angle += step) {
    code.angle = angle;
    const FieldNumbers field = expand_field(code, coding, 8, 0, 0);
    const double dx = magnitude(field.nx_q14 - 16384 * cosine);
    const double dy = magnitude(field.ny_q14 - 16384 * sine);
    worst = dx > worst ? dx : worst;
    worst = dy > worst ? dy : worst;
    const double next = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = next;
  }
  check::write("largest error of a direction [Q14 / 1000]: ");
  check::write_number(static_cast<int64_t>(worst * 1000));
  check::write("\n");
  CHECK(worst < 1);
}

TEST(axes_are_exact) {
  const int16_t expected[4][2] = {
      {16384, 0}, {0, 16384}, {-16384, 0}, {0, -16384}};
  FieldCode code;
  for (uint32_t quarter = 0; quarter < 4; ++quarter) {
    code.angle = quarter;
    const FieldNumbers field = expand_field(code, usual_coding(), 5, 0, 0);
    CHECK_EQ(field.nx_q14, expected[quarter][0]);
    CHECK_EQ(field.ny_q14, expected[quarter][1]);
  }
}

TEST(fields_pass_where_they_say) {
  Random random(8);
  const PackedCoding coding = usual_coding();
  for (int round = 0; round < 2000; ++round) {
    const uint32_t log2 = 2 + random.below(9);
    const int32_t x = random.between(-1400, 1400);
    const int32_t y = random.between(-1400, 1400);
    FieldCode code;
    code.kind = static_cast<FieldKind>(random.below(4));
    code.d0 = random.between(-255, 255);
    code.angle =
        random.below(has_angle(code.kind) ? 1u << coding.angle_bits(log2) : 4);
    code.bend = is_bent(code.kind) ? random.between(-40, 40) : 0;
    const FieldNumbers f = expand_field(code, coding, log2, x, y);
    const double nx = f.nx_q14 / 16384.0;
    const double ny = f.ny_q14 / 16384.0;
    const double distance = nx * x + ny * y + f.c_q4 / 16.0;
    CHECK(magnitude(distance - code.d0 * coding.d0_step / 64.0) <= 1.0 / 32);
    CHECK_EQ(f.bend == 0, code.bend == 0 || !is_bent(code.kind));
    if (f.bend == 0) {
      CHECK_EQ(f.along_q4, 0);
      continue;
    }
    const double along = nx * y - ny * x + f.along_q4 / 16.0;
    CHECK(magnitude(along) <= 1.0 / 32);
    // The sagitta half a chord away from the anchor.
    const double reach = 1 << (log2 > 6 ? log2 - 1 : 5);
    const double sagitta = f.bend / 524288.0 * reach * reach;
    CHECK(magnitude(sagitta - code.bend * coding.bend_step / 64.0) <=
              0.5 * reach * reach / 524288 + 1e-9 ||
          f.bend == 32767 || f.bend == -32767);
  }
}

TEST(numbers_that_do_not_fit_are_clamped) {
  PackedCoding coding = usual_coding();
  coding.d0_step = 255;
  coding.bend_step = 255;
  FieldCode code;
  code.kind = FieldKind::arc;
  code.d0 = 32767;
  code.bend = INT32_MAX;
  FieldNumbers field = expand_field(code, coding, 8, 0, 0);
  CHECK_EQ(field.c_q4, 32767);
  CHECK_EQ(field.bend, 32767);
  code.d0 = -32768;
  code.bend = INT32_MIN;
  field = expand_field(code, coding, 8, 0, 0);
  CHECK_EQ(field.c_q4, -32768);
  CHECK_EQ(field.bend, -32767);
  // Rounded to no bend at all: a line.
  coding.bend_step = 1;
  code.bend = 1;
  code.d0 = 0;
  CHECK_EQ(expand_field(code, coding, 12, 100, 100).bend, 0);
  CHECK_EQ(expand_field(code, coding, 12, 100, 100).along_q4, 0);
}

#else

TEST(packed_glyphs_are_left_out) {
  const uint8_t bytes[] = {3, 0x11, 0, 0, 0, 0};
  inkcell::PackedGlyph glyph;
  CHECK_EQ(inkcell::PackedGlyph::open(bytes, {}, glyph),
           inkcell::Status::unsupported);
}

#endif
