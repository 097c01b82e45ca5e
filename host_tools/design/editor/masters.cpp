#include "editor/masters.hpp"

#include <algorithm>

#include "model/error.hpp"
#include "model/sources.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design::editor {
std::optional<size_t> other_master(const Editor& editor) {
  if (editor.master() != 0) {
    return 0;
  }
  for (size_t i = 1; i < editor.project().layers.size(); ++i) {
    if (editor.project().find(editor.glyph_name(), i) != nullptr) {
      return i;
    }
  }
  return std::nullopt;
}

Glyph between(const Glyph& a, const Glyph& b, double part) {
  Glyph result = a;
  const auto mix = [part](double from, double to) {
    return from + part * (to - from);
  };
  result.width = mix(a.width, b.width);
  for (size_t c = 0; c < a.contours.size(); ++c) {
    for (size_t p = 0; p < a.contours[c].points.size(); ++p) {
      GlyphPoint& point = result.contours[c].points[p];
      const GlyphPoint& to = b.contours[c].points[p];
      point.x = mix(point.x, to.x);
      point.y = mix(point.y, to.y);
    }
  }
  return result;
}

size_t Editor::master(const std::string& glyph) const {
  const bool is_there = layer_ < project().layers.size() &&
                        project().find(glyph, layer_) != nullptr;
  return is_there ? layer_ : 0;
}

void Editor::choose_master(size_t layer) {
  tool_->cancel(*this);
  layer_ = layer;
  part_between = 0;
  had_source_ = has_source(*stored());
  select_nothing();
}

// Writes the project with other layers, and opens it again.
void Editor::write_layers(const Project& changed) {
  const std::filesystem::path folder = session_->files().folder;
  const std::string shown = glyph_;
  UfoFiles files = session_->files();
  write_ufo(changed, folder, files);
  session_->close();
  begin(folder);
  show(shown);
}

void Editor::remove_master(const std::string& name) {
  const std::vector<Layer>& layers = project().layers;
  const auto found =
      std::find_if(layers.begin() + 1, layers.end(),
                   [&name](const Layer& layer) { return layer.name == name; });
  if (found == layers.end()) {
    throw Error("there is no other master '" + name + "'");
  }
  const auto index = found - layers.begin();
  run({{"do", "set_axes"}});  // its places are gone, too
  choose_master(0);
  session_->save();
  Project changed = project();
  changed.layers.erase(changed.layers.begin() + index);
  write_layers(changed);
  message = {"Saved without the master " + name};
}

void Editor::add_master(const std::string& name, double bolder) {
  const std::vector<Layer>& layers = project().layers;
  const bool is_known =
      std::any_of(layers.begin(), layers.end(),
                  [&name](const Layer& layer) { return layer.name == name; });
  if (name.empty() || is_known) {
    throw Error("a master has a name that no other layer has");
  }
  tool_->cancel(*this);
  session_->save();
  Project changed = project();
  // Names of folders are lower-case ASCII, so that all file systems take them.
  size_t number = layers.size();
  const auto is_taken = [&number](const Layer& layer) {
    return layer.folder == "glyphs.master" + std::to_string(number);
  };
  while (std::any_of(layers.begin(), layers.end(), is_taken)) {
    ++number;
  }
  changed.layers.push_back({name, "glyphs.master" + std::to_string(number),
                            Value::object(), project().front().glyphs});
  write_layers(changed);
  choose_master(project().layers.size() - 1);
  message = {"Saved with the master " + name + ", whose glyphs are those of " +
             master_name(project(), 0) + " until you change them"};
  if (bolder != 0) {
    // Without a question: strokes and parts stay in the default master.
    session_->run({{"do", "change_weight"},
                   {"glyphs", "all"},
                   {"layer", name},
                   {"by", bolder}});
    follow_change();
    message = {"The master " + name + " has stems that are wider by " +
               std::to_string(std::lround(bolder)) + " units"};
  }
}

std::optional<Glyph> Editor::glyph_between() const {
  const auto other = other_master(*this);
  if (!other || part_between <= 0) {
    return std::nullopt;
  }
  const GlyphPointer a = glyph();
  const GlyphPointer b = project().find(glyph_, *other);
  return mismatches(*a, *b, "").empty()
             ? std::optional<Glyph>(between(*a, *b, part_between))
             : std::nullopt;
}

}  // namespace inkcell::design::editor
