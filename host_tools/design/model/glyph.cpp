#include "model/glyph.hpp"

#include <tuple>

#include "model/error.hpp"

namespace inkcell::design {
namespace {

auto fields(const GlyphPoint& p) {
  return std::tie(p.x, p.y, p.type, p.smooth, p.name, p.identifier);
}

auto fields(const PointContour& c) {
  return std::tie(c.points, c.identifier);
}

auto fields(const ComponentUse& c) {
  return std::tie(c.base, c.matrix, c.identifier);
}

auto fields(const Anchor& a) {
  return std::tie(a.x, a.y, a.name, a.color, a.identifier);
}

auto fields(const Guideline& g) {
  return std::tie(g.x, g.y, g.angle, g.name, g.color, g.identifier);
}

auto fields(const GlyphImage& i) {
  return std::tie(i.file, i.matrix, i.color);
}

auto fields(const Glyph& g) {
  return std::tie(g.name, g.width, g.height, g.unicodes, g.note, g.image,
                  g.guidelines, g.anchors, g.contours, g.components, g.lib);
}

constexpr const char* kTypeNames[] = {"move", "line", "curve", "qcurve",
                                      "offcurve"};

}  // namespace

bool operator==(const GlyphPoint& a, const GlyphPoint& b) {
  return fields(a) == fields(b);
}

bool operator==(const PointContour& a, const PointContour& b) {
  return fields(a) == fields(b);
}

bool operator==(const ComponentUse& a, const ComponentUse& b) {
  return fields(a) == fields(b);
}

bool operator==(const Anchor& a, const Anchor& b) {
  return fields(a) == fields(b);
}

bool operator==(const Guideline& a, const Guideline& b) {
  return fields(a) == fields(b);
}

bool operator==(const GlyphImage& a, const GlyphImage& b) {
  return fields(a) == fields(b);
}

bool operator==(const Glyph& a, const Glyph& b) {
  return fields(a) == fields(b);
}

std::string type_name(PointType type) {
  return kTypeNames[static_cast<size_t>(type)];
}

PointType parse_type(const std::string& name) {
  for (size_t i = 0; i < std::size(kTypeNames); ++i) {
    if (name == kTypeNames[i]) {
      return static_cast<PointType>(i);
    }
  }
  throw Error("point type '" + name +
              "' is not known; use move, line, curve, qcurve or offcurve");
}

bool is_undrawn(const Glyph& glyph) {
  const char32_t c = glyph.unicodes.empty() ? 0 : glyph.unicodes.front();
  const bool is_space = c == U' ' || c == 0xa0 || c == 0x1680 ||
                        (c >= 0x2000 && c <= 0x200f) || c == 0x202f ||
                        c == 0x205f || c == 0x3000;
  return glyph.contours.empty() && glyph.components.empty() && !is_space;
}

}  // namespace inkcell::design
