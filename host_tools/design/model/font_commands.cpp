// Commands on the font as a whole.
#include "model/command_table.hpp"
#include "model/masters.hpp"

namespace inkcell::design {
namespace {

template <typename Edit>
Change edited_font(const Project& project, const Edit& edit) {
  FontData data = *project.font;
  edit(data);
  Change change;
  change.font_before = project.font;
  change.font_after = std::make_shared<const FontData>(std::move(data));
  return change;
}

void set_or_erase(const Arguments& arguments,
                  const std::string& key,
                  Value& dictionary) {
  if (arguments.has("value")) {
    dictionary[key] = arguments.value("value");
  } else {
    dictionary.erase(key);
  }
}

Change set_info(const Project& project, const Arguments& arguments) {
  return edited_font(project, [&](FontData& font) {
    set_or_erase(arguments, arguments.text("key"), font.info);
  });
}

Change set_lib(const Project& project, const Arguments& arguments) {
  return edited_font(project, [&](FontData& font) {
    set_or_erase(arguments, arguments.text("key"), font.lib);
  });
}

Change set_group(const Project& project, const Arguments& arguments) {
  if (arguments.has("value")) {
    for (const Value& name : arguments.array("value")) {
      if (!name.is_string()) {
        arguments.refuse("\"value\" lists names of glyphs");
      }
    }
  }
  return edited_font(project, [&](FontData& font) {
    set_or_erase(arguments, arguments.text("group"), font.groups);
  });
}

Change set_kerning(const Project& project, const Arguments& arguments) {
  const std::string left = arguments.text("left");
  const std::string right = arguments.text("right");
  if (arguments.has("value")) {
    arguments.number("value");
  }
  return edited_font(project, [&](FontData& font) {
    set_or_erase(arguments, right, font.kerning[left]);
    if (font.kerning[left].empty()) {
      font.kerning.erase(left);
    }
  });
}

Change set_features(const Project& project, const Arguments& arguments) {
  return edited_font(
      project, [&](FontData& font) { font.features = arguments.text("text"); });
}

Change set_axes(const Project& project, const Arguments& arguments) {
  Value axes = Value::object();
  for (const char* key : {"axes", "masters", "instances"}) {
    if (arguments.has(key)) {
      axes[key] = arguments.value(key);
    }
  }
  if (!axes.empty()) {
    try {
      parse_axes(project, axes);
    } catch (const std::exception& error) {
      arguments.refuse(error.what());
    }
  }
  return edited_font(project, [&](FontData& font) {
    if (axes.empty()) {
      font.lib.erase(kAxesKey);
    } else {
      font.lib[kAxesKey] = axes;
    }
  });
}

}  // namespace

void add_font_commands(CommandTable& table) {
  table["set_axes"] = set_axes;
  table["set_features"] = set_features;
  table["set_group"] = set_group;
  table["set_info"] = set_info;
  table["set_kerning"] = set_kerning;
  table["set_lib"] = set_lib;
}

}  // namespace inkcell::design
