// Generates fields of outlines, and counts.
//
//   FIRMWARE FONT FIRST LAST BAND TOLERANCE...  code points and u in decimal,
//                                               the tolerance in 1/1024 u
//
// Prints for each tolerance of the characters that have ink:
//
//   field TOLERANCE GLYPHS MEAN MOST STACK RECORD MOST_RECORD RAM MOST_RAM
//
// instructions (mean, most), the stack of the deepest glyph, the bytes of the
// field, and those of the least buffer that it can be generated in.
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "inkcell/field/generate.hpp"
#include "inkcell/format/rom.hpp"
#include "rom_file.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::open_font;
using bench::parse;
using bench::Total;

alignas(4) uint8_t font_bytes[1 << 20];
alignas(4) uint8_t ram[1 << 18];
constexpr uint8_t kUntouched = 0xa5;

// What is left between nodes and cells while the field grows: afterwards cells
// lie in it, and what nobody wrote to.
uint32_t free_bytes(const GlyphField& field) {
  const size_t cells = size_t{format::samples::kBytes} * field.cell_count;
  size_t end = record_bytes(field);
  const size_t begin = end;
  while (end < sizeof ram && ram[end] == kUntouched) {
    ++end;
  }
  return static_cast<uint32_t>(end - begin + cells);
}

bool measure(const Font& font,
             uint32_t first,
             uint32_t last,
             const FieldLimits& limits) {
  Total instructions;
  Total stack;
  Total records;
  Total buffers;
  for (uint32_t code_point = first; code_point <= last; ++code_point) {
    uint16_t glyph = 0;
    if (font.glyph_of(code_point, glyph) != Status::ok ||
        font.record(glyph).size == 0) {
      continue;
    }
    GlyphField field;
    Status status = Status::ok;
    const auto work = [&] {
      status = generate_field(font, glyph, limits, ram, field);
    };
    stack.add(static_cast<uint32_t>(board::count_stack(work)));
    for (uint8_t& byte : ram) {
      byte = kUntouched;
    }
    instructions.add(board::count_instructions(work));
    if (status != Status::ok) {
      return false;
    }
    records.add(static_cast<uint32_t>(record_bytes(field)));
    buffers.add(static_cast<uint32_t>(sizeof ram) - free_bytes(field));
  }
  if (instructions.count == 0) {
    return false;
  }
  bench::print_row("field", limits.tolerance.raw, instructions.count,
                   instructions.mean(), instructions.most, stack.most,
                   records.mean(), records.most, buffers.mean(), buffers.most);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Font font;
  if (argc < 6 || !open_font(argv[1], font_bytes, font)) {
    return bench::fail("usage: FONT FIRST LAST BAND TOLERANCE...");
  }
  for (int i = 5; i < argc; ++i) {
    FieldLimits limits;
    limits.band_u = static_cast<int32_t>(parse(argv[4]));
    limits.tolerance.raw = static_cast<int32_t>(parse(argv[i]));
    if (!measure(font, parse(argv[2]), parse(argv[3]), limits)) {
      return bench::fail("no glyphs, a limit out of range, or too little RAM");
    }
  }
  return 0;
}
