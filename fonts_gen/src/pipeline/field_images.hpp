// Glyphs whose field is that of another glyph, reflected or turned.
#pragma once

#include <cstddef>
#include <vector>

#include "field/symmetry.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// A composite of one component that is reflected, turned by quarters, or
/// neither, and moved by whole u.
struct FieldImage {
  size_t glyph = 0;  // number in the font
  size_t of = 0;     // the component, which is no image itself
  Symmetry symmetry;
  int dx_u = 0;
  int dy_u = 0;
};

/// Those of `font`, in ascending order. Images of images are left out, so that
/// all images can be made at once; so are images of components that no text
/// shows, which would be sampled for their images alone.
std::vector<FieldImage> find_field_images(const SourceFont& font);

}  // namespace inkcell::gen
