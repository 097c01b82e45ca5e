#include "pipeline/field_images.hpp"

#include <cstdlib>
#include <optional>

namespace inkcell::gen {
namespace {

// [u] None if it is no whole number.
std::optional<int> whole_u(int font_units, int units_per_em) {
  const int scaled = font_units * 1024;
  return scaled % units_per_em == 0 ? std::optional(scaled / units_per_em)
                                    : std::nullopt;
}

std::optional<Symmetry> symmetry_of(const OutlineReference& reference) {
  constexpr int kOne = OutlineReference::kOne_q14;
  const auto& m = reference.matrix_q14;
  const bool is_upright = m[1] == 0 && m[2] == 0 && std::abs(m[0]) == kOne &&
                          std::abs(m[3]) == kOne;
  const bool is_lying = m[0] == 0 && m[3] == 0 && std::abs(m[1]) == kOne &&
                        std::abs(m[2]) == kOne;
  if (!is_upright && !is_lying) {
    return std::nullopt;
  }
  return Symmetry{m[0] / kOne, m[1] / kOne, m[2] / kOne, m[3] / kOne};
}

std::optional<FieldImage> image_of(const SourceFont& font, size_t glyph) {
  if (font.components[glyph].size() != 1) {
    return std::nullopt;
  }
  const OutlineReference& reference = font.components[glyph].front();
  const auto symmetry = symmetry_of(reference);
  const auto dx_u = whole_u(reference.dx, font.metrics.units_per_em);
  const auto dy_u = whole_u(reference.dy, font.metrics.units_per_em);
  if (!symmetry || !dx_u || !dy_u) {
    return std::nullopt;
  }
  return FieldImage{glyph, reference.glyph, *symmetry, *dx_u, *dy_u};
}

}  // namespace

std::vector<FieldImage> find_field_images(const SourceFont& font) {
  std::vector<FieldImage> images;
  for (size_t i = 0; i < font.components.size(); ++i) {
    const std::optional<FieldImage> image = image_of(font, i);
    if (image && font.is_shown(i) && font.is_shown(image->of) &&
        !image_of(font, image->of)) {
      images.push_back(*image);
    }
  }
  return images;
}

}  // namespace inkcell::gen
