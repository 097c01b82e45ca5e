// Fonts from a fuzzer: bytes in, and the promises of exercise.hpp checked.
//
// The last 64 bytes of an input choose the text, size, direction and place. The
// rest is the font. Unless the first of the 64 is odd, what would make open
// refuse it at once is put right: magic, version, sizes and checksums.
#include <algorithm>
#include <memory>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "front_ends.hpp"
#include "inkcell/field/draw.hpp"
#include "repair_font.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::get_u32;

constexpr size_t kChoiceBytes = 64;

Style style_of(const uint8_t* choice) {
  static constexpr int32_t kOne = 1 << 30;
  static constexpr int32_t kDirections[8][2] = {{kOne, 0},
                                                {0, kOne},
                                                {-kOne, 0},
                                                {0, -kOne},
                                                {kOne, 1},
                                                {759250125, -759250125},
                                                {-858993459, 644245094},
                                                {kOne - (1 << 20), 0}};
  const auto size = static_cast<int32_t>(
      256 + get_u16(choice) % (65536 - 256 + 1));  // 4 to 1024 px
  const auto& turn = kDirections[choice[2] % 8];
  Direction direction;
  direction.cosine.raw = turn[0];
  direction.sine.raw = turn[1];
  return Style(Q26_6::from_raw(size), kFilterPaperDisplay, direction);
}

// Near the window for small exponents, anywhere for large ones.
Q26_6 place(const uint8_t* choice) {
  const auto raw = static_cast<int32_t>(get_u32(choice));
  return Q26_6::from_raw(raw >> (choice[4] % 24));
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size < kChoiceBytes) {
    return;
  }
  const uint8_t* choice = data + size - kChoiceBytes;
  const size_t font_bytes = size - kChoiceBytes;
  // A block of exactly this size: the sanitizer sees one byte too much.
  const auto block = std::make_unique<uint8_t[]>(font_bytes);
  std::copy(data, choice, block.get());
  const Span<uint8_t> rom(block.get(), font_bytes);
  if (choice[0] % 2 == 0) {
    repair_font(rom);
  }
  if (!hostile::exercise(rom).opened) {
    return;
  }
  Font font;
  const Status status = open_any_font(rom, font);
  hostile::require(status == Status::ok, "open twice");
  const Style style = style_of(choice + 1);
  const Point origin = {place(choice + 4), place(choice + 9)};
  const auto glyph =
      static_cast<uint16_t>(get_u16(choice + 14) % (font.glyph_count() + 1u));
  hostile::draw_checked(font, glyph, style, origin);
  const auto* text = reinterpret_cast<const char*>(choice + 16);
  hostile::use_text(font, {text, kChoiceBytes - 16}, style, origin);
}
