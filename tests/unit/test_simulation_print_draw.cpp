// Prints: how much ink a tone takes, where light falls, and that strips and any
// bytes are no matter.
#include "check.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;

constexpr int32_t kSide = 48;
constexpr int32_t kMargin = 4;
constexpr PrintStyle kAll[] = {PrintStyle::rings, PrintStyle::engraving,
                               PrintStyle::hatching, PrintStyle::halftone,
                               PrintStyle::relief};

int8_t samples[kSide * kSide];

// A square, 4 px from the border of the grid, whose distances are those to the
// nearest side.
DistanceGrid square() {
  const DistanceGrid grid(samples, kSide, kSide, 0);
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    const int32_t column = x < kSide - 1 - x ? x : kSide - 1 - x;
    const int32_t row = y < kSide - 1 - y ? y : kSide - 1 - y;
    const int32_t least = column < row ? column : row;
    const int32_t value = (least - kMargin) * 32 + 16;
    samples[y * kSide + x] = static_cast<int8_t>(value < -128  ? -128
                                                 : value > 127 ? 127
                                                               : value);
  }
  return grid;
}

// The mean of a part.
int32_t ink(const Picture<kSide, kSide>& picture, const Rect& part) {
  return picture.ink(part) / ((part.x1 - part.x0) * (part.y1 - part.y0));
}

// Where distances are clamped there are no rings, and a cutoff moves the edge.
TEST(rings_end_with_the_distances_and_a_cutoff_thins) {
  const DistanceGrid grid = square();
  PrintLook look;
  look.style = PrintStyle::rings;
  look.contrast = 0;
  look.tone = 255;
  Picture<kSide, kSide> rings;
  draw_print(grid, look, 0, 0, kFilterText, rings.sink());
  CHECK(ink(rings, {6, 5, kSide - 6, 6}) > 200);
  CHECK_EQ(ink(rings, {9, 9, kSide - 9, kSide - 9}), 0);
  look.style = PrintStyle::relief;
  Picture<kSide, kSide> plain;
  draw_print(grid, look, 0, 0, kFilterText, plain.sink());
  look.cutoff.raw = 2 << 13;
  Picture<kSide, kSide> thin;
  draw_print(grid, look, 0, 0, kFilterText, thin.sink());
  for (int32_t x = kMargin; x + 2 < kSide / 2; ++x) {
    CHECK_EQ(thin.at(x + 2, kSide / 2), plain.at(x, kSide / 2));
  }
}

// A line of half a pixel along a slanted edge has the same ink in every row, so
// that it is no row of dashes.
TEST(thin_lines_at_slanted_edges_are_even) {
  const DistanceGrid grid(samples, kSide, kSide, 0);
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    const int32_t value = (x - 24) * 30 + (y - 24) * 11;
    samples[y * kSide + x] = static_cast<int8_t>(value < -128  ? -128
                                                 : value > 127 ? 127
                                                               : value);
  }
  PrintLook look;
  look.style = PrintStyle::rings;
  look.contrast = 0;
  look.tone = 16;  // of 256: half a pixel
  look.pitch = 8_px;
  look.shift = 2_px;
  Picture<kSide, kSide> picture;
  draw_print(grid, look, 0, 0, kFilterText, picture.sink());
  int32_t least = 255;
  int32_t most = 0;
  for (int32_t y = 8; y < kSide - 8; ++y) {
    const int32_t sum = picture.ink({0, y, kSide, y + 1});
    least = sum < least ? sum : least;
    most = sum > most ? sum : most;
  }
  CHECK(least >= 115);
  CHECK(most <= 150);
}

// A turn of the screen by half a turn about the middle changes nothing.
TEST(lines_turn_about_a_place) {
  const DistanceGrid grid = square();
  constexpr Rect kInside = {9, 9, kSide - 9, kSide - 9};
  PrintLook look;
  look.contrast = 0;
  look.style = PrintStyle::hatching;
  look.screen = from_degrees(90);
  look.screen_x = kSide / 2;
  Picture<kSide, kSide> upright;
  draw_print(grid, look, 0, 0, kFilterText, upright.sink());
  look.screen = from_degrees(270);
  Picture<kSide, kSide> turned;
  draw_print(grid, look, 0, 0, kFilterText, turned.sink());
  for (const auto [x, y] : pixels_of(kInside)) {
    const int32_t change = upright.at(x, y) - turned.at(x, y);
    CHECK(change >= -2 && change <= 2);
  }
}

TEST(flat_places_take_ink_by_their_tone) {
  const DistanceGrid grid = square();
  PrintLook look;
  look.contrast = 0;
  look.slope = 1_px;
  look.pitch = 5_px;
  constexpr Rect kInside = {9, 9, kSide - 9, kSide - 9};
  constexpr PrintStyle kTrue[] = {PrintStyle::engraving, PrintStyle::halftone,
                                  PrintStyle::relief};
  for (const PrintStyle style : kTrue) {
    look.style = style;
    for (int32_t tone = 0; tone <= 255; tone += 15) {
      look.tone = static_cast<uint8_t>(tone);
      Picture<kSide, kSide> picture;
      draw_print(grid, look, 0, 0, kFilterText, picture.sink());
      const int32_t error = ink(picture, kInside) - tone;
      // Lines thinner than a pixel, and gaps, are no thinner than they can be.
      CHECK(error <= 30 && error >= -30);
    }
  }
  // Hatching grows with the tone as well.
  look.style = PrintStyle::hatching;
  int32_t before = -1;
  for (int32_t tone = 30; tone <= 240; tone += 30) {
    look.tone = static_cast<uint8_t>(tone);
    Picture<kSide, kSide> picture;
    draw_print(grid, look, 0, 0, kFilterText, picture.sink());
    const int32_t now = ink(picture, kInside);
    CHECK(now > before);
    before = now;
  }
}

TEST(slopes_in_the_light_take_less_ink) {
  const DistanceGrid grid = square();
  constexpr Rect kLeft = {kMargin, 14, kMargin + 3, kSide - 14};
  constexpr Rect kRight = {kSide - kMargin - 3, 14, kSide - kMargin,
                           kSide - 14};
  constexpr Rect kTop = {14, kMargin, kSide - 14, kMargin + 3};
  constexpr Rect kBottom = {14, kSide - kMargin - 3, kSide - 14,
                            kSide - kMargin};
  for (const PrintStyle style : kAll) {
    PrintLook look;
    look.style = style;
    Picture<kSide, kSide> from_left;
    look.light = from_degrees(180);
    draw_print(grid, look, 0, 0, kFilterText, from_left.sink());
    CHECK(ink(from_left, kLeft) + 20 < ink(from_left, kRight));
    Picture<kSide, kSide> from_above;
    look.light = from_degrees(90);
    draw_print(grid, look, 0, 0, kFilterText, from_above.sink());
    CHECK(ink(from_above, kTop) + 20 < ink(from_above, kBottom));
    // Nothing outside.
    CHECK_EQ(ink(from_above, {0, 0, kSide, kMargin}), 0);
  }
}

TEST(strips_of_prints_are_parts_of_them) {
  const DistanceGrid grid = square();
  for (const PrintStyle style : kAll) {
    PrintLook look;
    look.style = style;
    Picture<kSide, kSide> whole;
    draw_print(grid, look, 3, -5, kFilterMotion, whole.sink());
    for (int32_t y = 0; y < kSide; y += 7) {
      for (int32_t x = 0; x < kSide - 13; x += 13) {
        Picture<13, 1> part(x, y);
        draw_print(grid, look, 3, -5, kFilterMotion, part.sink());
        for (int32_t i = 0; i < 13; ++i) {
          CHECK_EQ(part.at(x + i, y), whole.at(x + i, y));
        }
      }
    }
  }
}

TEST(any_look_of_any_grid_is_safe) {
  Random random(5);
  for (int32_t round = 0; round < 400; ++round) {
    random.fill(samples);
    const DistanceGrid grid(samples, random.between(1, kSide),
                            random.between(1, kSide), random.between(0, 3));
    PrintLook look;
    look.style = static_cast<PrintStyle>(random.below(7));
    look.light.raw = random.any();
    look.screen.raw = random.any();
    look.pitch.raw = random.any();
    look.slope.raw = random.any();
    look.shift.raw = random.any();
    look.screen_x = random.any();
    look.screen_y = random.any();
    look.cutoff.raw = random.any();
    look.tone = random.any();
    look.contrast = random.any();
    Picture<16, 4> picture(random.between(-9, 40), random.between(-9, 40));
    draw_print(grid, look, random.between(-20, 20), random.between(-20, 20),
               kFilterMotion, picture.sink());
    draw_print(grid, look, random.any(), random.any(), kFilterMotion,
               picture.sink());
  }
}

}  // namespace
