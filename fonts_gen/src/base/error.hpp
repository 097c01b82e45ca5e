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

/// A glyph that does not fit the format at these sizes and this tolerance: with
/// a lower --max-px or a higher --tolerance it may.
class TooComplex : public Error {
 public:
  TooComplex(const std::string& problem, const std::string& remedy)
      : Error(problem + "; " + remedy), problem_(problem) {}

  /// The text without the remedy: file, glyph and what is too much.
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

/// Something that the person should know although a font was generated.
struct Warning {
  enum class Kind {
    missing_characters,  // asked for, not in the font
    embedding,           // OS/2 fsType restricts what may be done
    tolerance_missed,    // a glyph is worse than asked for
    measure,             // a metric had to be guessed or clamped
    no_outline,          // a glyph is a bitmap or in colour only: no ink
    unused_face,         // a merged face gives no character
    face_taken,          // the first of several, since none was chosen
    no_kerning,          // a block of a paged font has no room for it
    default_instance,    // a variable font is converted at its defaults
    unshaped,            // a text needs shaping, which a device does not
    no_morph,            // a pair of glyphs or masters has no morph
    shaping_dear,        // a script takes much work on the device
    flat_gradients,      // of a font of several colours
  };
  Kind kind;
  std::string text;

  /// As programs print it: "warning: <text>", or "note: <text>" if the
  /// generator chose a default.
  std::string message() const {
    return (kind == Kind::default_instance ? "note: " : "warning: ") + text;
  }
};

using Warnings = std::vector<Warning>;

}  // namespace inkcell::gen
