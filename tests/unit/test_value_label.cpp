// Values that change: what is drawn and sent again makes the screen that a full
// redraw makes.
#include "inkcell/value_label.hpp"

#include "check.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/number_text.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/stroke.hpp"
#include "outline_font.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;

const Font& font = outline_record::sample_font();

constexpr int32_t kWidth = 120;
constexpr int32_t kHeight = 50;
uint8_t screens[2][kHeight][kWidth];
uint8_t buffer[8 * kWidth];

struct Screen {
  const ValueLabel& value;
  uint8_t (&pixels)[kHeight][kWidth];
  int32_t sent = 0;

  static Status draw(void* context, const Strip& strip) {
    const auto& screen = *static_cast<const Screen*>(context);
    // A picture.
    for (const auto [x, y] : pixels_of(strip.width, strip.height)) {
      strip.pixels[static_cast<size_t>(y * strip.stride + x)] =
          static_cast<uint8_t>((strip.x0 + x) * 5 ^ (strip.y0 + y) * 3);
    }
    const port::Grey8Canvas canvas(strip);
    screen.value.draw(canvas);
    return canvas.status();
  }
  static Status flush(void* display, const Strip& strip) {
    auto& screen = *static_cast<Screen*>(display);
    for (const auto [x, y] : pixels_of(strip.width, strip.height)) {
      screen.pixels[strip.y0 + y][strip.x0 + x] =
          strip.pixels[static_cast<size_t>(y * strip.stride + x)];
    }
    screen.sent += strip.width * strip.height;
    return Status::ok;
  }
};

// Draws a part of a screen; returns the pixels that were sent.
int32_t show(const ValueLabel& value, int32_t number, const Rect& part) {
  Screen screen = {value, screens[number]};
  port::StripLoop loop;
  loop.buffer = buffer;
  loop.format = port::PixelFormat::grey8;
  loop.width = kWidth;
  loop.height = kHeight;
  loop.context = &screen;
  loop.draw = Screen::draw;
  loop.display = &screen;
  loop.flush = Screen::flush;
  CHECK_OK(run_strips(loop, part));
  return screen.sent;
}

constexpr Rect kAll = {0, 0, kWidth, kHeight};

bool are_equal() {
  return __builtin_memcmp(screens[0], screens[1], sizeof screens[0]) == 0;
}

void check_changes(const Style& style, Anchor anchor) {
  constexpr const char* kTexts[] = {"AD", "FADE", "D", "", "EAF"};
  ValueLabel value(font, style, {60, 34}, anchor);
  show(value, 0, kAll);
  for (const char* const text : kTexts) {
    const Rect changed = value.set(text, {});
    CHECK(!is_empty(changed));
    const int32_t sent = show(value, 0, changed);
    CHECK(sent > 0 && sent < kWidth * kHeight / 2);
    show(value, 1, kAll);
    CHECK(are_equal());
  }
}

TEST(a_value_without_a_font_shows_nothing) {
  constexpr ValueLabel kEmpty;
  ValueLabel value = kEmpty;
  CHECK(is_empty(value.set("21.5", {})));
  CHECK_EQ(value.text().size, 4);
  Sink sink;
  sink.window = {0, 0, kWidth, kHeight};
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t*, int32_t) {
    CHECK(false);
  };
  value.draw(sink);
}

TEST(a_change_makes_the_screen_of_a_full_redraw) {
  Style style(20_px);
  check_changes(style, Anchor::left);
  check_changes(style, Anchor::centre);
  check_changes(style, Anchor::right);
  const Stroke stroke(kFilterText, Q6_10::from_int(2));
  style.set_effect(stroke);
  check_changes(style, Anchor::right);
  Style small(12_px);
  FitOptions options;
  options.across = true;
  Fit fit;
  CHECK_OK(Fit::make(font, small, options, fit));
  small.set_fit(fit);
  check_changes(small, Anchor::right);
}

TEST(values_stand_at_their_anchor) {
  const Style style(20_px);
  const int32_t width = Painter().measure(font, style, "AD").advance.raw;
  struct {
    Anchor anchor;
    int32_t left;
  } const anchors[] = {
      {Anchor::left, 0}, {Anchor::centre, width / 2}, {Anchor::right, width}};
  for (const auto& at : anchors) {
    ValueLabel value(font, style, {60, 34}, at.anchor);
    const Rect changed = value.set("AD", {});
    const Rect box = Painter().box(
        font, style, {Q26_6::from_raw(60 * 64 - at.left), 34_px}, "AD");
    CHECK(is_same(changed, box));
    CHECK(is_same(value.box(), box));
  }
}

// The anchor, the box and what is cleared are those of both.
TEST(a_number_and_its_unit_are_one_value) {
  const uint32_t kNine = '9';
  const outline_record::OutlineSource glyphs[] = {
      {600, {outline_record::kBar, 4}},
      {600, {outline_record::kEll, 6}},    // 9
      {900, {outline_record::kBar, 4}},    // :
      {768, {outline_record::kDisc, 13}},  // ;
  };
  alignas(4) static uint8_t font_bytes[512];
  const size_t size =
      outline_record::build_outline_font({glyphs, 4}, 0, kNine, font_bytes);
  Font digits;
  CHECK_OK(Font::open({font_bytes, size}, digits));
  const Style style(16_px);
  ValueLabel value(digits, style, {110, 34}, Anchor::right);
  show(value, 0, kAll);
  const Rect unit = Painter().box(
      digits, style,
      {Q26_6::from_raw(110 * 64 -
                       Painter().measure(digits, style, ":;").advance.raw),
       34_px},
      ":;");
  for (const int32_t number : each_of({9, 999999, 99})) {
    show(value, 0, value.set(NumberText(number).with_unit(":;"), {}));
    show(value, 1, kAll);
    CHECK(are_equal());
    CHECK_EQ(value.box().x1, unit.x1);
    CHECK(value.box().x0 < unit.x0);
  }
}

// On canvases of 1 and 2 bits, whose painters fit text: as with the style that
// the canvas makes, by its advances.
template <typename Canvas>
void check_fitted_anchors(int32_t stride) {
  uint8_t* const pages[] = {screens[0][0], screens[1][0]};
  const Style open(13_px);
  const Style fitted = Canvas::style(13_px);
  constexpr const char* kText = "DADEFADA";
  const int32_t width = Painter().measure(font, fitted, kText).advance.raw;
  CHECK(width != Painter().measure(font, open, kText).advance.raw);
  for (const Anchor anchor :
       each_of({Anchor::left, Anchor::centre, Anchor::right})) {
    __builtin_memset(screens, 0, sizeof screens);
    const auto canvas = [stride](uint8_t* page) {
      return Canvas({{page, sizeof screens[0]}, 0, 0, kWidth, 48, stride});
    };
    ValueLabel value(font, open, {60, 34}, anchor);
    const Rect changed = value.set(kText, Canvas());
    value.draw(canvas(pages[0]));
    const int32_t left = anchor == Anchor::left     ? 0
                         : anchor == Anchor::centre ? width / 2
                                                    : width;
    const Point at = {Q26_6::from_raw(60 * 64 - left), 34_px};
    Painter(canvas(pages[1])).text(font, fitted, at, kText);
    CHECK(are_equal());
    const Rect box = Painter().box(font, fitted, at, kText);
    CHECK(is_same(changed, box));
  }
}

TEST(fitted_values_stand_at_their_anchor) {
  check_fitted_anchors<port::MonoPagesCanvas>(kWidth);
  check_fitted_anchors<port::MonoRowsCanvas>(kWidth / 8);
  check_fitted_anchors<port::Grey2Canvas>(kWidth / 4);
}

TEST(nothing_changes_if_the_text_is_the_same) {
  const Style style(20_px);
  ValueLabel value(font, style, {10, 30});
  CHECK(is_empty(value.set("", {})));
  char text[] = "AD";
  CHECK(!is_empty(value.set(text, {})));
  CHECK(is_empty(value.set("AD", {})));
  text[1] = 'E';  // the label has a copy
  CHECK(value.text().data[1] == 'D');
  CHECK(!is_empty(value.set(text, {})));
}

TEST(long_texts_are_cut_after_a_character) {
  const Style style(20_px);
  ValueLabel value(font, style, {10, 30});
  TextReport report;
  const Sink sink;
  const Painter painter(sink, {}, nullptr, &report);
  static_cast<void>(value.set("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA", painter));
  CHECK_EQ(value.text().size, 31);
  CHECK_EQ(report.status, Status::ok);
  CHECK(is_empty(value.set("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAB", painter)));
  CHECK_EQ(report.status, Status::cut);
  static_cast<void>(value.set("AAAAAAAAAAAAAAAAAAAAAAAAAAAAA\u20ac", {}));
  CHECK_EQ(value.text().size, 29);
  static_cast<void>(value.set("AAAAAAAAAAAAAAAAAAAAAAAAAAAA\u20acA", {}));
  CHECK_EQ(value.text().size, 31);
}

}  // namespace
