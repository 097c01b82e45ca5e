#include "editor/spacing.hpp"

#include <cmath>
#include <map>

#include "editor/edits.hpp"
#include "export/tables.hpp"
#include "rom_file.hpp"

namespace inkcell::design::editor {
namespace {

// Both have the same length.
constexpr const char* kLeft = "public.kern1.";
constexpr const char* kRight = "public.kern2.";
const size_t kPrefix = std::string(kLeft).size();

std::string without_prefix(const std::string& group) {
  return group.size() > kPrefix ? group.substr(kPrefix) : std::string();
}

bool is_group(const std::string& name) {
  return name.rfind(kLeft, 0) == 0 || name.rfind(kRight, 0) == 0;
}

}  // namespace

std::vector<PlacedGlyph> line_of_text(const Project& project,
                                      const std::string& text) {
  std::map<char32_t, std::string> names;
  for (const auto& [name, glyph] : project.front().glyphs) {
    for (const char32_t c : glyph->unicodes) {
      names[c] = name;
    }
  }
  const KerningLookup kerning(*project.font);
  std::vector<PlacedGlyph> line;
  double x = 0;
  for (const char32_t c : tools::from_utf8(text)) {
    const auto found = names.find(c);
    if (found == names.end()) {
      continue;
    }
    const double kern =
        line.empty() ? 0 : kerning.value(line.back().name, found->second);
    x += kern;
    line.push_back({found->second, project.find(found->second), x, kern});
    x += line.back().glyph->width;
  }
  return line;
}

double width_of(const std::vector<PlacedGlyph>& line) {
  return line.empty() ? 0 : line.back().x + line.back().glyph->width;
}

Value set_kern(const Project& project,
               const std::string& left,
               const std::string& right,
               double value,
               bool is_exception) {
  auto entry = std::pair(left, right);
  if (!is_exception) {
    entry = KerningLookup(*project.font).entry(left, right);
  }
  Value command = {
      {"do", "set_kerning"}, {"left", entry.first}, {"right", entry.second}};
  // A pair may be an exception of 0 from its groups.
  if (value != 0 || is_exception || !is_group(entry.first) ||
      !is_group(entry.second)) {
    command["value"] = std::round(value);
  }
  return command;
}

std::string kern_text(const std::pair<std::string, std::string>& entry) {
  const auto text = [](const std::string& name) {
    return is_group(name) ? "@" + without_prefix(name) : name;
  };
  return text(entry.first) + "|" + text(entry.second);
}

std::string group_of(const Project& project,
                     const std::string& glyph,
                     bool is_left) {
  const KerningLookup kerning(*project.font);
  return without_prefix(is_left ? kerning.left_group(glyph)
                                : kerning.right_group(glyph));
}

Value join_group(const Project& project,
                 const std::string& glyph,
                 bool is_left,
                 const std::string& group) {
  const std::string prefix = is_left ? kLeft : kRight;
  const std::string old = group_of(project, glyph, is_left);
  if (old == group) {
    return nullptr;
  }
  const Value& groups = project.font->groups;
  const auto set = [&](const std::string& name, bool joins) -> Value {
    Value members = Value::array();
    for (const Value& member : groups.value(prefix + name, Value::array())) {
      if (member != glyph) {
        members.push_back(member);
      }
    }
    if (joins) {
      members.push_back(glyph);
    }
    Value command = {{"do", "set_group"}, {"group", prefix + name}};
    if (!members.empty()) {
      command["value"] = members;
    }
    return command;
  };
  std::vector<Value> commands;
  if (!old.empty()) {
    commands.push_back(set(old, false));
  }
  if (!group.empty()) {
    commands.push_back(set(group, true));
  }
  return batch(std::move(commands));
}

}  // namespace inkcell::design::editor
