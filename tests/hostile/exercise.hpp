// Everything that can be asked of a font, asked of bytes that may be hostile.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/text.hpp"

namespace hostile {

struct Outcome {
  bool opened = false;
  bool verified = false;
};

/// Opens `rom` and, if that succeeds, uses the font in every way. Ends the
/// program when a promise is broken: a pixel outside its window, out of order
/// or in too long a span, a picture that depends on strips, a metric that
/// cannot be.
Outcome exercise(inkcell::Span<const uint8_t> rom);

/// The same of a font that is open, whatever became of its bytes meanwhile.
void use(const inkcell::Font& font);

/// From here on bytes of fonts may differ from load to load: pictures need no
/// longer agree, nor show a pixel only once. All else must hold.
void expect_changing_bytes();

/// Draws a glyph in small windows about (0, 0), whole and in strips, and asks
/// for distances.
void draw_checked(const inkcell::Font& font,
                  uint16_t glyph,
                  const inkcell::TextStyle& style,
                  inkcell::Point origin);

/// Lays out, measures and draws a line, whole and row by row. At most 64 bytes.
void use_text(const inkcell::Font& font,
              inkcell::Text text,
              const inkcell::TextStyle& style,
              inkcell::Point origin);

/// Ends the program unless `condition` holds.
void require(bool condition, const char* what);

}  // namespace hostile
