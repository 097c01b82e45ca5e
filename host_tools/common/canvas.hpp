// Draws text into pictures by the device's code: layout, strips, sinks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "counting_sink.hpp"
#include "image.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::tools {

/// A style for `px` px/em (rounded to 1/64) and an angle in degrees, counter-
/// clockwise. Throws std::runtime_error if one is out of range.
Style make_style(double px, double angle, const Filter& filter);

/// Whether styles with this angle are not upright. Throws as make_style().
bool is_turned(double angle);

/// A line of glyphs. [font units]
struct Line {
  std::vector<PositionedGlyph> glyphs;
  int32_t y = 0;  // of its baseline, up from that of the first line
};

enum class Kerning { none, font };

/// Lays out one line, with the advances of the style.
Line lay_out(const Font& font,
             std::string_view text,
             Kerning kerning,
             const Style& style);

/// The width of a text, and the alignment of its lines.
struct Wrapping {
  std::optional<Q26_6> width;  // none: lines end at line feeds [px]
  Align align = Align::start;
};

/// Lays out lines below each other; the library breaks, orders and aligns them.
/// Without kerning text runs from left to right, left-aligned.
std::vector<Line> lay_out_lines(const Font& font,
                                std::string_view text,
                                Kerning kerning,
                                const Style& style,
                                const Wrapping& wrapping = {});

/// The ink of lines relative to the origin of the first, turned by the style.
/// [px, y down] Without ink: the point at the origin.
struct InkBox {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
};
InkBox ink_box(const Font& font,
               const std::vector<Line>& lines,
               const Style& style);

/// Rows of a strip, by default.
inline constexpr int32_t kStripRows = 32;

/// The origins of lines, rounded to 1/64 px: the first at `origin`, the others
/// along the style's direction. Throws std::runtime_error if one is too far
/// from the first.
std::vector<Point> line_origins(const Font& font,
                                const std::vector<Line>& lines,
                                const Style& style,
                                Point origin);

/// Draws lines from their origins.
void draw_lines(const Font& font,
                const std::vector<Line>& lines,
                const std::vector<Point>& origins,
                const Style& style,
                const Sink& sink);

/// Draws lines over the picture (255: full ink; three channels: for each
/// sub-pixel) in strips of `rows` rows, from line_origins(). Adds to `stats` if
/// given. Throws std::runtime_error if a side of the picture is not in 1..32767
/// px.
void draw_lines(const Font& font,
                const std::vector<Line>& lines,
                const Style& style,
                Point origin,
                Image& image,
                DrawStats* stats = nullptr,
                int32_t rows = kStripRows);

/// Whether a font has glyphs of several colours.
bool has_layers(const Font& font);

/// The same with those, over a picture of three channels that shows its
/// background: other glyphs are drawn in `ink`, 0xRRGGBB.
void draw_colours(const Font& font,
                  const std::vector<Line>& lines,
                  const Style& style,
                  Point origin,
                  uint32_t ink,
                  Image& image);

/// A position in px, rounded to 1/64. Throws std::runtime_error if it is not
/// within +-16777215 px, so that the sum of two positions fits Q26_6.
Point make_point(double x, double y);

}  // namespace inkcell::tools
