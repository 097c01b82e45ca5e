// What a sketch should have drawn, by the painter and a canvas of the whole
// screen, and the comparison.
#pragma once

#include <Inkcell.h>
#include <stdio.h>

// Text fitted as InkcellPrint fits it.
struct Expected {
  Expected(inkcell::Span<const uint8_t> rom, double size, bool is_mono)
      : style(inkcell::Q26_6::from_raw(static_cast<int32_t>(size * 64))) {
    is_good = inkcell::Font::open(rom, font) == inkcell::Status::ok;
    inkcell::FitOptions options;
    options.across = is_mono || size < 12;
    options.levels = is_mono ? 2 : 0;
    is_good = is_good && inkcell::Fit::make(font, style, options, fit) ==
                             inkcell::Status::ok;
    style.set_fit(fit);
  }
  void draw(const inkcell::Sink& sink,
            int x,
            int y,
            const char* text,
            const char* printed_after = "") const {
    const inkcell::Painter painter(sink);
    painter.text(font, style, {x, y}, text);
    inkcell::Point next = {x, y};
    next.x.raw += painter.measure(font, style, text).advance.raw;
    painter.text(font, style, next, printed_after);
  }
  int width(const char* text) const {
    inkcell::Painter painter;
    return (painter.measure(font, style, text).advance.raw + 63) / 64;
  }
  int line() const { return inkcell::line_height({font, style}).floor(); }
  int ascent() const { return inkcell::baseline({font, style}).floor(); }

  inkcell::Font font;
  inkcell::Style style;
  inkcell::Fit fit;
  bool is_good;
};

// 0 if two pictures are equal and show something, else 1.
template <typename Pixel>
int compare(const char* name,
            const Pixel* found,
            const Pixel* wanted,
            int count) {
  int others = 0;
  int inked = 0;
  for (int i = 0; i < count; ++i) {
    others += found[i] != wanted[i];
    inked += wanted[i] != wanted[0];
  }
  printf("%s: %d of %d pixels with ink, %d differ\n", name, inked, count,
         others);
  return others == 0 && inked > 100 ? 0 : 1;
}
