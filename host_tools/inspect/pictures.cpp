// Draws fields, cell borders and sheets of glyphs.
#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "canvas.hpp"
#include "census.hpp"

namespace inkcell::tools {
namespace {

struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

// Strongest at the edge, fading away from it on both sides. Saturated areas are
// flat.
constexpr Colour kEdge = {24, 32, 48};
constexpr Colour kInsideNear = {222, 104, 66};
constexpr Colour kInsideFar = {252, 214, 164};
constexpr Colour kOutsideNear = {136, 176, 214};
constexpr Colour kOutsideFar = {238, 244, 250};
constexpr Colour kSaturated = {255, 255, 255};
constexpr Colour kBorder = {40, 52, 72};

// Distance over which the colours change. [u]
constexpr double kFade = 96;
// Colours go in steps: one sees them as lines of equal distance, and the file
// stays small.
constexpr double kBandStep = 8;
Colour mix(const Colour& a, const Colour& b, double share_of_b) {
  const double t = std::clamp(share_of_b, 0.0, 1.0);
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

void put(Image& image, int x, int y, const Colour& colour) {
  uint8_t* pixel = image.at(x, y);
  pixel[0] = static_cast<uint8_t>(std::lround(colour.red));
  pixel[1] = static_cast<uint8_t>(std::lround(colour.green));
  pixel[2] = static_cast<uint8_t>(std::lround(colour.blue));
}

Colour get(const Image& image, int x, int y) {
  const uint8_t* pixel = image.at(x, y);
  return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
          static_cast<double>(pixel[2])};
}

// The grid of a glyph on a picture.
struct View {
  const GlyphField& field;
  double px_per_u;
  int width;
  int height;

  int x_px(int x_u) const {
    return static_cast<int>(std::lround((x_u - field.x0_u) * px_per_u));
  }
  int y_px(int y_u) const {
    return static_cast<int>(std::lround((field.y1_u() - y_u) * px_per_u));
  }
  Q16_16 x_u(int px) const { return to_u(field.x0_u + (px + 0.5) / px_per_u); }
  Q16_16 y_u(int px) const {
    return to_u(field.y1_u() - (px + 0.5) / px_per_u);
  }

 private:
  static Q16_16 to_u(double u) {
    return Q16_16::from_raw(static_cast<int32_t>(std::floor(u * 65536)));
  }
};

Colour field_colour(double distance_u, bool saturated, double px_per_u) {
  Colour colour = kSaturated;
  const double band = std::floor(std::fabs(distance_u) / kBandStep) * kBandStep;
  if (distance_u > 0) {
    colour = mix(kInsideNear, kInsideFar, saturated ? 1 : band / kFade);
  } else if (!saturated) {
    colour = mix(kOutsideNear, kOutsideFar, band / kFade);
  }
  const double away_px = std::fabs(distance_u) * px_per_u;
  // The edge: a line 2 px wide.
  return mix(colour, kEdge, std::clamp(1.5 - away_px, 0.0, 1.0));
}

void draw_field_colours(const View& view, Image& image) {
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Q16_16 x_u = view.x_u(x);
      const Q16_16 y_u = view.y_u(y);
      const double distance = distance_at(view.field, x_u, y_u).raw / 1024.0;
      const Cell cell = locate(view.field, x_u.floor(), y_u.floor());
      put(image, x, y,
          field_colour(distance, cell.samples == nullptr, view.px_per_u));
    }
  }
}

// Left and lower border of a cell; its neighbours draw the others.
void draw_border(const View& view, const Cell& cell, Image& image) {
  const int size = 1 << cell.size_log2;
  const int left = view.x_px(cell.x0_u);
  const int right = view.x_px(cell.x0_u + size);
  const int top = view.y_px(cell.y0_u + size);
  const int bottom = view.y_px(cell.y0_u);
  // Small cells would become one dark mass.
  const double strength = std::clamp(0.10 * (right - left), 0.25, 0.62);
  const auto blend = [&](int x, int y) {
    put(image, x, y, mix(get(image, x, y), kBorder, strength));
  };
  for (int x = left; x <= right; ++x) {
    blend(x, bottom);
  }
  for (int y = top; y < bottom; ++y) {
    blend(left, y);
  }
}

// Top and right border of the whole grid.
void draw_frame(const View& view, Image& image) {
  for (int x = 0; x <= view.width; ++x) {
    put(image, x, 0, mix(get(image, x, 0), kBorder, 0.62));
  }
  for (int y = 0; y <= view.height; ++y) {
    put(image, view.width, y, mix(get(image, view.width, y), kBorder, 0.62));
  }
}

// Grey of the lines between the boxes of a sheet.
constexpr uint8_t kRule = 225;

}  // namespace

Image draw_cells(const GlyphField& field, int side) {
  if (field.tiles_x == 0 || field.tiles_y == 0) {
    throw std::runtime_error("the glyph has no ink, and so no cells");
  }
  const int width_u = field.x1_u() - field.x0_u;
  const int height_u = field.y1_u() - field.y0_u;
  const double px_per_u =
      static_cast<double>(side) / std::max(width_u, height_u);
  const View view = {field, px_per_u,
                     static_cast<int>(std::lround(width_u * px_per_u)),
                     static_cast<int>(std::lround(height_u * px_per_u))};
  Image image(view.width + 1, view.height + 1, 3, 255);
  draw_field_colours(view, image);
  for_each_cell(field,
                [&](const Cell& cell) { draw_border(view, cell, image); });
  draw_frame(view, image);
  return image;
}

Image draw_sheet(const Font& font, double px) {
  const FontMetrics metrics = font.metrics();
  const double scale = px / metrics.units_per_em;
  int32_t widest = 0;
  for (uint32_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    GlyphMetrics measures;
    if (font.glyph_metrics(static_cast<uint16_t>(glyph), measures) ==
        Status::ok) {
      widest = std::max({widest, measures.advance,
                         measures.x_max - std::min<int>(measures.x_min, 0)});
    }
  }
  const int box_width = static_cast<int>(std::ceil(widest * scale)) + 8;
  const int rise = static_cast<int>(
      std::ceil(std::max(metrics.ascender, metrics.y_max) * scale));
  const int drop = static_cast<int>(
      std::ceil(-std::min(metrics.descender, metrics.y_min) * scale));
  const int box_height = rise + drop + 8;
  const int count = font.glyph_count();
  // About 3:2.
  const int columns = std::clamp(
      static_cast<int>(std::sqrt(1.5 * count * box_height / box_width)), 1,
      count);
  const int rows = (count + columns - 1) / columns;

  Image image(columns * box_width + 1, rows * box_height + 1);
  const Brush brush = make_brush(px, 0, kFilterText);
  for (int i = 0; i < count; ++i) {
    GlyphMetrics measures;
    static_cast<void>(font.glyph_metrics(static_cast<uint16_t>(i), measures));
    Image box(box_width, box_height);
    Line line;
    line.glyphs.push_back({0, 0, static_cast<uint16_t>(i)});
    const double slack = box_width - measures.advance * scale;
    draw_lines(font, {line}, brush, make_point(slack / 2, rise + 4), box);
    const int x0 = i % columns * box_width;
    const int y0 = i / columns * box_height;
    for (int y = 0; y < box_height; ++y) {
      std::copy_n(box.at(0, y), box_width, image.at(x0, y0 + y));
    }
  }
  invert(image);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (x % box_width == 0 || y % box_height == 0) {
        *image.at(x, y) = std::min(*image.at(x, y), kRule);
      }
    }
  }
  return image;
}

}  // namespace inkcell::tools
