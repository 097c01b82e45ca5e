// A value on a panel of TFT_eSPI, which changes without flicker.
#include <Arduino.h>
#include <InkcellPrint.h>
#include <TFT_eSPI.h>
#include <fonts/dejavu_sans_latin1.hpp>

TFT_eSPI tft;
InkcellPrint text(tft);

void setup() {
  tft.init();
  tft.fillScreen(TFT_NAVY);
  text.setTextColor(TFT_WHITE, TFT_NAVY);
}

void loop() {
  text.setFont(fonts::dejavu_sans_latin1, 48);
  text.setCursor(16, 100);
  text.print(millis() / 1000.0, 1);
  text.print(" s ");
  delay(100);
}
