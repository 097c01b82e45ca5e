// verify_fields: what opening a font of fields leaves to the moment of reading.
#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"

namespace {

using namespace inkcell;
using namespace font_builder;
namespace glyph = format::glyph;

alignas(4) uint8_t rom[1024];
alignas(4) uint8_t bytes[512];
Record record;

// Two tiles of 4 u, two nodes, two cells.
void make() {
  record.reset();
  record.tile_log2 = 2;
  record.tiles_x = 2;
  record.tiles_y = 1;
  record.reference_count = 2 + 8;
  record.cell_count = 2;
  for (uint32_t i = 0; i < record.reference_count; ++i) {
    record.references[i] = glyph::kCellFlag;
  }
  record.references[0] = glyph::kFirstNode;
  record.references[1] = glyph::kInside;
  record.references[4] = glyph::kFirstNode + 1;
  record.references[5] = glyph::kCellFlag | 1;
}

Status verify() {
  record.write(bytes);
  const GlyphSpec glyphs[] = {
      {500, {0, 0, 0, 0}, nullptr, nullptr, {bytes, record.size()}}};
  FontSpec spec;
  spec.glyphs = {glyphs, 1};
  const size_t size = build_font(spec, rom);
  CHECK(size != 0);
  Font font;
  CHECK_OK(Font::open({rom, size}, kFieldCoding, font));
  return verify_fields(font);
}

}  // namespace

TEST(accepts_fields) {
  make();
  CHECK_OK(verify());
}

TEST(finds_wrong_references) {
  const struct {
    uint32_t index;
    uint32_t reference;
    Status expected;
  } cases[] = {{1, glyph::kOutside, Status::ok},
               {1, glyph::kCellFlag | 1, Status::ok},
               {1, glyph::kCellFlag | 2, Status::corrupt},   // no such cell
               {1, 4, Status::corrupt},                      // no such node
               {3, glyph::kFirstNode, Status::corrupt},      // its parent
               {3, glyph::kFirstNode + 1, Status::corrupt},  // met twice
               {0, glyph::kFirstNode + 1, Status::corrupt},  // not the first
               {4, glyph::kOutside, Status::corrupt}};  // one node never met
  for (const auto& c : cases) {
    make();
    record.references[c.index] = static_cast<uint16_t>(c.reference);
    CHECK_EQ(verify(), c.expected);
  }
}

TEST(no_node_divides_a_square_of_1_u) {
  make();
  record.tile_log2 = 1;
  CHECK_EQ(verify(), Status::corrupt);
}

TEST(outlines_are_not_fields) {
  Font font;
  CHECK_EQ(verify_fields(font), Status::corrupt);  // it is not open
}
