#include "model/project.hpp"

#include <algorithm>
#include <tuple>

#include "model/error.hpp"

namespace inkcell::design {
namespace {

constexpr double kUsualUnitsPerEm = 1000;

auto fields(const FontData& f) {
  return std::tie(f.info, f.groups, f.kerning, f.lib, f.features);
}

void set_glyph(Project& project,
               const GlyphChange& change,
               const GlyphPointer& glyph) {
  auto& glyphs = project.layers.at(change.layer).glyphs;
  if (glyph == nullptr) {
    glyphs.erase(change.name);
  } else {
    glyphs[change.name] = glyph;
  }
}

}  // namespace

bool operator==(const FontData& a, const FontData& b) {
  return fields(a) == fields(b) &&
         std::equal(a.images.begin(), a.images.end(), b.images.begin(),
                    b.images.end(), [](const auto& x, const auto& y) {
                      return x.first == y.first && *x.second == *y.second;
                    });
}

Project::Project() : font(std::make_shared<FontData>()) {
  layers.push_back({"public.default", "glyphs", Value::object(), {}});
}

GlyphPointer Project::find(const std::string& glyph, size_t layer) const {
  const auto& glyphs = layers.at(layer).glyphs;
  const auto found = glyphs.find(glyph);
  return found == glyphs.end() ? nullptr : found->second;
}

GlyphPointer Project::glyph(const std::string& name, size_t layer) const {
  GlyphPointer found = find(name, layer);
  if (found == nullptr) {
    throw Error("there is no glyph '" + name + "' in the layer '" +
                layers.at(layer).name + "'");
  }
  return found;
}

double Project::units_per_em() const {
  const auto found = font->info.find("unitsPerEm");
  const double units = found != font->info.end() && found->is_number()
                           ? found->get<double>()
                           : kUsualUnitsPerEm;
  return units > 0 ? units : kUsualUnitsPerEm;
}

void Project::apply(const Change& change) {
  for (const GlyphChange& glyph : change.glyphs) {
    set_glyph(*this, glyph, glyph.after);
  }
  if (change.font_after != nullptr) {
    font = change.font_after;
  }
}

void Project::revert(const Change& change) {
  for (auto glyph = change.glyphs.rbegin(); glyph != change.glyphs.rend();
       ++glyph) {
    set_glyph(*this, *glyph, glyph->before);
  }
  if (change.font_before != nullptr) {
    font = change.font_before;
  }
}

std::set<std::string> image_names(const Project& project) {
  std::set<std::string> names;
  for (const Layer& layer : project.layers) {
    for (const auto& [name, glyph] : layer.glyphs) {
      if (glyph->image) {
        names.insert(glyph->image->file);
      }
    }
  }
  return names;
}

std::vector<std::string> glyph_order(const Project& project) {
  std::vector<std::string> names;
  std::set<std::string> listed;
  const auto order = project.font->lib.find("public.glyphOrder");
  if (order != project.font->lib.end() && order->is_array()) {
    for (const Value& name : *order) {
      if (name.is_string() && project.find(name.get<std::string>()) &&
          listed.insert(name.get<std::string>()).second) {
        names.push_back(name.get<std::string>());
      }
    }
  }
  for (const auto& [name, glyph] : project.front().glyphs) {
    if (listed.count(name) == 0) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace inkcell::design
