// Fonts whose bytes read differently each time.
//
//   hostile_changing
//
// The library promises to be safe even if flash changes between two reads. A
// value that is read, checked, read again and used would break that, whether
// the source or the compiler repeats the read; so object code is tested. The
// same program links the library with sanitizers and as it is shipped.
#include <stdio.h>

#include <memory>
#include <string>

#include "changing_bytes.hpp"
#include "exercise.hpp"
#include "good_fonts.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/strike/verify.hpp"

namespace {

using namespace inkcell;

// Workspace in a heap block of exactly its size.
constexpr size_t kRam = 600;

struct Ink {
  Rect window = {0, 0, 24, 20};
  int64_t pixels = 0;

  static void coverage(
      void* context, int32_t x, int32_t y, const uint8_t*, int32_t count) {
    hostile::require(count <= kMaxSpan, "length of the span");
    solid(context, x, y, count);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    Ink& ink = *static_cast<Ink*>(context);
    hostile::require(count >= 1 && y >= 0 && y < ink.window.y1 && x >= 0 &&
                         x <= ink.window.x1 - count,
                     "pixels in the window");
    ink.pixels += count;
  }
};

// By its coding.
Status open(const std::string& kind, Span<const uint8_t> rom, Font& out) {
  return kind == "strikes" ? Font::open(rom, kStrikeCoding, out)
         : kind == "both"  ? Font::open(rom, kOutlineStrikeCoding, out)
                           : open_any_font(rom, out);
}

void draw_with_ram(const Font& font, const Style& style, Ink& ink) {
  const auto ram = std::make_unique<uint32_t[]>(kRam / 4);
  const Workspace workspace = {reinterpret_cast<uint8_t*>(ram.get()), kRam};
  const Sink sink = {ink.window, &ink, Ink::coverage, Ink::solid};
  for (uint16_t glyph = 0; glyph < 7; ++glyph) {
    Painter(sink, workspace)
        .glyph(font, style,
               {Q26_6::from_int(1), Q26_6::from_raw(18 * 64 + glyph / 4)},
               glyph);
  }
}

void run(const std::string& kind, bool is_at_end, uint32_t one_in, int rounds) {
  const hostile::Bytes good = hostile::good_font(kind);
  hostile::ChangingBytes memory({good.data(), good.size()}, is_at_end);
  Ink ink;
  const bool has_strikes = kind == "strikes" || kind == "both";
  int opened = 0;
  int verified = 0;
  const int64_t loads = hostile::ChangingBytes::load_count();
  const int64_t changes = hostile::ChangingBytes::change_count();
  for (int round = 0; round < rounds; ++round) {
    // A font that is opened while bytes change, else one that was opened
    // before.
    Font font;
    memory.start(static_cast<uint32_t>(round + 1), one_in);
    const bool has_opened = open(kind, memory.bytes(), font) == Status::ok;
    opened += has_opened ? 1 : 0;
    if (!has_opened) {
      memory.stop();
      hostile::require(open(kind, memory.bytes(), font) == Status::ok,
                       "the good font opens");
      memory.start(static_cast<uint32_t>(round + 1), one_in);
    }
    verified += font.verify() == Status::ok ? 1 : 0;
    if (has_strikes) {
      verified += verify_strikes(font) == Status::ok ? 1 : 0;
      draw_with_ram(font, Style(22_px), ink);
    } else {
      draw_with_ram(font, Style(22_px, kFilterText), ink);
    }
    // Strikes alone refuse most styles that it has.
    if (round == 0 && kind != "strikes") {
      hostile::use(font);
    }
    memory.stop();
  }
  const int64_t trapped = hostile::ChangingBytes::load_count() - loads;
  const int64_t changed = hostile::ChangingBytes::change_count() - changes;
  printf(
      "%-8s 1 in %3u: %3d rounds, %3d opened, %3d verified, %8lld loads, "
      "%7lld of other bytes, %7lld pixels\n",
      kind.c_str(), one_in, rounds, opened, verified,
      static_cast<long long>(trapped), static_cast<long long>(changed),
      static_cast<long long>(ink.pixels));
  fflush(stdout);
  hostile::require(changed > trapped / (2 * int64_t{one_in}) && trapped > 1000,
                   "loads are trapped and changed");
}

}  // namespace

int main() {
  hostile::expect_changing_bytes();
  for (const char* kind : {"1", "2", "outline", "strikes", "both"}) {
    run(kind, true, 3, 10);
    run(kind, false, 40, 10);
    run(kind, true, 1000, 20);
  }
  return 0;
}
