// Lays samples out in columns.
#include "sheet.hpp"

#include <algorithm>
#include <stdexcept>

#include "canvas.hpp"
#include "inkcell/painter.hpp"

namespace inkcell::tools {
namespace {

constexpr int kGap = 8;  // [px]
constexpr int kLabelHeight = 20;
constexpr double kLabelPx = 13;
constexpr uint32_t kPaper = 0xffffff;
constexpr uint32_t kLabel = 0x303030;

}  // namespace

Image colour_image(int width, int height, uint32_t colour) {
  Image image(width, height, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<uint8_t>(colour >> (16 - 8 * (i % 3)));
  }
  return image;
}

port::Rgb888Canvas canvas_of(Image& image, uint32_t colour) {
  Strip strip;
  strip.pixels = {image.pixels.data(), image.pixels.size()};
  strip.width = image.width;
  strip.height = image.height;
  strip.stride = 3 * image.width;
  port::Rgb888Canvas canvas(strip, colour);
  port::set_sub_pixels(canvas);
  if (image.channels != 3 || canvas.status() != Status::ok) {
    throw std::runtime_error("the picture is too large to draw into");
  }
  return canvas;
}

void write_text(const Font& font,
                const std::string& text,
                const Style& style,
                double x,
                double y,
                uint32_t colour,
                Image& image) {
  const port::Rgb888Canvas canvas = canvas_of(image, colour);
  const Line line = lay_out(font, text, Kerning::font, style);
  Painter(canvas).glyphs(font, style, make_point(x, y),
                         {line.glyphs.data(), line.glyphs.size()});
}

Sheet::Sheet(const Font& font,
             const std::string& sizes,
             const SheetLayout& layout)
    : font_(font), sizes_(sizes), layout_(layout) {}

Sheet::Sheet(const Font& font, double px, const SheetLayout& layout)
    : Sheet(font, std::to_string(static_cast<int>(px)), layout) {}

void Sheet::add(const std::string& label,
                uint32_t ground,
                const std::function<void(Image&)>& draw,
                int height) {
  Image sample = colour_image(layout_.width,
                              height != 0 ? height : layout_.height, ground);
  draw(sample);
  labels_.push_back(label);
  samples_.push_back(sample);
}

Image Sheet::finish() const {
  const int zoomed = layout_.zoomed_width * layout_.zoom;
  const int column = 2 * kGap + layout_.width + zoomed;
  const auto columns = static_cast<size_t>(layout_.columns);
  // Of rows, and the end of the last.
  std::vector<int> tops = {kGap + kLabelHeight};
  for (size_t i = 0; i < samples_.size(); i += columns) {
    int height = 0;
    for (size_t j = i; j < std::min(i + columns, samples_.size()); ++j) {
      height = std::max(height, samples_[j].height);
    }
    tops.push_back(tops.back() + kLabelHeight + height * layout_.zoom + kGap);
  }
  Image sheet =
      colour_image(kGap + layout_.columns * column, tops.back(), kPaper);
  const Style style = make_style(kLabelPx, 0, kFilterText);
  const Span<const char> name = font_.name();
  write_text(font_,
             std::string(name.data, name.size) + ", " + sizes_ +
                 " px, and enlarged " + std::to_string(layout_.zoom) + " times",
             style, kGap, kGap + kLabelPx, 0, sheet);
  for (size_t i = 0; i < samples_.size(); ++i) {
    const int x = kGap + static_cast<int>(i % columns) * column;
    const int y = tops[i / columns];
    write_text(font_, labels_[i], style, x, y + kLabelPx, kLabel, sheet);
    paste(samples_[i], x, y + kLabelHeight, sheet);
    const Rect enlarged = {layout_.zoomed_x, 0,
                           layout_.zoomed_x + layout_.zoomed_width,
                           samples_[i].height};
    paste(enlarge(cut(samples_[i], enlarged), layout_.zoom),
          x + layout_.width + kGap, y + kLabelHeight, sheet);
  }
  return sheet;
}

}  // namespace inkcell::tools
