#include "svg/style.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/trimmed.hpp"

namespace inkcell::gen {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

// The value of a property in the attribute `style`; "" if it has none.
std::string declaration_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = node.attribute("style").value();
  std::string found;
  while (!style.empty()) {
    const std::string_view item = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(item.size() + 1, style.size()));
    const size_t colon = item.find(':');
    if (colon != std::string_view::npos &&
        trimmed(item.substr(0, colon), kBlanks) == name) {
      found = trimmed(item.substr(colon + 1), kBlanks);
    }
  }
  return found;
}

std::string quoted(const char* name, const std::string& value) {
  return std::string(name) + "='" + value + "'";
}

// The value of a property, or `parent` if it has none.
template <typename Value>
Value choice(const pugi::xml_node& node,
             const char* name,
             Value parent,
             std::initializer_list<std::pair<const char*, Value>> values) {
  const std::string text = property_of(node, name);
  if (text.empty() || text == "inherit") {
    return parent;
  }
  std::string known;
  for (const auto& [word, value] : values) {
    if (text == word) {
      return value;
    }
    known += std::string(known.empty() ? "" : ", ") + word;
  }
  throw Error(quoted(name, text) + " is not supported; use one of " + known);
}

std::string color_of(const pugi::xml_node& node,
                     const char* name,
                     const std::string& parent,
                     const PaintStyle& style) {
  const std::string text = lower(property_of(node, name));
  if (text.empty() || text == "inherit") {
    return parent;
  }
  if (text == "currentcolor") {
    return style.color;
  }
  if (text.compare(0, 4, "url(") == 0) {
    throw Error(quoted(name, text) +
                (style.has_colours
                     ? " is a gradient or a pattern; paint with one colour"
                     : " is a gradient or a pattern; an icon is of one "
                       "colour: paint with it, or with none"));
  }
  const bool is_hex = text[0] == '#' && (text.size() == 5 || text.size() == 9);
  const std::string function = text.substr(0, 5);
  if (!style.has_colours &&
      (is_hex || function == "rgba(" || function == "hsla(")) {
    throw Error(quoted(name, text) +
                " has an alpha; write a colour without one, or none");
  }
  if (text == "transparent") {
    return "none";
  }
  if (text == "black") {
    return "#000000";
  }
  if (text.size() == 4 && text[0] == '#') {
    return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
  }
  return text;
}

// 0 or 1, if there are no colours.
double opacity_of(const pugi::xml_node& node,
                  const char* name,
                  double parent,
                  bool has_colours) {
  const std::string text = property_of(node, name);
  if (text.empty() || text == "inherit") {
    return parent;
  }
  std::string_view rest = text;
  const std::optional<double> number = take_number(rest);
  const bool is_percent = rest == "%";
  const double opacity = number.value_or(-1) / (is_percent ? 100 : 1);
  if (opacity != 1 && opacity != 0 && !has_colours) {
    throw Error(quoted(name, text) +
                " is part transparent; draw the element opaque, or remove it");
  }
  if (!number || !(rest.empty() || is_percent)) {
    throw Error(quoted(name, text) + " is no number from 0 to 1; write one");
  }
  return std::clamp(opacity, 0.0, 1.0);
}

// Refuses a property that has another value than `plain`.
void refuse_unless(const char* plain,
                   const pugi::xml_node& node,
                   const char* name,
                   const char* remedy) {
  const std::string text = property_of(node, name);
  if (!text.empty() && text != plain) {
    throw Error(quoted(name, text) + " is not supported; " + remedy);
  }
}

void refuse_unless_none(const pugi::xml_node& node,
                        const char* name,
                        const char* remedy) {
  refuse_unless("none", node, name, remedy);
}

// What style sheets may say of a place or a form, and attributes may not.
void refuse_geometry(const pugi::xml_node& node) {
  bool has_transform = !property_of(node, "transform-origin").empty();
  for (const char* name :
       {"transform", "translate", "rotate", "scale", "offset-path"}) {
    has_transform = has_transform || !declaration_of(node, name).empty();
  }
  if (has_transform) {
    throw Error(
        "transforms of style sheets are not supported; use the attribute "
        "transform");
  }
  for (const char* name : {"d", "x", "y", "cx", "cy", "r", "rx", "ry"}) {
    if (!declaration_of(node, name).empty()) {
      throw Error(std::string("style has ") + name +
                  ", which is not supported; write it as an attribute");
    }
  }
}

// What shows only where there are several colours.
void refuse_blending(const pugi::xml_node& node) {
  refuse_unless("normal", node, "mix-blend-mode",
                "paint with the colour that shows, or remove it");
  refuse_unless("normal", node, "paint-order",
                "draw the stroke as an element of its own");
}

PenStyle pen_of(const pugi::xml_node& node, const PenStyle& parent) {
  PenStyle pen;
  pen.width = number_of(node, "stroke-width", parent.width);
  pen.miter_limit = number_of(node, "stroke-miterlimit", parent.miter_limit);
  pen.join = choice<LineJoin>(node, "stroke-linejoin", parent.join,
                              {{"miter", LineJoin::miter},
                               {"round", LineJoin::round},
                               {"bevel", LineJoin::bevel}});
  pen.cap = choice<LineCap>(node, "stroke-linecap", parent.cap,
                            {{"butt", LineCap::butt},
                             {"round", LineCap::round},
                             {"square", LineCap::square}});
  if (pen.width < 0 || pen.miter_limit < 1) {
    throw Error(
        "a stroke-width is at least 0 and a stroke-miterlimit at least 1");
  }
  return pen;
}

}  // namespace

std::string property_of(const pugi::xml_node& node, const char* name) {
  const std::string declared = declaration_of(node, name);
  return declared.empty()
             ? std::string(trimmed(node.attribute(name).value(), kBlanks))
             : declared;
}

double number_of(const pugi::xml_node& node,
                 const char* name,
                 double otherwise) {
  const std::string text = property_of(node, name);
  if (text.empty() || text == "inherit") {
    return otherwise;
  }
  std::string_view rest = text;
  const std::optional<double> value = take_number(rest);
  if (!value || !(rest.empty() || rest == "px")) {
    throw Error(quoted(name, text) +
                " is no number of user units; write one without a unit");
  }
  return *value;
}

std::vector<double> numbers_of(const pugi::xml_node& node, const char* name) {
  const std::string text = node.attribute(name).value();
  const std::optional<std::vector<double>> numbers = numbers_in(text);
  if (!numbers) {
    throw Error(quoted(name, text) + " is no list of numbers");
  }
  return *numbers;
}

PaintStyle style_of(const pugi::xml_node& node, const PaintStyle& parent) {
  refuse_unless_none(node, "clip-path",
                     "cut the paths themselves, or remove the clip path");
  refuse_unless_none(node, "mask",
                     "cut the paths themselves, or remove the mask");
  refuse_unless_none(node, "mask-image",
                     "cut the paths themselves, or remove the mask");
  refuse_unless_none(node, "filter", "remove it");
  refuse_unless_none(node, "backdrop-filter", "remove it");
  for (const char* marker :
       {"marker", "marker-start", "marker-mid", "marker-end"}) {
    refuse_unless_none(node, marker, "draw the marker as a path");
  }
  refuse_unless_none(node, "stroke-dasharray", "draw each dash as a path");
  refuse_unless_none(node, "vector-effect", "remove it");
  refuse_geometry(node);
  if (parent.has_colours) {
    refuse_blending(node);
  }
  PaintStyle style = parent;
  style.color = color_of(node, "color", parent.color, parent);
  style.fill = color_of(node, "fill", parent.fill, style);
  style.stroke = color_of(node, "stroke", parent.stroke, style);
  style.rule = choice<FillRule>(
      node, "fill-rule", parent.rule,
      {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::evenodd}});
  style.pen = pen_of(node, parent.pen);
  const std::string visibility = property_of(node, "visibility");
  const bool has_colours = parent.has_colours;
  style.opacity = parent.opacity * opacity_of(node, "opacity", 1, has_colours);
  style.fill_opacity =
      opacity_of(node, "fill-opacity", parent.fill_opacity, has_colours);
  style.stroke_opacity =
      opacity_of(node, "stroke-opacity", parent.stroke_opacity, has_colours);
  style.is_shown = parent.is_shown && style.opacity > 0 &&
                   property_of(node, "display") != "none" &&
                   visibility != "hidden" && visibility != "collapse";
  return style;
}

namespace {

// Names that drawings have; others are refused.
constexpr struct {
  const char* name;
  uint32_t rgb;
} kNamedColors[] = {
    {"aqua", 0x00ffff},    {"azure", 0xf0ffff},  {"black", 0x000000},
    {"blue", 0x0000ff},    {"brown", 0xa52a2a},  {"cyan", 0x00ffff},
    {"fuchsia", 0xff00ff}, {"gold", 0xffd700},   {"gray", 0x808080},
    {"green", 0x008000},   {"grey", 0x808080},   {"lime", 0x00ff00},
    {"magenta", 0xff00ff}, {"maroon", 0x800000}, {"navy", 0x000080},
    {"olive", 0x808000},   {"orange", 0xffa500}, {"pink", 0xffc0cb},
    {"purple", 0x800080},  {"red", 0xff0000},    {"silver", 0xc0c0c0},
    {"teal", 0x008080},    {"white", 0xffffff},  {"yellow", 0xffff00}};

// The numbers of "rgb(1 2 3 / 0.5)", of 0 to 255 and 0 to 1.
std::vector<double> channels_of(std::string_view text) {
  std::vector<double> channels;
  while (!text.empty()) {
    const size_t begin = text.find_first_of("+-.0123456789");
    if (begin == std::string_view::npos) {
      break;
    }
    text.remove_prefix(begin);
    const std::optional<double> number = take_number(text);
    if (!number) {
      return {};
    }
    const bool is_percent = !text.empty() && text.front() == '%';
    const double scale = !is_percent           ? 1
                         : channels.size() < 3 ? 255.0 / 100
                                               : 1.0 / 100;
    channels.push_back(*number * scale);
  }
  return channels;
}

// "#rgb", "#rgba", "#rrggbb" or "#rrggbbaa".
std::vector<double> hex_channels_of(const std::string& text) {
  const size_t digits = text.size() - 1;
  const size_t width = digits > 4 ? 2 : 1;
  std::vector<double> channels;
  for (size_t i = 1; i + width <= text.size(); i += width) {
    unsigned value = 0;
    const char* const end = text.data() + i + width;
    const auto read = std::from_chars(text.data() + i, end, value, 16);
    if (read.ec != std::errc() || read.ptr != end) {
      return {};
    }
    const unsigned channel = value * (width == 1 ? 17 : 1);
    channels.push_back(i > 3 * width ? channel / 255.0 : channel);
  }
  return digits % width == 0 ? channels : std::vector<double>();
}

}  // namespace

Paint paint_of(const std::string& color, double opacity) {
  Paint paint;
  paint.opacity = static_cast<uint8_t>(std::lround(255 * opacity));
  paint.is_ink = color == "currentcolor";
  if (paint.is_ink) {
    return paint;
  }
  std::vector<double> channels;
  if (color[0] == '#') {
    channels = hex_channels_of(color);
  } else if (color.compare(0, 3, "rgb") == 0) {
    channels = channels_of(color);
  } else {
    for (const auto& known : kNamedColors) {
      if (color == known.name) {
        channels = {static_cast<double>(known.rgb >> 16),
                    static_cast<double>(known.rgb >> 8 & 255),
                    static_cast<double>(known.rgb & 255)};
      }
    }
  }
  if (channels.size() != 3 && channels.size() != 4) {
    throw Error("is painted in " + color +
                ", which is no colour that is known; write it as #rrggbb");
  }
  const auto byte = [](double value) {
    return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  paint.red = byte(channels[0]);
  paint.green = byte(channels[1]);
  paint.blue = byte(channels[2]);
  if (channels.size() == 4) {
    paint.opacity = byte(255 * opacity * channels[3]);
  }
  return paint;
}

}  // namespace inkcell::gen
