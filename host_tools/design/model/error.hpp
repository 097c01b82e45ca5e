// What the design library throws.
#pragma once

#include <stdexcept>

namespace inkcell::design {

/// A project, command or file that cannot be used. The text names the file, the
/// glyph if it is about one, and the remedy; it is meant for the person at the
/// terminal.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace inkcell::design
