#include "svg/svg_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "shape/shape.hpp"
#include "svg/basic_shapes.hpp"
#include "svg/region.hpp"
#include "svg/stroke.hpp"
#include "svg/stroke_outline.hpp"
#include "svg/style.hpp"
#include "svg/transform.hpp"

namespace inkcell::gen {

struct SvgDrawing::Document {
  std::string text;
  pugi::xml_document xml;

  // The position of a node, for messages.
  std::string place_of(const pugi::xml_node& node) const {
    const auto begin = text.begin();
    const auto line = std::count(begin, begin + node.offset_debug(), '\n') + 1;
    return "line " + std::to_string(line) + ": <" + node.name() + ">";
  }
};

namespace {

// The deepest nesting of groups.
constexpr int kMostDepth = 64;

bool is_any(std::string_view name,
            std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::string_view kPrefix = "svg:";

// Elements that draw nothing by themselves. Those with a foreign prefix are a
// program's private data.
bool draws_nothing(std::string_view name) {
  return (name.find(':') != std::string_view::npos &&
          name.compare(0, kPrefix.size(), kPrefix) != 0) ||
         is_any(name, {"defs", "style", "title", "desc", "metadata", "symbol",
                       "clipPath", "mask", "marker", "filter", "pattern",
                       "linearGradient", "radialGradient", "view", "script"});
}

[[noreturn]] void refuse_element(std::string_view name) {
  const char* remedy =
      name == "text"    ? "convert the text to paths"
      : name == "image" ? "trace the picture to paths"
      : name == "use"   ? "replace it by a copy of what it refers to"
      : name == "style" ? "save the drawing without style sheets, with "
                          "attributes such as fill='black'"
      : name == "svg"   ? "move what it holds into the outer one"
      : name.compare(0, kPrefix.size(), kPrefix) == 0
          ? "save the drawing as plain SVG, without prefixes"
          : "convert it to paths, or remove it";
  throw Error(std::string("is not supported; ") + remedy);
}

void append(const Outline& part, Outline& outline) {
  outline.contours.insert(outline.contours.end(), part.contours.begin(),
                          part.contours.end());
}

// The stroke of a path, in u: curves if they are exact enough, else chords.
Outline stroked_area(const SvgPath& path,
                     const PenStyle& pen,
                     const Affine& to_u) {
  const double scale = std::sqrt(to_u.xx * to_u.xx + to_u.xy * to_u.xy +
                                 to_u.yx * to_u.yx + to_u.yy * to_u.yy);
  const double bound = kStrokeBound_u / scale;
  Outline area;
  for (const Subpath& subpath : path) {
    std::vector<Corners> pieces = stroke_pieces(subpath, pen, bound);
    for (Corners& piece : pieces) {
      for (Point& p : piece) {
        p = to_u.map(p.x, p.y);
      }
    }
    Outline part = united_area(pieces);
    if (std::optional<Outline> curves = stroke_outline(subpath, pen, bound)) {
      map(to_u, *curves);
      Outline filled = filled_area(*curves, FillRule::nonzero);
      if (fill_alike(filled, part, 2 * kStrokeBound_u)) {
        part = std::move(filled);
      }
    }
    append(part, area);
  }
  return area;
}

class Reader {
 public:
  Reader(const pugi::xml_node& root, bool has_colours) : root_(root) {
    style_.has_colours = has_colours;
    if (has_colours) {
      style_.color = "currentcolor";
    }
  }

  std::vector<PaintedOutline> run(const Affine& to_u) {
    refuse_style_sheets();
    read(root_, style_, to_u, kMostDepth);
    return std::move(layers_);
  }

  // The element at which an error occurred.
  const pugi::xml_node& current() const { return current_; }

 private:
  // A style sheet applies to the whole drawing, wherever it is.
  void refuse_style_sheets() {
    current_ = root_.find_node([](const pugi::xml_node& node) {
      return std::string_view(node.name()) == "style" && !node.text().empty();
    });
    if (!current_.empty()) {
      refuse_element("style");
    }
  }

  void read(const pugi::xml_node& node,
            const PaintStyle& parent,
            const Affine& outer,
            int depth) {
    const std::string_view name = node.name();
    if (node.type() != pugi::node_element || draws_nothing(name)) {
      return;
    }
    current_ = node;
    if (depth == 0) {
      throw Error("is nested too deep; ungroup the drawing");
    }
    const bool is_group = is_any(name, {"g", "a"}) || node == root_;
    const bool is_shape = is_any(name, {"path", "rect", "circle", "ellipse",
                                        "line", "polyline", "polygon"});
    if (!is_group && !is_shape) {
      refuse_element(name);
    }
    const PaintStyle style = style_of(node, parent);
    const Affine to_u =
        product(outer, parse_transform(node.attribute("transform").value()));
    if (is_shape && style.is_shown) {
      paint(*path_of(node), style, to_u);
    }
    for (const pugi::xml_node& child : node.children()) {
      if (is_group && property_of(node, "display") != "none") {
        read(child, style, to_u, depth - 1);
      }
    }
  }

  void paint(const SvgPath& path, const PaintStyle& style, const Affine& to_u) {
    if (path.empty()) {
      return;
    }
    const double fill = style.opacity * style.fill_opacity;
    if (style.fill != "none" && fill > 0) {
      Outline outline = contours_of(path);
      map(to_u, outline);
      add(filled_area(outline, style.rule), style.fill, fill);
    }
    const double stroke = style.opacity * style.stroke_opacity;
    if (style.stroke != "none" && stroke > 0 && style.pen.width != 0) {
      add(stroked_area(path, style.pen, to_u), style.stroke, stroke);
    }
  }

  // The fill of a line has contours, but no area.
  void add(const Outline& area, const std::string& color, double opacity) {
    if (area.contours.empty() || Shape(area).empty()) {
      return;
    }
    if (style_.has_colours) {
      const Paint paint = paint_of(color, opacity);
      if (layers_.empty() || !(layers_.back().paint == paint) ||
          paint.opacity != 255) {
        layers_.push_back({{}, paint});
      }
    } else if (layers_.empty()) {
      layers_.emplace_back();
    } else if (color != color_) {
      throw Error("is painted in " + color + ", what comes before it in " +
                  color_ +
                  "; an icon is of one colour: cut light parts out of the dark "
                  "ones as holes, or draw each colour as an icon of its own");
    }
    color_ = color;
    append(area, layers_.back().outline);
  }

  pugi::xml_node root_;
  pugi::xml_node current_;
  PaintStyle style_;
  std::string color_;
  std::vector<PaintedOutline> layers_;
};

}  // namespace

SvgDrawing::SvgDrawing(const std::filesystem::path& file)
    : file_(file), document_(std::make_unique<Document>()) {
  const auto refuse = [&](const std::string& why) {
    throw Error(file.string() + ": " + why);
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    refuse("there is no such file; check its name");
  }
  std::ifstream in(file, std::ios::binary);
  document_->text.assign(std::istreambuf_iterator<char>(in), {});
  if (!in.is_open() || in.bad()) {
    refuse("cannot be read; check its permissions");
  }
  const pugi::xml_parse_result parsed = document_->xml.load_buffer(
      document_->text.data(), document_->text.size());
  if (!parsed) {
    const auto begin = document_->text.begin();
    refuse("line " +
           std::to_string(std::count(begin, begin + parsed.offset, '\n') + 1) +
           ": is no sound XML: " + parsed.description() +
           "; save the drawing anew");
  }
  if (document_->xml.child("svg").empty()) {
    refuse("has no element <svg>; save the drawing as plain SVG");
  }
}

SvgDrawing::~SvgDrawing() = default;

std::optional<ViewBox> SvgDrawing::view_box() const {
  const pugi::xml_node root = document_->xml.child("svg");
  try {
    std::vector<double> box = numbers_of(root, "viewBox");
    if (root.attribute("viewBox").empty()) {
      if (root.attribute("width").empty() || root.attribute("height").empty()) {
        return std::nullopt;
      }
      box = {0, 0, number_of(root, "width", 0), number_of(root, "height", 0)};
    }
    if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0)) {
      throw Error(
          "a viewBox is four numbers, x, y, and width and height above 0");
    }
    return ViewBox{box[0], box[1], box[2], box[3]};
  } catch (const Error& error) {
    throw Error(file_.string() + ": " + document_->place_of(root) + " " +
                error.what());
  }
}

std::vector<PaintedOutline> SvgDrawing::read(const Affine& to_u,
                                             bool has_colours) const {
  Reader reader(document_->xml.child("svg"), has_colours);
  const auto refuse = [&](const std::string& why) {
    throw Error(file_.string() + ": " + document_->place_of(reader.current()) +
                " " + why);
  };
  std::vector<PaintedOutline> layers;
  try {
    layers = reader.run(to_u);
  } catch (const GeometryError& error) {
    refuse(error.what());
  } catch (const Error& error) {
    refuse(error.what());
  }
  if (layers.empty()) {
    throw Error(file_.string() +
                ": draws nothing; fill or stroke a path of it");
  }
  return layers;
}

Outline SvgDrawing::outline(const Affine& to_u) const {
  return std::move(read(to_u, false)[0].outline);
}

std::vector<PaintedOutline> SvgDrawing::layers(const Affine& to_u) const {
  return read(to_u, true);
}

}  // namespace inkcell::gen
