// Draws the printable ASCII of a font, one glyph at a time, and counts.
//
//   bench PX...      whole numbers
//
// For each size it prints: size, glyphs, instructions (mean, most), stack of
// the deepest glyph [bytes], and the sum of all coverage: the same on every
// core. A glyph is drawn once, from code point to pixels, into cleared strips
// of 16 rows of 8-bit coverage. No cache; clearing is not counted.
#include "board.hpp"
#include "counter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/text.hpp"
#include "stack.hpp"

asm(".pushsection .rodata.bench_font, \"a\"\n"
    ".balign 4\n"
    ".globl bench_font\n"
    "bench_font:\n"
    ".incbin \"" INKCELL_BENCH_FONT
    "\"\n"
    ".globl bench_font_end\n"
    "bench_font_end:\n"
    ".popsection\n");
extern "C" const uint8_t bench_font[];
extern "C" const uint8_t bench_font_end[];

namespace {

using namespace inkcell;

constexpr int32_t kSide = INKCELL_BENCH_SIDE;
constexpr int32_t kRows = 16;
static_assert(kSide % kRows == 0, "whole strips");

alignas(4) uint8_t pixels[kSide * kSide];

void clear_pixels() {
  for (uint8_t& pixel : pixels) {
    pixel = 0;
  }
}

// What is timed: everything from the code point on.
void draw_strips(const Font& font,
                 const Brush& brush,
                 uint32_t code_point,
                 Point origin,
                 int32_t height) {
  uint16_t glyph = 0;
  if (font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  port::A8Target target;
  target.strip.width = kSide;
  target.strip.height = kRows;
  target.strip.stride = kSide;
  for (int32_t y = 0; y < height; y += kRows) {
    target.strip.y0 = y;
    target.strip.pixels = {pixels + y * kSide,
                           static_cast<size_t>(kRows * kSide)};
    Sink sink;
    if (port::make_sink(target, sink) != Status::ok) {
      return;
    }
    draw_glyph(font, glyph, brush, origin, sink);
  }
}

struct Total {
  uint32_t glyphs = 0;
  uint32_t sum = 0;
  uint32_t most = 0;
  uint32_t stack = 0;
  uint32_t ink = 0;
  bool fits = true;
};

void add_glyph(const Font& font,
               const Brush& brush,
               uint32_t code_point,
               Total& total) {
  uint16_t glyph = 0;
  GlyphField field;
  if (font.glyph_of(code_point, glyph) != Status::ok ||
      font.field(glyph, field) != Status::ok) {
    return;
  }
  const Rect box = field_box(field, brush, {});
  const int32_t height = box.y1 - box.y0;
  if (box.x1 - box.x0 > kSide || height > kSide) {
    total.fits = false;
    return;
  }
  const Point origin = {Q26_6::from_int(-box.x0), Q26_6::from_int(-box.y0)};
  const auto work = [&] {
    draw_strips(font, brush, code_point, origin, height);
  };
  clear_pixels();
  const uint32_t count = board::count_instructions(work);
  for (const uint8_t pixel : pixels) {
    total.ink += pixel;
  }
  const auto stack = static_cast<uint32_t>(board::count_stack(work));
  total.glyphs += 1;
  total.sum += count;
  total.most = count > total.most ? count : total.most;
  total.stack = stack > total.stack ? stack : total.stack;
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

void print_number(uint32_t value) {
  board::print(" ");
  board::print_decimal(value);
}

uint32_t parse(const char* digits) {
  uint32_t value = 0;
  while (*digits >= '0' && *digits <= '9') {
    value = value * 10 + static_cast<uint32_t>(*digits++ - '0');
  }
  return value;
}

bool run_size(const Font& font, uint32_t px) {
  Brush brush;
  if (Brush::make(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText,
                  brush) != Status::ok) {
    return false;
  }
  Total total;
  for (uint32_t code_point = 0x20; code_point < 0x7f; ++code_point) {
    add_glyph(font, brush, code_point, total);
  }
  if (!total.fits || total.glyphs == 0) {
    board::print("a glyph is larger than the strips, or there is none\n");
    return false;
  }
  board::print("size");
  print_number(px);
  print_number(total.glyphs);
  print_number((total.sum + total.glyphs / 2) / total.glyphs);
  print_number(total.most);
  print_number(total.stack);
  print_number(total.ink);
  board::print("\n");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Font font;
  const auto size = static_cast<size_t>(bench_font_end - bench_font);
  if (Font::open({bench_font, size}, font) != Status::ok) {
    board::print("the font does not open\n");
    return 1;
  }
  if (!counter_is_exact()) {
    board::print("the counter is not exact\n");
    return 1;
  }
  for (int i = 1; i < argc; ++i) {
    if (!run_size(font, parse(argv[i]))) {
      return 1;
    }
  }
  return 0;
}
