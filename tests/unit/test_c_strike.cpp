// Strikes through the interface for C: the same pixels as in C++.
#include "inkcell/c/strike.h"

#include "check.hpp"
#include "inkcell/inkcell.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "outline_record.hpp"
#include "small_strike.hpp"

namespace {

using namespace inkcell;
using strike_font::Values;

constexpr int32_t kWidth = 64;
constexpr int32_t kHeight = 24;

alignas(4) uint8_t rom[8192];
alignas(4) uint8_t pixels[kWidth * kHeight];
uint8_t wanted[kWidth * kHeight];

void draw(const Font& font, const Style& style) {
  __builtin_memset(wanted, 0, sizeof wanted);
  const port::A8Canvas canvas(
      {{wanted, sizeof wanted}, 0, 0, kWidth, kHeight, kWidth});
  Painter(canvas).text(font, style, {2, 20}, "ACB");
}

bool has_full_pixel() {
  for (const uint8_t pixel : pixels) {
    if (pixel == 255) {
      return true;
    }
  }
  return false;
}

void draw_in_c(const inkcell_font_t& font, const inkcell_style_t& style) {
  __builtin_memset(pixels, 0, sizeof pixels);
  inkcell_a8_target_t target = {};
  target.strip.pixels = pixels;
  target.strip.size = sizeof pixels;
  target.strip.width = kWidth;
  target.strip.height = kHeight;
  target.strip.stride = kWidth;
  inkcell_sink_t sink;
  CHECK_EQ(inkcell_a8_sink(&target, &sink), INKCELL_OK);
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  inkcell_draw_text(&painter, &font, "ACB", 3, &style, 2 * 64, 20 * 64);
}

TEST(strikes_alone_are_drawn_from_c) {
  constexpr int32_t kSizes[] = {8, 16, 9};
  using namespace small_strike;
  const size_t size = build(kGlyphs, rom);
  for (int is_bits = 0; is_bits != 2; ++is_bits) {
    inkcell_font_t font;
    const auto open =
        is_bits != 0 ? inkcell_font_open_bit_strike : inkcell_font_open_strike;
    CHECK_EQ(open(rom, size, &font), INKCELL_OK);
    CHECK_EQ(inkcell_font_verify_strikes(&font), INKCELL_OK);
    Font same;
    CHECK_EQ(Font::open(rom, kStrikeCoding, same), Status::ok);
    for (const int32_t px : kSizes) {
      inkcell_style_t style;
      CHECK_EQ(inkcell_style_make(px * 64, &inkcell_filter_area, &style),
               INKCELL_OK);
      CHECK_EQ(inkcell_font_check(&font, &style),
               px == 9 ? INKCELL_UNSUPPORTED : INKCELL_OK);
      draw_in_c(font, style);
      draw(same, Style(Q26_6::from_int(px)));
      CHECK_EQ(__builtin_memcmp(pixels, wanted, sizeof pixels), 0);
      CHECK_EQ(has_full_pixel(), px != 9);
    }
  }
  inkcell_font_t font;
  CHECK_EQ(inkcell_font_open(rom, size, &font), INKCELL_UNSUPPORTED);
  CHECK_EQ(inkcell_font_open_outline_strike(rom, size, &font),
           INKCELL_UNSUPPORTED);
}

// Pictures that are not those of the outlines tell who draws.
TEST(strikes_beside_outlines_serve_their_style_in_c) {
  static strike_font::StrikeWriter<2048> strikes;
  strikes.begin(2);
  const auto full = [](uint16_t glyph, Values& values) {
    values.width = values.height = glyph == 0 ? 0 : 5;
    values.top = -9;
    for (auto& row : values.at) {
      for (uint8_t& value : row) {
        value = 15;
      }
    }
  };
  strikes.add({12, 4, format::StrikeFit::both, 0, 6}, full);
  strikes.add({12, 4, format::StrikeFit::heights, 0, 6}, full);
  const size_t size = strike_font::add_section(
      {rom, sizeof rom}, outline_record::build_sample_font(rom),
      format::section::kStrikes, strikes.bytes());
  CHECK(size != 0);
  inkcell_font_t font;
  CHECK_EQ(inkcell_font_open_outline_strike(rom, size, &font), INKCELL_OK);
  Font same;
  CHECK_EQ(Font::open(rom, kOutlineStrikeCoding, same), Status::ok);
  Font outlines;
  CHECK_EQ(Font::open(rom, outlines), Status::ok);
  for (int i = 0; i != 2; ++i) {
    const bool across = i != 0;
    inkcell_style_t style;
    CHECK_EQ(inkcell_style_make_strike(12 * 64, across, &style), INKCELL_OK);
    const Style twin =
        across ? strike_style(12_px) : strike_height_style(12_px);
    draw_in_c(font, style);
    draw(same, twin);
    CHECK_EQ(__builtin_memcmp(pixels, wanted, sizeof pixels), 0);
    draw(outlines, twin);
    CHECK(__builtin_memcmp(pixels, wanted, sizeof pixels) != 0);
    CHECK_EQ(inkcell_style_make_strike(2000 * 64, across, &style),
             INKCELL_BAD_ARGUMENT);
  }
  CHECK_EQ(inkcell_font_open_outline_bit_strike(rom, size, &font), INKCELL_OK);
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make_strike(12 * 64, true, &style), INKCELL_OK);
  draw_in_c(font, style);
  draw(outlines, strike_style(12_px));
  CHECK_EQ(__builtin_memcmp(pixels, wanted, sizeof pixels), 0);
}

}  // namespace
