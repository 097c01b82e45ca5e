#include "component/tree.hpp"

#include <cmath>
#include <set>

#include "component/contour_blend.hpp"
#include "component/contour_csg.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {
namespace {

constexpr int kMostDepth = 16;

std::vector<PointContour> contours_of_node(const Project& project,
                                           size_t layer,
                                           const Value& node,
                                           int depth);

std::vector<PointContour> contours_of_leaf(const Project& project,
                                           size_t layer,
                                           const Value& leaf) {
  ComponentUse use;
  use.base = leaf.at("glyph").get<std::string>();
  use.matrix = matrix_of(leaf);
  std::vector<PointContour> contours;
  append_component(project, layer, use, contours);
  for (PointContour& contour : contours) {
    for (GlyphPoint& point : contour.points) {
      point.x = std::round(point.x);
      point.y = std::round(point.y);
    }
  }
  return contours;
}

std::vector<PointContour> contours_of_operator(const Project& project,
                                               size_t layer,
                                               const Value& node,
                                               int depth) {
  static const std::set<std::string> kNames = {
      "union", "intersection", "difference", "exclusion", "blend"};
  const std::string op = node.value("op", "");
  if (kNames.count(op) == 0) {
    throw Error("operator '" + op +
                "' of a tree is not known; use union, intersection, "
                "difference, exclusion or blend");
  }
  const double radius = node.value("radius", 0.0);
  if (op == "blend" && !(radius > 0)) {
    throw Error("a blend has a \"radius\" above 0, in font units");
  }
  const Value& parts = node.at("parts");
  if (!parts.is_array() || parts.size() < 2) {
    throw Error("\"" + op + "\" of a tree has two or more \"parts\"");
  }
  std::vector<PointContour> sum =
      contours_of_node(project, layer, parts[0], depth - 1);
  for (size_t i = 1; i < parts.size(); ++i) {
    const std::vector<PointContour> part =
        contours_of_node(project, layer, parts[i], depth - 1);
    sum = op == "blend" ? blended(sum, part, radius,
                                  gen::kUPerEm / project.units_per_em())
                        : combined(sum, part, op);
  }
  return sum;
}

std::vector<PointContour> contours_of_node(const Project& project,
                                           size_t layer,
                                           const Value& node,
                                           int depth) {
  if (depth == 0) {
    throw Error("a tree of shapes is at most 16 levels deep");
  }
  try {
    return node.is_object() && node.contains("glyph")
               ? contours_of_leaf(project, layer, node)
               : contours_of_operator(project, layer, node, depth);
  } catch (const Value::exception& error) {
    throw Error(std::string("a tree of shapes is { \"op\", \"parts\" } or { "
                            "\"glyph\", \"matrix\" }: ") +
                error.what());
  }
}

bool has_same_tree(const GlyphChange& change) {
  const auto tree = [](const GlyphPointer& glyph) {
    return glyph == nullptr ? Value() : glyph->lib.value(kTreeKey, Value());
  };
  return tree(change.before) == tree(change.after);
}

bool has_same_ink(const GlyphChange& change) {
  return change.before != nullptr && change.after != nullptr &&
         change.before->contours == change.after->contours &&
         change.before->components == change.after->components;
}

// Whether a leaf is one of these glyphs, or has one as a component.
bool depends(const Project& project,
             size_t layer,
             const Glyph& glyph,
             const std::set<std::string>& names) {
  bool found = false;
  Value tree = glyph.lib[kTreeKey];
  map_leaves(tree, [&](const Value& leaf) {
    const Value& base = leaf["glyph"];
    for (const std::string& name : names) {
      found = found || (base.is_string() &&
                        reaches(project, layer, base.get<std::string>(), name));
    }
  });
  return found;
}

// Refuses a glyph that is a part of itself; `users` are those it is in.
void check_parts(const Project& project,
                 size_t layer,
                 const std::string& name,
                 std::set<std::string> users) {
  if (!users.insert(name).second) {
    throw Error("glyph '" + name + "' is a part of itself");
  }
  const GlyphPointer glyph = project.find(name, layer);
  if (glyph == nullptr) {
    return;
  }
  for (const ComponentUse& use : glyph->components) {
    check_parts(project, layer, use.base, users);
  }
  Value tree = glyph->lib.value(kTreeKey, Value());
  map_leaves(tree, [&](const Value& leaf) {
    if (leaf["glyph"].is_string()) {
      check_parts(project, layer, leaf["glyph"].get<std::string>(), users);
    }
  });
}

// The glyph with the contours of its tree.
GlyphPointer made_anew(const Project& project,
                       size_t layer,
                       const Glyph& glyph) {
  Glyph made = glyph;
  made.contours = in_direction_of(
      project, glyph, contours_of_tree(project, layer, glyph.lib[kTreeKey]));
  return std::make_shared<const Glyph>(std::move(made));
}

GlyphChange& entry_of(const Project& project,
                      size_t layer,
                      const std::string& name,
                      Change& change) {
  for (GlyphChange& entry : change.glyphs) {
    if (entry.layer == layer && entry.name == name) {
      return entry;
    }
  }
  const GlyphPointer now = project.find(name, layer);
  change.glyphs.push_back({layer, name, now, now});
  return change.glyphs.back();
}

void follow_in_layer(const Project& project, size_t layer, Change& change) {
  std::set<std::string> trees;  // those that changed
  std::set<std::string> moved;  // glyphs whose ink changed
  for (const GlyphChange& entry : change.glyphs) {
    if (entry.layer == layer) {
      if (entry.after != nullptr && entry.after->lib.contains(kTreeKey) &&
          !has_same_tree(entry)) {
        trees.insert(entry.name);
      }
      if (!has_same_ink(entry)) {
        moved.insert(entry.name);
      }
    }
  }
  Project state = project;
  state.apply(change);
  for (const std::string& name : trees) {
    check_parts(state, layer, name, {});
  }
  while (!trees.empty() || !moved.empty()) {
    for (const auto& [name, glyph] : state.layers[layer].glyphs) {
      if (glyph->lib.contains(kTreeKey) &&
          depends(state, layer, *glyph, moved)) {
        trees.insert(name);
      }
    }
    moved.clear();
    for (const std::string& name : trees) {
      GlyphChange& entry = entry_of(state, layer, name, change);
      const GlyphPointer made =
          made_anew(state, layer, *state.find(name, layer));
      if (!(made->contours == state.find(name, layer)->contours)) {
        moved.insert(name);
      }
      entry.after = made;
      state.layers[layer].glyphs[name] = made;
    }
    trees.clear();
  }
}

}  // namespace

std::vector<PointContour> contours_of_tree(const Project& project,
                                           size_t layer,
                                           const Value& tree) {
  return contours_of_node(project, layer, tree, kMostDepth);
}

void follow_parts(const Project& project, Change& change) {
  std::set<size_t> layers;
  for (const GlyphChange& entry : change.glyphs) {
    layers.insert(entry.layer);
  }
  for (const size_t layer : layers) {
    follow_in_layer(project, layer, change);
  }
}

}  // namespace inkcell::design
