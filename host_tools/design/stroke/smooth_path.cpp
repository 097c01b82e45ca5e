#include "stroke/smooth_path.hpp"

#include <algorithm>
#include <cmath>

#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

// Tangents shorter than this, of unit vectors that add up, are none. [1]
constexpr double kLeastTangent = 1e-6;
// A piece is a line if its handles are as near to the chord. [radians]
constexpr double kLeastBend = 1e-6;
constexpr double kLongestHandle = 2;  // [chords]
constexpr int kChordsOfPiece = 16;

// The direction in which a circle through three points passes the middle one;
// {0, 0} where the path turns back.
Point tangent_between(const Point& before,
                      const Point& at,
                      const Point& after) {
  const Point in = at - before;
  const Point out = after - at;
  const Point sum = length(out) * unit(in) + length(in) * unit(out);
  return length(sum) < kLeastTangent * (length(in) + length(out)) ? Point{}
                                                                  : unit(sum);
}

// The length of the handle at the angle `theta` from the chord, `phi` at the
// other end. [chords]
double handle_length(double theta, double phi) {
  const double a = std::sqrt(2.0) * (std::sin(theta) - std::sin(phi) / 16) *
                   (std::sin(phi) - std::sin(theta) / 16) *
                   (std::cos(theta) - std::cos(phi));
  const double root = std::sqrt(5.0);
  const double b =
      1 + (root - 1) / 2 * std::cos(theta) + (3 - root) / 2 * std::cos(phi);
  return std::clamp((2 + a) / (3 * std::max(b, kLeastTangent)), 0.0,
                    kLongestHandle);
}

// `tangent` at one end of a chord as a circle has it at the other end.
Point mirrored(const Point& tangent, const Point& chord) {
  const Point along = unit(chord);
  return 2 * dot(tangent, along) * along - tangent;
}

gen::Segment piece_of(const Point& from,
                      const Point& to,
                      Point leaving,
                      Point arriving) {
  const Point chord = to - from;
  const Point none;
  if (same(leaving, none)) {
    leaving = same(arriving, none) ? unit(chord) : mirrored(arriving, chord);
  }
  if (same(arriving, none)) {
    arriving = mirrored(leaving, chord);
  }
  const double theta = turn(chord, leaving);
  const double phi = turn(arriving, chord);
  gen::Segment piece;
  if (std::fabs(theta) < kLeastBend && std::fabs(phi) < kLeastBend) {
    piece.p[0] = from;
    piece.p[1] = to;
    return piece;
  }
  piece.kind = gen::Segment::Kind::cubic;
  piece.p[0] = from;
  piece.p[1] = from + length(chord) * handle_length(theta, phi) * leaving;
  piece.p[2] = to - length(chord) * handle_length(phi, theta) * arriving;
  piece.p[3] = to;
  return piece;
}

double distance_to_curve(const Point& p, const gen::Segment& piece) {
  double nearest = INFINITY;
  Point last = piece.p[0];
  for (int i = 1; i <= kChordsOfPiece; ++i) {
    const Point next =
        gen::point_on(piece, static_cast<double>(i) / kChordsOfPiece);
    nearest = std::min(nearest, distance_to_piece(p, last, next));
    last = next;
  }
  return nearest;
}

}  // namespace

std::vector<gen::Segment> smooth_path(const std::vector<StrokePoint>& points) {
  const size_t count = points.size();
  std::vector<Point> tangents(count);
  const auto is_smooth = [&points](size_t i) { return !points[i].is_corner; };
  for (size_t i = 1; i + 1 < count; ++i) {
    if (is_smooth(i)) {
      tangents[i] =
          tangent_between(points[i - 1].at, points[i].at, points[i + 1].at);
    }
  }
  if (count > 3 && same(points.front().at, points.back().at) && is_smooth(0) &&
      is_smooth(count - 1)) {
    tangents.front() = tangents.back() =
        tangent_between(points[count - 2].at, points[0].at, points[1].at);
  }
  std::vector<gen::Segment> pieces;
  for (size_t i = 0; i + 1 < count; ++i) {
    pieces.push_back(
        piece_of(points[i].at, points[i + 1].at, tangents[i], tangents[i + 1]));
  }
  return pieces;
}

std::vector<StrokePoint> knots_of(const std::vector<Point>& drawn,
                                  double tolerance) {
  std::vector<Point> all;
  for (const Point& p : drawn) {
    if (all.empty() || !same(all.back(), p)) {
      all.push_back(p);
    }
  }
  std::vector<size_t> kept;  // of all
  std::vector<bool> is_corner(all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == all.size();
    is_corner[i] = !is_end && turns_sharply(all[i - 1], all[i], all[i + 1]);
    if (is_end || is_corner[i]) {
      kept.push_back(i);
    }
  }
  for (bool is_done = false; !is_done;) {
    std::vector<StrokePoint> knots;
    for (const size_t i : kept) {
      StrokePoint knot;
      knot.at = all[i];
      knot.is_corner = is_corner[i];
      knots.push_back(knot);
    }
    const std::vector<gen::Segment> pieces = smooth_path(knots);
    is_done = true;
    for (size_t k = pieces.size(); k-- > 0;) {
      double worst = tolerance;
      size_t at = 0;
      for (size_t i = kept[k] + 1; i < kept[k + 1]; ++i) {
        const double d = distance_to_curve(all[i], pieces[k]);
        if (d > worst) {
          worst = d;
          at = i;
        }
      }
      if (at != 0) {
        kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(k) + 1, at);
        is_done = false;
      }
    }
    if (is_done) {
      return knots;
    }
  }
  return {};
}

}  // namespace inkcell::design
