// Codes of several tables: the step before tells which one a step is read with.
#pragma once

#include <cstddef>
#include <optional>

#include "outlines/outline_code.hpp"

namespace inkcell::gen {

/// The code of 2, 4 or 8 tables with the smallest tables and streams, as far as
/// the search finds it; all of them have `most_entries` at most. None if they
/// do not suffice.
std::optional<OutlineCode> make_table_code(const StepCounts& counts,
                                           size_t most_entries);

}  // namespace inkcell::gen
