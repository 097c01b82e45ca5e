// A label, and a value that changes without flicker, on a panel of TFT_eSPI.
#include <Inkcell.h>
#include <TFT_eSPI.h>
#include <fonts/dejavu_sans_latin1.hpp>

TFT_eSPI tft;
InkcellPrint text(tft);
float temperature = 21.5f;
int end = 0;  // of the value that is shown

void setup() {
  tft.init();
  tft.fillScreen(TFT_NAVY);
  text.setTextColor(TFT_WHITE, TFT_NAVY);       // ink, paper
  text.setFont(fonts::dejavu_sans_latin1, 24);  // px
  text.setCursor(16, 48);                       // left end of the baseline
  text.print("Living room");
}

void loop() {
  text.setFont(fonts::dejavu_sans_latin1, 48);
  text.setCursor(16, 150);
  text.print(temperature, 1);  // its paper replaces the old value
  text.print(" \u00B0C ");
  const int x = text.getCursorX();
  if (x < end) {  // which was longer
    tft.fillRect(x, 150 - text.fontAscent(), end - x, text.fontHeight(),
                 TFT_NAVY);
  }
  end = x;
  temperature -= 0.4f;
  delay(1000);
}
