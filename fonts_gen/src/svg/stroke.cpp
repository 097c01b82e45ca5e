#include "svg/stroke.hpp"

#include <algorithm>
#include <cmath>

#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// A straight part of the path.
struct Chord {
  Point a;
  Point b;
  Point along;  // of length 1
  /// At a joint of the path, not within a curve.
  bool begins_piece = false;
};

Point normal(const Point& along) {
  return {-along.y, along.x};
}

std::vector<Chord> chords_of(const Subpath& subpath, double bound) {
  std::vector<Chord> chords;
  const auto add = [&](const Point& a, const Point& b, bool begins_piece) {
    const Point along = direction(b - a);
    if (!(along == Point{})) {
      chords.push_back({a, b, along, begins_piece});
    }
  };
  Point pen = subpath.segments.front().p[0];
  for (const Segment& segment : subpath.segments) {
    const int count = chord_count(segment, bound);
    const Point end = end_of(segment);
    bool begins_piece = true;
    for (int i = 1; i <= count; ++i) {
      const Point next =
          i == count ? end : point_on(segment, static_cast<double>(i) / count);
      const size_t before = chords.size();
      add(pen, next, begins_piece);
      begins_piece &= chords.size() == before;
      pen = next;
    }
  }
  if (subpath.is_closed) {
    add(pen, subpath.segments.front().p[0], true);
  }
  return chords;
}

class Pen {
 public:
  Pen(const PenStyle& style, double bound)
      : style_(style), half_(style.width / 2) {
    const double share = std::min(1.0, bound / half_);
    step_ = std::max(2 * std::acos(1 - share), 0.01);
  }

  void draw(const Subpath& subpath, double bound) {
    const std::vector<Chord> chords = chords_of(subpath, bound);
    if (chords.empty()) {
      spot(subpath.segments.front().p[0]);
      return;
    }
    for (const Chord& chord : chords) {
      const Point n = half_ * normal(chord.along);
      // With corners on the path, as joins have: pieces share whole edges, so
      // rounding leaves no slit between them.
      pieces_.push_back({chord.a + n, chord.a, chord.a - n, chord.b - n,
                         chord.b, chord.b + n});
    }
    for (size_t i = 1; i < chords.size(); ++i) {
      join(chords[i - 1], chords[i]);
    }
    if (subpath.is_closed) {
      join(chords.back(), chords.front());
    } else {
      cap(chords.front().a, -1.0 * chords.front().along);
      cap(chords.back().b, chords.back().along);
    }
  }

  std::vector<Corners> take() { return std::move(pieces_); }

 private:
  // A sector from `a` to `b` around `centre`, with the pen's radius. The ends
  // are exact, so that neighbours share corners.
  void pie(const Point& centre, const Point& a, const Point& b, double angle) {
    Corners piece = {centre, a};
    const Point from = a - centre;
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::fabs(angle) / step_)));
    for (int i = 1; i < count; ++i) {
      const double t = angle * i / count;
      const double c = std::cos(t);
      const double s = std::sin(t);
      piece.push_back(centre +
                      Point{c * from.x - s * from.y, s * from.x + c * from.y});
    }
    piece.push_back(b);
    pieces_.push_back(std::move(piece));
  }

  // The join on the outer side of a turn.
  void join(const Chord& before, const Chord& after) {
    const Point& at = after.a;
    const double turn = std::atan2(cross(before.along, after.along),
                                   dot(before.along, after.along));
    if (turn == 0) {
      return;
    }
    const double side = turn > 0 ? -half_ : half_;
    const Point a = at + side * normal(before.along);
    const Point b = at + side * normal(after.along);
    const LineJoin kind = after.begins_piece ? style_.join : LineJoin::round;
    if (kind == LineJoin::round) {
      pie(at, a, b, turn);
      return;
    }
    Corners piece = {at, a};
    const double cosine = std::cos(turn / 2);
    if (kind == LineJoin::miter && cosine * style_.miter_limit >= 1) {
      piece.push_back(at + (0.5 / (cosine * cosine)) * ((a - at) + (b - at)));
    }
    piece.push_back(b);
    pieces_.push_back(std::move(piece));
  }

  void cap(const Point& at, const Point& out) {
    const Point n = half_ * normal(out);
    if (style_.cap == LineCap::round) {
      pie(at, at - n, at + n, kPi);
    } else if (style_.cap == LineCap::square) {
      const Point far = at + half_ * out;
      pieces_.push_back({at, at - n, far - n, far + n, at + n});
    }
  }

  // A subpath without length.
  void spot(const Point& at) {
    if (style_.cap != LineCap::butt) {
      cap(at, {1, 0});
      cap(at, {-1, 0});
    }
  }

  PenStyle style_;
  double half_;
  double step_ = 0;  // of round joins [radians]
  std::vector<Corners> pieces_;
};

}  // namespace

std::vector<Corners> stroke_pieces(const Subpath& subpath,
                                   const PenStyle& style,
                                   double bound) {
  Pen pen(style, bound);
  pen.draw(subpath, bound);
  return pen.take();
}

}  // namespace inkcell::gen
