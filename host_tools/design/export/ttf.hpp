// Projects as TrueType fonts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// The bytes of a TrueType font: head, hhea, maxp, OS/2, hmtx, cmap (4 and 12),
/// loca, glyf, name, post, and kern if the project has kerning. Contours keep
/// their points; components stay components if the table can hold them
/// (glyf_components.hpp); cubics become quadratics (glyf.hpp). The first glyph
/// is .notdef; one is made if the project has none.
///
/// Throws Error that names the glyph.
std::vector<uint8_t> write_ttf(const Project& project);

}  // namespace inkcell::design
