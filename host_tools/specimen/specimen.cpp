// Composes specimen pictures out of lines of text.
#include "specimen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "canvas.hpp"

namespace inkcell::tools {
namespace {

constexpr int kMargin = 12;  // [px]

constexpr const char* kPangram = "Sphinx of black quartz, judge my vow";

// Three sentences of typical text, with line breaks made by hand.
constexpr const char* kParagraph =
    "A font file goes in; at build time each glyph becomes a\n"
    "field of signed distances, sampled finely at corners and\n"
    "coarsely along stems. The device reads it from ROM and\n"
    "draws any size (8, 9.5, 12 px ...) at any position, without\n"
    "a heap: \"To AV, Wa 1/64 px & 99.7 %\".";

// Draws text with its origin at (x, y). [px]
void put(const Font& font,
         const std::string& text,
         double px,
         double angle,
         double x,
         double y,
         Image& image) {
  const Style style = make_style(px, angle, kFilterText);
  draw_lines(font, lay_out_lines(font, text, Kerning::font, style), style,
             make_point(x, y), image);
}

struct FontHeights {
  double ascent = 0;  // [em]
  double line = 0;
};

FontHeights heights(const Font& font) {
  const FontMetrics metrics = font.metrics();
  const double em = metrics.units_per_em;
  return {metrics.ascender / em,
          (metrics.ascender - metrics.descender + metrics.line_gap) / em};
}

double width_of(const Font& font, const std::string& text, double px) {
  const TextMeasure size = measure(font, Text(text.data(), text.size()));
  return size.advance * px / font.units_per_em();
}

// A word every 15 degrees, its origin `radius` px from (x, y). Lines do not
// touch if the radius is at least 4 times their size.
void draw_fan(const Font& font,
              const std::string& word,
              double px,
              double x,
              double y,
              double radius,
              Image& image) {
  constexpr double kRadians = 3.14159265358979323846 / 180;
  // The baseline is a third of the x-height below the ray, so that the word's
  // middle points to the centre.
  const double drop = 0.17 * px;
  for (int angle = 0; angle < 360; angle += 15) {
    const double cosine = std::cos(angle * kRadians);
    const double sine = std::sin(angle * kRadians);
    put(font, word, px, angle, x + radius * cosine + drop * sine,
        y - radius * sine + drop * cosine, image);
  }
}

}  // namespace

Image draw_sizes(const Font& font, int width) {
  constexpr std::array<double, 10> kSizes = {8,  9.5, 11, 13, 16,
                                             20, 26,  34, 45, 60};
  const std::string text = "One font, every size";
  const FontHeights em = heights(font);
  double height = 2 * kMargin;
  for (const double px : kSizes) {
    height += px * em.line;
  }
  Image image(width, static_cast<int>(std::ceil(height)));
  double y = kMargin;
  for (const double px : kSizes) {
    const double baseline = y + px * em.ascent;
    put(font, text, px, 0, kMargin, baseline, image);
    const int tenths = static_cast<int>(10 * px);
    const std::string half = tenths % 10 == 0 ? " px" : ".5 px";
    put(font, std::to_string(tenths / 10) + half, 10, 0,
        2 * kMargin + width_of(font, text, px), baseline, image);
    y += px * em.line;
  }
  // The fan is in the upper right corner, where the lines are short.
  constexpr double kFanPx = 17;
  constexpr double kRadius = 62;
  const double reach = kRadius + width_of(font, "inkcell", kFanPx) + kMargin;
  draw_fan(font, "inkcell", kFanPx, width - reach, reach, kRadius, image);
  invert(image);
  return image;
}

Image draw_body(const Font& font) {
  constexpr std::array<double, 3> kSizes = {11, 13, 16};
  const FontHeights em = heights(font);
  constexpr int kLines = 5;
  double height = kMargin;
  for (const double px : kSizes) {
    height += kLines * px * em.line + kMargin;
  }
  const double width =
      width_of(font,
               "draws any size (8, 9.5, 12 px ...) at any position, "
               "without",
               kSizes.back());
  Image image(static_cast<int>(width) + 2 * kMargin,
              static_cast<int>(std::ceil(height)));
  double y = kMargin;
  for (const double px : kSizes) {
    put(font, kParagraph, px, 0, kMargin, y + px * em.ascent, image);
    y += kLines * px * em.line + kMargin;
  }
  invert(image);
  return image;
}

Image draw_digits(const Font& font) {
  constexpr double kLarge = 160;
  constexpr double kSmall = 48;
  const FontHeights em = heights(font);
  const double width = std::max(width_of(font, "10:42", kLarge),
                                width_of(font, "0123456789", kSmall));
  Image image(static_cast<int>(width) + 2 * kMargin,
              static_cast<int>((kLarge + kSmall) * em.line));
  put(font, "10:42", kLarge, 0, kMargin, kLarge * em.ascent, image);
  put(font, "0123456789", kSmall, 0, kMargin,
      kLarge * em.line + kSmall * em.ascent * 0.9, image);
  invert(image);
  return image;
}

Image draw_turned(const Font& font) {
  constexpr double kRadius = 88;
  constexpr double kPx = 24;
  const double side = 2 * (kRadius + width_of(font, "distance", kPx) + kMargin);
  Image image(static_cast<int>(side), static_cast<int>(side));
  draw_fan(font, "distance", kPx, side / 2, side / 2, kRadius, image);
  invert(image);
  return image;
}

Image draw_moved(const Font& font) {
  constexpr double kPx = 14;
  constexpr int kRows = 9;
  const FontHeights em = heights(font);
  Image image(static_cast<int>(width_of(font, kPangram, kPx)) + 2 * kMargin,
              static_cast<int>(kRows * std::ceil(kPx * em.line)) + 2 * kMargin);
  for (int row = 0; row < kRows; ++row) {
    put(font, kPangram, kPx, 0, kMargin + row / 8.0,
        kMargin + row * std::ceil(kPx * em.line) + std::ceil(kPx * em.ascent),
        image);
  }
  invert(image);
  return image;
}

}  // namespace inkcell::tools
