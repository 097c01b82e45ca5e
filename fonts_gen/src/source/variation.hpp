// The axes and named instances of a variable font.
#pragma once

#include <hb.h>

#include <optional>
#include <string>
#include <vector>

namespace inkcell::gen {

/// A setting of a variable font, such as wght=600, or wght=300..800 for two
/// masters.
struct AxisSetting {
  std::string tag;  // four characters
  double value = 0;
  std::optional<double> second;  // of the second master
};

using AxisSettings = std::vector<AxisSetting>;

/// Reads "wght=600". Throws Error.
AxisSetting parse_axis(const std::string& text);

/// The same, and "wght=300..800". Throws Error.
AxisSetting parse_axis_range(const std::string& text);

/// Whether an axis moves from a first master to a second one.
bool has_second_master(const AxisSettings& axes);

/// The settings of the second master.
AxisSettings second_master(AxisSettings axes);

/// Those of the axes that move: "wght 800, wdth 75".
std::string second_values(const AxisSettings& axes);

struct FontAxis {
  std::string tag;  // four characters
  double least = 0;
  double usual = 0;  // of the file's own outlines
  double most = 0;
  double value = 0;  // of the face
};

struct NamedInstance {
  std::string name;            // such as "SemiBold"
  std::vector<double> values;  // of each axis
};

/// The axes and instances of a font, and the current values. No axes: not
/// variable.
struct Variation {
  std::vector<FontAxis> axes;
  std::vector<NamedInstance> instances;

  /// The name of the instance at the current values; "" if there is none.
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

/// Sets the axes to the named instance, if the name is not empty, then to
/// `settings`. Case, blanks and hyphens of the name are ignored. Throws Error,
/// which does not name the file.
void set_variation(const std::string& instance,
                   const std::vector<AxisSetting>& settings,
                   Variation& variation);

}  // namespace inkcell::gen
