// Calls all functions of a font with hostile bytes.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/text.hpp"

namespace hostile {

struct Outcome {
  bool opened = false;
  bool verified = false;
};

/// Opens `rom` and, if that succeeds, calls every function of the font. Ends
/// the program if a promise is broken: a pixel outside its window, out of order
/// or in too long a span, a picture that depends on strips, an impossible
/// metric.
Outcome exercise(inkcell::Span<const uint8_t> rom);

/// The same for an open font, whatever its bytes have become.
void use(const inkcell::Font& font);

/// From now on bytes of fonts may differ from load to load: pictures may
/// differ, and pixels may repeat. All other promises must hold.
void expect_changing_bytes();
bool bytes_may_change();

/// Draws a glyph in small windows about (0, 0), whole and in strips, and looks
/// up distances.
void draw_checked(const inkcell::Font& font,
                  uint16_t glyph,
                  const inkcell::Style& style,
                  inkcell::Point origin);

/// Lays out, measures and draws a line, whole and row by row. At most 64 bytes.
void use_text(const inkcell::Font& font,
              inkcell::Text text,
              const inkcell::Style& style,
              inkcell::Point origin);

/// Ends the program unless `condition` holds.
void require(bool condition, const char* what);

}  // namespace hostile
