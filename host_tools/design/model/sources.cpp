#include "model/sources.hpp"

#include <algorithm>
#include <cmath>

#include "model/arguments.hpp"
#include "shape/points.hpp"
#include "stroke/nib.hpp"

namespace inkcell::design {
namespace {

// The factor of a matrix that keeps angles; 0 for others.
double scale_of(const Matrix& m) {
  constexpr double kSlack = 1e-9;
  const double size = std::hypot(m.xx, m.xy);
  const bool keeps_angles =
      std::abs(m.xx * m.yx + m.xy * m.yy) < kSlack * size * size &&
      std::abs(std::hypot(m.yx, m.yy) - size) < kSlack * size;
  return keeps_angles ? size : 0;
}

// The angle of a nib after the map. [degrees]
double turned(const Matrix& m, double angle) {
  const double turn = std::atan2(m.xy, m.xx) / gen::kDegree;
  return m.determinant() < 0 ? turn - angle : turn + angle;
}

void map_stroke(const Matrix& m, double scale, Value& stroke) {
  Nib nib = parse_nib(stroke["nib"].get<std::string>());
  nib.width *= scale;
  nib.height *= scale;
  nib.angle = gen::kDegree * turned(m, nib.angle / gen::kDegree);
  stroke["nib"] = text_of(nib);
  for (Value& point : stroke["points"]) {
    const gen::Point to = m.map(point[0].get<double>(), point[1].get<double>());
    point[0] = to.x;
    point[1] = to.y;
    for (size_t i = 2; i < point.size(); ++i) {
      if (point[i].is_number()) {
        const double value = point[i].get<double>();
        point[i] = i < 4 ? scale * value : turned(m, value);
      }
    }
  }
}

// False if the tree has a blend and `scale` is 0.
bool scale_blends(double scale, Value& node) {
  if (!node.is_object() || !node.contains("parts")) {
    return true;
  }
  if (node.contains("radius")) {
    if (scale == 0) {
      return false;
    }
    node["radius"] = scale * node["radius"].get<double>();
  }
  bool is_possible = true;
  for (Value& part : node["parts"]) {
    is_possible = is_possible && scale_blends(scale, part);
  }
  return is_possible;
}

}  // namespace

bool has_source(const Glyph& glyph) {
  return glyph.lib.contains(kStrokesKey) || glyph.lib.contains(kTreeKey);
}

void drop_source(Glyph& glyph) {
  for (const char* key : {kStrokesKey, kOwnContoursKey, kTreeKey}) {
    glyph.lib.erase(key);
  }
}

size_t own_contours(const Glyph& glyph) {
  if (!glyph.lib.contains(kStrokesKey)) {
    return glyph.contours.size();
  }
  // Another program may have written it, or removed contours.
  const Value count = glyph.lib.value(kOwnContoursKey, Value(0));
  const int64_t own = count.is_number_integer() ? count.get<int64_t>() : 0;
  return std::min(static_cast<size_t>(std::max<int64_t>(own, 0)),
                  glyph.contours.size());
}

Glyph own_part(const Glyph& glyph) {
  Glyph own = glyph;
  own.contours.resize(own_contours(glyph));
  return own;
}

void settle_source(const Glyph& before, Glyph& glyph) {
  const std::vector<PointContour>& old = before.contours;
  const size_t strokes = old.size() - own_contours(before);
  const bool keeps_strokes =
      glyph.lib.contains(kStrokesKey) && strokes <= glyph.contours.size() &&
      std::equal(old.end() - static_cast<std::ptrdiff_t>(strokes), old.end(),
                 glyph.contours.end() - static_cast<std::ptrdiff_t>(strokes));
  if (keeps_strokes) {
    glyph.lib[kOwnContoursKey] = glyph.contours.size() - strokes;
  } else {
    drop_source(glyph);
  }
}

void map_leaves(Value& node, const std::function<void(Value&)>& edit) {
  if (!node.is_object()) {
    return;
  }
  if (node.contains("glyph")) {
    edit(node);
  } else if (node.contains("parts")) {
    for (Value& part : node["parts"]) {
      map_leaves(part, edit);
    }
  }
}

Matrix matrix_of(const Value& leaf) {
  const Value command = {
      {"do", "tree"},
      {"matrix", leaf.contains("matrix") ? leaf["matrix"] : Value::object()}};
  return Arguments(command).matrix("matrix");
}

void set_matrix(const Matrix& m, Value& leaf) {
  leaf["matrix"] = {m.xx, m.xy, m.yx, m.yy, m.dx, m.dy};
}

void transform_source(const Matrix& matrix, Glyph& glyph) try {
  const double scale = scale_of(matrix);
  if (glyph.lib.contains(kStrokesKey)) {
    if (scale == 0) {
      drop_source(glyph);
    } else {
      for (Value& stroke : glyph.lib[kStrokesKey]) {
        map_stroke(matrix, scale, stroke);
      }
    }
  }
  if (glyph.lib.contains(kTreeKey)) {
    Value& tree = glyph.lib[kTreeKey];
    if (!scale_blends(scale, tree)) {
      glyph.lib.erase(kTreeKey);
      return;
    }
    map_leaves(tree, [&matrix](Value& leaf) {
      set_matrix(product(matrix, matrix_of(leaf)), leaf);
    });
  }
} catch (const Value::exception&) {  // another program's
  drop_source(glyph);
}

}  // namespace inkcell::design
