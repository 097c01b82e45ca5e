// Calls the README's function and one of layout, and looks at what they drew.
#include <stdio.h>
#include <string.h>
#include <fonts/dejavu_sans.hpp>
#include <inkcell/font.hpp>
#include <inkcell/layout/label.hpp>
#include <inkcell/layout/text_box.hpp>
#include <inkcell/port/pixel.hpp>
#include <inkcell/port/rgb565.hpp>
#include <inkcell/status.hpp>
#include <inkcell/strip.hpp>
#include <inkcell/text.hpp>

inkcell::Status hello(const inkcell::Strip& strip);

// Nobody calls it, so that nothing of what it calls is linked.
inkcell::Status uncalled(const inkcell::Font& font) {
  return font.verify();
}

namespace {

constexpr int32_t kWidth = 160;
constexpr int32_t kHeight = 96;
constexpr auto kFormat = inkcell::port::PixelFormat::rgb565;

// A screen in RAM, black.
struct Screen {
  uint8_t bytes[inkcell::port::strip_bytes(kFormat, kWidth, kHeight)] = {};
  inkcell::Strip strip;

  Screen() {
    strip.pixels = bytes;
    strip.width = kWidth;
    strip.height = kHeight;
    strip.stride = inkcell::port::stride_bytes(kFormat, kWidth);
  }
};

// Groups of rows with ink in the paragraph's box: its lines.
int lines_of(const Screen& screen) {
  int lines = 0;
  bool was_inked = false;
  for (int32_t y = 0; y < 64; ++y) {
    bool inked = false;
    for (int32_t i = 0; i < 2 * kWidth; ++i) {
      inked = inked || screen.bytes[y * screen.strip.stride + i] != 0;
    }
    lines += inked && !was_inked ? 1 : 0;
    was_inked = inked;
  }
  return lines;
}

// A paragraph, and a label that scrolls, of the library inkcell::layout.
inkcell::Status page(const inkcell::Font& font,
                     const inkcell::Style& style,
                     inkcell::Q26_6 scroll,
                     const inkcell::Sink& sink) {
  const inkcell::TextBox box(font, style, {4, 0, 156, 64},
                             inkcell::Align::centre);
  box.draw("A paragraph that wraps", sink);
  inkcell::PositionedGlyph glyphs[32];
  inkcell::ScrollingLabel label;
  INKCELL_TRY(inkcell::ScrollingLabel::make(box.options, {},
                                            "A title that scrolls",
                                            {0, 64, 160, 96}, glyphs, label));
  label.draw_endless(scroll, inkcell::Q26_6::from_int(16), sink);
  return inkcell::Status::ok;
}

inkcell::Status draw_page(int32_t scroll, Screen& screen) {
  inkcell::Font font;
  INKCELL_TRY(inkcell::Font::open(fonts::dejavu_sans, font));
  const inkcell::Style style(inkcell::Q26_6::from_int(20));
  const inkcell::port::Rgb565Canvas canvas(screen.strip);
  INKCELL_TRY(canvas.status());
  return page(font, style, inkcell::Q26_6::from_int(scroll), canvas);
}

// The paragraph has lines and stands still; the label below it moves.
bool page_works() {
  static Screen first;
  static Screen second;
  if (draw_page(0, first) != inkcell::Status::ok ||
      draw_page(7, second) != inkcell::Status::ok) {
    return false;
  }
  const auto split = static_cast<size_t>(64 * first.strip.stride);
  return lines_of(first) == 2 &&
         memcmp(first.bytes, second.bytes, split) == 0 &&
         memcmp(first.bytes + split, second.bytes + split,
                sizeof(first.bytes) - split) != 0;
}

}  // namespace

// Writes the screen's bytes to the file that is named, if there is one.
int main(int argc, char** argv) {
  if (!page_works()) {
    puts("the page of layout is not as it should be");
    return 1;
  }
  Screen screen;
  if (hello(screen.strip) != inkcell::Status::ok) {
    puts("the README's program fails");
    return 1;
  }
  if (argc > 1) {
    FILE* out = fopen(argv[1], "wb");
    if (out == nullptr ||
        fwrite(screen.bytes, sizeof screen.bytes, 1, out) != 1 ||
        fclose(out) != 0) {
      puts("the screen cannot be written");
      return 1;
    }
  }
  // Twelve characters of 24 px: some 12 x 60 px of stems, on a few rows only.
  int white = 0;
  int inked_rows = 0;
  for (int32_t y = 0; y < kHeight; ++y) {
    bool inked = false;
    for (int32_t x = 0; x < kWidth; ++x) {
      const uint8_t* pixel = screen.bytes + y * screen.strip.stride + 2 * x;
      white += pixel[0] == 0xff && pixel[1] == 0xff ? 1 : 0;
      inked = inked || pixel[0] != 0 || pixel[1] != 0;
    }
    inked_rows += inked ? 1 : 0;
  }
  printf("%d white pixels on %d rows\n", white, inked_rows);
  return white > 250 && white < 1500 && inked_rows >= 18 && inked_rows <= 26
             ? 0
             : 1;
}
