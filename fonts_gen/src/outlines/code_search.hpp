// The search for the prefix code of a font's outlines.
#pragma once

#include <cstddef>

#include "outlines/outline_code.hpp"

namespace inkcell::gen {

/// The code with the smallest tables and streams for `counts`, as far as the
/// search finds it. The same counts give the same code on every machine. Words
/// have 4 bits or more, and tables `most_entries` together, 16..1024. Several
/// tables must save a twentieth, as they cost instructions.
OutlineCode make_outline_code(const StepCounts& counts,
                              size_t most_entries = 1024);

}  // namespace inkcell::gen
