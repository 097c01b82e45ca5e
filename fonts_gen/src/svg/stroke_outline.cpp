#include "svg/stroke_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Halvings of a curve. A curve without cusps needs far fewer.
constexpr int kMostHalvings = 8;
// Places at which a cubic is compared with the exact border.
constexpr int kSamples = 8;
// Distance in t from an end whose handle has no length: the tangent there is
// that of a point nearby.
constexpr double kNearEnd = 1e-4;

// A line or a cubic of the path. It has an extent.
struct Piece {
  Segment curve;
  Point along_at_start;  // of length 1
  Point along_at_end;
};

int degree(const Segment& segment) {
  return static_cast<int>(segment.kind) + 1;
}

const Point& end_of(const Segment& segment) {
  return segment.p[degree(segment)];
}

Segment line(const Point& a, const Point& b) {
  return {Segment::Kind::line, {a, b}};
}

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
  const int last = degree(curve);
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
    add_piece(
        line(end_of(subpath.segments.back()), subpath.segments.front().p[0]),
        pieces);
  }
  return pieces;
}

std::vector<Piece> backwards(std::vector<Piece> pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (Piece& piece : pieces) {
    std::reverse(piece.curve.p, piece.curve.p + degree(piece.curve) + 1);
    std::swap(piece.along_at_start, piece.along_at_end);
    piece.along_at_start = -1.0 * piece.along_at_start;
    piece.along_at_end = -1.0 * piece.along_at_end;
  }
  return pieces;
}

Point right_of(const Point& along) {
  return {along.y, -along.x};
}

// The border on the right of a cubic:
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
  OutlinePen(const PenStyle& style,
             double bound,
             Circles& circles,
             bool only_notes)
      : style_(style),
        half_(style.width / 2),
        bound_(bound),
        circles_(circles),
        only_notes_(only_notes) {}

  // False if a curve has a cusp.
  bool draw(const std::vector<Piece>& pieces,
            bool is_closed,
            const CoveredEnds& covered) {
    const std::vector<Piece> back = backwards(pieces);
    if (!side(pieces)) {
      return false;
    }
    if (is_closed) {
      join(pieces.back(), pieces.front());
      end_contour();
    } else {
      cap(pieces.back(), covered.end);
    }
    if (!side(back)) {
      return false;
    }
    if (is_closed) {
      join(back.back(), back.front());
    } else {
      cap(back.back(), covered.start);
    }
    end_contour();
    return true;
  }

  void spot(const Point& at) {
    arc(at, {1, 0}, 2 * kPi);
    end_contour();
  }

  Outline take() { return std::move(outline_); }

 private:
  // The handle goes with the point, so that the tangent stays.
  static void begin_at(const Point& p, Segment& segment) {
    if (degree(segment) > 1) {
      segment.p[1] = segment.p[1] + (p - segment.p[0]);
    }
    segment.p[0] = p;
  }

  // Adds a segment to the contour; it begins where the last one ended.
  void add(Segment segment) {
    if (!contour_.segments.empty()) {
      begin_at(end_of(contour_.segments.back()), segment);
    }
    if (degree(segment) > 1 || !(segment.p[0] == segment.p[1])) {
      contour_.segments.push_back(segment);
    }
  }

  void line_to(const Point& p) { add(line(p, p)); }

  void end_contour() {
    if (contour_.segments.empty()) {
      return;  // arcs are only noted
    }
    // As between segments, a gap that a smooth join leaves is closed.
    Segment& first = contour_.segments.front();
    const Point& last = end_of(contour_.segments.back());
    const Point gap = last - first.p[0];
    if (dot(gap, gap) <= 4 * bound_ * half_) {
      begin_at(last, first);
    }
    outline_.contours.push_back(std::exchange(contour_, {}));
  }

  // The border on the right of the path, from its start to its end.
  bool side(const std::vector<Piece>& pieces) {
    for (size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0) {
        join(pieces[i - 1], pieces[i]);
      }
      const Piece& piece = pieces[i];
      if (piece.curve.kind == Segment::Kind::line) {
        const Point off = half_ * right_of(piece.along_at_start);
        add(line(piece.curve.p[0] + off, piece.curve.p[1] + off));
      } else if (!add_border(Border(piece, half_), 0, 1, kMostHalvings)) {
        return false;
      }
    }
    return true;
  }

  // Cubic Hermite interpolation, in as many parts as the bound needs.
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

  // Around `centre`, from the direction `from` by `angle`; a line in its place
  // if it is covered. Arcs stay as they are: what comes before ends where they
  // begin, and what follows begins where they end.
  void arc(const Point& centre,
           const Point& from,
           double angle,
           bool is_covered = false) {
    const double begin = std::atan2(from.y, from.x);
    if (only_notes_) {
      circles_.note(centre, begin, angle);
      return;
    }
    const std::vector<Segment> pieces = circles_.arc(centre, begin, angle);
    if (pieces.empty()) {
      return;
    }
    if (!contour_.segments.empty()) {
      Segment& before = contour_.segments.back();
      const int last = degree(before);
      const Point way = pieces.front().p[0] - before.p[last];
      before.p[last] = pieces.front().p[0];
      if (last > 1) {
        before.p[last - 1] = before.p[last - 1] + way;
      }
    }
    if (is_covered) {
      line_to(end_of(pieces.back()));
    } else {
      contour_.segments.insert(contour_.segments.end(), pieces.begin(),
                               pieces.end());
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
      arc(at, right_of(in), turn);
      return;
    } else if (style_.join == LineJoin::miter &&
               cosine * style_.miter_limit >= 1) {
      const Point sum = half_ * (right_of(in) + right_of(out));
      line_to(at + (0.5 / (cosine * cosine)) * sum);
    }
    line_to(b);
  }

  void cap(const Piece& last, bool is_covered) {
    const Point& at = end_of(last.curve);
    const Point out = half_ * last.along_at_end;
    if (style_.cap == LineCap::round) {
      arc(at, right_of(last.along_at_end), kPi, is_covered);
      return;
    }
    if (style_.cap == LineCap::square) {
      line_to(at + right_of(out) + out);
      line_to(at - right_of(out) + out);
    }
    line_to(at - right_of(out));
  }

  PenStyle style_;
  double half_;
  double bound_;
  Circles& circles_;
  bool only_notes_;
  Contour contour_;
  Outline outline_;
};

bool draw(const Subpath& subpath,
          const PenStyle& style,
          const CoveredEnds& covered,
          OutlinePen& pen) {
  const std::vector<Piece> pieces = pieces_of(subpath);
  if (!pieces.empty()) {
    return pen.draw(pieces, subpath.is_closed, covered);
  }
  if (style.cap != LineCap::round) {
    return false;
  }
  pen.spot(subpath.segments.front().p[0]);
  return true;
}

}  // namespace

std::optional<Outline> stroke_outline(const Subpath& subpath,
                                      const PenStyle& style,
                                      const CoveredEnds& covered,
                                      double bound,
                                      Circles& circles) {
  OutlinePen pen(style, bound, circles, false);
  return draw(subpath, style, covered, pen) ? std::optional<Outline>(pen.take())
                                            : std::nullopt;
}

void note_arcs(const Subpath& subpath,
               const PenStyle& style,
               double bound,
               Circles& circles) {
  OutlinePen pen(style, bound, circles, true);
  draw(subpath, style, CoveredEnds(), pen);
}

}  // namespace inkcell::gen
