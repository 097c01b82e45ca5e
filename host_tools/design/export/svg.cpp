#include "export/svg.hpp"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>

#include "fit/vectors.hpp"
#include "ufo/numbers.hpp"
#include "ufo/plist.hpp"

namespace inkcell::design {
namespace {

constexpr double kMargin_u = 64;

std::string coordinates(const Point& p) {
  const auto round = [](double v) { return std::round(v * 1000) / 1000; };
  return to_text(round(p.x)) + " " + to_text(round(-p.y));
}

}  // namespace

std::string svg_path(const gen::Outline& outline) {
  std::string path;
  for (const gen::Contour& contour : outline.contours) {
    if (contour.segments.empty()) {
      continue;
    }
    path += "M" + coordinates(contour.segments.front().p[0]);
    for (const gen::Segment& segment : contour.segments) {
      const int points = segment.kind == gen::Segment::Kind::line        ? 1
                         : segment.kind == gen::Segment::Kind::quadratic ? 2
                                                                         : 3;
      path += " LQC"[points];
      for (int i = 1; i <= points; ++i) {
        path += (i == 1 ? "" : " ") + coordinates(segment.p[i]);
      }
    }
    path += "Z";
  }
  return path;
}

std::string svg_document(const gen::Outline& outline,
                         const std::string& title) {
  double x0 = 0, y0 = 0, x1 = 1024, y1 = 1024;
  for (const gen::Contour& contour : outline.contours) {
    for (const gen::Segment& segment : contour.segments) {
      x0 = std::min(x0, segment.p[0].x);
      y0 = std::min(y0, segment.p[0].y);
      x1 = std::max(x1, segment.p[0].x);
      y1 = std::max(y1, segment.p[0].y);
    }
  }
  pugi::xml_document document;
  pugi::xml_node svg = document.append_child("svg");
  svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  const auto whole = [](double v) { return to_text(std::round(v)); };
  svg.append_attribute("viewBox") =
      (whole(x0 - kMargin_u) + " " + whole(-y1 - kMargin_u) + " " +
       whole(x1 - x0 + 2 * kMargin_u) + " " + whole(y1 - y0 + 2 * kMargin_u))
          .c_str();
  svg.append_child("title")
      .append_child(pugi::node_pcdata)
      .set_value(title.c_str());
  pugi::xml_node path = svg.append_child("path");
  path.append_attribute("fill-rule") = "nonzero";
  path.append_attribute("d") = svg_path(outline).c_str();
  return xml_text(document);
}

}  // namespace inkcell::design
