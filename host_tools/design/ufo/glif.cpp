#include "ufo/glif.hpp"

#include <pugixml.hpp>

#include "model/contours.hpp"
#include "model/error.hpp"
#include "ufo/numbers.hpp"
#include "ufo/plist.hpp"

namespace inkcell::design {
namespace {

constexpr struct {
  const char* name;
  double Matrix::*member;
  double otherwise;
} kMatrixAttributes[] = {
    {"xScale", &Matrix::xx, 1},  {"xyScale", &Matrix::xy, 0},
    {"yxScale", &Matrix::yx, 0}, {"yScale", &Matrix::yy, 1},
    {"xOffset", &Matrix::dx, 0}, {"yOffset", &Matrix::dy, 0},
};

Matrix read_matrix(const pugi::xml_node& node) {
  Matrix matrix;
  for (const auto& [name, member, otherwise] : kMatrixAttributes) {
    matrix.*member = node.attribute(name).as_double(otherwise);
  }
  return matrix;
}

void write_matrix(const Matrix& matrix, pugi::xml_node& node) {
  for (const auto& [name, member, otherwise] : kMatrixAttributes) {
    if (matrix.*member != otherwise) {
      node.append_attribute(name) = to_text(matrix.*member).c_str();
    }
  }
}

std::string text_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

void write_text(pugi::xml_node& node,
                const char* attribute,
                const std::string& text) {
  if (!text.empty()) {
    node.append_attribute(attribute) = text.c_str();
  }
}

void write_number(pugi::xml_node& node, const char* attribute, double value) {
  node.append_attribute(attribute) = to_text(value).c_str();
}

PointContour read_contour(const pugi::xml_node& node) {
  PointContour contour;
  contour.identifier = text_of(node, "identifier");
  for (const pugi::xml_node& item : node.children("point")) {
    GlyphPoint point;
    point.x = item.attribute("x").as_double();
    point.y = item.attribute("y").as_double();
    point.type = item.attribute("type") ? parse_type(text_of(item, "type"))
                                        : PointType::offcurve;
    point.smooth = text_of(item, "smooth") == "yes";
    point.name = text_of(item, "name");
    point.identifier = text_of(item, "identifier");
    contour.points.push_back(std::move(point));
  }
  check_contour(contour);
  return contour;
}

void read_outline(const pugi::xml_node& node, Glyph& glyph) {
  for (const pugi::xml_node& item : node.children()) {
    const std::string tag = item.name();
    if (tag == "contour") {
      glyph.contours.push_back(read_contour(item));
    } else if (tag == "component") {
      glyph.components.push_back({text_of(item, "base"), read_matrix(item),
                                  text_of(item, "identifier")});
    } else if (!tag.empty()) {
      throw Error("<" + tag + "> is no part of an outline");
    }
  }
}

Guideline read_guideline(const pugi::xml_node& node) {
  Guideline line;
  const auto number = [&node](const char* name) {
    const pugi::xml_attribute found = node.attribute(name);
    return found ? std::optional<double>(found.as_double()) : std::nullopt;
  };
  line.x = number("x");
  line.y = number("y");
  line.angle = number("angle");
  line.name = text_of(node, "name");
  line.color = text_of(node, "color");
  line.identifier = text_of(node, "identifier");
  return line;
}

void read_unicode(const pugi::xml_node& node, Glyph& glyph) {
  const std::string hex = text_of(node, "hex");
  size_t used = 0;
  unsigned long code = 0;
  try {
    code = std::stoul(hex, &used, 16);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != hex.size() || code > 0x10ffff) {
    throw Error("unicode '" + hex + "' is no code point up to 10FFFF");
  }
  glyph.unicodes.push_back(static_cast<char32_t>(code));
}

void read_element(const pugi::xml_node& node,
                  const std::string& file,
                  Glyph& glyph) {
  const std::string tag = node.name();
  if (tag == "advance") {
    glyph.width = node.attribute("width").as_double();
    glyph.height = node.attribute("height").as_double();
  } else if (tag == "unicode") {
    read_unicode(node, glyph);
  } else if (tag == "note") {
    glyph.note = node.child_value();
  } else if (tag == "image") {
    glyph.image = GlyphImage{text_of(node, "fileName"), read_matrix(node),
                             text_of(node, "color")};
  } else if (tag == "guideline") {
    glyph.guidelines.push_back(read_guideline(node));
  } else if (tag == "anchor") {
    glyph.anchors.push_back({node.attribute("x").as_double(),
                             node.attribute("y").as_double(),
                             text_of(node, "name"), text_of(node, "color"),
                             text_of(node, "identifier")});
  } else if (tag == "outline") {
    read_outline(node, glyph);
  } else if (tag == "lib") {
    if (node.child("dict")) {
      glyph.lib = read_plist_node(node.child("dict"), file);
    }
  } else if (!tag.empty()) {
    throw Error("<" + tag + "> is no part of GLIF 2");
  }
}

void write_point(const GlyphPoint& point, pugi::xml_node& parent) {
  pugi::xml_node node = parent.append_child("point");
  write_number(node, "x", point.x);
  write_number(node, "y", point.y);
  if (point.on_curve()) {
    node.append_attribute("type") = type_name(point.type).c_str();
  }
  if (point.smooth) {
    node.append_attribute("smooth") = "yes";
  }
  write_text(node, "name", point.name);
  write_text(node, "identifier", point.identifier);
}

void write_outline(const Glyph& glyph, pugi::xml_node& parent) {
  pugi::xml_node outline = parent.append_child("outline");
  for (const PointContour& contour : glyph.contours) {
    pugi::xml_node node = outline.append_child("contour");
    write_text(node, "identifier", contour.identifier);
    for (const GlyphPoint& point : contour.points) {
      write_point(point, node);
    }
  }
  for (const ComponentUse& use : glyph.components) {
    pugi::xml_node node = outline.append_child("component");
    node.append_attribute("base") = use.base.c_str();
    write_matrix(use.matrix, node);
    write_text(node, "identifier", use.identifier);
  }
}

void write_guideline(const Guideline& line, pugi::xml_node& parent) {
  pugi::xml_node node = parent.append_child("guideline");
  const auto number = [&node](const char* name, std::optional<double> value) {
    if (value) {
      write_number(node, name, *value);
    }
  };
  number("x", line.x);
  number("y", line.y);
  number("angle", line.angle);
  write_text(node, "name", line.name);
  write_text(node, "color", line.color);
  write_text(node, "identifier", line.identifier);
}

void write_head(const Glyph& glyph, pugi::xml_node& root) {
  pugi::xml_node advance = root.append_child("advance");
  write_number(advance, "width", glyph.width);
  if (glyph.height != 0) {
    write_number(advance, "height", glyph.height);
  }
  for (const char32_t code : glyph.unicodes) {
    char hex[16];
    std::snprintf(hex, sizeof hex, "%04X", static_cast<unsigned>(code));
    root.append_child("unicode").append_attribute("hex") = hex;
  }
  if (!glyph.note.empty()) {
    root.append_child("note")
        .append_child(pugi::node_pcdata)
        .set_value(glyph.note.c_str());
  }
  if (glyph.image) {
    pugi::xml_node image = root.append_child("image");
    image.append_attribute("fileName") = glyph.image->file.c_str();
    write_matrix(glyph.image->matrix, image);
    write_text(image, "color", glyph.image->color);
  }
}

}  // namespace

Glyph parse_glif(const std::string& text, const std::string& file) {
  pugi::xml_document document;
  parse_xml(text, file, document);
  const pugi::xml_node root = document.child("glyph");
  if (!root || !root.attribute("name")) {
    throw Error(file + ": is no GLIF file");
  }
  Glyph glyph;
  glyph.name = text_of(root, "name");
  try {
    for (const pugi::xml_node& node : root.children()) {
      read_element(node, file, glyph);
    }
  } catch (const Error& error) {
    throw Error(file + ": glyph '" + glyph.name + "': " + error.what());
  }
  return glyph;
}

std::string write_glif(const Glyph& glyph) {
  pugi::xml_document document;
  declare_xml(document);
  pugi::xml_node root = document.append_child("glyph");
  root.append_attribute("name") = glyph.name.c_str();
  root.append_attribute("format") = "2";
  write_head(glyph, root);
  for (const Guideline& line : glyph.guidelines) {
    write_guideline(line, root);
  }
  for (const Anchor& anchor : glyph.anchors) {
    pugi::xml_node node = root.append_child("anchor");
    write_number(node, "x", anchor.x);
    write_number(node, "y", anchor.y);
    write_text(node, "name", anchor.name);
    write_text(node, "color", anchor.color);
    write_text(node, "identifier", anchor.identifier);
  }
  write_outline(glyph, root);
  if (!glyph.lib.empty()) {
    pugi::xml_node lib = root.append_child("lib");
    write_plist_node(glyph.lib, lib);
  }
  return xml_text(document);
}

}  // namespace inkcell::design
