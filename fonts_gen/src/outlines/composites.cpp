#include "outlines/composites.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "outlines/expand.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace {

using Polyline = std::vector<Point>;  // closed, [grid units]

// Chords of a curve for comparing components.
constexpr int kChords = 8;
// Components whose borders come nearer are treated as touching. [grid units]
constexpr double kLeastGap = 2;

// Limits of the search for a glyph, and the most components that it finds.
constexpr int kMostTries = 20000;
constexpr size_t kMostComponents = 8;

bool far_apart(const Box& a, const Box& b) {
  return a.x0 > b.x1 + kLeastGap || b.x0 > a.x1 + kLeastGap ||
         a.y0 > b.y1 + kLeastGap || b.y0 > a.y1 + kLeastGap;
}

Polyline flatten(const Contour& contour) {
  Polyline line = {contour.segments.front().p[0]};
  for (const Segment& segment : contour.segments) {
    const Point* p = segment.p;
    const int chords = segment.kind == Segment::Kind::line ? 0 : kChords;
    for (int i = 1; i <= chords; ++i) {
      line.push_back(
          on_quadratic(p[0], p[1], p[2], static_cast<double>(i) / kChords));
    }
    if (chords == 0) {
      line.push_back(end_of(segment));
    }
  }
  return line;
}

// The contours of a component, moved as its reference says.
std::vector<Polyline> placed(const MinimalOutline& outline,
                             const OutlineReference& reference,
                             int grid_shift) {
  const auto& m = reference.matrix_q14;
  const auto times = [&m](size_t i, double value) {
    return std::ldexp(m[i] * value, -14);
  };
  const double dx = std::ldexp(reference.dx, -grid_shift);
  const double dy = std::ldexp(reference.dy, -grid_shift);
  std::vector<Polyline> lines;
  for (const MinimalContour& contour : outline.contours) {
    lines.push_back(flatten(expand(contour, 1)));
    for (Point& p : lines.back()) {
      p = {times(0, p.x) + times(1, p.y) + dx,
           times(2, p.x) + times(3, p.y) + dy};
    }
  }
  return lines;
}

double side(const Point& p, const Point& a, const Point& b) {
  return cross(b - a, p - a);
}

bool are_near(const Point& a0,
              const Point& a1,
              const Point& b0,
              const Point& b1) {
  const bool cross = (side(b0, a0, a1) > 0) != (side(b1, a0, a1) > 0) &&
                     (side(a0, b0, b1) > 0) != (side(a1, b0, b1) > 0);
  return cross || std::min({squared_distance_to_segment(a0, b0, b1),
                            squared_distance_to_segment(a1, b0, b1),
                            squared_distance_to_segment(b0, a0, a1),
                            squared_distance_to_segment(b1, a0, a1)}) <
                      kLeastGap * kLeastGap;
}

bool are_near(const Polyline& a, const Polyline& b) {
  if (far_apart(box_of({a}), box_of({b}))) {
    return false;
  }
  for (size_t i = 0; i + 1 < a.size(); ++i) {
    for (size_t j = 0; j + 1 < b.size(); ++j) {
      if (are_near(a[i], a[i + 1], b[j], b[j + 1])) {
        return true;
      }
    }
  }
  return false;
}

bool is_inside(const Point& p, const std::vector<Polyline>& lines) {
  bool inside = false;
  for (const Polyline& line : lines) {
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      const Point& a = line[i];
      const Point& b = line[i + 1];
      if ((a.y > p.y) != (b.y > p.y)) {
        const bool upwards = b.y > a.y;
        inside ^= (side(p, a, b) > 0) == upwards;
      }
    }
  }
  return inside;
}

bool any_inside(const std::vector<Polyline>& a,
                const std::vector<Polyline>& b) {
  return std::any_of(a.begin(), a.end(), [&b](const Polyline& line) {
    return is_inside(line.front(), b);
  });
}

bool overlap(const std::vector<Polyline>& a, const std::vector<Polyline>& b) {
  if (far_apart(box_of(a), box_of(b))) {
    return false;
  }
  for (const Polyline& x : a) {
    for (const Polyline& y : b) {
      if (are_near(x, y)) {
        return true;
      }
    }
  }
  // Borders do not meet: each contour is inside as a whole or not at all.
  return any_inside(a, b) || any_inside(b, a);
}

// Applies `inner`, then `outer`.
OutlineReference compose(const OutlineReference& outer,
                         const OutlineReference& inner) {
  const auto& m = outer.matrix_q14;
  OutlineReference result;
  result.glyph = inner.glyph;
  result.dx = outer.dx + sum_q14(m[0], inner.dx, m[1], inner.dy);
  result.dy = outer.dy + sum_q14(m[2], inner.dx, m[3], inner.dy);
  result.matrix_q14 = product(m, inner.matrix_q14);
  return result;
}

// A contour without its position: the offsets of its points from the least one
// by (y, x), which comes first.
struct ContourShape {
  std::vector<std::tuple<int, int, PointKind>> points;

  bool operator<(const ContourShape& other) const {
    return points < other.points;
  }
};

// A contour of a glyph: the number of its shape, and its position. [grid units]
struct PlacedContour {
  size_t shape;
  int x;
  int y;
};

class CompositeSearch {
 public:
  CompositeSearch(const std::vector<CompositeCandidate>& glyphs, int grid_shift)
      : glyphs_(glyphs),
        grid_shift_(grid_shift),
        references_(glyphs.size()),
        is_component_(glyphs.size()),
        state_(glyphs.size(), State::open) {
    for (const CompositeCandidate& glyph : glyphs) {
      contours_.push_back(place_contours(glyph.outline));
    }
    glyphs_with_.resize(shapes_.size());
  }

  // Glyphs with few contours first, as they are components of others. Of these,
  // glyphs that are no composites in the source come first.
  std::vector<OutlineReferences> run() {
    std::vector<size_t> order(glyphs_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [this](size_t a, size_t b) {
      return contours_[a].size() < contours_[b].size();
    });
    for (const size_t g : order) {
      if (glyphs_[g].source.empty()) {
        search(g);
      }
    }
    for (const size_t g : order) {
      add_source(g);
    }
    for (const size_t g : order) {
      if (references_[g].empty() && !glyphs_[g].source.empty()) {
        search(g);
      }
    }
    return std::move(references_);
  }

 private:
  enum class State { open, visited, done };

  std::vector<PlacedContour> place_contours(const MinimalOutline& outline) {
    std::vector<PlacedContour> result;
    for (const MinimalContour& contour : outline.contours) {
      const std::vector<GridPoint>& points = contour.points;
      const auto least = std::min_element(
          points.begin(), points.end(),
          [](const GridPoint& a, const GridPoint& b) {
            return std::tie(a.y, a.x, a.kind) < std::tie(b.y, b.x, b.kind);
          });
      const auto first = static_cast<size_t>(least - points.begin());
      ContourShape shape;
      for (size_t i = 0; i < points.size(); ++i) {
        const GridPoint& point = points[(first + i) % points.size()];
        shape.points.emplace_back(point.x - least->x, point.y - least->y,
                                  point.kind);
      }
      const size_t number =
          shapes_.emplace(std::move(shape), shapes_.size()).first->second;
      result.push_back({number, least->x, least->y});
    }
    return result;
  }

  // Adds the source's components; composites among them are replaced by their
  // own components.
  void add_source(size_t g) {
    if (state_[g] != State::open || glyphs_[g].source.empty()) {
      return;
    }
    state_[g] = State::visited;
    OutlineReferences flat;
    for (const OutlineReference& reference : glyphs_[g].source) {
      const size_t component = reference.glyph;
      add_source(component);
      if (state_[component] == State::visited) {
        return;  // a cycle
      }
      if (references_[component].empty()) {
        flat.push_back(reference);
      }
      for (const OutlineReference& inner : references_[component]) {
        flat.push_back(compose(reference, inner));
      }
    }
    state_[g] = State::done;
    const auto is_blank = [this](const OutlineReference& reference) {
      return glyphs_[reference.glyph].simple_bytes == 0;
    };
    flat.erase(std::remove_if(flat.begin(), flat.end(), is_blank), flat.end());
    offer(g, flat);
  }

  // Makes `g` a composite of `references` if that is correct and saves bytes.
  bool offer(size_t g, const OutlineReferences& references) {
    if (references.empty() || is_component_[g] || !fits_record(references) ||
        (composite_bits(references) + 7) / 8 >= glyphs_[g].simple_bytes) {
      return false;
    }
    for (size_t i = 0; i < references.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        if (components_overlap(glyphs_, references[i], references[j],
                               grid_shift_)) {
          return false;
        }
      }
    }
    for (const OutlineReference& reference : references) {
      is_component_[reference.glyph] = true;
    }
    references_[g] = references;
    return true;
  }

  // Searches for simple glyphs that together have the contours of `g`; they
  // have been searched before. If there are none, `g` may become a component.
  void search(size_t g) {
    if (contours_[g].empty()) {
      return;
    }
    best_.clear();
    best_bits_ = std::numeric_limits<size_t>::max();
    tries_ = 0;
    if (!is_component_[g]) {
      std::vector<bool> covered(contours_[g].size());
      OutlineReferences chosen;
      cover(g, covered, chosen);
    }
    if (best_.empty() || !offer(g, best_)) {
      for (const PlacedContour& contour : contours_[g]) {
        std::vector<size_t>& list = glyphs_with_[contour.shape];
        if (list.empty() || list.back() != g) {
          list.push_back(g);
        }
      }
    }
  }

  // Extends `chosen` until all contours of `g` are covered, and keeps the
  // references with the fewest bits.
  void cover(size_t g, std::vector<bool>& covered, OutlineReferences& chosen) {
    const size_t bits = composite_bits(chosen);
    if (bits >= best_bits_ || ++tries_ > kMostTries) {
      return;
    }
    const auto open = std::find(covered.begin(), covered.end(), false);
    if (open == covered.end()) {
      best_ = chosen;
      best_bits_ = bits;
      return;
    }
    if (chosen.size() == kMostComponents) {
      return;
    }
    const PlacedContour& wanted =
        contours_[g][static_cast<size_t>(open - covered.begin())];
    for (const size_t component : glyphs_with_[wanted.shape]) {
      for (const PlacedContour& contour : contours_[component]) {
        if (contour.shape == wanted.shape) {
          try_component(g, component, wanted.x - contour.x,
                        wanted.y - contour.y, covered, chosen);
        }
      }
    }
  }

  void try_component(size_t g,
                     size_t component,
                     int x,
                     int y,
                     const std::vector<bool>& covered,
                     OutlineReferences& chosen) {
    OutlineReference reference;
    reference.glyph = component;
    const std::optional<int> dx = font_units(x);
    const std::optional<int> dy = font_units(y);
    std::vector<bool> with_component = covered;
    if (component == g || !dx || !dy ||
        !mark_contours(g, component, x, y, with_component)) {
      return;
    }
    reference.dx = *dx;
    reference.dy = *dy;
    chosen.push_back(reference);
    cover(g, with_component, chosen);
    chosen.pop_back();
  }

  // Marks the contours of `component`, moved, among those of `g`; false if one
  // is missing or already covered.
  bool mark_contours(size_t g,
                     size_t component,
                     int x,
                     int y,
                     std::vector<bool>& covered) const {
    for (const PlacedContour& contour : contours_[component]) {
      size_t i = 0;
      while (i < covered.size() &&
             (covered[i] || contours_[g][i].shape != contour.shape ||
              contours_[g][i].x != contour.x + x ||
              contours_[g][i].y != contour.y + y)) {
        ++i;
      }
      if (i == covered.size()) {
        return false;
      }
      covered[i] = true;
    }
    return true;
  }

  // Empty if the length is not a whole number of font units.
  std::optional<int> font_units(int grid_units) const {
    if (grid_shift_ >= 0) {
      return grid_units * (1 << grid_shift_);
    }
    const int units = 1 << -grid_shift_;
    if (grid_units % units != 0) {
      return std::nullopt;
    }
    return grid_units / units;
  }

  const std::vector<CompositeCandidate>& glyphs_;
  int grid_shift_;
  std::vector<OutlineReferences> references_;
  std::vector<bool> is_component_;  // must stay simple
  std::vector<State> state_;        // of add_source()
  std::map<ContourShape, size_t> shapes_;
  std::vector<std::vector<PlacedContour>> contours_;
  std::vector<std::vector<size_t>> glyphs_with_;  // by shape; simple ones
  OutlineReferences best_;
  size_t best_bits_ = 0;
  int tries_ = 0;
};

}  // namespace

std::vector<OutlineReferences> find_composites(
    const std::vector<CompositeCandidate>& glyphs, int grid_shift) {
  return CompositeSearch(glyphs, grid_shift).run();
}

bool components_overlap(const std::vector<CompositeCandidate>& glyphs,
                        const OutlineReference& a,
                        const OutlineReference& b,
                        int grid_shift) {
  return overlap(placed(glyphs[a.glyph].outline, a, grid_shift),
                 placed(glyphs[b.glyph].outline, b, grid_shift));
}

}  // namespace inkcell::gen
