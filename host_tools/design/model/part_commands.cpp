// Commands on contours, components, anchors and guidelines.
#include <algorithm>

#include "model/command_table.hpp"
#include "model/contours.hpp"

namespace inkcell::design {
namespace {

template <typename Item>
void insert_at(std::vector<Item>& items, size_t place, Item item) {
  items.insert(items.begin() + static_cast<std::ptrdiff_t>(place),
               std::move(item));
}

template <typename Item>
void erase_at(std::vector<Item>& items, size_t place) {
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(place));
}

Change add_contour(const Project& project, const Arguments& arguments) {
  const PointContour contour = parse_contour(arguments.array("points"));
  return edited(project, arguments, [&](Glyph& glyph) {
    const size_t at = arguments.has("at")
                          ? arguments.place("at", glyph.contours.size())
                          : own_contours(glyph);
    insert_at(glyph.contours, at, contour);
  });
}

Change delete_contour(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    erase_at(glyph.contours, arguments.index("contour", glyph.contours.size()));
  });
}

Change reverse_contour(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    PointContour& contour =
        glyph.contours[arguments.index("contour", glyph.contours.size())];
    contour = reversed(contour);
  });
}

Change set_contours(const Project& project, const Arguments& arguments) {
  std::vector<PointContour> contours;
  for (const Value& points : arguments.array("contours")) {
    contours.push_back(parse_contour(points));
  }
  return edited(project, arguments,
                [&](Glyph& glyph) { glyph.contours = contours; });
}

Change add_component(const Project& project, const Arguments& arguments) {
  ComponentUse use;
  use.base = arguments.text("base");
  use.matrix = arguments.matrix("matrix");
  const size_t layer = layer_of(project, arguments);
  if (reaches(project, layer, use.base, arguments.text("glyph"))) {
    arguments.refuse("'" + use.base +
                     "' is made of this glyph; a glyph cannot contain itself");
  }
  return edited(project, arguments, [&](Glyph& glyph) {
    insert_at(glyph.components, arguments.place("at", glyph.components.size()),
              use);
  });
}

Change delete_component(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    erase_at(glyph.components,
             arguments.index("component", glyph.components.size()));
  });
}

Change set_component(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    glyph.components[arguments.index("component", glyph.components.size())]
        .matrix = arguments.matrix("matrix");
  });
}

Change decompose(const Project& project, const Arguments& arguments) {
  const size_t layer = layer_of(project, arguments);
  return edited(project, arguments, [&](Glyph& glyph) {
    std::vector<PointContour> contours = glyph.contours;
    for (const ComponentUse& use : glyph.components) {
      append_component(project, layer, use, contours);
    }
    glyph.contours = std::move(contours);
    glyph.components.clear();
  });
}

Change add_anchor(const Project& project, const Arguments& arguments) {
  Anchor anchor;
  anchor.name = arguments.text("name");
  anchor.x = arguments.number("x");
  anchor.y = arguments.number("y");
  return edited(project, arguments,
                [&](Glyph& glyph) { glyph.anchors.push_back(anchor); });
}

Change delete_anchor(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    erase_at(glyph.anchors, arguments.index("anchor", glyph.anchors.size()));
  });
}

// Moves a guideline to "x", "y" and "angle".
void place_guideline(const Arguments& arguments, Guideline& line) {
  line.x.reset();
  line.y.reset();
  line.angle.reset();
  if (arguments.has("x")) {
    line.x = arguments.number("x");
  }
  if (arguments.has("y") || !arguments.has("x")) {
    line.y = arguments.number("y");
  }
  if (line.x && line.y) {
    line.angle = arguments.number("angle", 0);
  }
}

Change add_guideline(const Project& project, const Arguments& arguments) {
  Guideline line;
  place_guideline(arguments, line);
  line.name = arguments.text("name", "");
  return edited(project, arguments,
                [&](Glyph& glyph) { glyph.guidelines.push_back(line); });
}

Change set_guideline(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    place_guideline(arguments, glyph.guidelines[arguments.index(
                                   "guideline", glyph.guidelines.size())]);
  });
}

Change delete_guideline(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    erase_at(glyph.guidelines,
             arguments.index("guideline", glyph.guidelines.size()));
  });
}

}  // namespace

void add_part_commands(CommandTable& table) {
  table["add_anchor"] = add_anchor;
  table["add_component"] = add_component;
  table["add_contour"] = add_contour;
  table["add_guideline"] = add_guideline;
  table["decompose"] = decompose;
  table["delete_anchor"] = delete_anchor;
  table["delete_component"] = delete_component;
  table["delete_contour"] = delete_contour;
  table["delete_guideline"] = delete_guideline;
  table["reverse_contour"] = reverse_contour;
  table["set_component"] = set_component;
  table["set_contours"] = set_contours;
  table["set_guideline"] = set_guideline;
}

}  // namespace inkcell::design
