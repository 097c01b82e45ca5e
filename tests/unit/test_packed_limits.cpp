// Packed glyphs at the limits of their streams and of the heap.
#include "check.hpp"
#include "inkcell/packed.hpp"
#include "packed_record.hpp"

#if INKCELL_PACKED

namespace {

using namespace inkcell;

alignas(2) uint8_t memory[256];

PackedGlyph open(Span<const uint8_t> record, const PackedCoding& coding) {
  PackedGlyph glyph;
  CHECK_OK(PackedGlyph::open(record, coding, glyph));
  return glyph;
}

}  // namespace

// Behind the last byte there are zeros: all of a row may be made of them.
TEST(the_last_row_may_have_no_bytes) {
  // A tile above another. The lower one is empty.
  uint8_t bytes[16] = {3, 0x21};
  BitWriter bits({bytes + 6, sizeof(bytes) - 6});
  bits.put(0, 4);
  bits.end_byte();
  const size_t begin = bits.bytes();
  bits.node(8, 1);
  bits.end_byte();
  const size_t row_bytes = bits.bytes() - begin;
  bytes[5] = static_cast<uint8_t>(row_bytes);
  const Span<const uint8_t> record(bytes, 6 + bits.bytes());
  const Workspace workspace(memory, sizeof(memory));
  GlyphField field;
  CHECK_OK(expand(open(record, usual_coding()), 0, 1, workspace, field));
  CHECK_EQ(font_builder::get_u16(memory), 0);
  // A byte more leaves the record.
  bytes[5] = static_cast<uint8_t>(row_bytes + 1);
  CHECK_EQ(expand(open(record, usual_coding()), 0, 1, workspace, field),
           Status::corrupt);
}

// Of a shared field whose square is so large that the least bend is nothing.
TEST(bends_that_round_to_nothing_are_lines) {
  PackedCoding coding = usual_coding();
  coding.bend_step = 1;
  FieldCode code;
  code.kind = FieldKind::arc;
  code.d0 = -3;
  code.angle = 5;
  code.bend = 1;
  CHECK_EQ(expand_field(code, coding, 9, 256, 128).bend, 0);
  // Two tiles next to each other, the first of which refers to it.
  uint8_t bytes[32] = {3, 0x12};
  BitWriter bits({bytes + 5, sizeof(bytes) - 5});
  bits.put(1, 4);
  bits.put(static_cast<uint32_t>(code.kind), 2);
  bits.field(code, coding, 9);
  bits.end_byte();
  bits.node(8, 3);
  bits.kind(0, false, 0);
  bits.rank(true, 0);
  bits.node(8, 1);
  bits.end_byte();
  GlyphField field;
  CHECK_OK(expand(open({bytes, 5 + bits.bytes()}, coding), 0, 1,
                  {memory, sizeof(memory)}, field));
  // Two references and a line of three units, behind them.
  CHECK_EQ(field.heap_units, 2 + 3);
  CHECK_EQ(font_builder::get_u16(memory), 2 << 13 | 2);
}

TEST(bends_end_at_2_to_19) {
  PackedCoding coding = usual_coding();
  coding.bend_step = 1;
  FieldCode code;
  code.kind = FieldKind::arc;
  // In squares of 4096 u a step is 2^-9 of what is told apart.
  const auto bend_of = [&](int32_t steps) {
    code.bend = steps;
    return expand_field(code, coding, 12, 0, 0).bend;
  };
  constexpr int32_t kMost = 1 << 19;
  CHECK_EQ(bend_of(kMost - 512), (kMost >> 9) - 1);
  CHECK_EQ(bend_of(kMost), kMost >> 9);
  CHECK_EQ(bend_of(kMost + 512), kMost >> 9);
  CHECK_EQ(bend_of(-kMost - 512), -(kMost >> 9));
  CHECK_EQ(bend_of(INT32_MAX), kMost >> 9);
  CHECK_EQ(bend_of(INT32_MIN), -(kMost >> 9));
}

#  if !INKCELL_BOARD_FIRMWARE

namespace {

constexpr uint32_t kMostUnits = 8192;
alignas(2) uint8_t large_memory[2 * kMostUnits + 512];
uint8_t stream[8192];

// Divides squares until there are `left` nodes less; the others are empty.
void put_tree(BitWriter& bits, uint32_t log2, uint32_t& left) {
  const bool is_divided = log2 > 0 && left > 0;
  bits.node(log2, is_divided ? 0 : 1);
  if (is_divided) {
    --left;
    for (int i = 0; i < 4; ++i) {
      put_tree(bits, log2 - 1, left);
    }
  }
}

}  // namespace

// However much memory there is: references have no more than 13 bits.
TEST(heaps_end_at_8192_units) {
  for (uint32_t nodes = 2047; nodes <= 2048; ++nodes) {
    stream[0] = 3;
    stream[1] = 0x11;
    BitWriter bits({stream + 5, sizeof(stream) - 5});
    bits.put(0, 4);
    bits.end_byte();
    uint32_t left = nodes;
    put_tree(bits, 8, left);
    bits.end_byte();
    CHECK(bits.fits());
    CHECK_EQ(left, 0);
    GlyphField field;
    const Status status =
        expand(open({stream, 5 + bits.bytes()}, usual_coding()), 0, 1,
               {large_memory, sizeof(large_memory)}, field);
    CHECK_EQ(status,
             1 + 4 * nodes <= kMostUnits ? Status::ok : Status::buffer_small);
  }
}

#  endif  // !INKCELL_BOARD_FIRMWARE

#endif  // INKCELL_PACKED
