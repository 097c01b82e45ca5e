// A glyph of several colours, drawn in one.
#pragma once

#include <vector>

#include "shape/paint.hpp"

namespace inkcell::gen {

/// The form of layers for displays of one colour: their union, with parts cut
/// out that contrast with most of it, dark ones of a light picture or light
/// ones of a dark one. A rim stays along the border, and details that a small
/// display does not show are left out. Layers of less than 3/8 opacity count
/// only if there are no others.
///
/// Throws GeometryError.
Outline mono_form(const std::vector<PaintedOutline>& layers);

}  // namespace inkcell::gen
