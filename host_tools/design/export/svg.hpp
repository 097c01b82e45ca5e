// A glyph as SVG.
#pragma once

#include <string>

#include "shape/outline.hpp"

namespace inkcell::design {

/// The path data of an outline, y down, coordinates rounded to 1/1000 u.
std::string svg_path(const gen::Outline& outline);

/// A document that shows the outline and 64 u around it; 1 px is 1 u. `title`
/// is shown by browsers.
std::string svg_document(const gen::Outline& outline, const std::string& title);

}  // namespace inkcell::design
