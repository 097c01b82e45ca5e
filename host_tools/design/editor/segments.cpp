#include "editor/segments.hpp"

#include <algorithm>
#include <cmath>

#include "model/contours.hpp"

namespace inkcell::design::editor {
namespace {

// Steps of a curve in the search for a crossing or the nearest place.
constexpr int kSteps = 48;
constexpr int kHalvings = 40;

// The greatest slope of a nearly level line. [1 degree]
constexpr double kNearlyLevel = 0.0175;

size_t last_of(const gen::Segment& segment) {
  switch (segment.kind) {
    case gen::Segment::Kind::line:
      return 1;
    case gen::Segment::Kind::quadratic:
      return 2;
    default:
      return 3;
  }
}

Point between(Point a, Point b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double cross(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

PointContour rounded(const gen::Contour& contour) {
  PointContour points = from_segments(contour, 1);
  for (GlyphPoint& point : points.points) {
    point.x = std::round(point.x);
    point.y = std::round(point.y);
  }
  return points;
}

// A root of the distance to the line within [low, high], where it changes sign.
double root(
    const gen::Segment& segment, Point a, Point b, double low, double high) {
  const bool begins_left = cross(a, b, point_at(segment, low)) > 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    if ((cross(a, b, point_at(segment, middle)) > 0) == begins_left) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return (low + high) / 2;
}

double along(Point a, Point b, Point p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  return square == 0 ? -1 : ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
}

bool is_before(const OnCurve& a, const OnCurve& b) {
  return std::tuple(a.contour, a.segment, a.t) <
         std::tuple(b.contour, b.segment, b.t);
}

// A contour from one cut to the next.
struct Arc {
  std::vector<gen::Segment> segments;
  size_t end = 0;  // the cut
};

// Arcs by the cut at which they begin. `cuts` are sorted by is_before().
std::vector<Arc> arcs_of(const std::vector<PointContour>& contours,
                         const std::vector<OnCurve>& cuts) {
  std::vector<Arc> arcs(cuts.size());
  for (size_t first = 0; first < cuts.size();) {
    size_t last = first;
    while (last < cuts.size() && cuts[last].contour == cuts[first].contour) {
      ++last;
    }
    const std::vector<gen::Segment> all =
        segments_of(contours[cuts[first].contour]);
    for (size_t i = first; i < last; ++i) {
      const OnCurve& from = cuts[i];
      const size_t next = i + 1 < last ? i + 1 : first;
      const OnCurve& to = cuts[next];
      Arc& arc = arcs[i];
      arc.end = next;
      if (from.segment == to.segment && from.t < to.t) {
        const gen::Segment rest = split(all[from.segment], from.t).second;
        arc.segments = {split(rest, (to.t - from.t) / (1 - from.t)).first};
        continue;
      }
      arc.segments.push_back(split(all[from.segment], from.t).second);
      for (size_t k = (from.segment + 1) % all.size(); k != to.segment;
           k = (k + 1) % all.size()) {
        arc.segments.push_back(all[k]);
      }
      arc.segments.push_back(split(all[to.segment], to.t).first);
    }
    first = last;
  }
  return arcs;
}

}  // namespace

std::vector<gen::Segment> segments_of(const PointContour& contour) {
  if (!contour.open()) {
    return to_segments(contour, 1).segments;
  }
  PointContour closed = contour;
  closed.points.front().type = PointType::line;
  std::vector<gen::Segment> segments = to_segments(closed, 1).segments;
  if (!segments.empty()) {
    segments.pop_back();
  }
  return segments;
}

bool is_nearly_level(Point a, Point b) {
  const double dx = std::abs(b.x - a.x);
  const double dy = std::abs(b.y - a.y);
  const double off = std::min(dx, dy);
  return off > 0 && off < kNearlyLevel * std::max(dx, dy);
}

Point point_at(const gen::Segment& segment, double t) {
  return split(segment, t).second.p[0];
}

std::pair<gen::Segment, gen::Segment> split(const gen::Segment& segment,
                                            double t) {
  std::pair<gen::Segment, gen::Segment> parts{segment, segment};
  const size_t last = last_of(segment);
  Point row[4];
  std::copy(segment.p, segment.p + last + 1, row);
  for (size_t i = 0; i <= last; ++i) {
    parts.first.p[i] = row[0];
    parts.second.p[last - i] = row[last - i];
    for (size_t k = 0; k + i < last; ++k) {
      row[k] = between(row[k], row[k + 1], t);
    }
  }
  return parts;
}

std::optional<OnCurve> nearest_on_curve(const Glyph& glyph,
                                        Point at,
                                        double reach) {
  std::optional<OnCurve> best;
  for (size_t c = 0; c < glyph.contours.size(); ++c) {
    const std::vector<gen::Segment> segments = segments_of(glyph.contours[c]);
    for (size_t s = 0; s < segments.size(); ++s) {
      for (int i = 0; i < kSteps; ++i) {
        const double t0 = static_cast<double>(i) / kSteps;
        const Point a = point_at(segments[s], t0);
        const Point b = point_at(segments[s], t0 + 1.0 / kSteps);
        const double t = std::clamp(along(a, b, at), 0.0, 1.0);
        const Point p = between(a, b, t);
        const double distance = std::hypot(p.x - at.x, p.y - at.y);
        if (distance < reach) {
          reach = distance;
          best = OnCurve{c, s, t0 + t / kSteps, p};
        }
      }
    }
  }
  return best;
}

std::vector<OnCurve> crossings(const std::vector<PointContour>& contours,
                               Point a,
                               Point b) {
  std::vector<OnCurve> found;
  for (size_t c = 0; c < contours.size(); ++c) {
    const std::vector<gen::Segment> segments = segments_of(contours[c]);
    for (size_t s = 0; s < segments.size(); ++s) {
      for (int i = 0; i < kSteps; ++i) {
        const double low = static_cast<double>(i) / kSteps;
        const double high = static_cast<double>(i + 1) / kSteps;
        if ((cross(a, b, point_at(segments[s], low)) > 0) ==
            (cross(a, b, point_at(segments[s], high)) > 0)) {
          continue;
        }
        const double t = root(segments[s], a, b, low, high);
        const Point at = point_at(segments[s], t);
        const double place = along(a, b, at);
        if (place >= 0 && place <= 1) {
          found.push_back({c, s, t, at});
        }
      }
    }
  }
  std::sort(found.begin(), found.end(), [a, b](const auto& p, const auto& q) {
    return along(a, b, p.at) < along(a, b, q.at);
  });
  return found;
}

PointContour with_point(const PointContour& contour, const OnCurve& place) {
  gen::Contour result;
  const std::vector<gen::Segment> segments = segments_of(contour);
  for (size_t i = 0; i < segments.size(); ++i) {
    if (i != place.segment) {
      result.segments.push_back(segments[i]);
      continue;
    }
    const auto parts = split(segments[i], place.t);
    result.segments.push_back(parts.first);
    result.segments.push_back(parts.second);
  }
  return rounded(result);
}

// The line joins each cut with the one on the other side of the ink between
// them: a contour that reaches a cut follows the line and continues at the
// other cut.
std::vector<PointContour> cut_contours(
    const std::vector<PointContour>& contours, Point a, Point b) {
  std::vector<PointContour> closed;
  std::vector<PointContour> result;
  for (const PointContour& contour : contours) {
    (contour.open() ? result : closed).push_back(contour);
  }
  const std::vector<OnCurve> line = crossings(closed, a, b);
  if (line.empty() || line.size() % 2 != 0) {
    return contours;
  }
  std::vector<OnCurve> cuts = line;
  std::sort(cuts.begin(), cuts.end(), is_before);
  const auto index_of = [&cuts](const OnCurve& cut) {
    return static_cast<size_t>(
        std::lower_bound(cuts.begin(), cuts.end(), cut, is_before) -
        cuts.begin());
  };
  std::vector<size_t> partner(cuts.size());
  for (size_t i = 0; i < line.size(); i += 2) {
    partner[index_of(line[i])] = index_of(line[i + 1]);
    partner[index_of(line[i + 1])] = index_of(line[i]);
  }
  std::vector<bool> is_cut(closed.size());
  for (const OnCurve& cut : cuts) {
    is_cut[cut.contour] = true;
  }
  for (size_t i = 0; i < closed.size(); ++i) {
    if (!is_cut[i]) {
      result.push_back(closed[i]);
    }
  }
  const std::vector<Arc> arcs = arcs_of(closed, cuts);
  std::vector<bool> done(cuts.size());
  for (size_t start = 0; start < cuts.size(); ++start) {
    gen::Contour part;
    for (size_t at = start; !done[at]; at = partner[arcs[at].end]) {
      done[at] = true;
      part.segments.insert(part.segments.end(), arcs[at].segments.begin(),
                           arcs[at].segments.end());
      gen::Segment edge;
      edge.p[0] = cuts[arcs[at].end].at;
      edge.p[1] = cuts[partner[arcs[at].end]].at;
      part.segments.push_back(edge);
    }
    if (!part.segments.empty()) {
      result.push_back(rounded(part));
    }
  }
  return result;
}

bool is_inside(const std::vector<PointContour>& contours, Point at) {
  // A line to the left crosses the contours an odd number of times.
  const Point far = {at.x - 1e5, at.y + 0.25};
  return crossings(contours, {at.x, at.y + 0.25}, far).size() % 2 != 0;
}

}  // namespace inkcell::design::editor
