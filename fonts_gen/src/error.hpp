// What the generator throws and what it warns of.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace inkcell::gen {

/// A font that cannot be generated. The text names the file, the glyph if it is
/// about one, and the remedy; it is meant for the person at the terminal.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something that the person should know although a font was generated.
struct Warning {
  enum class Kind {
    missing_characters,  // asked for, not in the font
    embedding,           // OS/2 fsType restricts what may be done
    tolerance_missed,    // a glyph is worse than asked for
    measure,             // a metric had to be guessed or clamped
  };
  Kind kind;
  std::string text;
};

using Warnings = std::vector<Warning>;

}  // namespace inkcell::gen
