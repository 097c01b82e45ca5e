// A font prints on a display what the painter prints on a canvas of grey, and
// in two colours its pixels of at least one half.
#include <stdio.h>
#include <fonts/sans.hpp>

#include "inkcell/inkcell.hpp"
#include "inkcell_font.h"

static uint8_t shown[160 * 60];

class Screen : public esphome::display::Display {
 public:
  int get_width() override { return 160; }
  int get_height() override { return 60; }
  void draw_pixel_at(int x, int y, esphome::Color color) override {
    shown[y * 160 + x] = color.g;
  }
  esphome::display::DisplayType get_display_type() override { return type; }
  esphome::display::DisplayType type =
      esphome::display::DisplayType::DISPLAY_TYPE_COLOR;
#ifdef REAL_ESPHOME
  void update() override {}
  int get_height_internal() override {
    return 60;
  }
  int get_width_internal() override {
    return 160;
  }
#endif
};

static int draw(bool two_colours,
                bool is_binary,
                const char* text,
                const char* after) {
  static uint8_t wanted[160 * 60];
  for (int i = 0; i < 160 * 60; ++i) {
    shown[i] = wanted[i] = 0;
  }
  Screen screen;
  if (is_binary) {
    screen.type = esphome::display::DisplayType::DISPLAY_TYPE_BINARY;
  }
  esphome::inkcell_font::InkcellFont font(fonts::sans, sizeof fonts::sans,
                                          22 * 64, two_colours);
  int width, x_offset, baseline, height;
  font.measure(text, &width, &x_offset, &baseline, &height);
  const esphome::Color white(255, 255, 255), black(0, 0, 0);
  font.print(3, 5, &screen, white, text, black);
  font.print(3 + width, 5 + height, &screen, white, after,
             black);  // is clipped

  inkcell::Font same;
  inkcell::Style style(inkcell::Q26_6::from_int(22));
  inkcell::FitOptions options;
  options.across = two_colours;
  options.levels = two_colours ? 2 : 0;
  inkcell::Fit fit;
  if (inkcell::Font::open(fonts::sans, same) != inkcell::Status::ok ||
      inkcell::Fit::make(same, style, options, fit) != inkcell::Status::ok) {
    return 1;
  }
  style.set_fit(fit);
  const inkcell::port::A8Canvas canvas(
      inkcell::Strip{wanted, 0, 0, 160, 60, 160});
  const inkcell::Painter painter(canvas);
  painter.text(same, style, {3, 5 + baseline}, text);
  painter.text(same, style, {3 + width, 5 + height + baseline}, after);
  int others = 0;
  int inked = 0;
  for (int i = 0; i < 160 * 60; ++i) {
    const int value =
        two_colours || is_binary ? (wanted[i] >= 128 ? 255 : 0) : wanted[i];
    others += shown[i] != value;
    inked += value != 0;
  }
  const int advance =
      (inkcell::Painter().measure(same, style, text).advance.raw + 63) / 64;
  printf("ESPHome, %s%s: %d pixels with ink, %d differ\n",
         two_colours ? "two colours" : "grey", is_binary ? ", binary" : "",
         inked, others);
  return others != 0 || inked < 200 || advance != width || height < 20;
}

int main() {
  esphome::inkcell_font::InkcellFont none(nullptr, 0, 1280, false);
  int width = 1, x_offset, baseline, height;
  none.measure("A", &width, &x_offset, &baseline, &height);
  Screen screen;
  none.print(0, 0, &screen, {}, "A", {});  // is logged
  return draw(false, false, "21.5 \u00B0C", "Kg") |
         draw(true, false, "21.5 \u00B0C", "Kg") |
         draw(true, true, "21.5 \u00B0C", "Kg") |
         draw(false, true, "21.5 \u00B0C", "Kg") | (width != 0);
}
