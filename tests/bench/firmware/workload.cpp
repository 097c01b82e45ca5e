// Draws characters with an engine, one glyph at a time, and counts.
//
//   FIRMWARE FONT WAY FIRST LAST PX...      code points and sizes in decimal
//
// FONT is a file, read through semihosting; WAY is one of the engine's. For
// each size it prints: size, glyphs, instructions (mean, most), stack of the
// deepest glyph, heap, workspace [bytes], the sum of all coverage, and the
// pixels of all boxes. Characters that the font lacks are left out.
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "engine.h"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::parse;

constexpr size_t kFontBytes = 1 << 20;
alignas(4) uint8_t font_bytes[kFontBytes];

struct Size {
  bench::Total instructions;
  bench::Total stack;
  bench::Total ink;
  bench::Total box;
};

bool add_glyph(uint32_t code_point, Size& size) {
  const auto work = [code_point] { engine_draw(code_point); };
  const engine_answer answer = engine_prepare(code_point);
  if (answer != engine_ready) {
    return answer == engine_lacks;
  }
  // First, so that what an engine allocates once is not counted.
  size.stack.add(static_cast<uint32_t>(board::count_stack(work)));
  engine_prepare(code_point);
  size.instructions.add(board::count_instructions(work));
  size.ink.add(engine_ink());
  size.box.add(engine_box());
  return true;
}

// A loop of two instructions counts what it must, or nothing is believed.
bool counter_is_exact() {
  const auto loop = [](uint32_t rounds) {
    return board::count_instructions([rounds] {
      uint32_t left = rounds;
#if defined(__riscv)
      asm volatile("1: addi %0, %0, -1\n bnez %0, 1b\n" : "+r"(left));
#else
      asm volatile(".syntax unified\n1: subs %0, #1\n bne 1b\n"
                   : "+l"(left)
                   :
                   : "cc");
#endif
    });
  };
  loop(1);
  return loop(11000) - loop(1000) == 20000;
}

// Why a size cannot be measured, or null.
const char* run_size(uint32_t px,
                     const char* way,
                     uint32_t first,
                     uint32_t last) {
  if (!engine_set_size(px, way)) {
    return "the engine refuses the size or the way";
  }
  Size size;
  for (uint32_t code_point = first; code_point <= last; ++code_point) {
    if (!add_glyph(code_point, size)) {
      return "a glyph is larger than there is room for";
    }
  }
  if (size.instructions.count == 0) {
    return "the font has none of the characters";
  }
  bench::print_row("size", px, size.instructions.count,
                   size.instructions.mean(), size.instructions.most,
                   size.stack.most, engine_heap(), engine_workspace(),
                   size.ink.sum, size.box.sum);
  return nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    return bench::fail("usage: FONT WAY FIRST LAST PX...");
  }
  if (!counter_is_exact()) {
    return bench::fail("the counter is not exact");
  }
  const size_t size = bench::read_file(argv[1], font_bytes, sizeof font_bytes);
  if (size == 0) {
    return bench::fail("the font cannot be read, or is larger than 1 MB");
  }
  if (!engine_open(font_bytes, size)) {
    return bench::fail("the font does not open");
  }
  for (int i = 5; i < argc; ++i) {
    const char* const why =
        run_size(parse(argv[i]), argv[2], parse(argv[3]), parse(argv[4]));
    if (why != nullptr) {
      return bench::fail(why);
    }
  }
  return 0;
}
