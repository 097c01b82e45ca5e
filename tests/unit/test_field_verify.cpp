// Font::verify and glyphs of cells of primitives.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/font.hpp"

#if INKCELL_EDGE_CELLS

namespace {

using namespace inkcell;
using namespace font_builder;
namespace glyph = format::glyph;

alignas(4) uint8_t rom[1024];
alignas(4) uint8_t bytes[512];
FieldRecord record;  // too large for the stack of a small board

Status verify() {
  record.write(bytes);
  const GlyphSpec glyphs[] = {
      {500, {0, 0, 0, 0}, nullptr, nullptr, {bytes, record.size()}}};
  FontSpec spec;
  spec.glyphs = {glyphs, 1};
  const size_t size = build_font(spec, rom);
  CHECK(size != 0);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font.verify();
}

// Two tiles, two nodes, leaves of all kinds.
void make(bool linked) {
  Random random(1);
  record = FieldRecord();
  record.linked = linked;
  record.tiles_x = 2;
  record.make(random, 50);
  for (FieldRecord::Field& field : record.fields) {
    field = random_field(random, 0, 0, 50);
  }
  record.arc_count = 2;
  record.line_count = 2;
  record.pair_count = 1;
  record.triple_count = 1;
  record.node_count = 2;
  record.pairs[0][0] = 3;
  record.pairs[0][1] = 0;
  const uint16_t triple[] = {3, 3, 0, 1};
  for (int i = 0; i < 4; ++i) {
    record.triples[0][i] = triple[i];
  }
  for (uint16_t& reference : record.references) {
    reference = record.field_reference(0);
  }
  record.references[0] = glyph::kFirstNode;
  record.references[1] = record.triple_reference(0);
  record.references[2] = record.pair_reference(0);
  record.references[4] = glyph::kFirstNode + 1;
  record.references[5] = record.field_reference(2);
}

// What verify says of a record of tiles of 256 u whose heap begins with these
// units, and goes on with zeros.
Status verify_heap(uint8_t tiles,
                   uint16_t units,
                   uint16_t first,
                   uint16_t second) {
  alignas(2) static uint8_t heap[40];
  for (uint8_t& byte : heap) {
    byte = 0;
  }
  heap[0] = 2;
  heap[1] = 0x88;
  heap[6] = tiles;
  heap[7] = 1;
  put_u16(heap + 8, units);
  put_u16(heap + 10, first);
  put_u16(heap + 12, second);
  const GlyphSpec glyphs[] = {
      {500, {0, 0, 0, 0}, nullptr, nullptr, {heap, 10 + 2u * units}}};
  FontSpec spec;
  spec.glyphs = {glyphs, 1};
  const size_t size = build_font(spec, rom);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font.verify();
}

}  // namespace

TEST(accepts_fields) {
  for (int linked = 0; linked < 2; ++linked) {
    make(linked != 0);
    CHECK_OK(verify());
  }
}

TEST(finds_wrong_references_to_fields) {
  for (int linked = 0; linked < 2; ++linked) {
    struct Case {
      uint32_t index;
      uint32_t reference;
      Status expected;
    };
    make(linked != 0);
    // A heap does not say where nodes are that nothing refers to.
    const Status unmet = linked != 0 ? Status::ok : Status::corrupt;
    const Case cases[] = {
        {1, glyph::kInside, Status::ok},
        {1, record.field_reference(3), Status::ok},
        {1, record.triple_reference(0) + 1u, Status::corrupt},
        {1, linked != 0 ? 0xffffu : 0xffu, Status::corrupt},
        {3, glyph::kFirstNode, Status::corrupt},      // its parent
        {3, glyph::kFirstNode + 1, Status::corrupt},  // met twice
        {0, glyph::kFirstNode + 1, unmet},            // not the first
        {4, glyph::kOutside, unmet}};                 // one node never met
    for (const Case& c : cases) {
      make(linked != 0);
      record.references[c.index] = static_cast<uint16_t>(c.reference);
      CHECK_EQ(verify(), c.expected);
    }
    make(linked != 0);
    record.tile_log2 = 1;  // the second node divides 1 u
    CHECK_EQ(verify(), Status::corrupt);
    record.tile_log2 = 2;
    CHECK_EQ(verify(), Status::ok);
  }
}

TEST(finds_wrong_combinations) {
  for (int linked = 0; linked < 2; ++linked) {
    for (int i = 0; i < 4; ++i) {
      make(linked != 0);
      record.triples[0][i] = 4;
      CHECK_EQ(verify(), Status::corrupt);
    }
    for (int i = 0; i < 2; ++i) {
      make(linked != 0);
      record.pairs[0][i] = 4;
      CHECK_EQ(verify(), Status::corrupt);
    }
  }
}

TEST(finds_normals_that_are_not_of_unit_length) {
  struct Case {
    int32_t nx;
    int32_t ny;
    Status expected;
  };
  const Case cases[] = {
      {16384, 0, Status::ok},       {0, -16384, Status::ok},
      {16384 - 256, 0, Status::ok}, {16384 - 257, 0, Status::corrupt},
      {16384 + 256, 0, Status::ok}, {16384 + 257, 0, Status::corrupt},
      {11585, -11585, Status::ok},  {-32768, -32768, Status::corrupt},
      {0, 0, Status::corrupt}};
  for (const Case& c : cases) {
    for (uint32_t i = 0; i < 8; ++i) {
      make(i < 4);
      const uint32_t number = i % 4;
      record.fields[number].nx = c.nx;
      record.fields[number].ny = c.ny;
      CHECK_EQ(verify(), c.expected);
    }
  }
}

// One byte says 256 things: 2 sides, and what is left.
TEST(finds_more_than_a_reference_can_say) {
  static uint8_t large[18 + 6 * 255 + 4];
  alignas(4) static uint8_t large_rom[sizeof(large) + 300];
  for (uint32_t lines = 254; lines <= 255; ++lines) {
    for (uint8_t& byte : large) {
      byte = 0;
    }
    large[0] = glyph::kTypeEdges;
    large[6] = large[7] = 1;
    put_u16(large + format::edges::kLineCount, lines);
    for (uint32_t i = 0; i < lines; ++i) {
      put_u16(large + format::edges::kBytes + 6 * i, 1 << 14);
    }
    const GlyphSpec glyphs[] = {
        {500, {0, 0, 0, 0}, nullptr, nullptr, {large, 18 + 6 * lines + 1}}};
    FontSpec spec;
    spec.glyphs = {glyphs, 1};
    const size_t size = build_font(spec, large_rom);
    Font font;
    CHECK_OK(Font::open({large_rom, size}, font));
    CHECK_EQ(font.verify(), lines == 254 ? Status::ok : Status::corrupt);
  }
}

TEST(nodes_of_heaps_lie_behind_the_tiles_and_each_other) {
  constexpr uint16_t kNode = 1 << 13;
  CHECK_OK(verify_heap(6, 10, kNode | 6, 0));
  CHECK_EQ(verify_heap(6, 10, kNode | 5, 0), Status::corrupt);
  CHECK_EQ(verify_heap(6, 10, kNode | 1, 0), Status::corrupt);
  CHECK_OK(verify_heap(2, 11, kNode | 2, kNode | 6));
  CHECK_OK(verify_heap(2, 11, kNode | 2, kNode | 7));
  CHECK_EQ(verify_heap(2, 11, kNode | 2, kNode | 5), Status::corrupt);
}

#endif
