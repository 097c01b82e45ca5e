// The exception of the design library.
#pragma once

#include <stdexcept>

namespace inkcell::design {

/// A project, command or file that cannot be used. The text names the file, the
/// glyph if there is one, and the remedy; it is meant for the user.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace inkcell::design
