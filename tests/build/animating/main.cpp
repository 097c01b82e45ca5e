// A counter on a screen of 240 x 240 px in RGB565.
#include <fonts/sans.hpp>  // made by inkcell_add_font(), see above
#include <inkcell/inkcell.hpp>
#include <inkcell/motion/recipes.hpp>
#include <inkcell/port/rgb565.hpp>
#include <inkcell/port/strip_loop.hpp>

using namespace inkcell;
using namespace inkcell::motion;

// Three functions of yours.
uint32_t ticks_ms();  // since the start
void wait_ms(uint32_t ms);
Status send(void* display, const Strip& strip);  // to its place on the screen

constexpr int32_t kFrameMs = 33;
constexpr Style style = Style(24_px);
constexpr uint16_t kInk = 0xffff, kPaper = 0x0000;   // white on black
alignas(4) static uint8_t strip_rows[2 * 240 * 16];  // 16 rows
alignas(4) static uint8_t painter_ram[4096];         // for outlines that morph

struct Screen {
  port::StripLoop loop;
  uint32_t start = ticks_ms();
  Status status = Status::ok;  // the first error

  // Draws and sends the pixels that changed.
  template <typename Recipe>
  void redraw(const Rect& changed, Recipe& recipe) {
    loop.context = &recipe;
    loop.draw = [](void* context, const Strip& strip) {
      const port::Rgb565Canvas canvas(strip, kInk, kPaper);
      static_cast<Recipe*>(context)->draw(
          Painter(canvas, Workspace(painter_ram)));
      return canvas.status();
    };
    if (status == Status::ok) {
      status = run_strips(loop, changed);
    }
  }

  // Sleeps until `now` ms after the start. Returns at once if that has passed.
  void wait_until(int32_t now) const {
    const int32_t early = now - static_cast<int32_t>(ticks_ms() - start);
    if (early > 0) {
      wait_ms(static_cast<uint32_t>(early));
    }
  }
};

static Status animate(Screen& screen, const Font& font) {
  Counter steps(font, style, {8, 30}, 4);  // {x, baseline}, four wheels
  steps.roll(0, 1250, {0, 2600});          // from, to, {delay, duration [ms]}
  steps.at(0);
  screen.redraw({0, 0, 240, 240}, steps);  // the whole screen, once
  for (int32_t now = 0; now < 2600 + kFrameMs; now += kFrameMs) {
    screen.wait_until(now);
    screen.redraw(steps.at(now), steps);
  }
  return screen.status;
}

int main() {
  Font font;
  if (Font::open(fonts::sans, font) != Status::ok) {
    return 1;
  }
  Screen screen;
  screen.loop.buffer = strip_rows;
  screen.loop.width = screen.loop.height = 240;
  screen.loop.flush = send;
  return static_cast<int>(animate(screen, font));
}
