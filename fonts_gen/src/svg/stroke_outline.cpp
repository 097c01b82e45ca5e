#include "svg/stroke_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "svg/arc.hpp"

namespace inkcell::gen {
namespace {

// The most halvings of a curve. Curves without cusps need far fewer.
constexpr int kMostHalvings = 8;
// Points at which a cubic is compared with the exact border.
constexpr int kSamples = 8;
// If a handle has no length, the tangent is taken at this distance from the
// end. [t]
constexpr double kNearEnd = 1e-4;

// A line or a cubic of the path, never of length 0.
struct Piece {
  Segment curve;
  Point along_at_start;  // of length 1
  Point along_at_end;
};

// The same curve as a cubic; lines stay lines.
Segment raised(const Segment& segment) {
  if (segment.kind != Segment::Kind::quadratic) {
    return segment;
  }
  const Point* p = segment.p;
  return {Segment::Kind::cubic,
          {p[0], p[0] + (2.0 / 3) * (p[1] - p[0]),
           p[2] + (2.0 / 3) * (p[1] - p[2]), p[2]}};
}

void add_piece(const Segment& segment, std::vector<Piece>& pieces) {
  const Segment curve = raised(segment);
  const int last = degree_of(curve);
  Piece piece{curve, {}, {}};
  for (int i = last; i > 0; --i) {
    const Point along = direction(curve.p[i] - curve.p[0]);
    piece.along_at_start = along == Point{} ? piece.along_at_start : along;
  }
  for (int i = 0; i < last; ++i) {
    const Point along = direction(curve.p[last] - curve.p[i]);
    piece.along_at_end = along == Point{} ? piece.along_at_end : along;
  }
  if (!(piece.along_at_start == Point{} || piece.along_at_end == Point{})) {
    pieces.push_back(piece);
  }
}

std::vector<Piece> pieces_of(const Subpath& subpath) {
  std::vector<Piece> pieces;
  for (const Segment& segment : subpath.segments) {
    add_piece(segment, pieces);
  }
  if (subpath.is_closed) {
    add_piece(line_segment(end_of(subpath.segments.back()),
                           subpath.segments.front().p[0]),
              pieces);
  }
  return pieces;
}

std::vector<Piece> backwards(std::vector<Piece> pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (Piece& piece : pieces) {
    std::reverse(piece.curve.p, piece.curve.p + degree_of(piece.curve) + 1);
    std::swap(piece.along_at_start, piece.along_at_end);
    piece.along_at_start = -1.0 * piece.along_at_start;
    piece.along_at_end = -1.0 * piece.along_at_end;
  }
  return pieces;
}

Point right_of(const Point& along) {
  return {along.y, -along.x};
}

// The border to the right of a cubic:
//
//   r(t) = p(t) + half right(t),   r'(t) = p'(t) (1 + half curvature(t)).
//
class Border {
 public:
  Border(const Piece& piece, double half) : piece_(piece), half_(half) {}

  Point at(double t) const {
    const Point along = t == 0   ? piece_.along_at_start
                        : t == 1 ? piece_.along_at_end
                                 : direction(velocity(t));
    return point_on(piece_.curve, t) + half_ * right_of(along);
  }

  Point slope(double t) const {
    const Point* p = piece_.curve.p;
    if (length(velocity(t)) < kNearEnd * length(p[3] - p[0])) {
      t = std::clamp(t, kNearEnd, 1 - kNearEnd);
    }
    const Point v = velocity(t);
    const double speed = length(v);
    const double curvature =
        cross(v, acceleration(t)) / (speed * speed * speed);
    return (1 + half_ * curvature) * v;
  }

 private:
  Point velocity(double t) const {
    const Point* p = piece_.curve.p;
    const double s = 1 - t;
    return 3.0 * ((s * s) * (p[1] - p[0]) + (2 * s * t) * (p[2] - p[1]) +
                  (t * t) * (p[3] - p[2]));
  }

  Point acceleration(double t) const {
    const Point* p = piece_.curve.p;
    return 6.0 * ((1 - t) * (p[2] - 2.0 * p[1] + p[0]) +
                  t * (p[3] - 2.0 * p[2] + p[1]));
  }

  const Piece& piece_;
  double half_;
};

class OutlinePen {
 public:
  OutlinePen(const PenStyle& style, double bound)
      : style_(style), half_(style.width / 2), bound_(bound) {}

  // False if a curve has a cusp.
  bool draw(const std::vector<Piece>& pieces, bool is_closed) {
    const std::vector<Piece> back = backwards(pieces);
    if (!side(pieces)) {
      return false;
    }
    if (is_closed) {
      join(pieces.back(), pieces.front());
      end_contour();
    } else {
      cap(pieces.back());
    }
    if (!side(back)) {
      return false;
    }
    if (is_closed) {
      join(back.back(), back.front());
    } else {
      cap(back.back());
    }
    end_contour();
    return true;
  }

  void spot(const Point& at) {
    arc(at, {half_, 0}, 2 * kPi);
    end_contour();
  }

  Outline take() { return std::move(outline_); }

 private:
  // Appends a segment, which begins at the end of the last one.
  void add(Segment segment) {
    if (!contour_.segments.empty()) {
      segment.p[0] = end_of(contour_.segments.back());
    }
    if (degree_of(segment) > 1 || !(segment.p[0] == segment.p[1])) {
      contour_.segments.push_back(segment);
    }
  }

  void line_to(const Point& p) { add(line_segment(p, p)); }

  void end_contour() {
    outline_.contours.push_back(std::exchange(contour_, {}));
  }

  // The border to the right of the path, from its start to its end.
  bool side(const std::vector<Piece>& pieces) {
    for (size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0) {
        join(pieces[i - 1], pieces[i]);
      }
      const Piece& piece = pieces[i];
      if (piece.curve.kind == Segment::Kind::line) {
        const Point off = half_ * right_of(piece.along_at_start);
        add(line_segment(piece.curve.p[0] + off, piece.curve.p[1] + off));
      } else if (!add_border(Border(piece, half_), 0, 1, kMostHalvings)) {
        return false;
      }
    }
    return true;
  }

  // Cubic Hermite interpolation, with as many pieces as the bound needs.
  bool add_border(const Border& border, double t0, double t1, int halvings) {
    const double third = (t1 - t0) / 3;
    const Point a = border.at(t0);
    const Point b = border.at(t1);
    const Segment cubic{
        Segment::Kind::cubic,
        {a, a + third * border.slope(t0), b - third * border.slope(t1), b}};
    bool is_near = true;
    for (int i = 1; i < kSamples; ++i) {
      const double s = static_cast<double>(i) / kSamples;
      const Point exact = border.at(t0 + s * (t1 - t0));
      is_near &= length(point_on(cubic, s) - exact) <= bound_;
    }
    if (is_near) {
      add(cubic);
      return true;
    }
    const double t = (t0 + t1) / 2;
    return halvings > 0 && add_border(border, t0, t, halvings - 1) &&
           add_border(border, t, t1, halvings - 1);
  }

  // An arc from `centre` + `from` by `angle` around `centre`.
  void arc(const Point& centre, const Point& from, double angle) {
    const int count = arc_pieces(angle);
    const double k = arc_handle(angle / count);
    Point a = from;
    for (int i = 1; i <= count; ++i) {
      const double c = std::cos(angle * i / count);
      const double s = std::sin(angle * i / count);
      const Point b = {c * from.x - s * from.y, s * from.x + c * from.y};
      add({Segment::Kind::cubic,
           {centre + a, centre + a - k * right_of(a),
            centre + b + k * right_of(b), centre + b}});
      a = b;
    }
  }

  void join(const Piece& before, const Piece& after) {
    const Point& at = after.curve.p[0];
    const Point& in = before.along_at_end;
    const Point& out = after.along_at_start;
    const Point b = at + half_ * right_of(out);
    const double turn = std::atan2(cross(in, out), dot(in, out));
    const double cosine = std::cos(turn / 2);
    if (half_ * (1 - cosine) <= bound_ / 4) {
      return;  // smooth: the next segment begins where the last one ended
    }
    if (turn < 0) {
      line_to(at);
    } else if (style_.join == LineJoin::round) {
      arc(at, half_ * right_of(in), turn);
    } else if (style_.join == LineJoin::miter &&
               cosine * style_.miter_limit >= 1) {
      const Point sum = half_ * (right_of(in) + right_of(out));
      line_to(at + (0.5 / (cosine * cosine)) * sum);
    }
    line_to(b);
  }

  void cap(const Piece& last) {
    const Point& at = end_of(last.curve);
    const Point out = half_ * last.along_at_end;
    if (style_.cap == LineCap::round) {
      arc(at, right_of(out), kPi);
    } else if (style_.cap == LineCap::square) {
      line_to(at + right_of(out) + out);
      line_to(at - right_of(out) + out);
    }
    line_to(at - right_of(out));
  }

  PenStyle style_;
  double half_;
  double bound_;
  Contour contour_;
  Outline outline_;
};

}  // namespace

std::optional<Outline> stroke_outline(const Subpath& subpath,
                                      const PenStyle& style,
                                      double bound) {
  const std::vector<Piece> pieces = pieces_of(subpath);
  OutlinePen pen(style, bound);
  if (!pieces.empty()) {
    if (!pen.draw(pieces, subpath.is_closed)) {
      return std::nullopt;
    }
  } else if (style.cap == LineCap::round) {
    pen.spot(subpath.segments.front().p[0]);
  } else {
    return std::nullopt;
  }
  return pen.take();
}

}  // namespace inkcell::gen
