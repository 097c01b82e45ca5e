// Icons are characters of the font, named as their files; faces are merged.
#include <fonts/ui.hpp>

#include "check.hpp"
#include "inkcell/painter.hpp"

namespace {

using namespace inkcell;

// [px/em], as many as the icons' drawings have units: a unit is a pixel.
constexpr int32_t kSize = 24;

// Covered pixels of each column.
class Columns {
 public:
  Sink sink() {
    Sink sink;
    sink.window = {0, -kSize, kSize, kSize};
    sink.context = this;
    sink.coverage = [](void* columns, int32_t x, int32_t,
                       const uint8_t* coverage, int32_t count) {
      for (int32_t i = 0; i < count; ++i) {
        static_cast<Columns*>(columns)->sums_[x + i] += coverage[i];
      }
    };
    sink.solid = [](void* columns, int32_t x, int32_t, int32_t count) {
      for (int32_t i = 0; i < count; ++i) {
        static_cast<Columns*>(columns)->sums_[x + i] += 255;
      }
    };
    return sink;
  }

  int32_t pixels(int32_t first, int32_t end) const {
    int32_t sum = 0;
    for (int32_t x = first; x < end; ++x) {
      sum += sums_[x];
    }
    return (sum + 127) / 255;
  }

 private:
  int32_t sums_[kSize] = {};
};

Font open() {
  Font font;
  CHECK_OK(Font::open(fonts::ui, font));
  return font;
}

Style style() {
  Style style(Q26_6::from_int(kSize), kFilterText);
  return style;
}

// The ramp of the filter makes corners rounder and edges a little wider.
bool is_near(int32_t pixels, int32_t expected) {
  return pixels >= expected - 6 && pixels <= expected + 6;
}

// What docs/BUILD.md shows.
void draw_wifi(const Font& font, const Style& style, const Sink& sink) {
  const Point pen = {};
  inkcell::Painter(sink).text(font, style, pen,
                              fonts::ui_icons::kWifi);  // UTF-8
}

}  // namespace

TEST(icons_are_drawn_by_name) {
  Columns wifi;
  draw_wifi(open(), style(), wifi.sink());
  CHECK(wifi.pixels(0, kSize) > 80);
  CHECK(is_near(wifi.pixels(0, 12), wifi.pixels(12, 24)));

  // A roof of 90, a body of 140, less a door of 28.
  Columns home;
  Painter(home.sink()).text(open(), style(), {}, fonts::ui_icons::kHome);
  CHECK(is_near(home.pixels(0, kSize), 90 + 140 - 28));

  Columns battery;
  Painter(battery.sink()).text(open(), style(), {}, fonts::ui_icons::kBattery);
  CHECK(is_near(battery.pixels(2, 20), 18 * 10));
  CHECK(is_near(battery.pixels(20, 22), 2 * 4));
}

TEST(icons_have_the_code_points_asked_for) {
  const Font font = open();
  uint16_t glyph = 0;
  const uint32_t codes[] = {0xE001, 0xE002, 0xE000};
  for (const uint32_t code : codes) {
    CHECK(font.glyph_of(code, glyph) == Status::ok);
    CHECK(glyph != 0);
  }
  CHECK_EQ(fonts::ui_icons::kHome[2], '\x82');  // U+E002 is EE 80 82
}

TEST(characters_come_from_both_faces) {
  const Font font = open();
  uint16_t glyph = 0;
  const uint32_t codes[] = {'A', 0x3B1, 0x3C9};
  for (const uint32_t code : codes) {
    CHECK(font.glyph_of(code, glyph) == Status::ok);
  }
  CHECK(font.glyph_of(0x391, glyph) == Status::no_glyph);
  Columns alpha;
  Painter(alpha.sink()).text(font, style(), {}, "\xCE\xB1");
  CHECK(alpha.pixels(0, kSize) > 30);
}
