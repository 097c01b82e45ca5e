// The basic shapes of SVG as paths.
#pragma once

#include <optional>
#include <pugixml.hpp>

#include "svg/path_data.hpp"

namespace inkcell::gen {

/// The path of <path>, <rect>, <circle>, <ellipse>, <line>, <polyline> or
/// <polygon> (SVG 1.1, section 9), in user units, y down. Empty for a shape
/// without extent; nothing for any other element. Throws Error.
std::optional<SvgPath> path_of(const pugi::xml_node& node);

}  // namespace inkcell::gen
