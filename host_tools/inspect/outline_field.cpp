// One pixel of each picture is one distance.
#include "outline_field.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "inkcell/filter.hpp"

namespace inkcell::tools {
namespace {

constexpr int kPx = 32;            // size of the glyph [px/em]
constexpr int kStep = 1024 / kPx;  // between pixels [u]
constexpr double kReachU = 4 * kStep;

// Coverage is distance. [-4, 4] px, in steps of 1/32 px.
constexpr Filter kWide = make_filter({Q6_10::from_int(-4), Q6_10::from_int(4)});

int floor_div(int a, int b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

// The glyph with the middles of its pixels at u that are `phase_x`, `phase_y`
// more than a multiple of kStep.
Image draw_phase(const Font& font,
                 uint16_t glyph,
                 const Filter& filter,
                 const Rect& cells,
                 int phase_x,
                 int phase_y) {
  Image image(cells.x1 - cells.x0, cells.y1 - cells.y0);
  Line line;
  line.glyphs.push_back({0, 0, glyph});
  // x_u = (column + cells.x0) kStep + phase_x at column + 1/2, from the left;
  // y_u = (cells.y1 - 1 - row) kStep + phase_y at row + 1/2, from the top.
  const double x = 0.5 - cells.x0 - static_cast<double>(phase_x) / kStep;
  const double y = 0.5 + cells.y1 - 1 + static_cast<double>(phase_y) / kStep;
  draw_lines(font, {line}, make_style(kPx, 0, filter), make_point(x, y), image);
  return image;
}

double distance_of(uint8_t text, uint8_t wide) {
  return text > 0 && text < 255
             ? (text / 255.0 - 0.5) * kStep       // fine, near the edge
             : (wide / 255.0 * 2 - 1) * kReachU;  // coarse
}

}  // namespace

OutlineField::OutlineField(const Font& font, uint16_t glyph, const Rect& box_u)
    : box_(box_u) {
  const int width = box_.x1 - box_.x0;
  const int height = box_.y1 - box_.y0;
  distances_u_.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
  const Rect cells = {floor_div(box_.x0, kStep), floor_div(box_.y0, kStep),
                      floor_div(box_.x1 - 1, kStep) + 1,
                      floor_div(box_.y1 - 1, kStep) + 1};
  for (int phase = 0; phase < kStep * kStep; ++phase) {
    const int phase_x = phase % kStep;
    const int phase_y = phase / kStep;
    const Image text =
        draw_phase(font, glyph, kFilterText, cells, phase_x, phase_y);
    const Image wide = draw_phase(font, glyph, kWide, cells, phase_x, phase_y);
    for (int row = 0; row < text.height; ++row) {
      const int y = (cells.y1 - 1 - row) * kStep + phase_y;
      for (int column = 0; column < text.width; ++column) {
        const int x = (cells.x0 + column) * kStep + phase_x;
        if (x >= box_.x0 && x < box_.x1 && y >= box_.y0 && y < box_.y1) {
          distances_u_[static_cast<size_t>((y - box_.y0) * width + x -
                                           box_.x0)] =
              static_cast<float>(
                  distance_of(*text.at(column, row), *wide.at(column, row)));
        }
      }
    }
  }
}

double OutlineField::distance(int x, int y) const {
  const int column = std::clamp(x, box_.x0, box_.x1 - 1) - box_.x0;
  const int row = std::clamp(y, box_.y0, box_.y1 - 1) - box_.y0;
  return distances_u_[static_cast<size_t>(row * (box_.x1 - box_.x0) + column)];
}

FieldSample OutlineField::at(double x_u, double y_u) const {
  const int x = static_cast<int>(std::floor(x_u));
  const int y = static_cast<int>(std::floor(y_u));
  const double right = x_u - x;
  const double up = y_u - y;
  const double low = distance(x, y) * (1 - right) + distance(x + 1, y) * right;
  const double high =
      distance(x, y + 1) * (1 - right) + distance(x + 1, y + 1) * right;
  const double result = low * (1 - up) + high * up;
  return {result, std::fabs(result) > kReachU - 1};
}

}  // namespace inkcell::tools
