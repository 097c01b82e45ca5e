// Draws a pattern that no font has.
#include "star.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "adf.hpp"
#include "canvas.hpp"
#include "inkcell/adaptive.hpp"
#include "inkcell/render.hpp"
#include "inkcell/splat.hpp"
#include "outline.hpp"
#include "rom_font.hpp"
#include "shape.hpp"
#include "sheet.hpp"

namespace inkcell::tools {
namespace {

constexpr int kSide = 128;  // [px], an em
constexpr int kWedges = 36;
constexpr int kMiddle = 42;  // px that are enlarged
constexpr int kZoom = 3;
constexpr int kGap = 8;
constexpr int kLabelHeight = 14;
constexpr double kPi = 3.14159265358979323846;

gen::Shape star() {
  constexpr double kCentre = 512;
  constexpr double kInner = 4;
  constexpr double kOuter = 490;
  gen::Outline outline;
  for (int i = 0; i < kWedges; ++i) {
    const auto point = [i](double radius, double side) {
      const double angle = 2 * kPi * (i + side) / kWedges;
      return gen::Point{kCentre + radius * std::cos(angle),
                        kCentre + radius * std::sin(angle)};
    };
    const gen::Point corners[] = {point(kInner, -0.25), point(kOuter, -0.25),
                                  point(kOuter, 0.25), point(kInner, 0.25)};
    gen::Contour contour;
    for (int j = 0; j < 4; ++j) {
      contour.segments.push_back({gen::Segment::Kind::line,
                                  {corners[j], corners[(j + 1) % 4], {}, {}}});
    }
    outline.contours.push_back(contour);
  }
  return gen::Shape(outline);
}

// The exact pattern, `scale` x `scale` samples to a pixel weighed by w(x, y).
Image supersample(const gen::Shape& shape,
                  int scale,
                  const std::function<double(double, double)>& weight) {
  constexpr double kUnits = 1024.0 / kSide;
  Image image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      double sum = 0;
      double all = 0;
      for (int v = -scale; v < 2 * scale; ++v) {
        for (int u = -scale; u < 2 * scale; ++u) {
          const double right = (u + 0.5) / scale;
          const double down = (v + 0.5) / scale;
          const double w = weight(right - 0.5, down - 0.5);
          const bool is_inside =
              w > 0 &&
              shape.inside((x + right) * kUnits, (kSide - y - down) * kUnits);
          all += w;
          sum += is_inside ? w : 0;
        }
      }
      *image.at(x, y) = static_cast<uint8_t>(std::lround(255 * sum / all));
    }
  }
  return image;
}

// What the device draws, from cells of samples, as the paper's are.
class DeviceStar {
 public:
  explicit DeviceStar(const gen::Shape& shape) {
    gen::AdfOptions options;
    options.min_px = kSide;
    options.max_px = kSide;
    gen::RomGlyph glyph;
    glyph.samples = gen::build_adf(shape, options);
    record_ = gen::glyph_record(glyph, gen::Coding::direct);
    if (GlyphField::open({record_.data(), record_.size()}, field_) !=
        Status::ok) {
      throw std::runtime_error("the pattern does not open");
    }
  }

  Image draw(Painter painter, const void* options, uint8_t reach_px) const {
    Image image = colour_image(kSide, kSide, 0);
    const ColourSink target(image, 0xffffff);
    Brush brush = make_brush(kSide, 0, kFilterText);
    brush.set_painter(painter, options, reach_px);
    draw_field(field_, brush, make_point(0, kSide), target.sink());
    return image;
  }

 private:
  std::vector<uint8_t> record_;  // from new: aligned to more than 2
  GlyphField field_;
};

Image in_colour(const Image& grey) {
  Image image(grey.width, grey.height, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = grey.pixels[i / 3];
  }
  return image;
}

Image middle_of(const Image& image) {
  Image part(kMiddle, kMiddle, 3);
  const int first = (kSide - kMiddle) / 2;
  for (int y = 0; y < kMiddle; ++y) {
    const uint8_t* line = image.at(first, first + y);
    std::copy(line, line + 3 * kMiddle, part.at(0, y));
  }
  return enlarge(part, kZoom);
}

}  // namespace

Image draw_star(const Font& font) {
  const gen::Shape shape = star();
  const DeviceStar device(shape);
  const Adaptive even = make_adaptive(kFilterText, kCalmRadius);
  const Adaptive paper =
      make_adaptive(kFilterText, kPaperRadius, SampleRule::paper);
  std::vector<uint32_t> sums(kSide * kSide);
  Splats splats;
  if (make_splats({sums.data(), sums.size()}, kSplatRadius, splats) !=
      Status::ok) {
    throw std::runtime_error("splats are not to be had");
  }
  struct Entry {
    std::string label;
    Image image;
  };
  const Entry entries[] = {
      {"4 samples, box",
       in_colour(supersample(shape, 2,
                             [](double x, double y) {
                               return std::fabs(x) < 0.5 && std::fabs(y) < 0.5
                                          ? 1.0
                                          : 0.0;
                             }))},
      {"16 samples, Gaussian",
       in_colour(supersample(shape, 4,
                             [](double x, double y) {
                               const double square = x * x + y * y;
                               return square <= 1 ? std::exp2(-3 * square) : 0;
                             }))},
      {"Inkcell, one sample", device.draw(nullptr, nullptr, 0)},
      {"Inkcell, up to 13, even",
       device.draw(paint_adaptive, &even, kAdaptiveReach)},
      {"Inkcell, up to 13, paper",
       device.draw(paint_adaptive, &paper, kAdaptiveReach)},
      {"Inkcell, splats", device.draw(paint_splats, &splats, kSplatReach)}};
  constexpr int kColumn = kSide + kGap;
  constexpr int kHeight = kLabelHeight + kSide + kZoom * kMiddle + 3 * kGap;
  Image sheet = colour_image(kGap + 6 * kColumn, kHeight, 0xffffff);
  const Brush brush = make_brush(10, 0, kFilterText);
  int x = kGap;
  for (const Entry& entry : entries) {
    write_text(font, entry.label, brush, x, kGap + 10, 0x404040, sheet);
    paste(entry.image, x, kGap + kLabelHeight, sheet);
    paste(middle_of(entry.image), x, 2 * kGap + kLabelHeight + kSide, sheet);
    x += kColumn;
  }
  return sheet;
}

}  // namespace inkcell::tools
