#include "trace/field_outline.hpp"

#include <algorithm>
#include <cmath>

#include "field/record.hpp"
#include "model/error.hpp"
#include "trace/contour_walk.hpp"

namespace inkcell::design {
namespace {

// How far a corner is rounded: samples lose it within their smallest cells.
constexpr double kReach_u = 2.5;

// Least turn of a corner. [radians]
constexpr double kTurn = 0.2;

void add_distances(const gen::Shape& from,
                   const gen::Shape& to,
                   double step_u,
                   EdgeError& error) {
  for (const gen::Edge& edge : from.edges()) {
    const Point chord = edge.b - edge.a;
    const int steps = std::max(1, static_cast<int>(length(chord) / step_u));
    for (int i = 0; i < steps; ++i) {
      const Point p = edge.a + static_cast<double>(i) / steps * chord;
      const double d = to.distance(p.x, p.y);
      error.worst = std::max(error.worst, std::fabs(d));
      // Weighted by length, so that short chords do not count more.
      const double share = length(chord) / steps;
      error.sum += d * d * share;
      error.length_u += share;
    }
  }
}

}  // namespace

gen::Outline outline_of(const GlyphField& field,
                        const FieldOutlineOptions& options) {
  const auto distance = [&field](const Point& p) {
    return distance_u(field, p);
  };
  std::vector<Loop> loops = walk_contours(field);
  CornerOptions corners;
  corners.reach = kReach_u;
  corners.turn = kTurn;
  corners.distance = distance;
  for (Loop& loop : loops) {
    find_corners(corners, loop);
  }
  FitOptions fit;
  fit.tolerance = options.tolerance_u;
  fit.extremes = options.extremes;
  fit.distance = distance;
  return fit_loops(loops, fit);
}

ShapeField::ShapeField(const gen::Shape& shape, const gen::Target& options)
    : record_(gen::field_record(gen::build_sample_tree(shape, options))) {
  if (GlyphField::open({record_.data(), record_.size()}, field_) !=
      Status::ok) {
    throw Error("the field that was generated cannot be opened");
  }
}

double EdgeError::rms() const {
  return length_u == 0 ? 0 : std::sqrt(sum / length_u);
}

void EdgeError::add(const EdgeError& other) {
  worst = std::max(worst, other.worst);
  sum += other.sum;
  length_u += other.length_u;
}

EdgeError edge_error(const gen::Shape& a, const gen::Shape& b, double step_u) {
  EdgeError error;
  if (a.empty() || b.empty()) {
    error.worst = a.empty() && b.empty() ? 0 : HUGE_VAL;
    return error;
  }
  add_distances(a, b, step_u, error);
  add_distances(b, a, step_u, error);
  return error;
}

}  // namespace inkcell::design
