// Draws a line of text into strips of RGB565, and blends without drawing.
//
//   FIRMWARE FONT PX...
//
// Prints for each size what `draw` of the laid-out line takes in 16-row strips:
//
//   run PX INSTRUCTIONS STACK STRIPS
//
// and of the sink alone, hundredths of an instruction for one more pixel that
// is partly covered, for one more solid one, and what a call of each takes for
// nothing:
//
//   blend PARTLY SOLID CALL_PARTLY CALL_SOLID
#include "inkcell/port/rgb565.hpp"
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "inkcell/painter.hpp"
#include "rom_file.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::open_font;
using bench::parse;

constexpr int32_t kWidth = 640;
constexpr int32_t kRows = 16;
alignas(4) uint8_t font_bytes[1 << 20];
alignas(4) uint8_t pixels[kWidth * kRows * 2];
PositionedGlyph glyphs[16];
alignas(4) uint8_t workspace[2560];  // for outlines

Strip strip_at(int32_t y) {
  return {{pixels, sizeof pixels}, 0, y, kWidth, kRows, kWidth * 2};
}

bool measure_run(const Font& font, int32_t px) {
  const Style style(Q26_6::from_int(px), kFilterText);
  Span<const PositionedGlyph> run;
  if (Painter().lay_out(font, style, "Hello, 12:34", glyphs, run) !=
      Status::ok) {
    return false;
  }
  uint32_t instructions = 0;
  uint32_t stack = 0;
  uint32_t strips = 0;
  for (int32_t y = 0; y < px + px / 2; y += kRows) {
    const port::Rgb565Canvas sink(strip_at(y));
    const auto work = [&] {
      Painter(sink, {workspace, sizeof workspace})
          .glyphs(font, style, {Q26_6::from_int(4), Q26_6::from_int(px)}, run);
    };
    const auto used = static_cast<uint32_t>(board::count_stack(work));
    stack = used > stack ? used : stack;
    instructions += board::count_instructions(work);
    strips += 1;
  }
  bench::print_row("run", px, instructions, stack, strips);
  return true;
}

bool measure_blend() {
  const port::Rgb565Canvas sink(strip_at(0), port::rgb565(40, 80, 160));
  uint8_t coverage[kMaxSpan];
  for (int32_t i = 0; i < kMaxSpan; ++i) {
    coverage[i] = static_cast<uint8_t>(1 + 7 * i);
  }
  const auto partly = [&](int32_t count) {
    return board::count_instructions(
        [&] { sink.coverage(sink.context, 0, 0, coverage, count); });
  };
  const auto solid = [&](int32_t count) {
    return board::count_instructions(
        [&] { sink.solid(sink.context, 0, 0, count); });
  };
  const uint32_t partly_100 = (partly(32) - partly(16)) * 100 / 16;
  const uint32_t solid_100 = (solid(512) - solid(256)) * 100 / 256;
  bench::print_row("blend", partly_100, solid_100,
                   partly(16) - 16 * partly_100 / 100,
                   solid(256) - 256 * solid_100 / 100);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Font font;
  if (argc < 3 || !open_font(argv[1], font_bytes, font)) {
    return bench::fail("usage: FONT PX..., or the font does not open");
  }
  for (int i = 2; i < argc; ++i) {
    if (!measure_run(font, static_cast<int32_t>(parse(argv[i])))) {
      return bench::fail("a size is out of range");
    }
  }
  return measure_blend() ? 0 : 1;
}
