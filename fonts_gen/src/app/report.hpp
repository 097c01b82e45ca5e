// The report of a finished font: a table for people and JSON for programs.
#pragma once

#include <string>

#include "pipeline/font_report.hpp"

namespace inkcell::gen {

/// Bytes per part, cells, the worst glyphs by bytes and by error, the time.
/// Ends with a line end.
std::string report_for_people(const FontReport& report);

/// The same as a JSON object, with the figures of every glyph.
std::string report_as_json(const FontReport& report);

}  // namespace inkcell::gen
