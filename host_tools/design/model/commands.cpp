#include "model/commands.hpp"

#include "component/tree.hpp"
#include "model/command_table.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {
namespace {

const CommandTable& command_table() {
  static const CommandTable table = [] {
    CommandTable all;
    add_batch_command(all);
    add_bearing_commands(all);
    add_glyph_commands(all);
    add_image_commands(all);
    add_part_commands(all);
    add_point_commands(all);
    add_field_commands(all);
    add_font_commands(all);
    add_source_commands(all);
    add_spacing_command(all);
    add_transform_commands(all);
    add_weight_commands(all);
    return all;
  }();
  return table;
}

}  // namespace

size_t layer_of(const Project& project, const Arguments& arguments) {
  if (!arguments.has("layer")) {
    return 0;
  }
  const std::string name = arguments.text("layer");
  for (size_t i = 0; i < project.layers.size(); ++i) {
    if (project.layers[i].name == name) {
      return i;
    }
  }
  arguments.refuse("there is no layer '" + name + "'");
}

Change own_change_of(const Project& project, const Value& command) {
  const Arguments arguments(command);
  const auto found = command_table().find(arguments.name());
  if (found == command_table().end()) {
    std::string names;
    for (const std::string& name : command_names()) {
      names += (names.empty() ? "" : ", ") + name;
    }
    arguments.refuse("is not known; there are " + names);
  }
  return found->second(project, arguments);
}

Change change_of(const Project& project, const Value& command) {
  const Arguments arguments(command);
  try {
    Change change = own_change_of(project, command);
    follow_parts(project, change);
    return change;
  } catch (const gen::GeometryError& error) {
    arguments.refuse(error.what());
  }
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : command_table()) {
    names.push_back(name);
  }
  return names;
}

}  // namespace inkcell::design
