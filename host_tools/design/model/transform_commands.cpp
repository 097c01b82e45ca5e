// Commands that map, align and distribute contours.
#include <algorithm>
#include <cmath>
#include <set>

#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "model/point_selection.hpp"
#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

// The range of points and curves on one axis. [font units]
struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return (low + high) / 2; }
};

struct Extent {
  Range x;
  Range y;

  void add(gen::Point p) {
    x.add(p.x);
    y.add(p.y);
  }
};

Extent extent_of(const PointContour& contour) {
  constexpr double kBound = 1.0 / 64;  // of chords [font units]
  Extent extent;
  for (const GlyphPoint& point : contour.points) {
    if (point.on_curve()) {
      extent.add({point.x, point.y});
    }
  }
  for (const gen::Segment& segment : to_segments(contour, 1).segments) {
    const int count = gen::chord_count(segment, kBound);
    for (int i = 0; i < count; ++i) {
      extent.add(gen::point_on(segment, static_cast<double>(i) / count));
    }
  }
  return extent;
}

// "about": a point, "middle" of the points that move, or by default the
// origin.
gen::Point centre_of(const Arguments& arguments,
                     const Glyph& glyph,
                     const PointSelection& selection) {
  if (!arguments.has("about")) {
    return {};
  }
  const Value& about = arguments.value("about");
  if (about == "middle") {
    Extent extent;
    for (const auto& [contour, point] : selection) {
      const GlyphPoint& p = glyph.contours[contour].points[point];
      extent.add({p.x, p.y});
    }
    return selection.empty() ? gen::Point()
                             : gen::Point{extent.x.middle(), extent.y.middle()};
  }
  if (!about.is_array() || about.size() != 2 || !about[0].is_number() ||
      !about[1].is_number()) {
    arguments.refuse("\"about\" is \"middle\" or a point, [x, y]");
  }
  return {about[0].get<double>(), about[1].get<double>()};
}

Matrix move(gen::Point by) {
  Matrix m;
  m.dx = by.x;
  m.dy = by.y;
  return m;
}

PointSelection all_points(const Glyph& glyph) {
  PointSelection all;
  for (size_t c = 0; c < glyph.contours.size(); ++c) {
    for (size_t p = 0; p < glyph.contours[c].points.size(); ++p) {
      all.emplace(c, p);
    }
  }
  return all;
}

// What is ink stays ink: contours that are reflected as a whole change their
// direction.
void turn_round(const PointSelection& selection, Glyph& glyph) {
  for (size_t c = 0; c < glyph.contours.size(); ++c) {
    const auto count =
        std::count_if(selection.begin(), selection.end(),
                      [c](const auto& entry) { return entry.first == c; });
    if (static_cast<size_t>(count) == glyph.contours[c].points.size()) {
      glyph.contours[c] = reversed(glyph.contours[c]);
    }
  }
}

Change transform(const Project& project, const Arguments& arguments) {
  const bool round = arguments.flag("round", true);
  const auto snap = [round](double v) { return round ? std::round(v) : v; };
  const bool is_part = arguments.has("points");
  return edited(
      project, arguments,
      [&](Glyph& glyph) {
        const Glyph before = glyph;
        const PointSelection selection =
            is_part ? parse_selection(glyph, arguments) : all_points(glyph);
        const gen::Point centre = centre_of(arguments, glyph, selection);
        const Matrix matrix = product(
            move(centre),
            product(arguments.matrix("matrix"), move({-centre.x, -centre.y})));
        for (const auto& [contour, point] : selection) {
          GlyphPoint& p = glyph.contours[contour].points[point];
          const gen::Point to = matrix.map(p.x, p.y);
          p.x = snap(to.x);
          p.y = snap(to.y);
        }
        if (is_part && matrix.determinant() < 0) {
          turn_round(selection, glyph);
        }
        if (is_part) {
          if (!selection.empty()) {
            settle_source(before, glyph);
          }
          return;
        }
        for (Anchor& anchor : glyph.anchors) {
          const gen::Point to = matrix.map(anchor.x, anchor.y);
          anchor.x = snap(to.x);
          anchor.y = snap(to.y);
        }
        for (ComponentUse& use : glyph.components) {
          use.matrix = product(matrix, use.matrix);
        }
        transform_source(matrix, glyph);
      },
      true);
}

std::vector<size_t> contours_of(const Glyph& glyph,
                                const Arguments& arguments,
                                size_t least) {
  std::set<size_t> chosen;
  for (const Value& index : arguments.array("contours")) {
    if (!index.is_number_unsigned() ||
        index.get<size_t>() >= glyph.contours.size()) {
      arguments.refuse("\"contours\" are numbers below " +
                       std::to_string(glyph.contours.size()) + "; " +
                       index.dump() + " is none");
    }
    chosen.insert(index.get<size_t>());
  }
  if (chosen.size() < least) {
    arguments.refuse("\"contours\" are " + std::to_string(least) +
                     " or more; here are " + std::to_string(chosen.size()));
  }
  return {chosen.begin(), chosen.end()};
}

void move_contour(double by, bool is_level, PointContour& contour) {
  for (GlyphPoint& point : contour.points) {
    (is_level ? point.x : point.y) += std::round(by);
  }
}

Change align_contours(const Project& project, const Arguments& arguments) {
  static const std::map<std::string, std::pair<bool, double>> kSides = {
      {"left", {true, 0}},    {"centre", {true, 0.5}},  {"right", {true, 1}},
      {"bottom", {false, 0}}, {"middle", {false, 0.5}}, {"top", {false, 1}}};
  const auto side = kSides.find(arguments.text("to"));
  if (side == kSides.end()) {
    arguments.refuse("\"to\" is left, centre, right, bottom, middle or top");
  }
  const auto [is_level, part] = side->second;
  return edited(
      project, arguments, [&, is_level = is_level, part = part](Glyph& glyph) {
        const std::vector<size_t> chosen = contours_of(glyph, arguments, 2);
        const auto range = [&](size_t c) {
          const Extent extent = extent_of(glyph.contours[c]);
          return is_level ? extent.x : extent.y;
        };
        const auto place = [part](const Range& r) {
          return r.low + part * (r.high - r.low);
        };
        Range all;
        for (const size_t c : chosen) {
          all.add(range(c).low);
          all.add(range(c).high);
        }
        for (const size_t c : chosen) {
          move_contour(place(all) - place(range(c)), is_level,
                       glyph.contours[c]);
        }
      });
}

// Equal gaps between the contours; the outermost stay.
Change distribute_contours(const Project& project, const Arguments& arguments) {
  const std::string along = arguments.text("along");
  if (along != "x" && along != "y") {
    arguments.refuse("\"along\" is x or y");
  }
  const bool is_level = along == "x";
  return edited(project, arguments, [&](Glyph& glyph) {
    std::vector<std::pair<Range, size_t>> row;
    double ink = 0;
    Range all;
    for (const size_t c : contours_of(glyph, arguments, 3)) {
      const Extent extent = extent_of(glyph.contours[c]);
      const Range range = is_level ? extent.x : extent.y;
      row.emplace_back(range, c);
      ink += range.high - range.low;
      all.add(range.low);
      all.add(range.high);
    }
    std::stable_sort(row.begin(), row.end(), [](const auto& a, const auto& b) {
      return a.first.middle() < b.first.middle();
    });
    const double gap =
        (all.high - all.low - ink) / static_cast<double>(row.size() - 1);
    double at = all.low;
    for (const auto& [range, c] : row) {
      move_contour(at - range.low, is_level, glyph.contours[c]);
      at += range.high - range.low + gap;
    }
  });
}

}  // namespace

void add_transform_commands(CommandTable& table) {
  table["align_contours"] = align_contours;
  table["distribute_contours"] = distribute_contours;
  table["transform"] = transform;
}

}  // namespace inkcell::design
