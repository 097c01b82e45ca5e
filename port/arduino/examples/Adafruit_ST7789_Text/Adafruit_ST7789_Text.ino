// A paragraph, a line that ends at the right edge, and text over a picture, on
// a panel of Adafruit_GFX.
#include <Adafruit_GFX.h>
#include <Adafruit_ST7789.h>
#include <Inkcell.h>
#include <fonts/dejavu_sans_latin1.hpp>

Adafruit_ST7789 tft(10, 9, 8);  // CS, DC, RST
InkcellPrint text(tft);
GFXcanvas16 picture(100, 40);

void setup() {
  tft.init(240, 240);
  tft.fillScreen(0xffff);

  text.setFont(fonts::dejavu_sans_latin1, 18);
  text.setTextColor(0x0000, 0xffff);
  text.setCursor(0, text.fontAscent());
  text.println("Lines end between words, as they do on paper.");
  text.print(String("Pressure: "));
  text.println(1013);

  const char* const right = "12:34";
  text.setFont(fonts::dejavu_sans_latin1, 40.5);
  text.setTextColor(0xf800, 0xffff);
  text.setCursor(240 - text.textWidth(right), 160);
  text.print(right);

  picture.fillScreen(
      0x07e0);  // without a paper, text is drawn on what is there
  InkcellPrint over(picture);
  over.setFont(fonts::dejavu_sans_latin1, 28);
  over.setTextColor(0x001f);
  over.setCursor(4, 30);
  over.print("Over");
  tft.drawRGBBitmap(8, 190, picture.getBuffer(), 100, 40);
}

void loop() {}
