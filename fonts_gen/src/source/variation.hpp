// The axes and named instances of a variable font.
#pragma once

#include <hb.h>

#include <string>
#include <vector>

namespace inkcell::gen {

/// A setting of a variable font, such as wght=600.
struct AxisSetting {
  std::string tag;  // four characters
  double value = 0;
};

/// Reads "wght=600". Throws Error.
AxisSetting parse_axis(const std::string& text);

struct FontAxis {
  std::string tag;  // four characters
  double least = 0;
  double usual = 0;  // where the file's own outlines are
  double most = 0;
  double value = 0;  // where the face is
};

struct NamedInstance {
  std::string name;            // such as "SemiBold"
  std::vector<double> values;  // of each axis
};

/// What a variable font can be, and what it is. Without axes: a font that is
/// not variable.
struct Variation {
  std::vector<FontAxis> axes;
  std::vector<NamedInstance> instances;

  /// The name of the instance that the axes are at; "" without one.
  std::string instance() const;
  bool is_default() const;
  /// "wght 100..900 (default 400), wdth 62.5..100 (default 100)"
  std::string ranges() const;
  /// "wght 600 of 100..900, wdth 100 of 62.5..100 (SemiBold)"
  std::string place() const;
  /// "wght 600, wdth 100"
  std::string values() const;
  /// "Thin, Regular, Bold"; "" without named instances.
  std::string instance_names() const;
};

/// The font's axes at their defaults.
Variation read_variation(hb_face_t* face);

/// Moves the axes to the instance of this name, if it is not empty, and then
/// those of `settings`. Upper and lower case, blanks and hyphens of the name do
/// not count. Throws Error, which does not name the file.
void set_variation(const std::string& instance,
                   const std::vector<AxisSetting>& settings,
                   Variation& variation);

}  // namespace inkcell::gen
