// Commands on glyphs as a whole.
#include <algorithm>
#include <cmath>

#include "model/command_table.hpp"

namespace inkcell::design {
namespace {

std::vector<char32_t> parse_unicodes(const Arguments& arguments) {
  std::vector<char32_t> unicodes;
  for (const Value& value : arguments.array("unicodes")) {
    if (!value.is_number_unsigned() || value.get<uint64_t>() > 0x10ffff) {
      arguments.refuse("\"unicodes\" are whole numbers up to 1114111");
    }
    unicodes.push_back(value.get<char32_t>());
  }
  return unicodes;
}

Change add_glyph(const Project& project, const Arguments& arguments) {
  GlyphChange change;
  change.layer = layer_of(project, arguments);
  change.name = arguments.text("glyph");
  if (change.name.empty()) {
    arguments.refuse("a glyph has a name");
  }
  if (project.find(change.name, change.layer) != nullptr) {
    arguments.refuse("the glyph exists already");
  }
  Glyph glyph;
  glyph.name = change.name;
  glyph.width = arguments.number("width", 0);
  if (arguments.has("unicodes")) {
    glyph.unicodes = parse_unicodes(arguments);
  }
  change.after = std::make_shared<const Glyph>(std::move(glyph));
  return {{change}, nullptr, nullptr};
}

Change delete_glyph(const Project& project, const Arguments& arguments) {
  Change change = edited(project, arguments, [](Glyph&) {});
  for (const auto& [name, glyph] :
       project.layers[change.glyphs[0].layer].glyphs) {
    for (const ComponentUse& use : glyph->components) {
      if (use.base == change.glyphs[0].name && name != use.base) {
        arguments.refuse("it is a component of '" + name +
                         "'; decompose that first");
      }
    }
  }
  change.glyphs[0].after = nullptr;
  drop_unnamed_images(project, change);
  return change;
}

Change rename_glyph(const Project& project, const Arguments& arguments) {
  const std::string to = arguments.text("to");
  Change change =
      edited(project, arguments, [&to](Glyph& glyph) { glyph.name = to; });
  const size_t layer = change.glyphs[0].layer;
  const std::string from = change.glyphs[0].name;
  if (to.empty() || project.find(to, layer) != nullptr) {
    arguments.refuse("\"to\" is a name that no glyph has yet");
  }
  change.glyphs.push_back({layer, to, nullptr, change.glyphs[0].after});
  change.glyphs[0].after = nullptr;
  for (const auto& [name, glyph] : project.layers[layer].glyphs) {
    const auto refers = [&from](const ComponentUse& use) {
      return use.base == from;
    };
    if (name == from || std::none_of(glyph->components.begin(),
                                     glyph->components.end(), refers)) {
      continue;
    }
    Glyph user = *glyph;
    for (ComponentUse& use : user.components) {
      use.base = refers(use) ? to : use.base;
    }
    change.glyphs.push_back(
        {layer, name, glyph, std::make_shared<const Glyph>(std::move(user))});
  }
  return change;
}

Change set_advance(const Project& project, const Arguments& arguments) {
  const double width = arguments.number("width");
  return edited(project, arguments,
                [width](Glyph& glyph) { glyph.width = width; });
}

Change set_unicodes(const Project& project, const Arguments& arguments) {
  const std::vector<char32_t> unicodes = parse_unicodes(arguments);
  return edited(project, arguments,
                [&unicodes](Glyph& glyph) { glyph.unicodes = unicodes; });
}

Change set_glyph_lib(const Project& project, const Arguments& arguments) {
  const std::string key = arguments.text("key");
  return edited(project, arguments, [&](Glyph& glyph) {
    if (arguments.has("value")) {
      glyph.lib[key] = arguments.value("value");
    } else {
      glyph.lib.erase(key);
    }
  });
}

Change transform(const Project& project, const Arguments& arguments) {
  const Matrix matrix = arguments.matrix("matrix");
  const bool round = arguments.flag("round", true);
  const auto snap = [round](double v) { return round ? std::round(v) : v; };
  return edited(project, arguments, [&](Glyph& glyph) {
    for (PointContour& contour : glyph.contours) {
      for (GlyphPoint& point : contour.points) {
        const gen::Point to = matrix.map(point.x, point.y);
        point.x = snap(to.x);
        point.y = snap(to.y);
      }
    }
    for (Anchor& anchor : glyph.anchors) {
      const gen::Point to = matrix.map(anchor.x, anchor.y);
      anchor.x = snap(to.x);
      anchor.y = snap(to.y);
    }
    for (ComponentUse& use : glyph.components) {
      use.matrix = product(matrix, use.matrix);
    }
  });
}

}  // namespace

void add_glyph_commands(CommandTable& table) {
  table["add_glyph"] = add_glyph;
  table["delete_glyph"] = delete_glyph;
  table["rename_glyph"] = rename_glyph;
  table["set_advance"] = set_advance;
  table["set_glyph_lib"] = set_glyph_lib;
  table["set_unicodes"] = set_unicodes;
  table["transform"] = transform;
}

}  // namespace inkcell::design
