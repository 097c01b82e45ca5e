// Parses sizes of the command line: numbers and ranges.
#pragma once

#include <string>
#include <vector>

namespace inkcell::tools {

/// The sizes of a list such as {"8-64", "12.5"}: ranges of integers, and
/// numbers, rounded to 1/64 as on the device. In the order given. [px/em]
///
/// Throws std::runtime_error that names what is not a size from 4 to 1024.
std::vector<double> read_sizes(const std::vector<std::string>& list);

}  // namespace inkcell::tools
