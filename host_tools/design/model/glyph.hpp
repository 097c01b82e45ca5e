// A glyph in the editor: contours, components, anchors and more. Coordinates
// are in font units, y up.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/value.hpp"
#include "shape/affine.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// How the curve reaches a point, as in UFO 3. `move` begins an open contour.
/// Off-curve points precede the `curve` (cubic) or `qcurve` (quadratic) point
/// that they belong to.
enum class PointType : uint8_t { move, line, curve, qcurve, offcurve };

struct GlyphPoint {
  double x = 0;
  double y = 0;
  PointType type = PointType::line;
  bool smooth = false;
  std::string name;
  std::string identifier;

  bool on_curve() const { return type != PointType::offcurve; }
};

struct PointContour {
  std::vector<GlyphPoint> points;
  std::string identifier;

  bool open() const {
    return !points.empty() && points.front().type == PointType::move;
  }
};

using Matrix = gen::Affine;

/// A reference to another glyph of the same layer.
struct ComponentUse {
  std::string base;
  Matrix matrix;
  std::string identifier;
};

struct Anchor {
  double x = 0;
  double y = 0;
  std::string name;
  std::string color;
  std::string identifier;
};

struct Guideline {
  std::optional<double> x;
  std::optional<double> y;
  std::optional<double> angle;  // [degrees]
  std::string name;
  std::string color;
  std::string identifier;
};

/// A picture behind the outline: images/`file` of the project.
struct GlyphImage {
  std::string file;
  Matrix matrix;
  std::string color;
};

struct Glyph {
  std::string name;
  double width = 0;
  double height = 0;
  std::vector<char32_t> unicodes;
  std::string note;
  std::optional<GlyphImage> image;
  std::vector<Guideline> guidelines;
  std::vector<Anchor> anchors;
  std::vector<PointContour> contours;
  std::vector<ComponentUse> components;
  Value lib = Value::object();
};

bool operator==(const GlyphPoint& a, const GlyphPoint& b);
bool operator==(const PointContour& a, const PointContour& b);
bool operator==(const ComponentUse& a, const ComponentUse& b);
bool operator==(const Anchor& a, const Anchor& b);
bool operator==(const Guideline& a, const Guideline& b);
bool operator==(const GlyphImage& a, const GlyphImage& b);
bool operator==(const Glyph& a, const Glyph& b);

/// Whether it has neither contours nor components, and is no space.
bool is_undrawn(const Glyph& glyph);

/// The name of a point type in GLIF and in commands; empty for off-curve points
/// in GLIF. Throws Error for an unknown name.
std::string type_name(PointType type);
PointType parse_type(const std::string& name);

}  // namespace inkcell::design
