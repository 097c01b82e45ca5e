// Digits of italics overhang their cells: clocks and counters draw all of their
// ink, as glyphs drawn alone, at rest, while they roll and while they morph.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "inkcell/filter.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/recipes.hpp"
#include "inkcell/port/a8.hpp"
#include "morph_font.hpp"

namespace inkcell::gen::test {
namespace {

using motion::Clock;
using motion::Counter;
using motion::DigitCells;
using motion::OutlineMorph;

constexpr int kPageWidth = 320;
constexpr int kPageHeight = 160;
constexpr inkcell::Point kLineStart(40, 100);
constexpr int kWheels = 4;

struct Page {
  std::vector<uint8_t> pixels;

  Page() : pixels(kPageWidth * kPageHeight) {}

  template <typename Draw>
  void draw(const Draw& draw) {
    alignas(4) static uint8_t ram[8192];
    const port::A8Canvas canvas({{pixels.data(), pixels.size()},
                                 0,
                                 0,
                                 kPageWidth,
                                 kPageHeight,
                                 kPageWidth});
    draw(Painter(canvas, Span<uint8_t>(ram)));
  }
  // Of some rows. [px]
  double ink(int first, int last) const {
    double sum = 0;
    for (int i = first * kPageWidth; i < last * kPageWidth; ++i) {
      sum += pixels[static_cast<size_t>(i)] / 255.0;
    }
    return sum;
  }
};

struct Italic {
  Italic(const char* file, int px)
      : face(digits_of(file, "01")),
        style(Q26_6::from_int(px), kFilterMotion),
        cells(motion::measure_digits(face.font, style)) {}

  uint16_t glyph(int digit) const {
    return face.font.glyph_or_notdef(U'0' + static_cast<uint32_t>(digit));
  }
  // Where a glyph begins in a cell, in whose middle it is.
  inkcell::Point place(int cell, uint16_t glyph) const {
    const int32_t advance = face.font.advance(glyph);
    return {Q26_6::from_raw(
                kLineStart.x.raw + cell * cells.width.raw +
                (cells.width.raw - to_px(face.font, style, advance).raw) / 2),
            kLineStart.y};
  }

  const MorphFont& face;
  Style style;
  DigitCells cells;
};

// Ink on the left and on the right of a cell. [px]
double overhang_of(const Page& page, const Italic& italic, int cell) {
  const int left = (kLineStart.x.raw + cell * italic.cells.width.raw) >> 6;
  const int right =
      (kLineStart.x.raw + (cell + 1) * italic.cells.width.raw) >> 6;
  double sum = 0;
  for (int i = 0; i < kPageWidth * kPageHeight; ++i) {
    const int x = i % kPageWidth;
    if (x < left || x > right) {
      sum += page.pixels[static_cast<size_t>(i)] / 255.0;
    }
  }
  return sum;
}

class ItalicDigits : public testing::TestWithParam<const char*> {
 protected:
  // A clock's second digit alone: its hour is 0 to 9, then the next one.
  static Page clock_digit(const Italic& italic, int hour, int since_ms) {
    Clock clock(italic.face.font, italic.style, kLineStart);
    const auto from = static_cast<uint32_t>(hour * 60 + 59);
    clock.at(from, from + 1, since_ms);
    Page page;
    page.draw([&](const Painter& painter) {
      clock.draw_digit(painter, italic.style, 1);
    });
    return page;
  }
};

TEST_P(ItalicDigits, RestAndRollWithAllOfTheirInk) {
  double overhang = 0;
  for (const int px : {20, 48, 72}) {
    const Italic italic(GetParam(), px);
    const int pitch = italic.cells.bottom - italic.cells.top;
    // Rows without the soft edges of cells.
    const int top = kLineStart.y.raw / 64 + italic.cells.top + pitch / 12 + 1;
    const int bottom =
        kLineStart.y.raw / 64 + italic.cells.bottom - pitch / 12 - 1;
    for (int hour = 0; hour < 9; ++hour) {
      for (const int since_ms : {0, 90, 200, 310, 420, Clock::kEndMs}) {
        const Page shown = clock_digit(italic, hour, since_ms);
        const Q16_16 part =
            motion::ease(motion::cubic_bezier(650, 0, 350, 1000),
                         motion::fraction(0, Clock::kEndMs, since_ms));
        Page alone;
        alone.draw([&](const Painter& painter) {
          for (int i = 0; i < 2; ++i) {
            const uint16_t glyph = italic.glyph(hour + i);
            inkcell::Point at = italic.place(1, glyph);
            at.y.raw += i * pitch * 64 - motion::lerp(0, pitch * 64, part);
            painter.for_motion().glyph(italic.face.font, italic.style, at,
                                       glyph);
          }
        });
        const bool rests = part.raw == 0 || part.raw == 65536;
        const int first =
            rests ? kLineStart.y.raw / 64 + italic.cells.top : top;
        const int last =
            rests ? kLineStart.y.raw / 64 + italic.cells.bottom : bottom;
        EXPECT_EQ(shown.ink(first, last), alone.ink(first, last))
            << px << " px, " << hour << " after " << since_ms << " ms";
        overhang = std::max(overhang, overhang_of(shown, italic, 1));
      }
    }
    // A counter draws the digits of a line.
    for (const int number : {1234, 5678, 9090}) {
      Counter counter(italic.face.font, italic.style, kLineStart, kWheels);
      counter.roll(number, number, {});
      counter.at(0);
      Page shown;
      shown.draw([&](const Painter& painter) { counter.draw(painter); });
      Page alone;
      alone.draw([&](const Painter& painter) {
        for (int i = 0; i < kWheels; ++i) {
          const uint16_t glyph = italic.glyph(
              std::to_string(number)[static_cast<size_t>(i)] - '0');
          painter.for_motion().glyph(italic.face.font, italic.style,
                                     italic.place(i, glyph), glyph);
        }
      });
      EXPECT_EQ(shown.pixels, alone.pixels) << px << " px, " << number;
    }
  }
  std::printf("%s: up to %.1f px of ink beside a cell\n", GetParam(), overhang);
  EXPECT_GT(overhang, 1);
}

TEST_P(ItalicDigits, MorphWithAllOfTheirInk) {
  const Italic italic(GetParam(), 72);
  OutlineMorph morph;
  ASSERT_EQ(OutlineMorph::open(italic.face.font, italic.glyph(0),
                               italic.glyph(1), morph),
            Status::ok);
  Clock clock(italic.face.font, italic.style, kLineStart);
  for (int since_ms = 20; since_ms < Clock::kEndMs; since_ms += 40) {
    clock.at(0, 1, since_ms);
    const Q16_16 part = clock.progress(3);
    Page shown;
    shown.draw([&](const Painter& painter) {
      clock.draw_digit(painter, italic.style, 3);
    });
    Page alone;
    alone.draw([&](const Painter& painter) {
      const Font& font = italic.face.font;
      const uint16_t colon = font.glyph_or_notdef(':');
      inkcell::Point at = kLineStart;
      at.x.raw += 3 * italic.cells.width.raw +
                  to_px(font, italic.style, font.advance(colon)).raw;
      at.x.raw +=
          (italic.cells.width.raw - morph.advance(italic.style, part).raw) / 2;
      morph.draw(painter, italic.style, at, part);
    });
    EXPECT_EQ(shown.pixels, alone.pixels) << since_ms;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faces,
    ItalicDigits,
    testing::Values(
        "/usr/share/fonts/truetype/liberation/LiberationSerif-Italic.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSerif-BoldItalic.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-BoldItalic.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Italic.ttf",
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/"
        "Roboto-BlackItalic.ttf"));

}  // namespace
}  // namespace inkcell::gen::test
