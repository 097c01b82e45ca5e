// Lines end between words, at the right edge; text without a paper lies on what
// was there. A long word is cut, the bytes of a character may come one by one,
// nothing is printed without a font, and lines of several sizes stand apart.
#include "Adafruit_ST7789_Text.ino"
#include "expected.hpp"

static uint16_t wanted[240 * 240];

static int check_example() {
  setup();
  loop();
  for (uint16_t& pixel : wanted) {
    pixel = 0xffff;
  }
  const Expected small(fonts::dejavu_sans_latin1, 18, false);
  const Expected large(fonts::dejavu_sans_latin1, 40.5, false);
  const auto canvas = inkcell::port::gfx_canvas16(wanted, 240, 240, 0x0000);
  int y = small.ascent();
  small.draw(canvas, 0, y, "Lines end between words, ");
  small.draw(canvas, 0, y += small.line(), "as they do on paper.");
  y += small.line();
  small.draw(canvas, 0, y, "Pressure: ", "1013");
  const auto red = inkcell::port::gfx_canvas16(wanted, 240, 240, 0xf800);
  large.draw(red, 240 - large.width("12:34"), 160, "12:34");
  inkcell::port::Rgb565Canvas green(canvas.strip(), 0x07e0);
  green.window = {8, 190, 108, 230};
  green.fill();
  green.set_colour(0x001f);
  Expected(fonts::dejavu_sans_latin1, 28, false).draw(green, 12, 220, "Over");
  return compare("Adafruit_ST7789", tft.memory, wanted, 240 * 240);
}

static int check_edges() {
  GFXcanvas16 canvas(60, 80);
  InkcellPrint out(canvas);
  const bool is_silent = out.print("A") == 0 && out.getWriteError() != 0 &&
                         !out.setFont({}, 12) && out.textWidth("A") == 0;
  const Expected font(fonts::dejavu_sans_latin1, 20, false);
  out.setFont(fonts::dejavu_sans_latin1, 20);
  out.setCursor(0, 20);
  out.print("WWWWW");  // three to the line
  out.setCursor(4, 20 + 2 * font.line());
  for (const char* byte = "\u00B0C"; *byte != '\0'; ++byte) {
    out.write(static_cast<uint8_t>(*byte));
  }
  static uint16_t pixels[60 * 80];
  const auto paper = inkcell::port::gfx_canvas16(pixels, 60, 80);
  font.draw(paper, 0, 20, "WWW");
  font.draw(paper, 0, 20 + font.line(), "WW");
  font.draw(paper, 4, 20 + 2 * font.line(), "\u00B0", "C");
  int16_t left, top;
  uint16_t width, height;
  out.getTextBounds(String("WW"), 0, 20, &left, &top, &width, &height);
  const bool is_bounded = left >= -1 && top > 0 && top + height >= 20 &&
                          width >= font.width("WW") - 2;
  return compare("GFXcanvas16", canvas.getBuffer(), pixels, 60 * 80) |
         !is_silent | !is_bounded;
}

// A font that follows a line feed moves the baseline, not the top of the line:
// its paper leaves the line before.
static int check_sizes() {
  GFXcanvas16 canvas(120, 120);
  InkcellPrint out(canvas);
  const Expected small(fonts::dejavu_sans_latin1, 12, false);
  const Expected large(fonts::dejavu_sans_latin1, 40, false);
  out.setTextColor(0xffff, 0x0000);
  out.setFont(fonts::dejavu_sans_latin1, 12);
  out.setCursor(0, small.ascent());
  out.println("gjpq");
  out.setFont(fonts::dejavu_sans_latin1, 40);
  out.setFont(fonts::dejavu_sans_latin1, 12);
  bool is_good = out.getCursorY() == small.ascent() + small.line();
  out.setFont(fonts::dejavu_sans_latin1, 40);
  out.write(0xc2);  // a character that never ends
  out.setFont(fonts::dejavu_sans_latin1, 40);
  out.println("A");
  out.setFont(fonts::dejavu_sans_latin1, 12);
  const int y = small.line() + large.line() + small.ascent();
  is_good = is_good && out.getCursorY() == y;
  out.setCursor(50, y);
  is_good = is_good && !out.setFont(fonts::dejavu_sans_latin1, 0) &&
            !out.setFont(fonts::dejavu_sans_latin1, -4) &&
            out.print("A") == 0 && !out.hasGlyphs("A") &&
            out.setFont(fonts::dejavu_sans_latin1, 12) &&
            out.getCursorY() == y && out.hasGlyphs("21.5 \u00B0C\n") &&
            !out.hasGlyphs("A\u20AC");
  static uint16_t pixels[120 * 120];
  const auto paper = inkcell::port::gfx_canvas16(pixels, 120, 120);
  small.draw(paper, 0, small.ascent(), "gjpq");
  large.draw(paper, 0, small.line() + large.ascent(), "A");
  return compare("sizes", canvas.getBuffer(), pixels, 120 * 120) | !is_good;
}

int main() {
  return check_example() | check_edges() | check_sizes();
}
