// What becomes of characters that a font lacks.
#include "inkcell/text_report.hpp"

#include "check.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/painter.hpp"
#include "pixels.hpp"
#include "sample_rom.hpp"

namespace {

using namespace inkcell;
using sample_rom::sample;

constexpr Style kStyle = Style(20_px, kFilterText);

uint32_t without_accents(uint32_t code_point) noexcept {
  return code_point == 0xC4 ? uint32_t{'A'} : code_point;
}

// As docs/DRAW.md has it.
TextReport show(const Font& font, const Style& style, Point pen, Text words) {
  const Sink canvas;
  TextReport report;
  report.instead = '?';                 // or TextReport::kNothing
  report.substitute = without_accents;  // yours: a code point for another
  const Painter painter(canvas, {}, nullptr, &report);
  painter.text(font, style, pen, words);
  return report;
}

TEST(a_report_tells_of_what_is_drawn) {
  const TextReport report = show(sample(), kStyle, {0, 40}, "\u00c4\u00d6");
  CHECK_EQ(report.missing, 1);
  CHECK_EQ(report.first_missing, 0xD6);
}

// The glyphs that a painter with a report lays out.
template <size_t kCount>
void check_replaced(TextReport& report,
                    Text text,
                    const uint16_t (&expected)[kCount]) {
  const Font font = sample();
  const Sink sink;
  const Painter painter(sink, {}, nullptr, &report);
  PositionedGlyph buffer[8];
  Span<const PositionedGlyph> run;
  CHECK_OK(painter.lay_out(font, kStyle, text, buffer, run));
  CHECK_EQ(run.size, kCount);
  for (size_t i = 0; i < run.size && i < kCount; ++i) {
    CHECK_EQ(run[i].glyph, expected[i]);
  }
}

TEST(missing_characters_are_what_the_report_says) {
  // A, B and C are glyphs 2, 3 and 4; x, y and z are missing.
  TextReport report;
  check_replaced(report, "AxBy", {2, 0, 3, 0});
  CHECK_EQ(report.status, Status::no_glyph);
  CHECK_EQ(report.missing, 2);
  CHECK_EQ(report.first_missing, 'x');
  report = {};
  report.instead = TextReport::kNothing;
  check_replaced(report, "AxBy", {2, 3});
  CHECK_EQ(report.missing, 2);
  report = {};
  report.instead = 'C';
  check_replaced(report, "AxBy", {2, 4, 3, 4});
  report.instead = 'z';  // missing, too
  check_replaced(report, "Ax", {2, 0});
  CHECK_EQ(report.missing, 3);
  report = {};
  report.instead = TextReport::kNothing;
  report.substitute = [](uint32_t code_point) noexcept {
    return code_point == 'x' ? uint32_t{'B'} : code_point;
  };
  check_replaced(report, "AxBy", {2, 3, 3});
  CHECK_EQ(report.missing, 1);
  CHECK_EQ(report.first_missing, 'y');
  // Spaces and what shows nothing are no missing characters.
  report = {};
  check_replaced(report, "A\u200b\u0301B", {2, 3});
  CHECK_EQ(report.status, Status::ok);
}

TEST(measures_and_boxes_know_what_is_missing) {
  const Font font = sample();
  const Sink sink;
  TextReport report;
  report.instead = TextReport::kNothing;
  const Painter painter(sink, {}, nullptr, &report);
  CHECK_EQ(painter.measure(font, kStyle, "AxB").advance.raw,
           Painter().measure(font, kStyle, "AB").advance.raw);
  const Rect box = painter.box(font, kStyle, {3, 40}, "xAx");
  const Rect same = Painter().box(font, kStyle, {3, 40}, "A");
  CHECK(is_same(box, same));
  CHECK_EQ(report.missing, 3);
}

}  // namespace
