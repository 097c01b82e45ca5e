#include "editor/masters.hpp"

#include <algorithm>

#include "model/error.hpp"
#include "model/sources.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design::editor {
namespace {

std::string kind_of(const GlyphPoint& point) {
  switch (point.type) {
    case PointType::offcurve:
      return "a handle";
    case PointType::line:
      return "the end of a line";
    case PointType::move:
      return "an open end";
    default:
      return "the end of a curve";
  }
}

// Its name if it has one, or its numbers from 1 on.
std::string name_of(const PointContour& contour, size_t c, size_t p) {
  const std::string& name = contour.points[p].name;
  return "point " + (name.empty() ? std::to_string(p + 1) : "'" + name + "'") +
         " of contour " + std::to_string(c + 1);
}

std::string count_text(size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void compare(const PointContour& a,
             const PointContour& b,
             size_t c,
             const std::string& other,
             std::vector<std::string>& found) {
  const size_t count = std::min(a.points.size(), b.points.size());
  for (size_t p = 0; p < count; ++p) {
    if (a.points[p].type != b.points[p].type) {
      found.push_back(name_of(a, c, p) + ": " + kind_of(a.points[p]) +
                      " here, " + kind_of(b.points[p]) + " in " + other);
    }
  }
  if (a.points.size() != b.points.size()) {
    found.push_back("contour " + std::to_string(c + 1) + ": " +
                    count_text(a.points.size(), "point") + " here, " +
                    std::to_string(b.points.size()) + " in " + other);
  }
}

}  // namespace

std::string master_name(const Project& project, size_t layer) {
  const std::string& name = project.layers[layer].name;
  return name == "public.default" ? "Default" : name;
}

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

std::vector<std::string> mismatches(const Glyph& a,
                                    const Glyph& b,
                                    const std::string& other) {
  std::vector<std::string> found;
  if (a.contours.size() != b.contours.size()) {
    found.push_back(count_text(a.contours.size(), "contour") + " here, " +
                    std::to_string(b.contours.size()) + " in " + other);
  }
  const size_t count = std::min(a.contours.size(), b.contours.size());
  for (size_t c = 0; c < count; ++c) {
    compare(a.contours[c], b.contours[c], c, other, found);
  }
  return found;
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

void Editor::add_master(const std::string& name) {
  const std::vector<Layer>& layers = project().layers;
  const bool is_known =
      std::any_of(layers.begin(), layers.end(),
                  [&name](const Layer& layer) { return layer.name == name; });
  if (name.empty() || is_known) {
    throw Error("a master has a name that no other layer has");
  }
  const std::filesystem::path folder = session_->files().folder;
  const std::string shown = glyph_;
  tool_->cancel(*this);
  session_->save();
  UfoFiles files = session_->files();
  Project changed = project();
  // Names of folders are lower-case ASCII, so that all file systems take them.
  changed.layers.push_back({name,
                            "glyphs.master" + std::to_string(layers.size()),
                            Value::object(), project().front().glyphs});
  write_ufo(changed, folder, files);
  session_->close();
  begin(folder);
  show(shown);
  choose_master(project().layers.size() - 1);
  message = {"Saved with the master " + name + ", whose glyphs are those of " +
             master_name(project(), 0) + " until you change them"};
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
