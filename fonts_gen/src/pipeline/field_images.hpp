// Glyphs whose field is that of another glyph, reflected or turned.
#pragma once

#include <cstddef>
#include <vector>

#include "samples/symmetry.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// A composite of one component that is reflected, turned by quarters, or
/// neither, and moved by whole u.
struct FieldImage {
  size_t glyph = 0;  // number in the font
  size_t of = 0;     // the component, which has no components
  Symmetry symmetry;
  int dx_u = 0;
  int dy_u = 0;
};

/// All of them in `font`, in ascending order. Components of images are glyphs
/// that a text may show: others would be sampled for their images only.
std::vector<FieldImage> find_field_images(const SourceFont& font);

}  // namespace inkcell::gen
