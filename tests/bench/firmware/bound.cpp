// The dearest glyph of an em that bytes can describe: every pixel in a cell of
// its own, found at the bottom of its tree, of three bent fields with a rounded
// vertex. What any other glyph of as many pixels costs is less.
//
//   FIRMWARE DEPTH PX...
//
// Prints for each size: bound PX PIXELS INSTRUCTIONS STACK, for strips of 16
// rows of 8-bit coverage.
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell_strips.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;

constexpr uint32_t kEm = 1024;
constexpr uint32_t kMinDepth = 5;
constexpr uint32_t kMaxTiles = (kEm >> kMinDepth) * (kEm >> kMinDepth);
alignas(4) uint8_t record[128 + kMaxTiles];
GlyphField field;

void put_u16(uint8_t*& at, int32_t value) {
  *at++ = static_cast<uint8_t>(value);
  *at++ = static_cast<uint8_t>(value >> 8);
}

// An arc without a direction: it is worth `tenths` of a px everywhere.
void put_arc(uint8_t*& at, int32_t tenths, int32_t px) {
  put_u16(at, 0);
  put_u16(at, 0);
  put_u16(at, tenths * 16 * static_cast<int32_t>(kEm) / (10 * px));
  put_u16(at, 16);
  put_u16(at, 1);
}

bool make_record(uint32_t depth, int32_t px) {
  const uint32_t tiles = depth < 10 ? kEm >> depth : 1;
  uint8_t* at = record;
  *at++ = 2;  // cells of primitives
  *at++ = static_cast<uint8_t>(depth);
  put_u16(at, 0);
  put_u16(at, 0);
  *at++ = static_cast<uint8_t>(tiles);
  *at++ = static_cast<uint8_t>(tiles);
  put_u16(at, static_cast<int32_t>(depth));
  put_u16(at, 3);  // arcs
  put_u16(at, 0);
  put_u16(at, 0);
  put_u16(at, 1);  // triples
  put_arc(at, -3, px);
  put_arc(at, 1, px);
  put_arc(at, 1, px);
  const uint8_t triple[] = {static_cast<uint8_t>(Csg::intersection_of_union), 0,
                            1, 2};
  for (const uint8_t byte : triple) {
    *at++ = byte;
  }
  for (uint32_t i = 0; i < tiles * tiles; ++i) {
    *at++ = format::glyph::kFirstNode;
  }
  // A node's children are the next node, those of the last the triple, which
  // comes behind the three fields.
  for (uint32_t node = 1; node <= depth; ++node) {
    const uint32_t child = node < depth ? node : depth + 3;
    for (int i = 0; i < 4; ++i) {
      *at++ = static_cast<uint8_t>(format::glyph::kFirstNode + child);
    }
  }
  const auto size = static_cast<size_t>(at - record);
  if (GlyphField::open({record, size}, field) != Status::ok) {
    return false;
  }
  field.ink = {0, 0, kEm - 1, kEm - 1};
  return true;
}

bool measure(uint32_t depth, int32_t px) {
  const Q26_6 size = Q26_6::from_int(px);
  if (!make_record(depth, px) ||
      TextStyle::make(size, kFilterText, bench::style) != Status::ok) {
    return false;
  }
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
  const uint32_t numbers[] = {static_cast<uint32_t>(px),
                              static_cast<uint32_t>(px * px),
                              board::count_instructions(work), stack};
  board::print("bound");
  for (const uint32_t number : numbers) {
    bench::print_number(number);
  }
  board::print("\n");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const uint32_t depth = argc < 3 ? 0 : bench::parse(argv[1]);
  if (depth < kMinDepth || depth > format::glyph::kMaxTileLog2) {
    board::print("usage: DEPTH PX...\n");
    return 1;
  }
  for (int i = 2; i < argc; ++i) {
    if (!measure(depth, static_cast<int32_t>(bench::parse(argv[i])))) {
      board::print("the size does not fit\n");
      return 1;
    }
  }
  return 0;
}
