// Boxes tell of what they do not draw, and are on few levels what is drawn.
#include "check.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "layout_font.hpp"

namespace {

using namespace inkcell;

alignas(4) uint8_t rom[layout_font::kBytes];

// At 10 px/em: letters 7.5 px, bars 6 px, spaces 5 px wide.
struct Setting {
  Font font = layout_font::open(rom);
  Style style = Style(10_px, kFilterText);

  TextBox box(const Rect& rect) const { return TextBox(font, style, rect); }
};

TEST(a_report_tells_of_what_is_not_drawn) {
  const Setting setting;
  const Sink sink = {{0, 0, 40, 40}};
  TextReport report;
  report.instead = TextReport::kNothing;
  const Painter painter(sink, {}, nullptr, &report);
  const TextBox box = setting.box({0, 0, 40, 40});
  CHECK_EQ(box.measure("AxB", painter).width.raw,
           box.measure("AB", {}).width.raw);
  CHECK_EQ(report.status, Status::no_glyph);
  CHECK_EQ(report.first_missing, 'x');
  // Another face has it.
  report = {};
  const Face other = {&setting.font, &setting.style};
  TextBox mixed = box;
  mixed.options.fallback = {&other, 1};
  report.substitute = [](uint32_t) noexcept { return uint32_t{'A'}; };
  CHECK_EQ(mixed.measure("xx", painter).width.raw,
           box.measure("AA", {}).width.raw);
  CHECK_EQ(report.status, Status::ok);
  // Letters that join, and marks that are placed; others stand side by side.
  constexpr const char* kPlain[] = {"\u05d0\u05d1", "\u0661\u0967", "\u0939",
                                    "A\u200d\ufe0f"};
  for (const char* const text : kPlain) {
    report = {};
    static_cast<void>(box.measure(text, painter));
    CHECK(report.status != Status::needs_shaping);
  }
  constexpr const char* kJoined[] = {"A\u0628", "A\u093e", "A\u0301",
                                     "A\u0e31"};
  for (const char* const text : kJoined) {
    report = {};
    static_cast<void>(box.measure(text, painter));
    CHECK_EQ(report.status, Status::needs_shaping);
  }
#if !INKCELL_BOARD_FIRMWARE
  // A line that is longer than positions reach.
  static char line[40000];
  for (char& c : line) {
    c = 'A';
  }
  report = {};
  TextBox whole = box;
  whole.options.wraps = false;
  static_cast<void>(whole.measure({line, 100}, painter));
  CHECK_EQ(report.status, Status::ok);
  static_cast<void>(whole.measure({line, sizeof line}, painter));
  CHECK_EQ(report.status, Status::cut);
#endif
#if !INKCELL_ASSERTIONS
  // As in static memory whose constructors were not run.
  report = {};
  TextBox unmade = box;
  unmade.clip = {};
  unmade.draw("A", painter);
  CHECK_EQ(report.status, Status::bad_argument);
  report = {};
  TextBox().draw("A", painter);
  CHECK_EQ(report.status, Status::bad_argument);
#endif
}

// On a canvas of 1 bit text is broken, measured and placed as it is drawn.
TEST(boxes_on_few_levels_are_what_is_drawn) {
  const Setting setting;
  const Style open(13_px);
  const Style fitted = port::MonoPagesCanvas::style(13_px);
  static uint8_t pages[2][48 * 80 / 8];
  const auto canvas = [](uint8_t(&page)[48 * 80 / 8]) {
    return port::MonoPagesCanvas({page, 0, 0, 80, 48, 80});
  };
  constexpr const char* kText = "CABBA CA BAC ABACA";
  const port::MonoPagesCanvas probe;
  for (int32_t width = 30; width < 80; ++width) {
    __builtin_memset(pages, 0, sizeof pages);
    const TextBox by_canvas(setting.font, open, {1, 0, 1 + width, 48},
                            Align::right);
    const TextBox by_style(setting.font, fitted, {1, 0, 1 + width, 48},
                           Align::right);
    const TextSize size = by_canvas.measure(kText, probe);
    const TextSize same = by_style.measure(kText, {});
    CHECK_EQ(size.width.raw, same.width.raw);
    CHECK_EQ(size.width.raw % 64, 0);
    CHECK_EQ(size.lines, same.lines);
    for (size_t i = 0; i < 18; ++i) {
      CHECK_EQ(by_canvas.caret(kText, probe, {i, false}).x0,
               by_style.caret(kText, {}, {i, false}).x0);
    }
    CHECK_EQ(by_canvas.hit(kText, probe, width / 2, 3).offset,
             by_style.hit(kText, {}, width / 2, 3).offset);
    const Rect box = by_canvas.box(kText, probe);
    CHECK_EQ(box.x0, by_style.box(kText, {}).x0);
    by_canvas.draw(kText, canvas(pages[0]));
    by_style.draw(kText, canvas(pages[1]));
    CHECK(__builtin_memcmp(pages[0], pages[1], sizeof pages[0]) == 0);
    TextLine room[8];
    Span<const TextLine> lines;
    CHECK_OK(by_canvas.lay_out(kText, probe, room, lines));
    __builtin_memset(pages[1], 0, sizeof pages[1]);
    by_canvas.draw(kText, canvas(pages[1]), lines);
    CHECK(__builtin_memcmp(pages[0], pages[1], sizeof pages[0]) == 0);
  }
}

}  // namespace
