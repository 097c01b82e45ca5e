// The attribute `transform` of SVG.
#pragma once

#include <string_view>

#include "shape/affine.hpp"

namespace inkcell::gen {

/// Reads "translate(3 4) scale(2)": matrix, translate, scale, rotate, skewX and
/// skewY (SVG 1.1, section 7.6), the outermost first. Throws Error.
Affine parse_transform(std::string_view text);

}  // namespace inkcell::gen
