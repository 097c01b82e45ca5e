// Draws a test pattern.
#include "star.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "canvas.hpp"
#include "field/sample_tree.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/supersample.hpp"
#include "peers.hpp"
#include "rom/rom_font.hpp"
#include "shape/outline.hpp"
#include "shape/shape.hpp"
#include "sheet.hpp"

namespace inkcell::tools {
namespace {

constexpr int kSide = 128;  // [px], an em
constexpr int kWedges = 36;
constexpr int kMiddle = 42;  // px that are enlarged
constexpr int kZoom = 3;
constexpr int kSpace = 8;
constexpr int kCaptionHeight = 14;
constexpr double kUnits = 1024.0 / kSide;  // to a px
constexpr double kPi = 3.14159265358979323846;

using Wedge = std::array<gen::Point, 4>;

std::vector<Wedge> star() {
  constexpr double kCentre = 512;
  constexpr double kInner = 4;
  constexpr double kOuter = 490;
  std::vector<Wedge> wedges;
  for (int i = 0; i < kWedges; ++i) {
    const auto point = [i](double radius, double side) {
      const double angle = 2 * kPi * (i + side) / kWedges;
      return gen::Point{kCentre + radius * std::cos(angle),
                        kCentre + radius * std::sin(angle)};
    };
    wedges.push_back({point(kInner, -0.25), point(kOuter, -0.25),
                      point(kOuter, 0.25), point(kInner, 0.25)});
  }
  return wedges;
}

gen::Shape shape_of(const std::vector<Wedge>& wedges) {
  gen::Outline outline;
  for (const Wedge& corners : wedges) {
    gen::Contour contour;
    for (size_t i = 0; i < corners.size(); ++i) {
      contour.segments.push_back(
          {gen::Segment::Kind::line,
           {corners[i], corners[(i + 1) % corners.size()], {}, {}}});
    }
    outline.contours.push_back(contour);
  }
  return gen::Shape(outline);
}

// The exact coverage.
Image cover(const std::vector<Wedge>& wedges) {
  std::vector<std::vector<PeerCorner>> polygons;
  for (const Wedge& corners : wedges) {
    polygons.emplace_back();
    for (const gen::Point& corner : corners) {
      polygons.back().push_back({corner.x / kUnits, kSide - corner.y / kUnits});
    }
  }
  return fill_polygons(polygons, kSide, kSide);
}

enum class Jitter { none, whole };

// The exact pattern, with `scale` x `scale` samples a pixel weighed by w(x, y),
// each in the middle of its square or at a random place in it.
Image supersample(const gen::Shape& shape,
                  int scale,
                  Jitter jitter,
                  double (*weight)(double, double)) {
  // All samples; those around the picture belong to pixels at its border.
  const int side = (kSide + 2) * scale;
  std::vector<gen::Point> places;
  std::vector<char> inside;
  std::minstd_rand random;
  const auto place = [&] {
    return jitter == Jitter::none
               ? 0.5
               : static_cast<double>(random() - std::minstd_rand::min()) /
                     (std::minstd_rand::max() - std::minstd_rand::min());
  };
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      const double x = (u + place()) / scale - 1;
      const double y = (v + place()) / scale - 1;
      places.push_back({x, y});
      inside.push_back(shape.inside(x * kUnits, (kSide - y) * kUnits) ? 1 : 0);
    }
  }
  Image image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      double sum = 0;
      double all = 0;
      for (int v = y * scale; v < (y + 3) * scale; ++v) {
        for (int u = x * scale; u < (x + 3) * scale; ++u) {
          const auto i = static_cast<size_t>(v * side + u);
          const double w = weight(places[i].x - x - 0.5, places[i].y - y - 0.5);
          all += w;
          sum += inside[i] != 0 ? w : 0;
        }
      }
      *image.at(x, y) = static_cast<uint8_t>(std::lround(255 * sum / all));
    }
  }
  return image;
}

// What the device draws, from a field, as the paper's are.
class DeviceStar {
 public:
  explicit DeviceStar(const gen::Shape& shape) {
    gen::Target options;
    options.min_px = kSide;
    options.max_px = kSide;
    gen::RomGlyph glyph;
    glyph.field = gen::build_sample_tree(shape, options);
    record_ = gen::glyph_record(glyph);
    if (GlyphField::open({record_.data(), record_.size()}, field_) !=
        Status::ok) {
      throw std::runtime_error("the pattern does not open");
    }
  }

  // `effect` may be null.
  Image draw(const Effect* effect) const {
    Image image = colour_image(kSide, kSide, 0);
    const port::Rgb888Canvas canvas = canvas_of(image, 0xffffff);
    Style style = make_style(kSide, 0, kFilterText);
    if (effect != nullptr) {
      style.set_effect(*effect);
    }
    draw_field(field_, style, make_point(0, kSide), canvas);
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
  constexpr int kFirst = (kSide - kMiddle) / 2;
  constexpr int kEnd = kFirst + kMiddle;
  return enlarge(cut(image, {kFirst, kFirst, kEnd, kEnd}), kZoom);
}

}  // namespace

Image draw_star(const Font& font) {
  const std::vector<Wedge> wedges = star();
  const gen::Shape shape = shape_of(wedges);
  const DeviceStar device(shape);
  const CircleSamples even(kFilterText, kCalmRadius);
  const CircleSamples paper(kFilterText, kPaperRadius, SampleRule::paper);
  std::vector<uint32_t> sums(kSide * kSide);
  const Splat splat(Span<uint32_t>(sums.data(), sums.size()));
  struct Entry {
    const char* label;
    Image image;
  };
  const Entry entries[] = {
      {"4 samples, box",
       in_colour(supersample(shape, 2, Jitter::none, box_weight))},
      {"16, Gaussian",
       in_colour(supersample(shape, 4, Jitter::none, gaussian_weight))},
      {"16, jittered, Gaussian",
       in_colour(supersample(shape, 4, Jitter::whole, gaussian_weight))},
      {"FreeType", in_colour(cover(wedges))},
      {"Inkcell, one sample", device.draw(nullptr)},
      {"Inkcell, up to 13, even", device.draw(&even)},
      {"Inkcell, up to 13, paper", device.draw(&paper)},
      {"Inkcell, splats", device.draw(&splat)}};
  // Two rows of columns, each a picture and its middle.
  constexpr int kColumns = 4;
  constexpr int kColumn = kSide + kSpace;
  constexpr int kRow = kCaptionHeight + kSide + kZoom * kMiddle + 3 * kSpace;
  Image sheet = colour_image(kSpace + kColumns * kColumn, 2 * kRow, 0xffffff);
  const Style style = make_style(10, 0, kFilterText);
  int column = 0;
  int y = kSpace;
  for (const Entry& entry : entries) {
    const int x = kSpace + column * kColumn;
    write_text(font, entry.label, style, x, y + 10, 0x404040, sheet);
    paste(entry.image, x, y + kCaptionHeight, sheet);
    paste(middle_of(entry.image), x, y + kSpace + kCaptionHeight + kSide,
          sheet);
    column = (column + 1) % kColumns;
    y += column == 0 ? kRow : 0;
  }
  return sheet;
}

}  // namespace inkcell::tools
