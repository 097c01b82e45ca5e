#include "import/svg_import.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "import/svg_path.hpp"
#include "model/error.hpp"
#include "model/glyph.hpp"

namespace inkcell::design {
namespace {

constexpr double kUnitsOfU = 1024;

// Groups in groups: plenty.
constexpr int kMostDepth = 64;

// Places on a segment by which areas are taken.
constexpr int kLooks = 8;

int degree(const gen::Segment& segment) {
  return segment.kind == gen::Segment::Kind::line        ? 1
         : segment.kind == gen::Segment::Kind::quadratic ? 2
                                                         : 3;
}

// De Casteljau.
Point point_at(const gen::Segment& segment, double t) {
  Point p[4];
  std::copy(std::begin(segment.p), std::end(segment.p), p);
  for (int n = degree(segment); n > 0; --n) {
    for (int i = 0; i < n; ++i) {
      p[i] = p[i] + t * (p[i + 1] - p[i]);
    }
  }
  return p[0];
}

std::vector<Point> polygon_of(const gen::Contour& contour) {
  std::vector<Point> polygon;
  for (const gen::Segment& segment : contour.segments) {
    for (int i = 0; i < kLooks; ++i) {
      polygon.push_back(point_at(segment, static_cast<double>(i) / kLooks));
    }
  }
  return polygon;
}

double area(const std::vector<Point>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  }
  return sum;
}

bool contains(const std::vector<Point>& polygon, const Point& p) {
  bool inside = false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) &&
        p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

void reverse(gen::Contour& contour) {
  std::reverse(contour.segments.begin(), contour.segments.end());
  for (gen::Segment& segment : contour.segments) {
    std::reverse(segment.p, segment.p + degree(segment) + 1);
  }
}

// Ink on the left of all contours.
void direct(gen::Outline& outline, bool is_evenodd) {
  std::vector<std::vector<Point>> polygons;
  std::vector<double> areas;
  for (const gen::Contour& contour : outline.contours) {
    polygons.push_back(polygon_of(contour));
    areas.push_back(area(polygons.back()));
  }
  const auto largest = std::max_element(
      areas.begin(), areas.end(),
      [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  for (size_t i = 0; i < polygons.size(); ++i) {
    bool is_wrong = *largest < 0;
    if (is_evenodd) {
      bool is_hole = false;
      for (size_t k = 0; k < polygons.size(); ++k) {
        is_hole ^= k != i && contains(polygons[k], polygons[i][1]);
      }
      is_wrong = (areas[i] < 0) != is_hole;
    }
    if (is_wrong) {
      reverse(outline.contours[i]);
    }
  }
}

// "name(1, 2 3) name(4)", the outermost first.
Matrix parse_transform(std::string_view text) {
  const std::string whole(text);
  Matrix result;
  while (true) {
    const size_t open = text.find('(');
    const size_t close = text.find(')');
    if (open == std::string_view::npos || close < open ||
        close == std::string_view::npos) {
      break;
    }
    std::string name(text.substr(0, open));
    name.erase(std::remove_if(name.begin(), name.end(),
                              [](char c) {
                                return std::isalpha(
                                           static_cast<unsigned char>(c)) == 0;
                              }),
               name.end());
    std::array<double, 6> v = {};
    size_t count = 0;
    const char* end = text.data() + close;
    for (const char* at = text.data() + open + 1; at < end;) {
      double value = 0;
      const auto [next, error] = std::from_chars(at, end, value);
      if (error != std::errc()) {
        ++at;  // a space or a comma
      } else if (count == v.size()) {
        break;
      } else {
        v[count++] = value;
        at = next;
      }
    }
    Matrix m;
    if (name == "matrix" && count == 6) {
      m = {v[0], v[1], v[2], v[3], v[4], v[5]};
    } else if (name == "translate" && count >= 1) {
      m = {1, 0, 0, 1, v[0], v[1]};
    } else if (name == "scale" && count >= 1) {
      m = {v[0], 0, 0, count == 1 ? v[0] : v[1], 0, 0};
    } else if (name == "rotate" && (count == 1 || count == 3)) {
      const double c = std::cos(v[0] * M_PI / 180);
      const double s = std::sin(v[0] * M_PI / 180);
      m = {c, s, -s, c, v[1] - c * v[1] + s * v[2], v[2] - s * v[1] - c * v[2]};
    } else if (name == "skewX" && count == 1) {
      m.yx = std::tan(v[0] * M_PI / 180);
    } else if (name == "skewY" && count == 1) {
      m.xy = std::tan(v[0] * M_PI / 180);
    } else {
      throw Error("transform '" + whole + "' is not one of SVG 1.1");
    }
    result = product(result, m);
    text.remove_prefix(close + 1);
  }
  return result;
}

// An attribute, or the property of the same name in `style`.
std::string property(const pugi::xml_node& node, const char* name) {
  const std::string style = node.attribute("style").value();
  const size_t at = style.find(std::string(name) + ":");
  if (at == std::string::npos) {
    return node.attribute(name).value();
  }
  const size_t begin = style.find_first_not_of(' ', style.find(':', at) + 1);
  return begin == std::string::npos
             ? ""
             : style.substr(begin, style.find(';', begin) - begin);
}

struct Inherited {
  Matrix matrix;
  bool is_evenodd = false;
  bool is_filled = true;
};

class SvgReader {
 public:
  explicit SvgReader(const Matrix& place) { root_.matrix = place; }

  gen::Outline run(const pugi::xml_node& svg) {
    read(svg, root_, kMostDepth);
    return std::move(outline_);
  }

 private:
  static bool is_any(const std::string& name,
                     std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void read(const pugi::xml_node& node, Inherited state, int depth) {
    const std::string name = node.name();
    if (is_any(name, {"rect", "circle", "ellipse", "line", "polyline",
                      "polygon", "text", "image", "use"})) {
      throw Error("<" + name + "> is no path; convert it to one");
    }
    if (!is_any(name, {"svg", "g", "a", "path"}) || depth == 0) {
      return;  // draws nothing
    }
    state.matrix = product(
        state.matrix, parse_transform(node.attribute("transform").value()));
    const std::string rule = property(node, "fill-rule");
    state.is_evenodd = rule.empty() ? state.is_evenodd : rule == "evenodd";
    const std::string fill = property(node, "fill");
    state.is_filled = fill.empty() ? state.is_filled : fill != "none";
    if (name == "path") {
      if (state.is_filled) {
        add(node.attribute("d").value(), state);
      }
      return;
    }
    for (const pugi::xml_node& child : node.children()) {
      read(child, state, depth - 1);
    }
  }

  void add(const char* data, const Inherited& state) {
    gen::Outline path = parse_svg_path(data);
    for (gen::Contour& contour : path.contours) {
      for (gen::Segment& segment : contour.segments) {
        for (Point& p : segment.p) {
          p = state.matrix.map(p.x, p.y);
        }
      }
    }
    direct(path, state.is_evenodd);
    outline_.contours.insert(outline_.contours.end(), path.contours.begin(),
                             path.contours.end());
  }

  Inherited root_;
  gen::Outline outline_;
};

}  // namespace

gen::Outline read_svg(const std::filesystem::path& file,
                      const DrawingPlace& place) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(file.c_str());
  if (!parsed || document.child("svg").empty()) {
    throw Error(file.string() + ": is no sound SVG" +
                (parsed ? "" : std::string(": ") + parsed.description()));
  }
  const double scale = kUnitsOfU / place.px_per_em;
  const Matrix to_u = {
      scale, 0, 0, -scale, -scale * place.origin.x, scale * place.origin.y};
  try {
    gen::Outline outline = SvgReader(to_u).run(document.child("svg"));
    if (outline.contours.empty()) {
      throw Error("holds no filled path");
    }
    return outline;
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

}  // namespace inkcell::design
