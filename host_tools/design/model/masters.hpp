// Masters of a font: layers whose points correspond, and their places on axes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// The name of a layer; "Default" for UFO's public.default.
std::string master_name(const Project& project, size_t layer);

/// What does not correspond in two masters of a glyph, one text for each
/// contour or point; empty: there are glyphs between them. `other` is the name
/// of the second master.
std::vector<std::string> mismatches(const Glyph& a,
                                    const Glyph& b,
                                    const std::string& other);

/// The key of the font's lib that has its axes.
inline constexpr const char* kAxesKey = "org.inkcell.axes";

/// A place on all axes, by their tags.
using AxisPlace = std::map<std::string, double>;

struct Axis {
  std::string tag;
  std::string name;
};

struct Axes {
  struct Master {
    size_t layer = 0;
    AxisPlace place;
  };
  struct Instance {
    std::string name;
    AxisPlace place;
  };

  std::vector<Axis> axes;
  std::vector<Master> masters;  // the default one first
  std::vector<Instance> instances;
};

/// The axes in the font's lib: { "axes": [{ "tag", "name" }], "masters": {
/// LAYER: { TAG: NUMBER } }, "instances": [{ "name", TAG: NUMBER }] }. Throws
/// Error that names what is wrong.
Axes axes_of(const Project& project);
Axes parse_axes(const Project& project, const Value& value);

}  // namespace inkcell::design
