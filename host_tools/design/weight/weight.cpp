#include "weight/weight.hpp"

#include <algorithm>
#include <cmath>

#include "model/contours.hpp"
#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

constexpr int kRounds = 3;         // of measuring and adding
constexpr double kStart_u = 0.25;  // of a ray, from its edge
constexpr double kAlong = 0.85;    // cosine: edges of one stem
constexpr double kThickest_u = 330;
constexpr double kMostOfGap = 0.45;  // that an edge takes
constexpr double kMostExtra = 1.5;   // of the growth

gen::Outline outline_of(const std::vector<PointContour>& contours) {
  gen::Outline outline;
  for (const PointContour& contour : contours) {
    gen::Contour curves = to_segments(contour, 1);
    if (!curves.segments.empty()) {
      outline.contours.push_back(std::move(curves));
    }
  }
  return outline;
}

// From an edge along `way`, a unit vector, to the first edge that it meets;
// infinite if there is none or it is not across the way.
double gap_from(const gen::Shape& shape, const Point& edge, const Point& way) {
  const Point from = edge + kStart_u * way;
  double least = gen::kInfinity;
  bool is_across = false;
  for (const gen::Edge& other : shape.edges()) {
    const Point d = other.b - other.a;
    const double area = cross(way, d);
    if (area == 0) {
      continue;
    }
    const double t = cross(other.a - from, d) / area;
    const double s = cross(other.a - from, way) / area;
    if (t > 0 && t < least && s >= 0 && s <= 1) {
      least = t;
      is_across = std::abs(area) > kAlong * length(d);
    }
  }
  return is_across ? least + kStart_u : gen::kInfinity;
}

struct PointOfEdge {
  Point at;
  Point normal;
};

PointOfEdge middle_of(const Piece& piece, bool is_clockwise) {
  return {point_on(piece.curve, 0.5),
          normal_at(piece.curve, 0.5, is_clockwise)};
}

class Weight {
 public:
  Weight(const std::vector<PointContour>& contours, const WeightChange& change)
      : before_(contours), change_(change), shape_(outline_of(contours)) {
    const gen::Shape turned(swapped(outline_of(contours)));
    const Growth& growth = change.growth;
    rises_ = shift_of_heights(level_edges(shape_, turned), shape_.box(),
                              change.heights, growth.up);
    StemShift stems = shift_of_stems(shape_, level_edges(turned, shape_),
                                     growth.across, change.squeeze);
    goes_ = std::move(stems.shift);
    if (change.squeeze < 1) {
      counters_ = std::move(stems.counters);
    }
    holds_top_ = rises_.at(shape_.box().y1) == -growth.up;
    holds_bottom_ = rises_.at(shape_.box().y0) == growth.up;
    for (const PointContour& contour : before_) {
      pieces_.push_back(pieces_of(contour));
      thickness_.emplace_back();
      for (Piece& piece : pieces_.back()) {
        measure(piece);
      }
    }
  }

  std::vector<PointContour> run() {
    std::vector<PointContour> after = moved_contours();
    for (int round = 0; round < kRounds; ++round) {
      const gen::Shape shape(outline_of(after));
      for (size_t c = 0; c < pieces_.size(); ++c) {
        correct(c, pieces_of(after[c]), shape);
      }
      const gen::Shape now(outline_of(moved_contours()));
      hold_heights(now.box());
      hold_counters(now, round == 0);
      after = moved_contours();
    }
    const double dx = shape_.box().x0 - gen::Shape(outline_of(after)).box().x0;
    for (PointContour& contour : after) {
      for (GlyphPoint& point : contour.points) {
        point.x += dx;
      }
    }
    return after;
  }

 private:
  void measure(Piece& piece) {
    const PointOfEdge middle = middle_of(piece, change_.is_clockwise);
    const double by = change_.growth.along(middle.normal);
    const double ink = gap_from(shape_, middle.at, -1.0 * middle.normal);
    const double gap = gap_from(shape_, middle.at, middle.normal);
    const double room = kMostOfGap * (by > 0 ? gap : ink);
    if (std::abs(by) > room) {  // it would meet the other edge
      piece.extra = by > 0 ? room - by : -room - by;
      thickness_.back().push_back(gen::kInfinity);
    } else {
      thickness_.back().push_back(ink < kThickest_u ? ink : gen::kInfinity);
    }
  }

  std::vector<PointContour> moved_contours() const {
    std::vector<PointContour> after;
    for (size_t c = 0; c < before_.size(); ++c) {
      after.push_back(
          moved(before_[c], pieces_[c], change_.growth, change_.is_clockwise));
      const std::vector<GlyphPoint>& was = before_[c].points;
      std::vector<GlyphPoint>& points = after[c].points;
      for (size_t p = 0, end = 0; p < points.size(); p = end) {
        const GlyphPoint at = points[p];  // those of a closed notch are there
        while (end < points.size() && points[end].x == at.x &&
               points[end].y == at.y) {
          ++end;
        }
        const double dx = (goes_.at(was[p].x) + goes_.at(was[end - 1].x)) / 2;
        const double dy = (rises_.at(was[p].y) + rises_.at(was[end - 1].y)) / 2;
        for (size_t i = p; i < end; ++i) {
          points[i].x = at.x + dx;
          points[i].y = at.y + dy;
        }
      }
    }
    return after;
  }

  // Points without a level side leave the heights by more than the growth.
  void hold_heights(const gen::Box& now) {
    constexpr double kNear_u = 30;
    const gen::Box& box = shape_.box();
    if (holds_top_) {
      rises_.raise(box.y1 - kNear_u, box.y1 - now.y1, true);
    }
    if (holds_bottom_) {
      rises_.raise(box.y0 + kNear_u, box.y0 - now.y0, false);
    }
  }

  // The part of counters between slanted stems that stays.
  void hold_counters(const gen::Shape& shape, bool is_first) {
    std::vector<double> row;
    for (SlantedCounter& counter : counters_) {
      shape.crossings(counter.y, row);
      const auto right = std::upper_bound(
          row.begin(), row.end(), counter.middle + goes_.at(counter.middle));
      if (right != row.begin() && right != row.end() &&
          (right - row.begin()) % 2 == 0) {
        const double now = *right - *(right - 1);
        if (is_first) {
          counter.width -= change_.squeeze * (counter.width - now);
        }
        goes_.raise(counter.middle, counter.width - now, true);
      }
    }
  }

  void correct(size_t c,
               const std::vector<Piece>& after,
               const gen::Shape& shape) {
    for (size_t i = 0; i < pieces_[c].size() && i < after.size(); ++i) {
      Piece& piece = pieces_[c][i];
      const PointOfEdge was = middle_of(piece, change_.is_clockwise);
      const PointOfEdge now = middle_of(after[i], change_.is_clockwise);
      // Upright and level edges are those of stems, bars and heights; rays
      // from single curves of a bend would make it uneven.
      const bool is_line = piece.curve.kind == gen::Segment::Kind::line;
      const bool is_axis =
          std::max(std::abs(was.normal.x), std::abs(was.normal.y)) > 0.9995;
      const double ink = gap_from(shape, now.at, -1.0 * now.normal);
      if (!is_line || is_axis || thickness_[c][i] == gen::kInfinity ||
          ink > kThickest_u + thickness_[c][i]) {
        continue;
      }
      const double by = change_.growth.along(was.normal);
      const double most = kMostExtra * std::abs(by);
      piece.extra = std::clamp(
          piece.extra + (thickness_[c][i] + 2 * by - ink) / 2, -most, most);
    }
  }

  const std::vector<PointContour>& before_;
  const WeightChange& change_;
  gen::Shape shape_;
  Shift rises_;
  Shift goes_;
  std::vector<SlantedCounter> counters_;
  bool holds_top_ = false;
  bool holds_bottom_ = false;
  std::vector<std::vector<Piece>> pieces_;
  std::vector<std::vector<double>> thickness_;  // of the ink behind pieces
};

}  // namespace

std::vector<PointContour> with_weight(const std::vector<PointContour>& contours,
                                      const WeightChange& change) {
  if (shape_of(contours).empty()) {
    return contours;
  }
  return Weight(contours, change).run();
}

gen::Shape shape_of(const std::vector<PointContour>& contours) {
  return gen::Shape(outline_of(contours));
}

}  // namespace inkcell::design
