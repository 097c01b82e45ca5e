// The command on the space beside glyphs.
#include <algorithm>
#include <cmath>

#include "model/bearings.hpp"
#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "model/sources.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {
namespace {

Matrix moved_by(double dx) {
  Matrix matrix;
  matrix.dx = dx;
  return matrix;
}

void move_ink(double dx, Glyph& glyph) {
  for (PointContour& contour : glyph.contours) {
    for (GlyphPoint& point : contour.points) {
      point.x += dx;
    }
  }
  for (Anchor& anchor : glyph.anchors) {
    anchor.x += dx;
  }
  for (ComponentUse& use : glyph.components) {
    use.matrix.dx += dx;
  }
  if (glyph.image) {
    glyph.image->matrix.dx += dx;
  }
  transform_source(moved_by(dx), glyph);
}

// Glyphs that have `name` as a part stay as they are, although it moves by
// `dx`.
void hold_users(const Project& project,
                size_t layer,
                const std::string& name,
                double dx,
                Change& change) {
  for (const auto& [user_name, user] : project.layers[layer].glyphs) {
    Glyph held = *user;
    for (ComponentUse& use : held.components) {
      if (use.base == name) {
        use.matrix = product(use.matrix, moved_by(-dx));
      }
    }
    if (held.lib.contains(kTreeKey)) {
      map_leaves(held.lib[kTreeKey], [&](Value& leaf) {
        if (leaf["glyph"] == name) {
          set_matrix(product(matrix_of(leaf), moved_by(-dx)), leaf);
        }
      });
    }
    if (user_name != name && !(held == *user)) {
      change.glyphs.push_back({layer, user_name, user,
                               std::make_shared<const Glyph>(std::move(held))});
    }
  }
}

Change set_bearings(const Project& project, const Arguments& arguments) {
  const size_t layer = layer_of(project, arguments);
  double dx = 0;
  Change change = edited(
      project, arguments,
      [&](Glyph& glyph) {
        const auto now = bearings_of(project, glyph, layer);
        if (!now) {
          arguments.refuse("the glyph has no ink; set its advance instead");
        }
        dx = std::round(arguments.number("left", now->left) - now->left);
        const double right =
            std::round(arguments.number("right", now->right) - now->right);
        if (glyph.width + dx + right < 0) {
          arguments.refuse("the advance would be below 0");
        }
        move_ink(dx, glyph);
        glyph.width += dx + right;
      },
      true);
  if (dx != 0) {
    const std::string name = change.glyphs[0].name;  // the list grows
    hold_users(project, layer, name, dx, change);
  }
  return change;
}

}  // namespace

std::optional<Bearings> bearings_of(const Project& project,
                                    const Glyph& glyph,
                                    size_t layer) {
  const gen::Shape shape(outline_of(project, glyph, layer));
  if (shape.empty()) {
    return std::nullopt;
  }
  const double scale = project.units_per_em() / gen::kUPerEm;
  return Bearings{std::round(scale * shape.box().x0),
                  std::round(glyph.width - scale * shape.box().x1)};
}

void add_bearing_commands(CommandTable& table) {
  table["set_bearings"] = set_bearings;
}

}  // namespace inkcell::design
