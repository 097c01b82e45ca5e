// Two sizes on an OLED of 1 bit in 24 KB of flash, with Adafruit's libraries: the
// fonts beside this sketch are pictures of letters at one size. Others are made by
//
//   inkcell-fontgen --font DejaVuSans.ttf \
//       --chars 0x20-0x7E,0xB0,0xC4,0xD6,0xDC,0xDF,0xE4,0xF6,0xFC \
//       --strike 11:1 --strike-only --name sans_11 --out sans_11.h
//   inkcell-fontgen --font DejaVuSans.ttf --chars 0x20,0x2B-0x3A,0xB0 \
//       --strike 24:1 --strike-only --name digits_24 --out digits_24.h
#include <Adafruit_GFX.h>
#include <Adafruit_SSD1306.h>
#include <Inkcell.h>

#include "digits_24.h"
#include "sans_11.h"

Adafruit_SSD1306 oled(128, 64, &Wire, -1);
InkcellPrint text(oled);
int count = 0;

void setup() {
  oled.begin(SSD1306_SWITCHCAPVCC, 0x3C);
  oled.clearDisplay();
  text.setStrikes(fonts::sans_11, 11);
  text.setTextColor(SSD1306_WHITE);  // on what is there
  text.setCursor(0, text.fontAscent());
  text.print(F("Pump 2 is running dry. Close the valve."));
  oled.display();
}

void loop() {
  text.setStrikes(fonts::digits_24, 24);
  text.setTextColor(SSD1306_WHITE, SSD1306_BLACK);
  text.setCursor(0, 58);
  text.print(++count);
  oled.display();
  delay(1000);
}
