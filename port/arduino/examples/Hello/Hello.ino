// Draws a line of text into RAM, as RGB565, and prints how many pixels have
// ink. Send `pixels` to your display in place of counting.
#include <Inkcell.h>
#include <fonts/dejavu_sans_digits.hpp>

constexpr int32_t kWidth = 120;
constexpr int32_t kHeight = 32;
alignas(2) static uint8_t pixels[2 * kWidth * kHeight];

using namespace inkcell::literals;
constexpr inkcell::Style kStyle = inkcell::Style(24_px);

inkcell::Status draw_clock(const char* text) {
  inkcell::Font font;
  INKCELL_TRY(inkcell::Font::open(fonts::dejavu_sans_digits, font));
  inkcell::Strip strip;
  strip.pixels = pixels;
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = 2 * kWidth;
  inkcell::port::Rgb565Canvas canvas(strip, 0xffff, 0x0000);  // white on black
  inkcell::Painter painter(canvas);
  painter.text(font, kStyle, {4, 25}, text);
  return canvas.status();
}

void setup() {
  Serial.begin(115200);
}

void loop() {
  if (draw_clock("12:34") != inkcell::Status::ok) {
    Serial.println("the font cannot be drawn");
    return;
  }
  int inked = 0;
  for (int32_t i = 0; i < kWidth * kHeight; ++i) {
    inked += pixels[2 * i] != 0 || pixels[2 * i + 1] != 0;
  }
  Serial.println(inked);
  delay(1000);
}
