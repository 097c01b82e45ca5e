// The eight letters in three weights, a line each.
#include <fonts/family_400.hpp>
#include <fonts/family_500.hpp>
#include <fonts/family_700.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/grey4.hpp>
#include <inkcell/port/strip_loop.hpp>

#include "board.hpp"
#include "display.hpp"

using namespace inkcell;

constexpr int32_t kWidth = INKCELL_DISPLAY_WIDTH;
constexpr Q26_6 kBaselines[] = {15_px, 36_px, 57_px};
constexpr Style kStyle = Style(18_px);
alignas(4) static uint8_t buffer[kWidth / 2 * INKCELL_DISPLAY_HEIGHT];

static Status draw(void* context, const Strip& strip) {
  const Font* const fonts = static_cast<const Font*>(context);
  const port::Grey4Canvas canvas(strip, 15, 0);  // white on black
  const Painter painter(canvas);
  for (size_t i = 0; i < 3; ++i) {
    painter.text(fonts[i], kStyle, {2_px, kBaselines[i]}, "hound blind");
  }
  return canvas.status();
}

static Status run() {
  constexpr port::PixelFormat kFormat = port::PixelFormat::grey4;
  if (!board::display_init(kFormat)) {
    return Status::unsupported;
  }
  static Font fonts[3];
  INKCELL_TRY(Font::open(fonts::family_400, fonts[0]));
  INKCELL_TRY(Font::open(fonts::family_500, fonts[1]));
  INKCELL_TRY(Font::open(fonts::family_700, fonts[2]));
  port::StripLoop loop;
  loop.buffer = buffer;
  loop.format = kFormat;
  loop.width = kWidth;
  loop.height = INKCELL_DISPLAY_HEIGHT;
  loop.context = fonts;
  loop.draw = draw;
  loop.flush = [](void*, const Strip& strip) {
    return board::display_write(strip);
  };
  INKCELL_TRY(run_strips(loop));
  board::print("READY\n");
  for (;;) {
  }
}

int main() {
  return static_cast<int>(run());
}
