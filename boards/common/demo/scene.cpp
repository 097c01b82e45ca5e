// The layout on a screen of any size, and the animation.
#include "scene.hpp"
#include "inkcell/painter.hpp"

#include INKCELL_DEMO_CODING_HEADER
#include INKCELL_DEMO_FONT_HEADER

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

constexpr Text kMoving = kHeight < 32 ? Text("type from distance fields")
                                      : Text("Inkcell: type for small devices");
constexpr int32_t kFirstMinute = 10 * 60 + 42;
constexpr uint32_t kFramesPerMinute = 480;
constexpr uint32_t kMinutesPerDay = 24 * 60;
constexpr int32_t kStepQ6 = 8;  // of the moving line in a frame: 1/8 px
constexpr int32_t kMarginQ6 = kWidth * 64 / 32;

constexpr int32_t kWidthQ6 = kWidth * 64;
constexpr int32_t kHeightQ6 = kHeight * 64;
constexpr int32_t kClockQ6 = INKCELL_DEMO_CLOCK_PX * 64;
constexpr int32_t kTextQ6 = INKCELL_DEMO_TEXT_PX * 64;

Point point(int32_t x_q6, int32_t y_q6) noexcept {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

// "10:42" at a minute of the day.
Text time_text(uint32_t minute, char (&digits)[5]) noexcept {
  const uint32_t hour = minute / 60;
  minute %= 60;
  digits[0] = static_cast<char>('0' + hour / 10);
  digits[1] = static_cast<char>('0' + hour % 10);
  digits[2] = ':';
  digits[3] = static_cast<char>('0' + minute / 10);
  digits[4] = static_cast<char>('0' + minute % 10);
  return {digits, sizeof digits};
}

int32_t count_missing(const Font& font, Text text) noexcept {
  int32_t missing = 0;
  while (text.size != 0) {
    uint16_t glyph;
    missing += font.glyph_of(next_code_point(text), glyph) != Status::ok;
  }
  return missing;
}

// `sink` limited to the part of its window to the right of `x`.
Sink right_of(Sink sink, int32_t x) noexcept {
  sink.window.x0 = sink.window.x0 > x ? sink.window.x0 : x;
  return sink;
}

}  // namespace

const char* Scene::body_text(int32_t line) noexcept {
  constexpr const char* kShort[] = {"Crisp at every size,",
                                    "no heap, no float."};
  constexpr const char* kLong[] = {
      "One small font for every size:", "each pixel takes its distance",
      "to the outline, with no heap", "and only integers."};
  return kBodyLines == 2 ? kShort[line % 2] : kLong[line % 4];
}

Status Scene::lay_out(const Font& font,
                      const Style& style,
                      Text text,
                      Line& line) noexcept {
  const Painter painter;
  INKCELL_TRY(painter.lay_out(font, style, text, line.glyphs, line.used));
  line.width_q6 = painter.measure(font, style, text).advance.raw;
  return Status::ok;
}

// Fits still text to the pixel grid, and all text in black and white, where
// sub-pixel steps are invisible.
Status Scene::make_look(int32_t size_q6, bool is_still, Look& look) noexcept {
  constexpr int32_t kAcrossBelowQ6 = 12 * 64;
  look.style = Style(Q26_6::from_raw(size_q6), kFilterText);
  if (!is_still && !kIsMono) {
    return Status::ok;
  }
  FitOptions options;
  options.across = kIsMono || size_q6 < kAcrossBelowQ6;
  options.levels = kIsMono ? 2 : 0;
  INKCELL_TRY(Fit::make(font_, look.style, options, look.fit));
  look.style.set_fit(look.fit);
  if constexpr (kIsMono) {
    look.bilevel.threshold_px = look.fit.bilevel_weight();
    look.style.set_effect(look.bilevel);
  }
  return Status::ok;
}

Status Scene::open() noexcept {
  INKCELL_TRY(
      Font::open(fonts::INKCELL_DEMO_FONT_NAME, INKCELL_DEMO_CODING, font_));
  INKCELL_TRY(make_look(kClockQ6, true, clock_look_));
  INKCELL_TRY(make_look(kTextQ6, true, text_look_));
  INKCELL_TRY(make_look(kTextQ6, false, moving_look_));
  INKCELL_TRY(lay_out(font_, moving_look_.style, kMoving, moving_));
  INKCELL_TRY(lay_out_body());
  set_frame(0);
  return Status::ok;
}

Status Scene::lay_out_body() noexcept {
  // Evenly between the clock and the moving line.
  const int32_t top = kMarginQ6 + kClockQ6 * 3 / 4;
  const int32_t bottom = kHeightQ6 - kMarginQ6;
  const int32_t step = (bottom - top) / (kBodyLines + 1);
  for (int32_t i = 0; i < kBodyLines; ++i) {
    Line& line = body_[i];
    INKCELL_TRY(lay_out(font_, text_look_.style, body_text(i), line));
    line.origin = point((kWidthQ6 - line.width_q6) / 2, top + step * (i + 1));
  }
  return Status::ok;
}

void Scene::set_frame(uint32_t frame) noexcept {
  const uint32_t minute =
      (kFirstMinute + frame / kFramesPerMinute) % kMinutesPerDay;
  char digits[5];
  // A line holds five glyphs.
  static_cast<void>(
      lay_out(font_, clock_look_.style, time_text(minute, digits), clock_));
  // Digits are 3/4 em high.
  clock_.origin = kOneLine ? point(0, (kHeightQ6 + kClockQ6 * 3 / 4) / 2)
                           : point((kWidthQ6 - clock_.width_q6) / 2,
                                   kMarginQ6 + kClockQ6 * 3 / 4);

  // Moves left until nothing is visible, then enters on the right.
  const int32_t left = kOneLine ? clock_.width_q6 + kMarginQ6 : 0;
  const int32_t home = left + kMarginQ6;
  const uint32_t period =
      static_cast<uint32_t>(kWidthQ6 - left + moving_.width_q6);
  int32_t x = home - static_cast<int32_t>(frame % (period / kStepQ6) *
                                          static_cast<uint32_t>(kStepQ6));
  if (x < left - moving_.width_q6) {
    x += static_cast<int32_t>(period / kStepQ6) * kStepQ6;
  }
  const int32_t baseline =
      kOneLine ? (kHeightQ6 + kTextQ6 * 3 / 4) / 2 : kHeightQ6 - kMarginQ6;
  moving_.origin = point(x, baseline);
}

void Scene::draw(const Strip& strip) noexcept {
  Canvas canvas(strip);
  const Workspace ram =
      kLentBytes == 0 ? Workspace() : Workspace(ram_, sizeof ram_);
  inkcell::Painter(canvas.sink(Ink::clock), ram)
      .glyphs(font_, clock_look_.style, clock_.origin, clock_.used);
  for (int32_t i = 0; i < kBodyLines; ++i) {
    inkcell::Painter(canvas.sink(Ink::text), ram)
        .glyphs(font_, text_look_.style, body_[i].origin, body_[i].used);
  }
  const int32_t left = kOneLine ? (clock_.width_q6 + kMarginQ6 + 63) / 64 : 0;
  inkcell::Painter(right_of(canvas.sink(Ink::moving), left), ram)
      .glyphs(font_, moving_look_.style, moving_.origin, moving_.used);
}

int32_t Scene::missing_characters() const noexcept {
  int32_t missing =
      count_missing(font_, "0123456789:") + count_missing(font_, kMoving);
  for (int32_t i = 0; i < kBodyLines; ++i) {
    missing += count_missing(font_, body_text(i));
  }
  return missing;
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
