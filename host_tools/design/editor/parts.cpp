#include "editor/parts.hpp"

#include "editor/edits.hpp"
#include "editor/segments.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

// Removes the leaf of this number. An operator with one part left becomes that
// part. True if `node` itself is to go.
bool remove_leaf(Value& node, size_t& number) {
  if (node.contains("glyph")) {
    return number-- == 0;
  }
  Value& parts = node["parts"];
  for (size_t i = 0; i < parts.size(); ++i) {
    if (remove_leaf(parts[i], number)) {
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  if (parts.size() == 1) {
    const Value left = parts[0];
    node = left;
  }
  return false;
}

}  // namespace

bool has_tree(const Glyph& glyph) {
  return glyph.lib.contains(kTreeKey);
}

std::vector<Value> parts_of(const Glyph& glyph) {
  std::vector<Value> parts;
  Value tree = glyph.lib.value(kTreeKey, Value());
  map_leaves(tree, [&parts](const Value& leaf) { parts.push_back(leaf); });
  return parts;
}

std::vector<PointContour> contours_of_part(const Project& project,
                                           const Value& part) {
  ComponentUse use;
  use.base = part.value("glyph", "");
  use.matrix = matrix_of(part);
  std::vector<PointContour> contours;
  append_component(project, 0, use, contours);
  return contours;
}

std::optional<size_t> part_at(const Project& project,
                              const Glyph& glyph,
                              Point at) {
  const std::vector<Value> parts = parts_of(glyph);
  for (size_t i = parts.size(); i-- > 0;) {
    if (is_inside(contours_of_part(project, parts[i]), at)) {
      return i;
    }
  }
  return std::nullopt;
}

Value set_tree(const Value& tree) {
  return {{"do", "set_tree"}, {"tree", tree}};
}

Value map_part(const Glyph& glyph, size_t part, const Matrix& matrix) {
  Value tree = glyph.lib[kTreeKey];
  size_t number = 0;
  map_leaves(tree, [&](Value& leaf) {
    if (number++ == part) {
      set_matrix(product(matrix, matrix_of(leaf)), leaf);
    }
  });
  return set_tree(tree);
}

Value delete_part(const Glyph& glyph, size_t part) {
  Value tree = glyph.lib[kTreeKey];
  remove_leaf(tree, part);
  if (!tree.contains("parts")) {
    throw Error("a combination has two parts or more; turn it into an outline");
  }
  return set_tree(tree);
}

Value add_part(const Glyph& glyph, const std::string& base) {
  Value tree = glyph.lib[kTreeKey];
  tree["parts"].push_back({{"glyph", base}});
  return set_tree(tree);
}

Value combine_components(const Glyph& glyph) {
  if (glyph.components.size() < 2 || !glyph.contours.empty()) {
    throw Error(
        "glyphs are combined from two components or more, without contours; "
        "add them with \"Add component\"");
  }
  Value parts = Value::array();
  std::vector<Value> commands;
  for (size_t i = glyph.components.size(); i-- > 0;) {
    commands.push_back({{"do", "delete_component"}, {"component", i}});
  }
  for (const ComponentUse& use : glyph.components) {
    Value leaf = {{"glyph", use.base}};
    set_matrix(use.matrix, leaf);
    parts.push_back(leaf);
  }
  commands.push_back(set_tree({{"op", "union"}, {"parts", parts}}));
  return batch(std::move(commands));
}

}  // namespace inkcell::design::editor
