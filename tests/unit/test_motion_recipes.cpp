// Recipes, and the code of docs/ANIMATING.md that uses them: what is drawn
// again is all that changed, and rests are plain text.
#include "check.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/motion/fade.hpp"
#include "inkcell/motion/recipes.hpp"
#include "outline_record.hpp"
#include "picture.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace outline_record;

constexpr int32_t kWidth = 96;
constexpr int32_t kHeight = 40;
constexpr Rect kAll = {0, 0, kWidth, kHeight};

// Digits, then ':' and ';', of a few shapes.
constexpr OutlinePoint kSquare[] = {
    {start, 60, 0}, {corner, 540, 0}, {corner, 540, 700}, {corner, 60, 700}};
alignas(4) uint8_t font_bytes[1024];

const Font& test_font() {
  static Font font;
  if (font.glyph_count() == 0) {
    const OutlineSource glyphs[] = {
        {600, {kBar, 4}},   {700, {kSquare, 4}}, {600, {kBar, 4}},
        {600, {kEll, 6}},   {700, {kSquare, 4}}, {600, {kBar, 4}},
        {600, {kEll, 6}},   {768, {kDisc, 13}},  {600, {kBar, 4}},
        {600, {kEll, 6}},   {700, {kSquare, 4}}, {600, {kBar, 4}},
        {768, {kDisc, 13}}, {600, {kEll, 6}}};
    const size_t size = build_outline_font({glyphs, 14}, 0, '/', font_bytes);
    CHECK_OK(Font::open({font_bytes, size}, font));
  }
  return font;
}

const Font& font = test_font();
const Style style(18_px);
const Style small(14_px);

using Page = Picture<kWidth, kHeight, Overlap::light>;
Page whole;
Page expected;
alignas(4) uint8_t ram[2048];

// Of other parts of the target nothing changes.
template <typename Recipe>
void draw(Recipe& recipe, Page& target, const Rect& part = kAll) {
  const Sink sink = target.sink(part);
  if (!is_empty(sink.window)) {
    target.clear(sink.window);
    recipe.draw(Painter(sink, Workspace(ram)));
  }
}

// Draws what changed, as programs do, and compares it with all of the picture,
// in strips.
struct Screen {
  Page shown;
  int32_t redraws = 0;
  uint32_t pixels = 0;

  template <typename Recipe>
  void redraw(const Rect& changed, Recipe& recipe) {
    const Rect part = intersect(changed, kAll);
    if (!is_empty(part)) {
      ++redraws;
      pixels +=
          static_cast<uint32_t>((part.x1 - part.x0) * (part.y1 - part.y0));
      ::draw(recipe, shown, part);
    }
    for (int32_t y = 0; y < kHeight; y += 5) {
      ::draw(recipe, expected, {0, y, kWidth, y + 5});
    }
    CHECK(shown == expected);
  }
  void wait_until(int32_t) const {}
};

// The pictures at rest, from plain text.
template <typename Recipe>
void check_plain(Recipe& recipe, Point origin, Text text) {
  draw(recipe, whole);
  expected.clear();
  Painter(expected.sink(), Workspace(ram)).text(font, style, origin, text);
  CHECK(expected.ink() > 0);
  CHECK(whole == expected);
}

// The examples of docs/ANIMATING.md.

constexpr int32_t kFrameMs = 33;

void count_up(Screen& screen) {
  Counter steps(font, style, {8, 30}, 4);
  steps.roll(0, 1250, {0, 2600});
  for (int32_t now = 0; now < 2600 + kFrameMs; now += kFrameMs) {
    screen.redraw(steps.at(now), steps);
  }
}

void tell_time(Screen& screen) {
  const uint32_t minute = 60;  // of the day: from 00:59 to 01:00
  Clock clock(font, style, {4, 30});
  for (int32_t now = 0; now < Clock::kEndMs + kFrameMs; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(clock.at(minute - 1, minute, now), clock);
  }
}

void type(Screen& screen) {
  Typewriter line(font, style, {2, 30}, "012:3", 90);  // 90 ms a letter
  for (int32_t now = 0; now < 3000; now = line.next_due(now)) {
    screen.wait_until(now);
    screen.redraw(line.at(now, {}), line);
  }
}

void reveal(Screen& screen) {
  const Timing timing = {200, 900};  // delay, duration [ms]
  Wipe title(font, style, {2, 30}, "01234", timing);
  for (int32_t now = 0; now < 1100 + kFrameMs; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(title.at(now, {}), title);
  }
}

void grow(Screen& screen) {
  PulseMotion motion;
  motion.swell_ms = 500;  // of a letter, up and down
  motion.timing.duration_ms = 1500;
  motion.timing.repeats = 0;    // 0: repeats for ever
  motion.stagger.step_ms = 80;  // from letter to letter
  WeightPulse line(font, style, {2, 30}, "01234", motion);
  for (int32_t now = 0; now < 3000; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(line.at(now), line);
  }
}

Status bounce(Screen& screen) {
  static constexpr Hop kHop = hop(8_px, 500);  // height, duration [ms]
  LetterMotion motion;
  motion.keys = kHop.keys;  // or those of swell(1.5_px, 500)
  motion.timing.duration_ms = 1500;
  motion.timing.repeats = 0;    // 0: repeats for ever
  motion.stagger.step_ms = 80;  // from letter to letter
  RunPlace where;
  where.origin = {2, 30};  // x, baseline
  where.size = style.size();
  where.pivot_height = 0;  // they stand on their feet
  RunGlyph glyphs[8];      // one for each letter, or more
  Run run;
  INKCELL_TRY(lay_out(font, "01234", Anchor::left, glyphs, run));
  PoseRenderer renderer(font, style.size());
  MovingLetters letters(renderer, font, run, where, motion);
  for (int32_t now = 0; now < 3000; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(letters.at(now), letters);
  }
  return Status::ok;
}

// A line that runs by, with soft ends.
struct Ticker {
  static constexpr Rect kBox = {0, 8, 96, 34};  // x0, y0, x1, y1 [px]
  static constexpr Q26_6 kGap = 24_px;          // from the end to the start
  static constexpr int32_t kSpeed = 40;         // [px/s]
  ScrollingLabel label;
  Q26_6 scroll;

  Rect at(int64_t now_ms) {
    const int32_t loop = label.width().raw + kGap.raw;  // [1/64 px]
    scroll = Q26_6::from_raw(
        static_cast<int32_t>(now_ms * kSpeed * 64 / 1000 % loop));
    return kBox;  // all of it moves
  }
  void draw(const Painter& painter) const {
    SoftWindow window;
    window.target = &painter.sink();
    window.window = kBox;
    window.soft.left = window.soft.right = 16;  // [px]
    const Sink sink = make_sink(window);
    label.draw_endless(scroll, kGap, painter.with(sink));
  }
};

Status run_by(Screen& screen) {
  PositionedGlyph glyphs[16];  // one for each letter, or more
  Ticker ticker;
  INKCELL_TRY(ScrollingLabel::make(LayoutOptions(font, style), {}, "00000000",
                                   Ticker::kBox, glyphs, ticker.label));
  for (int32_t now = 0; now < 4000; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(ticker.at(now), ticker);
  }
  return Status::ok;
}

}  // namespace

TEST(counters_roll) {
  Screen screen;
  count_up(screen);
  CHECK(screen.redraws > 60);

  Counter counter(font, style, {8, 30}, 3);
  counter.roll(98, 100, {0, 1000}, kLinear);
  Rect all = counter.at(0);
  CHECK_EQ(all.x0, counter.box().x0);
  CHECK(is_empty(counter.at(0)));
  CHECK_EQ(counter.value(), 98u);
  // One wheel turns from 98 to 99, all three from 99 to 100.
  Rect changed = counter.at(250);
  CHECK(changed.x0 > all.x0 + 20);
  changed = counter.at(750);
  CHECK_EQ(changed.x0, all.x0);
  CHECK_EQ(counter.value(), 99u);
  counter.at(2000);
  CHECK_EQ(counter.value(), 100u);
  CHECK(counter.next_due(2000) == kNever);
  // Leading zeros are blank, too large numbers stop at the largest.
  counter.roll(7, 7, {});
  counter.at(0);
  draw(counter, whole);
  const int32_t seven = whole.ink();
  counter.roll(5000, 5000, {});
  counter.at(0);
  draw(counter, whole);
  CHECK_EQ(counter.value(), 999u);
  const int32_t most = whole.ink();
  CHECK(most > 2 * seven && seven > 0);
  counter.roll(999, 999, {});
  counter.at(0);
  draw(counter, whole);
  CHECK_EQ(whole.ink(), most);
  counter.roll(-20, -20, {});
  counter.at(0);
  CHECK_EQ(counter.value(), 0u);
}

TEST(counters_count_down_and_overshoot) {
  Screen screen;
  Counter counter(font, style, {8, 30}, 4);
  counter.roll(1250, 0, {0, 1000}, kOvershoot);
  for (int32_t now = 0; now <= 1100; now += 21) {
    screen.redraw(counter.at(now), counter);
  }
  CHECK_EQ(counter.value(), 0u);
}

TEST(clocks_roll_without_pairs) {
  Screen screen;
  tell_time(screen);
  // 00:59 to 01:00: three digits, all at once.
  Clock clock(font, style, {4, 30});
  Rect all = clock.at(59, 60, 0);
  CHECK_EQ(all.x1, clock.box().x1);
  CHECK(is_empty(clock.at(59, 60, 0)));
  Rect changed = clock.at(59, 60, 60);
  CHECK(changed.x0 > all.x0 && changed.x0 < 30);
  CHECK_EQ(changed.x1, all.x1);
  // The first digit stays.
  CHECK_EQ(clock.progress(0).raw, 1 << 16);
  CHECK(clock.progress(1).raw > 0 && clock.progress(1).raw < 1 << 15);
  CHECK_EQ(clock.progress(2).raw, clock.progress(1).raw);
  CHECK_EQ(clock.progress(3).raw, clock.progress(1).raw);
  // The end of one minute is the beginning of the next.
  clock.at(59, 60, Clock::kEndMs);
  CHECK(is_empty(clock.at(60, 61, 0)));
  CHECK(is_empty(clock.at(60, 60, 1000)));
  // Any minute and any time.
  clock.at(0xffffffff, 0xfffffffe, INT32_MIN);
  clock.at(1439, 1440, INT32_MAX);
  draw(clock, whole);
}

// A clock at half of a change, in a font with or without a pair: '0' and '1'.
void draw_change(bool has_pair, uint32_t minute, Page& target) {
  // 14 bytes and the record: one contour, four sides to four sides.
  uint8_t morphs[24] = {1, 0, 4, 8, 80, 0, 0, 0, 1 | 2 << 4, 0};
  BitWriter record({morphs + 10, 14});
  record.put(4, 4);
  record.put(1, 2);
  record.put(4, 7);
  record.put(1, 4);
  record.put(0, 3);
  record.put(1, 4);
  alignas(4) static uint8_t bytes[1024];
  OutlineSource glyphs[12];
  for (OutlineSource& glyph : glyphs) {
    glyph = {600, {kSquare, 4}};
  }
  glyphs[1] = glyphs[11] = {600, {kBar, 4}};
  Font paired;
  const size_t size = build_outline_font(
      {glyphs, 12}, 0, '0', bytes, {}, {morphs, has_pair ? sizeof morphs : 0});
  CHECK_OK(Font::open({bytes, size}, paired));
  Clock clock(paired, style, {4, 30});
  clock.at(minute, minute + 1, Clock::kEndMs / 2);
  draw(clock, target);
}

TEST(all_digits_of_a_change_go_the_same_way) {
  // 00:00 to 00:01 morphs.
  draw_change(true, 0, whole);
  draw_change(false, 0, expected);
  CHECK(!(whole == expected));
  // 00:09 to 00:10: 9 has no pair with 0, so 0 rolls to 1, too.
  draw_change(true, 9, whole);
  draw_change(false, 9, expected);
  CHECK(whole == expected);
}

TEST(clocks_show_seconds) {
  Screen screen;
  Clock clock(font, small, {2, 30}, ClockUnit::seconds);
  const uint32_t second = 12 * 3600 + 59 * 60 + 59;
  for (int32_t now = 0; now < Clock::kEndMs + kFrameMs; now += kFrameMs) {
    screen.redraw(clock.at(second, second + 1, now), clock);
  }
  CHECK(screen.redraws > 10);
  // 12:59:59 to 13:00:00: all digits but the first.
  CHECK_EQ(clock.digits(), 6);
  clock.at(second, second + 1, 300);
  CHECK_EQ(clock.progress(0).raw, 1 << 16);
  for (int32_t i = 1; i < 6; ++i) {
    CHECK(clock.progress(i).raw > 0 && clock.progress(i).raw < 1 << 16);
  }
  // At rest, 12:13:14: as 12:13, and 13:14 a pair of digits further.
  const uint32_t later = 12 * 3600 + 13 * 60 + 14;
  clock.at(later, later, 0);
  draw(clock, whole);
  Clock minutes(font, small, {2, 30});
  minutes.at(12 * 60 + 13, 12 * 60 + 13, 0);
  draw(minutes, expected);
  const int32_t end = minutes.box().x1 - 2;
  for (const auto [x, y] : pixels_of(end, kHeight)) {
    CHECK_EQ(whole.at(x, y), expected.at(x, y));
  }
  const uint16_t colon = font.glyph_or_notdef(':');
  const int32_t from_q6 = 2 * 64 + 2 * to_px(font, small, 768).raw +
                          to_px(font, small, font.advance(colon)).raw;
  const int32_t from = (from_q6 >> 6) + 1;
  Clock last(font, small, {Q26_6::from_raw(from_q6), 30_px});
  last.at(13 * 60 + 14, 13 * 60 + 14, 0);
  draw(last, expected);
  for (const auto [x, y] : pixels_of({from, 0, kWidth, kHeight})) {
    CHECK_EQ(whole.at(x, y), expected.at(x, y));
  }
  // Any second and any time.
  CHECK(is_empty(clock.at(later + 86400, later, 0)));
  clock.at(0xffffffff, 0xfffffffe, INT32_MIN);
  clock.at(86399, 86400, INT32_MAX);
  draw(clock, whole);
}

// Digits that lean out of their cells, as those of italics do.
TEST(ink_overhangs_its_cell) {
  constexpr OutlinePoint kLeaning[] = {{start, -180, -20},
                                       {corner, 100, -20},
                                       {corner, 800, 700},
                                       {corner, 520, 700}};
  alignas(4) static uint8_t bytes[1024];
  OutlineSource glyphs[12];
  for (OutlineSource& glyph : glyphs) {
    glyph = {600, {kLeaning, 4}};
  }
  glyphs[11] = {300, {kBar, 4}};  // ':'
  Font leaning;
  const size_t size = build_outline_font({glyphs, 12}, 0, '0', bytes);
  CHECK_OK(Font::open({bytes, size}, leaning));
  const Point at = {20, 30};
  Counter counter(leaning, style, at, 1);
  counter.roll(7, 7, {});
  const Rect changed = counter.at(0);
  draw(counter, whole);
  expected.clear();
  Painter(expected.sink(), Workspace(ram)).text(leaning, style, at, "7");
  CHECK(expected.ink() > 0);
  CHECK(whole == expected);
  const Rect ink = Painter().box(leaning, style, at, "7");
  CHECK(changed.x0 <= ink.x0 && changed.x1 >= ink.x1);
  // A clock's digit, and what is drawn again of both.
  Clock clock(leaning, style, at);
  clock.at(0, 1, 0);
  whole.clear();
  clock.draw_digit(Painter(whole.sink(), Workspace(ram)), style, 0);
  CHECK(whole == expected);
  Screen first;
  Clock other(leaning, style, at);
  for (int32_t now = 0; now < Clock::kEndMs + kFrameMs; now += kFrameMs) {
    first.redraw(other.at(59, 60, now), other);
  }
  Screen second;
  Counter three(leaning, style, at, 3);
  three.roll(95, 105, {0, 1000});
  for (int32_t now = 0; now <= 1000 + kFrameMs; now += kFrameMs) {
    second.redraw(three.at(now), three);
  }
}

TEST(typewriters_type) {
  Screen screen;
  type(screen);
  CHECK(screen.redraws > 8 && screen.redraws < 14);

  Typewriter line(font, style, {2, 30}, "012:3", 90);
  CHECK_EQ(line.end_ms(), 450);
  line.at(450 + 530, {});  // the caret is off
  check_plain(line, {2, 30}, "012:3");
  line.at(2 * 90 + 89, {});
  draw(line, whole);
  CHECK_EQ(whole.at(line.caret().x0, 28), 255);
  // It erases where time goes back.
  for (int32_t now = 600; now > -50; now -= 17) {
    screen.redraw(line.at(now, {}), line);
  }
  // Nothing changes before it is due.
  for (int32_t now = -100; now < 2000; now += 7) {
    line.at(now, {});
    const int32_t due = line.next_due(now);
    CHECK(due > now);
    CHECK(is_empty(line.at(due - 1, {})));
  }
  line.at(INT32_MAX, {});
  line.at(INT32_MIN, {});
}

TEST(wipes_reveal_and_hide) {
  Screen screen;
  reveal(screen);
  Wipe shows(font, style, {2, 30}, "01234", {0, 1000});
  Wipe hides(font, style, {2, 30}, "01234", {0, 1000}, Wipe::Kind::hide);
  int32_t last = -1;
  for (int32_t now = 0; now <= 1000; now += 50) {
    shows.at(now, {});
    draw(shows, whole);
    const int32_t ink = whole.ink();
    CHECK(now == 0 ? ink == 0 : ink >= last);
    last = ink;
    screen.redraw(hides.at(now, {}), hides);
  }
  check_plain(shows, {2, 30}, "01234");
  CHECK_EQ(screen.shown.ink(), 0);
  hides.at(0, {});
  check_plain(hides, {2, 30}, "01234");
}

TEST(letters_move_one_after_the_other) {
  Screen screen;
  CHECK_OK(bounce(screen));
  // Half of the time they rest.
  CHECK(screen.redraws > 40 && screen.redraws < 60);

  const PoseThere keys = swell(2_px, 400);
  const LetterMotion motion = {keys.keys, {0, 1000, 0}, {50}};
  const RunPlace where = {{2, 30}, style.size(), {}, 250};
  RunGlyph glyphs[8];
  Run run;
  CHECK_OK(lay_out(font, "0123", Anchor::left, glyphs, run));
  PoseRenderer renderer(font, style.size());
  MovingLetters letters(renderer, font, run, where, motion);
  CHECK(!is_empty(letters.at(0)));
  draw(letters, whole);
  const int32_t rest = whole.ink();
  letters.at(275);  // between the second and the third
  draw(letters, whole);
  CHECK(whole.ink() > rest * 5 / 4);
  letters.at(800);
  draw(letters, whole);
  CHECK_EQ(whole.ink(), rest);
  letters.at(INT32_MIN);
  letters.at(INT32_MAX);
}

// What moves is in motion_outline_morph.
TEST(letters_without_masters_stay_plain) {
  Screen screen;
  grow(screen);
  CHECK_EQ(screen.redraws, 1);
}

TEST(tickers_fade_at_their_ends) {
  Screen screen;
  CHECK_OK(run_by(screen));
  CHECK_EQ(screen.redraws, 122);
  PositionedGlyph glyphs[16];
  Ticker ticker;
  CHECK_OK(ScrollingLabel::make(LayoutOptions(font, style), {}, "00000000",
                                Ticker::kBox, glyphs, ticker.label));
  int32_t columns[2] = {};
  for (int32_t now = 0; now < 4000; now += 33) {
    ticker.at(now);
    draw(ticker, whole);
    for (int32_t y = 0; y < kHeight; ++y) {
      for (int32_t i = 0; i < 2; ++i) {
        const int32_t coverage = whole.at(48 * i, y);
        columns[i] = coverage > columns[i] ? coverage : columns[i];
      }
    }
  }
  CHECK(columns[0] < 10);
  CHECK_EQ(columns[1], 255);
  // 2560 loops later, in hours, it shows the same.
  ticker.at(1000);
  const int32_t scroll = ticker.scroll.raw;
  ticker.at(1000 + 1000 * int64_t{ticker.label.width().raw + 24 * 64});
  CHECK_EQ(ticker.scroll.raw, scroll);
  ticker.at(INT64_C(100000000000));  // three years
  CHECK(ticker.scroll.raw >= 0);
}

TEST(soft_windows_are_linear) {
  whole.clear();
  const Sink target = whole.sink();
  SoftWindow soft;
  soft.target = &target;
  soft.window = {10, 5, 30, 25};
  soft.soft = {8, 4, 0, 0};
  const Sink sink = make_sink(soft);
  CHECK_EQ(sink.window.x0, 10);
  for (int32_t y = 5; y < 25; ++y) {
    sink.solid(sink.context, 10, y, 20);
  }
  CHECK_EQ(whole.at(10, 20), 15);  // 255 / 16
  CHECK_EQ(whole.at(11, 20), 47);
  CHECK_EQ(whole.at(18, 20), 255);
  CHECK_EQ(whole.at(29, 20), 255);
  CHECK_EQ(whole.at(20, 5), 31);  // 255 / 8
  CHECK_EQ(whole.at(10, 5), 2);
  CHECK_EQ(whole.at(30, 20), 0);
}

// As docs/ANIMATING.md says, on 32 bits.
TEST(recipes_are_small) {
  if (sizeof(void*) == 4) {
    CHECK_EQ(sizeof(Counter), 80u);
    CHECK_EQ(sizeof(Clock), 56u);
    CHECK_EQ(sizeof(Typewriter), 40u);
    CHECK_EQ(sizeof(Wipe), 60u);
    CHECK_EQ(sizeof(MovingLetters), 28u);
    CHECK_EQ(sizeof(WeightPulse), 64u);
  }
}
