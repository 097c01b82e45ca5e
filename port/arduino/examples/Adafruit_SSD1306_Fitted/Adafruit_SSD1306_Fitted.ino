// Small text on an OLED of 1 bit: fitted to the grid of pixels by itself.
#include <Adafruit_GFX.h>
#include <Adafruit_SSD1306.h>
#include <Inkcell.h>
#include <fonts/dejavu_sans_latin1.hpp>

Adafruit_SSD1306 oled(128, 64, &Wire, -1);
InkcellPrint text(oled);
int count = 0;

void setup() {
  oled.begin(SSD1306_SWITCHCAPVCC, 0x3C);
  oled.clearDisplay();
  text.setFont(fonts::dejavu_sans_latin1, 11);
  text.setTextColor(SSD1306_WHITE);  // on what is there
  text.setCursor(0, text.fontAscent());
  text.print(F("Pump 2 is running dry. Close the valve."));
  oled.display();
}

void loop() {
  text.setFont(fonts::dejavu_sans_latin1, 24);
  text.setTextColor(SSD1306_WHITE, SSD1306_BLACK);
  text.setCursor(0, 58);
  text.print(++count);
  oled.display();
  delay(1000);
}
