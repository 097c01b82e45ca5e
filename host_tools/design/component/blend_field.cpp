#include "component/blend_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace inkcell::design {
namespace {

// The fillet of a flat corner is cut off at this distance. [radii]
constexpr double kMostReach = 4;
// Beyond the reach the weight falls to 0 until this distance. [reaches]
constexpr double kEndReach = 1.3;
// A fillet may bend behind the tangents at the corner, as edges do; points
// farther behind belong to another side of the ink. [radii]
constexpr double kBehind = 0.3;
constexpr double kFarBehind = 0.6;

// From 1 at `full` to 0 at `none`, smoothly.
double falling(double value, double full, double none) {
  const double t = std::clamp((value - none) / (full - none), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::optional<Point> crossing(const gen::Edge& a, const gen::Edge& b) {
  const Point u = a.b - a.a;
  const Point v = b.b - b.a;
  const double area = cross(u, v);
  if (area == 0) {
    return std::nullopt;
  }
  const double s = cross(b.a - a.a, v) / area;
  const double t = cross(b.a - a.a, u) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) {
    return std::nullopt;
  }
  return a.a + s * u;
}

// Away from ink, which is on the left of edges.
Point normal_of(const gen::Edge& edge) {
  const Point along = unit(edge.b - edge.a);
  return {along.y, -along.x};
}

bool boxes_meet(const gen::Edge& a, const gen::Edge& b) {
  return std::max(a.a.x, a.b.x) >= std::min(b.a.x, b.b.x) &&
         std::max(b.a.x, b.b.x) >= std::min(a.a.x, a.b.x) &&
         std::max(a.a.y, a.b.y) >= std::min(b.a.y, b.b.y) &&
         std::max(b.a.y, b.b.y) >= std::min(a.a.y, a.b.y);
}

}  // namespace

BlendField::BlendField(const gen::Shape& a, const gen::Shape& b, double radius)
    : a_(a), b_(b), radius_(radius) {
  for (const gen::Edge& one : a_.edges()) {
    for (const gen::Edge& other : b_.edges()) {
      if (!boxes_meet(one, other)) {
        continue;
      }
      const auto at = crossing(one, other);
      if (!at) {
        continue;
      }
      Corner corner{*at, normal_of(one), normal_of(other), 0, 0};
      const double angle = std::fabs(turn(corner.normal_a, corner.normal_b));
      corner.reach = radius_ / std::max(std::sin(angle), 1 / kMostReach);
      corner.weight = std::min(1.0, std::sqrt(2.0) * std::sin(angle / 2));
      corners_.push_back(corner);
    }
  }
}

double BlendField::weight_at(const Point& p) const {
  double most = 0;
  for (const Corner& corner : corners_) {
    const Point from = p - corner.at;
    const double near =
        falling(length(from), corner.reach, kEndReach * corner.reach);
    if (near == 0) {
      continue;
    }
    const double side =
        std::min(dot(from, corner.normal_a), dot(from, corner.normal_b)) /
        radius_;
    most = std::max(
        most, corner.weight * near * falling(side, -kBehind, -kFarBehind));
  }
  return most;
}

double BlendField::swell_of(const Point& p, double a, double b) const {
  const double h = radius_ - std::fabs(a - b);
  return h <= 0 ? 0 : weight_at(p) * h * h / (4 * radius_);
}

double BlendField::swell(const Point& p) const {
  return swell_of(p, a_.distance(p.x, p.y), b_.distance(p.x, p.y));
}

double BlendField::distance(const Point& p) const {
  const double a = a_.distance(p.x, p.y);
  const double b = b_.distance(p.x, p.y);
  return std::max(a, b) + swell_of(p, a, b);
}

gen::Box BlendField::box() const {
  const double reach = radius_ / 4 + 2;
  const gen::Box& a = a_.box();
  const gen::Box& b = b_.box();
  return {std::min(a.x0, b.x0) - reach, std::min(a.y0, b.y0) - reach,
          std::max(a.x1, b.x1) + reach, std::max(a.y1, b.y1) + reach};
}

}  // namespace inkcell::design
