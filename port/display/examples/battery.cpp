// A battery on an OLED of 128 x 64 px, SSD1306 on I2C, 1 bit: its outline with
// round corners, as much of it filled as is left, the number, and a sign of
// warning when it is low. Edges lie at whole pixels, so that they are sharp.
//
// Coming from U8g2:
//
//   u8g2.drawBox(x, y, w, h)           fill(painter, rectangle(a, b))
//   u8g2.drawRFrame(x, y, w, h, r)     stroke(painter, rounded_rectangle(...))
//   u8g2.drawTriangle(x0, y0, ...)     fill(painter, polygon(points))
//   u8g2.drawLine(x0, y0, x1, y1)      stroke(painter, line(a, b), {1_px})
//   u8g2.setDrawColor(0)               canvas.set_level(0)
#include <fonts/battery_text.hpp>
#include <inkcell/figures/figures.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/i2c_display.hpp>
#include <inkcell/port/ssd1306.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::figures;
using namespace inkcell::port;

constexpr int32_t kWidth = 128;
constexpr Figure kCase = rounded_rectangle({10, 8}, {102, 40}, 6_px);
constexpr Figure kPole = rounded_rectangle({104, 18}, {112, 30}, 2_px);
constexpr Point kTriangle[] = {{56, 12}, {68, 36}, {44, 36}};
constexpr Figure kWarning = polygon(kTriangle);
constexpr Style kText = MonoPagesCanvas::style(16_px);
static uint8_t rows[kWidth * 16 / 8];  // two of the eight pages

struct Screen {
  const Font& font;
  int32_t percent;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  MonoPagesCanvas canvas(strip, 1, 0);
  const Painter painter(canvas);
  stroke(painter, kCase, {2_px});
  fill(painter, kPole);
  if (screen.percent < 15) {
    stroke(painter, kWarning, {2_px, Cap::butt, Join::round});
    stroke(painter, line({56, 20}, {56, 27}), {2_px});
    fill(painter, rectangle({55, 30}, {57, 32}));
  } else {
    const int32_t end = 14 + screen.percent * 84 / 100;
    fill(painter, rounded_rectangle({14, 12}, {end, 36}, 3_px));
  }
  NumberText number(screen.percent, 0);
  number.with_unit(" %");
  painter.text(screen.font, kText, {44, 60}, number);
  return canvas.status();
}

static Status run() {
  I2cDisplay i2c;  // at address 0x3c
  i2c.write = write_i2c;
  Ssd1306 display;
  display.bus = make_bus(i2c);
  INKCELL_TRY(init(display));
  Font font;
  INKCELL_TRY(Font::open(fonts::battery_text, font));
  Screen screen = {font, 0};
  StripLoop loop = loop_over(display, rows);
  loop.context = &screen;
  loop.draw = draw;
  for (;;) {
    screen.percent = static_cast<int32_t>(read_percent());
    INKCELL_TRY(run_strips(loop));
    wait_ms(nullptr, 1000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
