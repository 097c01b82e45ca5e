// The dearest glyph of an em that bytes can describe: every pixel in a cell of
// its own, found at the bottom of its tree, of nine samples. What any other
// glyph of as many pixels costs is less.
//
//   FIRMWARE DEPTH PX...
//
// Prints for each size: bound PX PIXELS INSTRUCTIONS STACK, for strips of 16
// rows of 8-bit coverage.
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "inkcell/field/cell.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell_strips.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;

constexpr uint32_t kEm = 1024;
constexpr uint32_t kMinDepth = 5;
constexpr uint32_t kMaxTiles = (kEm >> kMinDepth) * (kEm >> kMinDepth);
alignas(4) uint8_t record[128 + 2 * kMaxTiles];
GlyphField field;

void put_u16(uint8_t*& at, int32_t value) {
  *at++ = static_cast<uint8_t>(value);
  *at++ = static_cast<uint8_t>(value >> 8);
}

bool make_record(uint32_t depth) {
  const uint32_t tiles = depth < 10 ? kEm >> depth : 1;
  uint8_t* at = record;
  *at++ = format::glyph::kTypeSamples;
  *at++ = static_cast<uint8_t>(depth);
  put_u16(at, 0);
  put_u16(at, 0);
  *at++ = static_cast<uint8_t>(tiles);
  *at++ = static_cast<uint8_t>(tiles);
  put_u16(at, static_cast<int32_t>(depth));
  put_u16(at, 1);  // cells
  for (uint32_t i = 0; i < tiles * tiles; ++i) {
    put_u16(at, format::glyph::kFirstNode);
  }
  // A node's children are the next node, those of the last one the cell.
  for (uint32_t node = 1; node <= depth; ++node) {
    for (int i = 0; i < 4; ++i) {
      put_u16(at, static_cast<int32_t>(node < depth
                                           ? format::glyph::kFirstNode + node
                                           : format::glyph::kCellFlag));
    }
  }
  // Slanted, and partly covered at any size.
  put_u16(at, 0);
  const int8_t offsets[] = {-64, -32, 0, -32, 32, 0, 32, 64};
  for (const int8_t offset : offsets) {
    *at++ = static_cast<uint8_t>(offset);
  }
  const auto size = static_cast<size_t>(at - record);
  if (GlyphField::open({record, size}, field) != Status::ok) {
    return false;
  }
  field.ink = {0, 0, kEm - 1, kEm - 1};
  return true;
}

bool measure(uint32_t depth, int32_t px) {
  if (!make_record(depth)) {
    return false;
  }
  bench::style = Style(Q26_6::from_int(px), kFilterText);
  const Rect box = field_box(field, bench::style, {});
  if (box.x1 - box.x0 > kEngineSide || box.y1 - box.y0 > kEngineSide) {
    return false;
  }
  bench::origin = {Q26_6::from_int(-box.x0), Q26_6::from_int(-box.y0)};
  bench::height = box.y1 - box.y0;
  const auto work = [] {
    bench::draw_strips(
        [] { draw_field(field, bench::style, bench::origin, bench::sink); });
  };
  const auto stack = static_cast<uint32_t>(board::count_stack(work));
  bench::print_row("bound", px, px * px, board::count_instructions(work),
                   stack);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const uint32_t depth = argc < 3 ? 0 : bench::parse(argv[1]);
  if (depth < kMinDepth || depth > format::glyph::kMaxTileLog2) {
    return bench::fail("usage: DEPTH PX...");
  }
  for (int i = 2; i < argc; ++i) {
    if (!measure(depth, static_cast<int32_t>(bench::parse(argv[i])))) {
      return bench::fail("the size does not fit");
    }
  }
  return 0;
}
