// A screen of your own on an emulated board: copy this folder. 128 x 64 px,
// grey of 4 bits; for another board change its name in the commands of
// docs/BOARD.md, and here the format, the canvas and the sizes.
#include <fonts/sans.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/layout/text_box.hpp>
#include <inkcell/port/grey4.hpp>
#include <inkcell/port/strip_loop.hpp>

#include "display.hpp"  // of boards/common

using namespace inkcell;

constexpr port::PixelFormat kFormat = port::PixelFormat::grey4;
constexpr int32_t kWidth = INKCELL_DISPLAY_WIDTH;
constexpr int32_t kHeight = INKCELL_DISPLAY_HEIGHT;
constexpr Style kText = Style(11_px);
constexpr Style kLarge = Style(28_px);
alignas(4) static uint8_t buffer[kWidth / 2 * 8];  // 8 rows

struct Screen {
  TextBox words;
  ValueLabel value;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const port::Grey4Canvas canvas(strip, 15, 0);  // white on black
  screen.words.draw("Living room, second floor", canvas);
  screen.value.draw(canvas);
  return canvas.status();
}

static Status run() {
  if (!board::display_init(kFormat)) {
    return Status::unsupported;
  }
  Font font;
  INKCELL_TRY(Font::open(fonts::sans, font));
  Screen screen;  // refers to styles and font, which must outlive it
  screen.words = TextBox(font, kText, {0, 0, kWidth, 30}, Align::centre);
  screen.value = ValueLabel(font, kLarge, {kWidth / 2, 58}, Anchor::centre);

  port::StripLoop loop;
  loop.buffer = buffer;
  loop.format = kFormat;
  loop.width = kWidth;
  loop.height = kHeight;
  loop.context = &screen;
  loop.draw = draw;
  loop.flush = [](void*, const Strip& strip) {
    return board::display_write(strip);
  };
  INKCELL_TRY(run_strips(loop));
  for (int32_t tenths = 215;; tenths += tenths < 235 ? 1 : 0) {
    const Rect changed = screen.value.set(NumberText(tenths, 1), {});
    INKCELL_TRY(run_strips(loop, changed));
  }
}

int main() {
  return static_cast<int>(
      run());  // ends QEMU: the exit code says what is wrong
}
