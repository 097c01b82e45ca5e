#include "editor/thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "model/contours.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::editor {
namespace {

constexpr double kEmPart = 0.62;
constexpr double kBaseline = 0.72;  // of the side, from the top

}  // namespace

tools::Image thumbnail(const Project& project, const Glyph& glyph, int side) {
  try {
    const gen::Shape shape(outline_of(project, glyph));
    if (shape.empty()) {
      return {};
    }
    tools::Image image(side, side);
    const double px_per_u = kEmPart * side / gen::kUPerEm;
    const double width_u = glyph.width * gen::kUPerEm / project.units_per_em();
    const double left = (side - width_u * px_per_u) / 2;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double d =
            shape.distance((x + 0.5 - left) / px_per_u,
                           (kBaseline * side - y - 0.5) / px_per_u);
        *image.at(x, y) = static_cast<uint8_t>(
            std::lround(255 * std::clamp(d * px_per_u + 0.5, 0.0, 1.0)));
      }
    }
    return image;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace inkcell::design::editor
