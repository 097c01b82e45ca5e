// Draws fields, cell borders and sheets of glyphs.
#include "pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bytes.hpp"
#include "canvas.hpp"
#include "census.hpp"
#include "inkcell/format.hpp"

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
// Borders of saturated cells, and the others by the number of their fields; 0:
// samples.
constexpr Colour kSaturatedBorder = {196, 204, 214};
constexpr std::array<Colour, 4> kBorders = {
    {{40, 52, 72}, {38, 132, 72}, {70, 58, 190}, {196, 24, 96}}};
// Where one field of a cell is zero.
constexpr Colour kZeroLine = {112, 40, 120};
// What grid fitting knows.
constexpr Colour kZone = {90, 96, 104};
constexpr Colour kBar = {208, 0, 24};
constexpr Colour kOtherEdge = {150, 0, 190};
constexpr Colour kStem = {0, 120, 40};
constexpr int kDash = 6;  // and the gap to the next one [px]

// Distance over which the colours change. [u]
constexpr double kFade = 96;
// Colours go in steps: one sees them as lines of equal distance, and the file
// stays small.
constexpr double kBandStep = 8;

// A point of the glyph. [u]
struct Vector {
  double x = 0;
  double y = 0;
};

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

int read_i16(const uint8_t* at) {
  return static_cast<int16_t>(read_u16(at));
}

// One field of a cell as docs/FORMAT.md states it, in real numbers. [u]
double field_value(const GlyphField& field, uint16_t unit, Vector p) {
  namespace fields = format::fields;
  const uint8_t* at = field.cells + 2 * (unit & format::linked::kOffsetMask);
  const double nx = read_i16(at + fields::kNormalX) / 16384.0;
  const double ny = read_i16(at + fields::kNormalY) / 16384.0;
  const double plane =
      nx * p.x + ny * p.y + read_i16(at + fields::kOffset) / 16.0;
  if ((unit & format::linked::kArcField) == 0) {
    return plane;
  }
  const double along =
      nx * p.y - ny * p.x + read_i16(at + fields::kAlong) / 16.0;
  return plane + read_i16(at + fields::kBend) / 524288.0 * along * along;
}

// How much of a pixel lies on the lines, 1 px wide, where one of several fields
// is zero.
double zero_line(const View& view, const Cell& cell, Vector p) {
  double strength = 0;
  for (int i = 0; cell.field_count > 1 && i < cell.field_count; ++i) {
    const double away_px =
        std::fabs(field_value(view.field, cell.fields[i], p)) * view.px_per_u;
    strength = std::max(strength, std::clamp(1 - away_px, 0.0, 1.0));
  }
  return 0.6 * strength;
}

enum class ZeroLines { hidden, shown };

void draw_field_colours(const View& view, ZeroLines lines, Image& image) {
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Q16_16 x_u = view.x_u(x);
      const Q16_16 y_u = view.y_u(y);
      const double distance = distance_at(view.field, x_u, y_u).raw / 1024.0;
      const Cell cell = locate(view.field, x_u.floor(), y_u.floor());
      const double line =
          lines == ZeroLines::hidden
              ? 0
              : zero_line(view, cell, {x_u.raw / 65536.0, y_u.raw / 65536.0});
      put(image, x, y,
          mix(field_colour(distance, cell.is_saturated(), view.px_per_u),
              kZeroLine, line));
    }
  }
}

// Where cells meet, the border of the one with more fields shows: drawn last.
int rank(const Cell& cell) {
  return cell.is_saturated() ? -1 : cell.field_count;
}

// The four sides of a cell over the picture without borders.
void draw_border(const View& view,
                 const Cell& cell,
                 const Image& bare,
                 Image& image) {
  const int size = 1 << cell.size_log2;
  const int left = view.x_px(cell.x0_u);
  const int right = view.x_px(cell.x0_u + size);
  const int top = view.y_px(cell.y0_u + size);
  const int bottom = view.y_px(cell.y0_u);
  // Small cells would become one dark mass.
  const double strength = std::clamp(0.10 * (right - left), 0.25, 0.62);
  const Colour& colour =
      cell.is_saturated() ? kSaturatedBorder : kBorders[cell.field_count];
  const auto blend = [&](int x, int y) {
    put(image, x, y, mix(get(bare, x, y), colour, strength));
  };
  for (int x = left; x <= right; ++x) {
    blend(x, bottom);
    blend(x, top);
  }
  for (int y = top; y <= bottom; ++y) {
    blend(left, y);
    blend(right, y);
  }
}

void draw_borders(const View& view, Image& image) {
  const Image bare = image;
  std::vector<Cell> cells;
  for_each_cell(view.field, [&](const Cell& cell) { cells.push_back(cell); });
  std::stable_sort(
      cells.begin(), cells.end(),
      [](const Cell& a, const Cell& b) { return rank(a) < rank(b); });
  for (const Cell& cell : cells) {
    draw_border(view, cell, bare, image);
  }
}

// A picture of the glyph's grid, whose longer side becomes `side` px.
View view_of(const GlyphField& field, int side) {
  if (field.tiles_x == 0 || field.tiles_y == 0) {
    throw std::runtime_error("the glyph has no ink, and so no picture");
  }
  const int width_u = field.x1_u() - field.x0_u;
  const int height_u = field.y1_u() - field.y0_u;
  const double px_per_u =
      static_cast<double>(side) / std::max(width_u, height_u);
  return {field, px_per_u, static_cast<int>(std::lround(width_u * px_per_u)),
          static_cast<int>(std::lround(height_u * px_per_u))};
}

Image draw_field(const View& view, ZeroLines lines) {
  Image image(view.width + 1, view.height + 1, 3, 255);
  draw_field_colours(view, lines, image);
  return image;
}

// Lines across the whole picture, `dash` px long with gaps in between; 0: in
// one piece.
void draw_height(
    const View& view, int y_u, const Colour& colour, int dash, Image& image) {
  const int y = view.y_px(y_u);
  for (int x = 0; y >= 0 && y < image.height && x < image.width; ++x) {
    if (dash == 0 || x / dash % 2 == 0) {
      put(image, x, y, colour);
    }
  }
}

void draw_stem(const View& view, int x_u, Image& image) {
  const int x = view.x_px(x_u);
  for (int y = 0; x >= 0 && x < image.width && y < image.height; ++y) {
    put(image, x, y, kStem);
  }
}

// Grey of the lines between the boxes of a sheet.
constexpr uint8_t kRule = 225;

}  // namespace

Image draw_cells(const GlyphField& field, int side) {
  const View view = view_of(field, side);
  Image image = draw_field(view, ZeroLines::shown);
  draw_borders(view, image);
  return image;
}

Image draw_edges(const FontCensus& font, const GlyphCensus& glyph, int side) {
  const View view = view_of(glyph.field, side);
  Image image = draw_field(view, ZeroLines::hidden);
  for (const int stem : glyph.stems_u) {
    draw_stem(view, stem, image);
  }
  for (const EdgeCensus& edge : glyph.edges) {
    draw_height(view, edge.height_u, edge.is_bar ? kBar : kOtherEdge, 0, image);
  }
  for (const HintZone& zone : font.zones) {
    draw_height(view, zone.height_u, kZone, kDash, image);
  }
  return image;
}

Image draw_sheet(const Font& font, double px) {
  const Brush brush = make_brush(px, 0, kFilterText);  // refuses odd sizes
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
