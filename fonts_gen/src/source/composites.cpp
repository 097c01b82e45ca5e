#include "source/composites.hpp"

#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

// Real fonts nest composites two or three deep; this stops cycles.
constexpr int kMostDepth = 8;

// Points of components of components are rounded at each level. [font units]
constexpr int kRounding = 1;

using Points = std::vector<std::array<int, 2>>;

// A component as in the file: its glyph and its matrix.
struct Component {
  uint32_t glyph;
  MatrixQ14 matrix_q14;
};

class Composites {
 public:
  Composites(const FontFile& file, const std::vector<uint32_t>& glyphs)
      : file_(file) {
    for (size_t i = 0; i < glyphs.size(); ++i) {
      place_of_.emplace(glyphs[i], i);
    }
  }

  OutlineReferences references(uint32_t glyph) const {
    std::vector<Component> components;
    const Component whole{glyph, OutlineReference().matrix_q14};
    if (!add_components(whole, kMostDepth, components)) {
      return {};
    }
    return locate(components, points_of(glyph));
  }

  // Adds the simple glyphs that `glyph` needs and the font lacks.
  void add_missing(uint32_t glyph,
                   int depth,
                   std::set<uint32_t>& missing) const {
    for (const Component& component : components_of(glyph)) {
      if (depth > 0 && place_of_.count(component.glyph) == 0) {
        if (components_of(component.glyph).empty()) {
          missing.insert(component.glyph);
        }
        add_missing(component.glyph, depth - 1, missing);
      }
    }
  }

 private:
  FT_GlyphSlot load(uint32_t glyph, FT_Int32 flags) const {
    if (FT_Load_Glyph(file_.ft(), glyph, FT_LOAD_NO_SCALE | flags) != 0) {
      file_.refuse("glyph " + std::to_string(glyph) + " cannot be loaded");
    }
    return file_.ft()->glyph;
  }

  Points points_of(uint32_t glyph) const {
    const FT_Outline& outline = load(glyph, FT_LOAD_NO_HINTING)->outline;
    Points points;
    for (int i = 0; i < outline.n_points; ++i) {
      points.push_back({static_cast<int>(outline.points[i].x),
                        static_cast<int>(outline.points[i].y)});
    }
    return points;
  }

  std::vector<Component> components_of(uint32_t glyph) const {
    const FT_GlyphSlot slot = load(glyph, FT_LOAD_NO_RECURSE);
    std::vector<Component> components;
    if (slot->format != FT_GLYPH_FORMAT_COMPOSITE) {
      return components;
    }
    for (FT_UInt i = 0; i < slot->num_subglyphs; ++i) {
      FT_Int id = 0;
      FT_UInt flags = 0;
      FT_Int arg1 = 0;
      FT_Int arg2 = 0;
      FT_Matrix m;
      FT_Get_SubGlyph_Info(slot, i, &id, &flags, &arg1, &arg2, &m);
      components.push_back(
          {static_cast<uint32_t>(id),
           {to_q14(m.xx), to_q14(m.xy), to_q14(m.yx), to_q14(m.yy)}});
    }
    return components;
  }

  static int to_q14(FT_Fixed value_q16) {
    return static_cast<int>((value_q16 + 2) >> 2);
  }

  // Adds the components of `whole`; false if one is no glyph of the font.
  bool add_components(const Component& whole,
                      int depth,
                      std::vector<Component>& found) const {
    const std::vector<Component> parts = components_of(whole.glyph);
    if (parts.empty() || depth == 0) {
      return false;
    }
    for (const Component& part : parts) {
      const Component combined{part.glyph,
                               product(whole.matrix_q14, part.matrix_q14)};
      if (place_of_.count(part.glyph) != 0) {
        found.push_back(combined);
      } else if (!add_components(combined, depth - 1, found)) {
        return false;
      }
    }
    return true;
  }

  // Finds offsets by the points of the whole glyph, which are those of the
  // components in order. So it works for any kind of offset in the file: by
  // matching points, scaled, or varied along an axis.
  OutlineReferences locate(const std::vector<Component>& components,
                           const Points& whole) const {
    OutlineReferences references;
    size_t at = 0;
    for (const Component& component : components) {
      const Points points = transformed(component);
      if (points.size() > whole.size() - at) {
        return {};
      }
      OutlineReference reference;
      reference.glyph = place_of_.at(component.glyph);
      reference.matrix_q14 = component.matrix_q14;
      if (!points.empty() && !find_offset(points, whole, at, reference)) {
        return {};
      }
      at += points.size();
      references.push_back(reference);
    }
    return at == whole.size() ? references : OutlineReferences();
  }

  Points transformed(const Component& component) const {
    Points points = points_of(component.glyph);
    const auto& m = component.matrix_q14;
    const FT_Matrix matrix = {m[0] * 4, m[1] * 4, m[2] * 4, m[3] * 4};
    for (auto& p : points) {
      FT_Vector vector = {p[0], p[1]};
      FT_Vector_Transform(&vector, &matrix);  // rounds as the whole glyph does
      p = {static_cast<int>(vector.x), static_cast<int>(vector.y)};
    }
    return points;
  }

  static bool find_offset(const Points& points,
                          const Points& whole,
                          size_t at,
                          OutlineReference& reference) {
    std::array<int, 2> offset{};
    for (size_t axis = 0; axis < 2; ++axis) {
      int least = whole[at][axis] - points[0][axis];
      int most = least;
      for (size_t i = 0; i < points.size(); ++i) {
        const int difference = whole[at + i][axis] - points[i][axis];
        least = std::min(least, difference);
        most = std::max(most, difference);
      }
      const int limit = reference.has_matrix() ? 2 * kRounding : 0;
      if (most - least > limit) {
        return false;
      }
      offset[axis] = (least + most) >> 1;
    }
    reference.dx = offset[0];
    reference.dy = offset[1];
    return true;
  }

  const FontFile& file_;
  std::map<uint32_t, size_t> place_of_;
};

}  // namespace

std::vector<OutlineReferences> source_composites(
    const FontFile& file, const std::vector<uint32_t>& glyphs) {
  const Composites composites(file, glyphs);
  std::vector<OutlineReferences> references;
  for (const uint32_t glyph : glyphs) {
    references.push_back(composites.references(glyph));
  }
  return references;
}

std::vector<uint32_t> missing_components(const FontFile& file,
                                         const std::vector<uint32_t>& glyphs) {
  const Composites composites(file, glyphs);
  std::set<uint32_t> missing;
  for (const uint32_t glyph : glyphs) {
    composites.add_missing(glyph, kMostDepth, missing);
  }
  return {missing.begin(), missing.end()};
}

}  // namespace inkcell::gen
