#include "outlines/unite.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "outlines/curves.hpp"
#include "outlines/intersect.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"

namespace inkcell {
namespace gen {
namespace {

// How far from the middle of a piece the winding is looked at. More than
// kSamePoint_u, so that pieces on each other have the same two sides. [u]
constexpr double kAside_u = 1e-3;
// Smallest area of a contour. [u^2]
constexpr double kLeastArea = 1e-2;
// How far the result may be from the union of the flattened contours. [u]
constexpr double kAgreement_u = 2 * kFlatteningBound;

// A part of a source segment, monotonic in x and in y, and the vertices at its
// ends once they are known.
struct Piece {
  uint32_t source;
  double t0;
  double t1;
  Segment curve;
  size_t from = 0;
  size_t to = 0;
  bool backwards = false;  // from `t1` to `t0`; `curve` is turned round already
};

std::vector<Segment> closed_segments(const Outline& outline) {
  std::vector<Segment> segments;
  for (const Contour& contour : outline.contours) {
    if (flatten(contour).size() < 3) {
      continue;  // and coordinates are checked
    }
    const Point first = contour.segments.front().p[0];
    Point pen = first;
    for (const Segment& segment : contour.segments) {
      bool moves = false;
      for (int i = 1; i <= degree_of(segment); ++i) {
        moves |= !(segment.p[i] == segment.p[0]);
      }
      if (moves) {
        segments.push_back(segment);
        pen = end_of(segment);
      }
    }
    if (!(pen == first)) {
      segments.push_back(line_segment(pen, first));
    }
  }
  return segments;
}

// Pieces between the parameters `at`, which are sorted here.
void cut(const Segment& source,
         uint32_t index,
         std::vector<double> at,
         std::vector<Piece>& pieces) {
  at.push_back(0);
  at.push_back(1);
  std::sort(at.begin(), at.end());
  for (size_t i = 0; i + 1 < at.size(); ++i) {
    if (at[i] < at[i + 1]) {
      pieces.push_back(
          {index, at[i], at[i + 1], part_of(source, at[i], at[i + 1])});
    }
  }
}

// Numbers for points; those closer than kSamePoint_u share one.
class Vertices {
 public:
  explicit Vertices(const std::vector<Piece>& pieces) {
    for (const Piece& piece : pieces) {
      points_.push_back(piece.curve.p[0]);
      points_.push_back(end_of(piece.curve));
    }
    std::vector<size_t> order(points_.size());
    for (size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::sort(order.begin(), order.end(), [this](size_t a, size_t b) {
      const Point& p = points_[a];
      const Point& q = points_[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
    number_.resize(points_.size());
    for (size_t i = 0; i < order.size(); ++i) {
      number_[order[i]] = order[i];
      for (size_t k = i; k-- > 0;) {
        const Point d = points_[order[i]] - points_[order[k]];
        if (d.x > kSamePoint_u) {
          break;
        }
        if (length(d) <= kSamePoint_u) {
          number_[order[i]] = number_[order[k]];
          break;
        }
      }
    }
  }

  size_t start(size_t piece) const { return number_[2 * piece]; }
  size_t end(size_t piece) const { return number_[2 * piece + 1]; }
  const Point& at(size_t vertex) const { return points_[vertex]; }
  size_t count() const { return points_.size(); }

 private:
  std::vector<Point> points_;
  std::vector<size_t> number_;
};

// Abscissa at which a piece has the ordinate y, which lies between its ends.
double abscissa(const Segment& curve, double y) {
  const bool rises = curve.p[0].y < end_of(curve).y;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 48; ++i) {
    const double t = (low + high) / 2;
    ((point_on(curve, t).y < y) == rises ? low : high) = t;
  }
  return point_on(curve, low).x;
}

int winding(const std::vector<Piece>& pieces, const Point& at) {
  int sum = 0;
  for (const Piece& piece : pieces) {
    const Point& a = piece.curve.p[0];
    const Point& b = end_of(piece.curve);
    if ((a.y <= at.y) == (b.y <= at.y) || std::max(a.x, b.x) < at.x) {
      continue;
    }
    if (std::min(a.x, b.x) > at.x || abscissa(piece.curve, at.y) > at.x) {
      sum += b.y > a.y ? 1 : -1;
    }
  }
  return sum;
}

class Union {
 public:
  // False if the pieces do not make closed contours.
  bool make(const Outline& outline, Outline& result) {
    sources_ = closed_segments(outline);
    if (!cut_at_meetings()) {
      return false;
    }
    keep_border();
    return stitch(result);
  }

 private:
  bool cut_at_meetings() {
    std::vector<Piece> monotonic;
    for (size_t i = 0; i < sources_.size(); ++i) {
      cut(sources_[i], static_cast<uint32_t>(i), turning_points(sources_[i]),
          monotonic);
    }
    std::vector<std::vector<double>> at(sources_.size());
    const auto add = [&](const Piece& piece, double t) {
      const Point p = point_on(piece.curve, t);
      if (length(p - piece.curve.p[0]) > kSamePoint_u &&
          length(p - end_of(piece.curve)) > kSamePoint_u) {
        at[piece.source].push_back(piece.t0 + t * (piece.t1 - piece.t0));
      }
    };
    std::vector<Meeting> meetings;
    for (size_t i = 0; i < monotonic.size(); ++i) {
      for (size_t k = i + 1; k < monotonic.size(); ++k) {
        if (same(monotonic[i].curve, monotonic[k].curve)) {
          continue;
        }
        meetings.clear();
        if (!find_meetings(monotonic[i].curve, monotonic[k].curve, meetings)) {
          return false;
        }
        for (const Meeting& meeting : meetings) {
          add(monotonic[i], meeting.t);
          add(monotonic[k], meeting.u);
        }
      }
    }
    for (const Piece& piece : monotonic) {
      at[piece.source].push_back(piece.t0);
    }
    for (size_t i = 0; i < sources_.size(); ++i) {
      cut(sources_[i], static_cast<uint32_t>(i), at[i], pieces_);
    }
    const Vertices vertices(pieces_);
    for (size_t i = 0; i < pieces_.size(); ++i) {
      pieces_[i].from = vertices.start(i);
      pieces_[i].to = vertices.end(i);
      points_.push_back(vertices.at(2 * i));
      points_.push_back(vertices.at(2 * i + 1));
    }
    return true;
  }

  // One curve twice, in whatever direction.
  static bool same(const Segment& a, const Segment& b) {
    if (a.kind != b.kind || a.kind == Segment::Kind::line) {
      return false;
    }
    const Segment turned = reversed(b);
    const auto equal = [&](const Segment& other) {
      return std::equal(a.p, a.p + degree_of(a) + 1, other.p);
    };
    return equal(b) || equal(turned);
  }

  void keep_border() {
    std::vector<Piece> kept;
    for (const Piece& piece : pieces_) {
      if (piece.from == piece.to) {
        continue;
      }
      const Point middle_point = point_on(piece.curve, 0.5);
      const Point along = direction(point_on(piece.curve, 0.5 + 1e-3) -
                                    point_on(piece.curve, 0.5 - 1e-3));
      const Point left{-kAside_u * along.y, kAside_u * along.x};
      const bool filled_left = winding(pieces_, middle_point + left) != 0;
      const bool filled_right = winding(pieces_, middle_point - left) != 0;
      if (filled_left == filled_right) {
        continue;
      }
      Piece border = piece;
      if (filled_right) {
        border.curve = reversed(piece.curve);
        border.backwards = true;
        std::swap(border.from, border.to);
      }
      if (!lies_on_one_of(border, kept)) {
        kept.push_back(border);
      }
    }
    pieces_ = std::move(kept);
  }

  static bool lies_on_one_of(const Piece& piece,
                             const std::vector<Piece>& others) {
    const Point m = point_on(piece.curve, 0.5);
    for (const Piece& other : others) {
      if (other.from == piece.from && other.to == piece.to &&
          length(point_on(other.curve, 0.5) - m) < kAside_u) {
        return true;
      }
    }
    return false;
  }

  // Where contours touch, the next piece is the first one clockwise from the
  // one that arrives: it bounds the same corner of the filled area.
  //
  //            ^ next         filled area: left of both
  //     filled |
  //     -----> o -----> another
  //
  size_t next_of(size_t piece, const std::vector<bool>& used) const {
    size_t best = pieces_.size();
    double best_turn = 0;
    const Point back = aim(reversed(pieces_[piece].curve));
    for (const size_t candidate : leaving_[pieces_[piece].to]) {
      if (used[candidate]) {
        continue;
      }
      const double turn = clockwise(back, aim(pieces_[candidate].curve));
      if (best == pieces_.size() || turn < best_turn) {
        best = candidate;
        best_turn = turn;
      }
    }
    return best;
  }

  // The direction a little way along, so that tangent curves are told apart.
  static Point aim(const Segment& curve) {
    const double size = length(end_of(curve) - curve.p[0]);
    return direction(point_on(curve, std::min(0.5, 0.5 / size)) - curve.p[0]);
  }

  // 0..4 for a turn of 0..360 degrees, monotonic.
  static double clockwise(const Point& from, const Point& to) {
    const double s = -cross(from, to);
    const double c = dot(from, to);
    return s >= 0 ? 1 - c : 3 + c;
  }

  bool stitch(Outline& result) {
    leaving_.assign(points_.size(), {});
    for (size_t i = 0; i < pieces_.size(); ++i) {
      leaving_[pieces_[i].from].push_back(i);
    }
    std::vector<bool> used(pieces_.size(), false);
    for (size_t first = 0; first < pieces_.size(); ++first) {
      if (used[first]) {
        continue;
      }
      std::vector<Piece> chain;
      size_t piece = first;
      do {
        used[piece] = true;
        chain.push_back(pieces_[piece]);
        if (pieces_[piece].to == pieces_[first].from) {
          // Closed, unless the corner goes on.
          const std::vector<size_t>& here = leaving_[pieces_[piece].to];
          if (here.size() == 1) {
            break;
          }
          used[first] = false;
          const size_t next = next_of(piece, used);
          used[first] = true;
          if (next == first) {
            break;
          }
          piece = next;
        } else {
          piece = next_of(piece, used);
        }
        if (piece == pieces_.size()) {
          return false;
        }
      } while (true);
      add_contour(chain, result);
    }
    return true;
  }

  static bool continues(const Piece& a, const Piece& b) {
    return a.source == b.source && a.backwards == b.backwards &&
           (a.backwards ? a.t0 == b.t1 : a.t1 == b.t0);
  }

  // Parts of one source segment become one again.
  void add_contour(std::vector<Piece>& chain, Outline& result) const {
    size_t start = 0;
    while (start < chain.size() &&
           continues(chain[(start + chain.size() - 1) % chain.size()],
                     chain[start])) {
      ++start;
    }
    std::rotate(chain.begin(),
                chain.begin() + static_cast<ptrdiff_t>(start % chain.size()),
                chain.end());
    std::vector<Piece> whole;
    for (const Piece& piece : chain) {
      if (!whole.empty() && continues(whole.back(), piece)) {
        (piece.backwards ? whole.back().t0 : whole.back().t1) =
            piece.backwards ? piece.t0 : piece.t1;
        whole.back().to = piece.to;
      } else {
        whole.push_back(piece);
      }
    }
    Contour contour;
    double area = 0;
    for (const Piece& piece : whole) {
      Segment segment = part_of(sources_[piece.source], piece.t0, piece.t1);
      if (piece.backwards) {
        segment = reversed(segment);
      }
      segment.p[0] = points_[piece.from];
      segment.p[degree_of(segment)] = points_[piece.to];
      area += twice_area(segment);
      contour.segments.push_back(segment);
    }
    if (std::fabs(area) > 2 * kLeastArea) {
      result.contours.push_back(std::move(contour));
    }
  }

  std::vector<Segment> sources_;
  std::vector<Piece> pieces_;
  std::vector<Point> points_;
  std::vector<std::vector<size_t>> leaving_;
};

bool agree(const Outline& outline, const Shape& shape) {
  double twice = 0;
  for (const Contour& contour : outline.contours) {
    for (const Segment& segment : contour.segments) {
      twice += twice_area(segment);
      for (const double t : {0.0, 0.3, 0.7}) {
        const Point p = point_on(segment, t);
        if (std::fabs(shape.distance(p.x, p.y)) > kAgreement_u) {
          return false;
        }
      }
    }
  }
  double border = 0;
  for (const Edge& edge : shape.edges()) {
    twice -= cross(edge.a, edge.b);
    border += length(edge.b - edge.a);
  }
  return std::fabs(twice) <= 2 * (kAgreement_u * border + kLeastArea);
}

// Edges of Shape follow each other; a contour ends where they do not.
Outline contours_of(const Shape& shape) {
  Outline outline;
  bool open = false;
  for (const Edge& edge : shape.edges()) {
    if (!open) {
      outline.contours.emplace_back();
    }
    std::vector<Segment>& segments = outline.contours.back().segments;
    segments.push_back(line_segment(edge.a, edge.b));
    open = !(edge.b == segments.front().p[0]);
  }
  return outline;
}

}  // namespace

Outline unite(const Outline& outline) {
  const Shape shape(outline);
  Outline result;
  if (shape.empty()) {
    return result;
  }
  if (!Union().make(outline, result) || !agree(result, shape)) {
    return contours_of(shape);
  }
  return result;
}

}  // namespace gen
}  // namespace inkcell
