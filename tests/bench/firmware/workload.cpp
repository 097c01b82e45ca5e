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
#include "semihosting.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::parse;
using bench::print_number;

constexpr size_t kFontBytes = 1 << 20;
alignas(4) uint8_t font_bytes[kFontBytes];

struct Total {
  uint32_t glyphs = 0;
  uint32_t sum = 0;
  uint32_t most = 0;
  uint32_t stack = 0;
  uint32_t ink = 0;
  uint32_t box = 0;
};

bool add_glyph(uint32_t code_point, Total& total) {
  const auto work = [code_point] { engine_draw(code_point); };
  const engine_answer answer = engine_prepare(code_point);
  if (answer != engine_ready) {
    return answer == engine_lacks;
  }
  // First, so that what an engine allocates once is not counted.
  const auto stack = static_cast<uint32_t>(board::count_stack(work));
  engine_prepare(code_point);
  const uint32_t count = board::count_instructions(work);
  total.glyphs += 1;
  total.sum += count;
  total.most = count > total.most ? count : total.most;
  total.stack = stack > total.stack ? stack : total.stack;
  total.ink += engine_ink();
  total.box += engine_box();
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

bool fail(const char* why) {
  board::print(why);
  board::print("\n");
  return false;
}

bool run_size(uint32_t px, const char* way, uint32_t first, uint32_t last) {
  if (!engine_set_size(px, way)) {
    return fail("the engine refuses the size or the way");
  }
  Total total;
  for (uint32_t code_point = first; code_point <= last; ++code_point) {
    if (!add_glyph(code_point, total)) {
      return fail("a glyph is larger than there is room for");
    }
  }
  if (total.glyphs == 0) {
    return fail("the font has none of the characters");
  }
  board::print("size");
  print_number(px);
  print_number(total.glyphs);
  print_number((total.sum + total.glyphs / 2) / total.glyphs);
  print_number(total.most);
  print_number(total.stack);
  print_number(engine_heap());
  print_number(engine_workspace());
  print_number(total.ink);
  print_number(total.box);
  board::print("\n");
  return true;
}

bool open_font(const char* name) {
  const intptr_t file = semihosting::open(name, semihosting::Mode::read);
  if (file < 0) {
    return fail("there is no such font");
  }
  const intptr_t length = semihosting::length(file);
  const auto size = static_cast<size_t>(length);
  if (length < 0 || size > kFontBytes ||
      !semihosting::read(file, font_bytes, size)) {
    return fail("the font cannot be read, or is larger than 1 MB");
  }
  semihosting::close(file);
  return engine_open(font_bytes, size) || fail("the font does not open");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    fail("usage: FONT WAY FIRST LAST PX...");
    return 1;
  }
  if (!counter_is_exact()) {
    fail("the counter is not exact");
    return 1;
  }
  if (!open_font(argv[1])) {
    return 1;
  }
  for (int i = 5; i < argc; ++i) {
    if (!run_size(parse(argv[i]), argv[2], parse(argv[3]), parse(argv[4]))) {
      return 1;
    }
  }
  return 0;
}
