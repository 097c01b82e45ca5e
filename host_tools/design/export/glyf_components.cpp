#include "export/glyf_components.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "component/contour_csg.hpp"
#include "model/contours.hpp"
#include "model/sources.hpp"

namespace inkcell::design {
namespace {

constexpr int kOne_q14 = 1 << 14;
constexpr std::array<int, 4> kUnit_q14 = {kOne_q14, 0, 0, kOne_q14};

// The largest movement of a point by rounding a matrix. [font units]
constexpr double kMatrixBound = 1.0 / 8;

// One product of a matrix, as FreeType rounds it.
int times_q14(int factor_q14, int value) {
  return static_cast<int>(
      std::lround(static_cast<double>(factor_q14) * value / kOne_q14));
}

std::vector<GlyfContour> placed(std::vector<GlyfContour> contours,
                                const GlyfComponent& component) {
  const auto& m = component.matrix_q14;
  for (GlyfContour& contour : contours) {
    for (GlyfPoint& p : contour) {
      p = {times_q14(m[0], p.x) + times_q14(m[2], p.y) + component.dx,
           times_q14(m[1], p.x) + times_q14(m[3], p.y) + component.dy,
           p.on_curve};
    }
  }
  return contours;
}

// Empty if a record cannot hold it. `box` is that of the base.
std::optional<GlyfComponent> component_of(const ComponentUse& use,
                                          const GlyfBox& box) {
  const Matrix& m = use.matrix;
  const double entries[4] = {m.xx, m.xy, m.yx, m.yy};
  const int extents[2] = {std::max(std::abs(box.x0), std::abs(box.x1)),
                          std::max(std::abs(box.y0), std::abs(box.y1))};
  GlyfComponent component;
  component.base = use.base;
  double moved[2] = {};
  for (size_t i = 0; i < 4; ++i) {
    if (!(entries[i] >= -2 && entries[i] < 2)) {
      return std::nullopt;
    }
    const long rounded = std::lround(entries[i] * kOne_q14);
    if (rounded == 2 * kOne_q14) {
      return std::nullopt;
    }
    component.matrix_q14[i] = static_cast<int>(rounded);
    moved[i % 2] +=
        std::fabs(entries[i] - static_cast<double>(rounded) / kOne_q14) *
        extents[i / 2];
  }
  constexpr double kMostOffset = 32767;
  if (std::max(moved[0], moved[1]) > kMatrixBound ||
      !(std::fabs(m.dx) <= kMostOffset && std::fabs(m.dy) <= kMostOffset)) {
    return std::nullopt;
  }
  component.dx = static_cast<int>(std::lround(m.dx));
  component.dy = static_cast<int>(std::lround(m.dy));
  return component;
}

bool boxes_meet(const GlyfBox& a, const GlyfBox& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

// Without components if records cannot hold it.
GlyfGlyph composite_of(const Project& project, const Glyph& glyph) {
  GlyfGlyph result;
  std::vector<GlyfBox> boxes;
  for (const ComponentUse& use : glyph.components) {
    const GlyfGlyph base = glyf_glyph(project, *project.glyph(use.base));
    if (base.contours.empty()) {
      continue;
    }
    if (use.base[0] == '_') {
      return {};
    }
    std::optional<GlyfComponent> component =
        component_of(use, box_of(base.contours));
    if (!component) {
      return {};
    }
    std::vector<GlyfContour> contours = placed(base.contours, *component);
    const GlyfBox box = box_of(contours);
    component->overlaps = std::any_of(
        boxes.begin(), boxes.end(),
        [&box](const GlyfBox& other) { return boxes_meet(box, other); });
    boxes.push_back(box);
    std::move(contours.begin(), contours.end(),
              std::back_inserter(result.contours));
    result.components.push_back(std::move(*component));
    result.depth = std::max(result.depth, base.depth + 1);
    result.is_reflected |= base.is_reflected || use.matrix.determinant() < 0;
  }
  const bool any_overlap = std::any_of(
      result.components.begin(), result.components.end(),
      [](const GlyfComponent& component) { return component.overlaps; });
  return result.is_reflected && any_overlap ? GlyfGlyph() : result;
}

void add_component(const GlyfComponent& component,
                   unsigned id,
                   unsigned flags,
                   BigEndian& record) {
  constexpr unsigned kWords = 1, kAreOffsets = 2, kScale = 8, kTwoScales = 64,
                     kTwoByTwo = 128, kUnscaledOffset = 4096;
  const auto& m = component.matrix_q14;
  const auto is_byte = [](int value) { return value >= -128 && value < 128; };
  flags |= kAreOffsets;
  if (!is_byte(component.dx) || !is_byte(component.dy)) {
    flags |= kWords;
  }
  std::vector<int> entries;
  if (m[1] != 0 || m[2] != 0) {
    entries.assign(m.begin(), m.end());
    flags |= kTwoByTwo | kUnscaledOffset;
  } else if (m[0] != m[3]) {
    entries = {m[0], m[3]};
    flags |= kTwoScales | kUnscaledOffset;
  } else if (m != kUnit_q14) {
    entries = {m[0]};
    flags |= kScale | kUnscaledOffset;
  }
  record.words(flags, id);
  for (const int offset : {component.dx, component.dy}) {
    if ((flags & kWords) != 0) {
      record.i16(offset);
    } else {
      record.u8(static_cast<unsigned>(offset) & 0xff);
    }
  }
  for (const int entry : entries) {
    record.i16(entry);
  }
}

}  // namespace

GlyfGlyph glyf_glyph(const Project& project, const Glyph& glyph) {
  GlyfGlyph result;
  const size_t own = own_contours(glyph);
  std::vector<PointContour> contours =
      own == 0 || own == glyph.contours.size()
          ? glyph.contours
          : in_direction_of(project, glyph,
                            combined(glyph.contours, {}, "union"));
  for (const ComponentUse& use : glyph.components) {
    append_component(project, 0, use, contours);
  }
  result.contours = glyf_contours(contours);
  if (result.contours.empty() || !glyf_contours(glyph.contours).empty()) {
    return result;
  }
  GlyfGlyph composite = composite_of(project, glyph);
  return composite.components.empty() ? result : composite;
}

BigEndian composite_record(const GlyfGlyph& glyph,
                           const std::map<std::string, unsigned>& ids) {
  constexpr unsigned kMore = 32, kOverlap = 1024;
  const bool overlap = std::any_of(
      glyph.components.begin(), glyph.components.end(),
      [](const GlyfComponent& component) { return component.overlaps; });
  BigEndian record = glyf_header(-1, box_of(glyph.contours));
  for (size_t i = 0; i < glyph.components.size(); ++i) {
    const GlyfComponent& component = glyph.components[i];
    const bool is_last = i + 1 == glyph.components.size();
    add_component(component, ids.at(component.base),
                  (is_last ? 0 : kMore) | (i == 0 && overlap ? kOverlap : 0),
                  record);
  }
  return record;
}

}  // namespace inkcell::design
