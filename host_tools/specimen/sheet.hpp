// A list of labelled samples, each in its size and enlarged beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "image.hpp"
#include "inkcell/font.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/style.hpp"

namespace inkcell::tools {

/// The layout of all samples of a sheet.
struct SheetLayout {
  int width = 0;  // of a sample [px]
  int height = 0;
  int zoom = 0;          // of its enlarged part
  int zoomed_x = 0;      // which begins here
  int zoomed_width = 0;  // and is so wide [px]
  int columns = 1;       // of samples; they go from left to right
};

class Sheet {
 public:
  /// The title names the font, the sizes [px] and the zoom. It and the labels
  /// are written in `font`, which must outlive the sheet.
  Sheet(const Font& font, const std::string& sizes, const SheetLayout& layout);
  Sheet(const Font& font, double px, const SheetLayout& layout);

  /// Adds a sample: `draw` gets a picture of three channels, filled with
  /// `ground` (0xRRGGBB), `height` px high unless that is 0.
  void add(const std::string& label,
           uint32_t ground,
           const std::function<void(Image&)>& draw,
           int height = 0);

  Image finish() const;

 private:
  const Font& font_;
  std::string sizes_;
  SheetLayout layout_;
  std::vector<std::string> labels_;
  std::vector<Image> samples_;
};

/// A picture of three channels, full of `colour`.
Image colour_image(int width, int height, uint32_t colour);

/// Draws in colour, with sub-pixels, on a picture of three channels.
port::Rgb888Canvas canvas_of(Image& image, uint32_t colour);

/// Draws text over a picture of three channels, its origin at (x, y). [px]
void write_text(const Font& font,
                const std::string& text,
                const Style& style,
                double x,
                double y,
                uint32_t colour,
                Image& image);

}  // namespace inkcell::tools
