// Contracts that are broken end the program, those that are kept do not.
#include "inkcell/assert.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "base/bytes.hpp"
#include "check.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "outline_record.hpp"
#include "place/style_parts.hpp"
#include "rows/band.hpp"

namespace {

using namespace inkcell;

// Whether a program that does this ends by a signal.
template <typename Action>
bool ends(const Action& action) {
  const pid_t child = fork();
  if (child == 0) {
    action();
    _exit(0);
  }
  int status = 0;
  CHECK(child > 0 && waitpid(child, &status, 0) == child);
  CHECK(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
  return WIFSIGNALED(status);
}

volatile int32_t kept;  // what is computed is used
const void* volatile kept_address;

void take(void*, int32_t, int32_t, const uint8_t*, int32_t) {}
void take_solid(void*, int32_t, int32_t, int32_t) {}
constexpr Sink kSink = {{0, 0, 8, 4}, nullptr, take, take_solid};

}  // namespace

TEST(numbers_fit_their_type) {
  const auto convert = [](int16_t value) {
    return [=] { kept = Q6_10::from_int(value).raw; };
  };
  CHECK(!ends(convert(-32)) && !ends(convert(31)));
  CHECK(ends(convert(-33)) && ends(convert(32)));
}

TEST(elements_exist) {
  static const uint8_t bytes[3] = {1, 2, 3};
  const auto read = [](size_t i) {
    return [=] { kept = Span<const uint8_t>(bytes)[i]; };
  };
  CHECK(!ends(read(2)));
  CHECK(ends(read(3)));
}

TEST(loads_are_aligned) {
  alignas(4) static const uint8_t bytes[8] = {};
  const auto read = [](size_t i) {
    return [=] { kept = detail::load_u16(bytes + i); };
  };
  CHECK(!ends(read(2)));
  CHECK(ends(read(1)));
}

TEST(code_points_come_from_a_text) {
  const auto read = [](const char* string) {
    return [=] {
      Text text = string;
      kept = static_cast<int32_t>(next_code_point(text));
    };
  };
  CHECK(!ends(read("a")));
  CHECK(ends(read("")));
}

TEST(rows_are_in_the_window_of_a_sink_with_functions) {
  const auto draw = [](const Sink& sink, int32_t x, int32_t y) {
    return [=] {
      alignas(4) const uint8_t row[4] = {255, 255, 9, 9};
      detail::emit_row(sink, x, y, row, 4);
    };
  };
  CHECK(!ends(draw(kSink, 4, 3)));
  CHECK(ends(draw(kSink, 8, 3)));
  CHECK(ends(draw(kSink, 4, 4)));
  Sink deaf = kSink;
  deaf.solid = nullptr;
  CHECK(ends(draw(deaf, 4, 3)));
}

TEST(runs_have_faces) {
  static uint8_t rom[outline_record::kSampleFontBytes];
  const size_t size = outline_record::build_sample_font(rom);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  Style style(9_px, kFilterText);
  const auto draw_with = [](const Font* own, const Style* look) {
    return [=] {
      PositionedGlyph at;
      at.glyph = 1;
      const Face face = {own, look};
      Painter(kSink).glyphs(face, {}, {}, {&at, 1});
    };
  };
  CHECK(!ends(draw_with(&font, &style)));
  CHECK(ends(draw_with(nullptr, &style)));
  CHECK(ends(draw_with(&font, nullptr)));
}

TEST(styles_are_checked_before_they_draw) {
  static uint8_t rom[outline_record::kSampleFontBytes];
  const size_t size = outline_record::build_sample_font(rom);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  Style style(9_px, kFilterText);
  const auto draw = [&] { Painter(kSink).text(font, style, {}, "A"); };
  CHECK(!ends(draw));
  const Splat splat({});
  style.set_effect(splat);
  CHECK_EQ(font.check(style), Status::unsupported);
  CHECK(ends(draw));
}

TEST(boxes_are_made) {
  static TextBox box;
  const auto draw = [] { box.draw("A", Painter(kSink)); };
  CHECK(ends(draw));
  static Font font;
  static Style style(9_px, kFilterText);
  box = TextBox(font, style, {0, 0, 9, 9});
  CHECK(!ends(draw));
  box.clip = {};  // as where a constructor was not run
  CHECK(ends(draw));
}

TEST(slants_are_of_slanted_styles) {
  static Style style;
  const auto ask = [] { kept_address = &detail::StyleParts::slant(style); };
  CHECK(ends(ask));
  Direction down;
  down.cosine.raw = 0;
  down.sine.raw = -(1 << 30);
  style = Style(9_px, kFilterText, down);
  CHECK(!ends(ask));
}
