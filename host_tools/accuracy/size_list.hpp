// Sizes as the command line gives them: numbers and ranges.
#pragma once

#include <string>
#include <vector>

namespace inkcell::tools {

/// The sizes of a list such as {"8-64", "12.5"}: ranges of whole numbers, and
/// numbers, rounded to the 64ths that the device can draw. In the order given.
/// [px/em]
///
/// Throws std::runtime_error that names what is no size from 4 to 1024.
std::vector<double> read_sizes(const std::vector<std::string>& list);

}  // namespace inkcell::tools
