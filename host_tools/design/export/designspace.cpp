#include "export/designspace.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "app/output.hpp"
#include "model/error.hpp"
#include "model/masters.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

// "Regular" for the default layer.
std::string style_of(const Project& project, size_t layer) {
  return layer == 0 ? project.font->info.value("styleName", "Regular")
                    : project.layers[layer].name;
}

// The master as a font of its own; glyphs that it lacks are the default's.
Project master_of(const Project& project, size_t layer) {
  Project master;
  FontData font = *project.font;
  font.info["styleName"] = style_of(project, layer);
  font.lib.erase(kAxesKey);
  master.font = std::make_shared<const FontData>(std::move(font));
  master.front().glyphs = project.layers[layer].glyphs;
  const auto& others = project.front().glyphs;
  master.front().glyphs.insert(others.begin(), others.end());
  return master;
}

void check_difference(const Project& project, size_t layer) {
  for (const auto& [name, glyph] : project.layers[layer].glyphs) {
    const GlyphPointer other = project.find(name);
    if (layer == 0 || other == nullptr || !(*glyph == *other)) {
      return;
    }
  }
  throw Error("the master " + master_name(project, layer) + " is the same as " +
              master_name(project, 0) +
              ": nothing would vary; change it, or leave it out of the axis");
}

void check_correspondence(const Project& project, size_t layer) {
  for (const auto& [name, glyph] : project.layers[layer].glyphs) {
    const GlyphPointer other = project.find(name);
    const std::vector<std::string> found =
        other == nullptr
            ? std::vector<std::string>{"it is in this master alone"}
            : mismatches(*glyph, *other, master_name(project, 0));
    if (!found.empty()) {
      throw Error("glyph '" + name + "' of the master " +
                  master_name(project, layer) + ": " + found.front());
    }
  }
}

void add_place(pugi::xml_node parent,
               const Axes& axes,
               const AxisPlace& place) {
  pugi::xml_node location = parent.append_child("location");
  for (const Axis& axis : axes.axes) {
    pugi::xml_node dimension = location.append_child("dimension");
    dimension.append_attribute("name") = axis.name.c_str();
    dimension.append_attribute("xvalue") = place.at(axis.tag);
  }
}

void add_axes(pugi::xml_node root, const Axes& axes) {
  pugi::xml_node list = root.append_child("axes");
  for (const Axis& axis : axes.axes) {
    const double usual = axes.masters.front().place.at(axis.tag);
    double low = usual;
    double high = usual;
    for (const Axes::Master& master : axes.masters) {
      low = std::min(low, master.place.at(axis.tag));
      high = std::max(high, master.place.at(axis.tag));
    }
    pugi::xml_node node = list.append_child("axis");
    node.append_attribute("tag") = axis.tag.c_str();
    node.append_attribute("name") = axis.name.c_str();
    node.append_attribute("minimum") = low;
    node.append_attribute("maximum") = high;
    node.append_attribute("default") = usual;
  }
}

}  // namespace

void write_designspace(const Project& project, const fs::path& file) {
  const Axes axes = axes_of(project);
  const std::string family = project.font->info.value("familyName", "Font");
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("designspace");
  root.append_attribute("format") = "4.1";
  add_axes(root, axes);
  pugi::xml_node sources = root.append_child("sources");
  for (const Axes::Master& master : axes.masters) {
    check_difference(project, master.layer);
    check_correspondence(project, master.layer);
    const std::string style = style_of(project, master.layer);
    const fs::path folder = file.stem().string() + "-" + style + ".ufo";
    UfoFiles files;
    write_ufo(master_of(project, master.layer), file.parent_path() / folder,
              files);
    pugi::xml_node source = sources.append_child("source");
    source.append_attribute("filename") = folder.string().c_str();
    source.append_attribute("name") = style.c_str();
    source.append_attribute("familyname") = family.c_str();
    source.append_attribute("stylename") = style.c_str();
    if (master.layer == 0) {
      for (const char* kind : {"lib", "groups", "features", "info"}) {
        source.append_child(kind).append_attribute("copy") = "1";
      }
    }
    add_place(source, axes, master.place);
  }
  pugi::xml_node instances = root.append_child("instances");
  for (const Axes::Instance& instance : axes.instances) {
    pugi::xml_node node = instances.append_child("instance");
    node.append_attribute("familyname") = family.c_str();
    node.append_attribute("stylename") = instance.name.c_str();
    node.append_attribute("name") = instance.name.c_str();
    add_place(node, axes, instance.place);
  }
  std::ostringstream text;
  document.save(text, "  ");
  gen::OutputFile out(file);
  out.write(text.str());
  out.commit();
}

}  // namespace inkcell::design
