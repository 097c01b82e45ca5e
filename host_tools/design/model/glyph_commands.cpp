// Commands on glyphs as a whole.
#include <algorithm>

#include "model/command_table.hpp"
#include "model/glyph_names.hpp"
#include "ufo/glif.hpp"

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

// The character that the name says, unless another glyph has it.
std::vector<char32_t> usual_unicodes(const Layer& layer,
                                     const std::string& name) {
  const std::optional<char32_t> c = character_of_name(name);
  const bool is_free =
      c &&
      std::none_of(
          layer.glyphs.begin(), layer.glyphs.end(), [c](const auto& entry) {
            const auto& codes = entry.second->unicodes;
            return std::find(codes.begin(), codes.end(), *c) != codes.end();
          });
  return is_free ? std::vector<char32_t>{*c} : std::vector<char32_t>();
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
  glyph.unicodes =
      arguments.has("unicodes")
          ? parse_unicodes(arguments)
          : usual_unicodes(project.layers[change.layer], change.name);
  change.after = std::make_shared<const Glyph>(std::move(glyph));
  return {{change}, nullptr, nullptr};
}

Change delete_glyph(const Project& project, const Arguments& arguments) {
  Change change = edited(project, arguments, [](Glyph&) {});
  for (const auto& entry : project.layers[change.glyphs[0].layer].glyphs) {
    const std::string& name = entry.first;
    const std::shared_ptr<const Glyph>& glyph = entry.second;
    for (const ComponentUse& use : glyph->components) {
      if (use.base == change.glyphs[0].name && name != use.base) {
        arguments.refuse("it is a component of '" + name +
                         "'; decompose that first");
      }
    }
    Value tree = glyph->lib.value(kTreeKey, Value());
    map_leaves(tree, [&](const Value& leaf) {
      if (leaf["glyph"] == change.glyphs[0].name &&
          name != change.glyphs[0].name) {
        arguments.refuse("it is a part of '" + name +
                         "'; turn that into an outline first");
      }
    });
  }
  change.glyphs[0].after = nullptr;
  drop_unnamed_images(project, change);
  return change;
}

// The font's data with another name in the place of a glyph's: in groups,
// kerning and the order of glyphs.
FontData renamed(FontData font,
                 const std::string& from,
                 const std::string& to) {
  const auto rename_in = [&](Value& list) {
    for (Value& name : list) {
      name = name == from ? Value(to) : name;
    }
  };
  const auto rename_key = [&](Value& table) {
    if (table.is_object() && table.contains(from)) {
      table[to] = table[from];
      table.erase(from);
    }
  };
  for (auto& [group, names] : font.groups.items()) {
    rename_in(names);
  }
  rename_key(font.kerning);
  for (auto& [left, row] : font.kerning.items()) {
    rename_key(row);
  }
  const auto order = font.lib.find("public.glyphOrder");
  if (order != font.lib.end() && order->is_array()) {
    rename_in(*order);
  }
  return font;
}

// The names in a tree of shapes.
void rename_in_tree(Value& node,
                    const std::string& from,
                    const std::string& to) {
  if (node.is_object()) {
    for (auto& [key, value] : node.items()) {
      if (key == "glyph" && value == from) {
        value = to;
      } else {
        rename_in_tree(value, from, to);
      }
    }
  } else if (node.is_array()) {
    for (Value& part : node) {
      rename_in_tree(part, from, to);
    }
  }
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
    Glyph user = *glyph;
    for (ComponentUse& use : user.components) {
      use.base = use.base == from ? to : use.base;
    }
    if (user.lib.contains(kTreeKey)) {
      rename_in_tree(user.lib[kTreeKey], from, to);
    }
    if (name != from && !(user == *glyph)) {
      change.glyphs.push_back(
          {layer, name, glyph, std::make_shared<const Glyph>(std::move(user))});
    }
  }
  FontData font = renamed(*project.font, from, to);
  if (layer == 0 && !(font == *project.font)) {
    change.font_before = project.font;
    change.font_after = std::make_shared<const FontData>(std::move(font));
  }
  return change;
}

Change set_advance(const Project& project, const Arguments& arguments) {
  const double width = arguments.number("width");
  if (width < 0) {
    arguments.refuse("the advance would be below 0");
  }
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

// The glyph as it was, for undo by glyph.
Change set_glyph(const Project& project, const Arguments& arguments) {
  return edited(
      project, arguments,
      [&](Glyph& glyph) {
        const std::string name = glyph.name;
        glyph = parse_glif(arguments.text("glif"), "\"glif\" of " + name);
        glyph.name = name;
      },
      true);
}

}  // namespace

void add_glyph_commands(CommandTable& table) {
  table["add_glyph"] = add_glyph;
  table["delete_glyph"] = delete_glyph;
  table["rename_glyph"] = rename_glyph;
  table["set_advance"] = set_advance;
  table["set_glyph"] = set_glyph;
  table["set_glyph_lib"] = set_glyph_lib;
  table["set_unicodes"] = set_unicodes;
}

}  // namespace inkcell::design
