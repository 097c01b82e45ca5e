// Inkcell with strikes, from the code point to pixels. Ways:
//
//   a8, pages          8-bit coverage in one strip, and pages of 1 bit, of a
//   font
//                      of strikes alone
//   both_a8, both_pages    of a font that has outlines, too
//   outline_a8, outline_pages    the same pictures from its outlines; 2,560
//                                bytes are lent
#include "engine.h"
#include "inkcell/few_levels.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/text.hpp"

using namespace inkcell;

namespace {

constexpr int32_t kSide = 64;
constexpr size_t kWorkspace = 2560;
alignas(4) uint8_t pixels[kSide * kSide];
alignas(4) uint8_t workspace[kWorkspace];

Span<const uint8_t> rom;
Font font;
Style style;
Point origin;
port::A8Canvas a8;
port::MonoPagesCanvas pages;
bool is_in_pages = false;
bool has_outlines = false;
uint32_t box = 0;

bool begins_with(const char* name, const char* begin) {
  while (*begin != '\0' && *name == *begin) {
    ++name;
    ++begin;
  }
  return *begin == '\0';
}

const Sink& sink() {
  return is_in_pages ? static_cast<const Sink&>(pages) : a8;
}

}  // namespace

bool engine_open(const uint8_t* bytes, size_t size) {
  rom = {bytes, size};
  return true;
}

bool engine_set_size(uint32_t px, const char* way) {
  const bool is_alone = begins_with(way, "a8") || begins_with(way, "pages");
  has_outlines = begins_with(way, "outline");
  is_in_pages = begins_with(way, "pages") || begins_with(way, "both_pages") ||
                begins_with(way, "outline_pages");
  const Q26_6 size = Q26_6::from_int(static_cast<int32_t>(px));
  style = is_alone || is_in_pages ? Style(size) : strike_style(size);
  // As headers of fonts with such a strike say.
  const Coding& coding = is_alone       ? kStrikeCoding
                         : has_outlines ? kOutlineCoding
                         : is_in_pages  ? kOutlineBitStrikeCoding
                                        : kOutlineStrikeCoding;
  Font opened;
  const Status status = Font::open(rom, coding, opened);
  font = opened;
  return status == Status::ok;
}

engine_answer engine_prepare(uint32_t code_point) {
  uint16_t glyph = 0;
  if (font.glyph_of(code_point, glyph) != Status::ok) {
    return engine_lacks;
  }
  const Rect rect = Painter(sink()).glyph_box(font, style, {}, glyph);
  const int32_t width = rect.x1 - rect.x0;
  const int32_t height = rect.y1 - rect.y0;
  if (width > kSide || height > kSide) {
    return engine_too_large;
  }
  origin = {Q26_6::from_int(-rect.x0), Q26_6::from_int(-rect.y0)};
  box = static_cast<uint32_t>(width * height);
  for (uint8_t& byte : pixels) {
    byte = 0;
  }
  a8.set_strip({{pixels, sizeof pixels}, 0, 0, kSide, kSide, kSide});
  pages.set_strip({{pixels, sizeof pixels}, 0, 0, kSide, kSide, kSide});
  return engine_ready;
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (font.glyph_of(code_point, glyph) == Status::ok) {
    const Workspace ram =
        has_outlines ? Workspace{workspace, kWorkspace} : Workspace{};
    Painter(sink(), ram).glyph(font, style, origin, glyph);
  }
}

uint32_t engine_ink() {
  uint32_t sum = 0;
  for (const uint8_t byte : pixels) {
    sum += is_in_pages ? 255u * static_cast<uint32_t>(__builtin_popcount(byte))
                       : byte;
  }
  return sum;
}

uint32_t engine_box() {
  return box;
}

size_t engine_heap() {
  return 0;
}

size_t engine_workspace() {
  return has_outlines ? kWorkspace : 0;
}
