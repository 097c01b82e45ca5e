#include "morph_reader.hpp"

#include <algorithm>

#include "bits.hpp"
#include "shape/points.hpp"

namespace inkcell::gen::test {
namespace {

struct Curve {
  Point p[3];
  bool is_line = false;
  bool is_cut = false;
};

// A segment, by the number of the first point after its beginning.
struct NumberedCurve : Curve {
  int number = 0;
  size_t next = 0;
};

std::vector<NumberedCurve> curves_of(const MinimalOutline& outline) {
  std::vector<NumberedCurve> curves;
  int first = 0;
  for (const MinimalContour& contour : outline.contours) {
    const auto& points = contour.points;
    const size_t n = points.size();
    const size_t begin = curves.size();
    const auto at = [&](size_t i) {
      return Point{static_cast<double>(points[i % n].x),
                   static_cast<double>(points[i % n].y)};
    };
    const auto off = [&](size_t i) {
      return points[i % n].kind == PointKind::off_curve;
    };
    Point pen = at(0);
    for (size_t i = 1; i <= n; ++i) {
      NumberedCurve curve;
      curve.number = first + static_cast<int>(i);
      curve.is_line = !off(i);
      curve.p[0] = pen;
      curve.p[1] = at(i);
      curve.p[2] = curve.is_line ? at(i)
                   : off(i + 1)  ? middle(at(i), at(i + 1))
                                 : at(i + 1);
      i += !curve.is_line && !off(i + 1) ? 1u : 0u;
      pen = curve.p[2];
      curve.next = curves.size() + 1;
      curves.push_back(curve);
    }
    curves.back().next = begin;
    first += static_cast<int>(n) + 1;
  }
  return curves;
}

// Where a glyph is on its contour.
class Track {
 public:
  Track(const MinimalOutline& outline, Bits& bits, int width)
      : curves_(curves_of(outline)), bits_(bits), width_(width) {}

  Point at;

  void begin() { jump(); }

  // The size of a contour that is born there, `since` it began.
  double begin_point(double since) {
    jump();
    const Point first = at;
    jump();
    at = middle(first, at);
    is_point_ = true;
    const int birth = bits_.u(4);
    const int swell = bits_.u(3);
    return std::min(std::max(16 * since - birth, 0.0), 1.0) *
           (1 + since * (1 - since) * swell);
  }

  Curve move() {
    Curve out;
    out.p[0] = at;
    out.is_line = true;
    if (is_point_) {
      // There it stays.
    } else if (bits_.u(1) == 0) {
      out = part(1);
      segment_ = curves_.at(segment_).next;
      from_ = 0;
    } else if (bits_.u(1) == 0) {
      // It stays.
    } else if (bits_.u(1) == 0) {
      const double to = bits_.u(3) / 8.0;
      out = part(to);
      from_ = to;
    } else {
      out.is_cut = true;
      jump();
    }
    if (out.is_line) {
      out.p[1] = middle(out.p[0], at);
    }
    out.p[2] = at;
    return out;
  }

 private:
  static Point on(const Curve& curve, double s, double t) {
    const auto mix = [](const Point& a, const Point& b, double part) {
      return (1 - part) * a + part * b;
    };
    return curve.is_line ? mix(curve.p[0], curve.p[2], t)
                         : mix(mix(curve.p[0], curve.p[1], s),
                               mix(curve.p[1], curve.p[2], s), t);
  }

  Curve part(double to) {
    const Curve& whole = curves_.at(segment_);
    Curve out;
    out.is_line = whole.is_line;
    out.p[0] = on(whole, from_, from_);
    out.p[1] = on(whole, from_, to);
    at = on(whole, to, to);
    return out;
  }

  void jump() {
    const int number = bits_.u(width_);
    from_ = bits_.u(3) / 8.0;
    segment_ = curves_.size();
    for (size_t i = 0; i < curves_.size(); ++i) {
      segment_ = curves_[i].number == number ? i : segment_;
    }
    at = on(curves_.at(segment_), from_, from_);
  }

  std::vector<NumberedCurve> curves_;
  Bits& bits_;
  int width_;
  size_t segment_ = 0;
  double from_ = 0;
  bool is_point_ = false;
};

// About the middle of the box of the joints.
void resize(std::vector<Point>& polygon, size_t chords, double size) {
  Point low = {kInfinity, kInfinity};
  Point high = {-kInfinity, -kInfinity};
  for (size_t i = 0; i < polygon.size(); i += chords) {
    low = {std::min(low.x, polygon[i].x), std::min(low.y, polygon[i].y)};
    high = {std::max(high.x, polygon[i].x), std::max(high.y, polygon[i].y)};
  }
  for (Point& point : polygon) {
    point = (1 - size) * middle(low, high) + size * point;
  }
}

uint32_t number_at(const std::vector<uint8_t>& bytes, size_t bit, int width) {
  uint32_t value = 0;
  for (int i = 0; i < width; ++i) {
    const size_t at = bit + static_cast<size_t>(i);
    value |= static_cast<uint32_t>(bytes.at(at / 8) >> at % 8 & 1) << i;
  }
  return value;
}

}  // namespace

std::vector<MorphEntry> read_morphs(const std::vector<uint8_t>& section) {
  const size_t count = section.at(0) + size_t{section.at(1)} * 256;
  const int glyph_bits = section.at(2);
  const int offset_bits = section.at(3);
  const auto row = static_cast<size_t>(2 * glyph_bits + offset_bits);
  const size_t table_end = 8 + (count * row + 7) / 8;
  std::vector<MorphEntry> entries;
  std::vector<size_t> begins;
  for (size_t i = 0; i < count; ++i) {
    const size_t bit = 64 + i * row;
    const auto bits = static_cast<size_t>(glyph_bits);
    entries.push_back(
        {static_cast<int>(number_at(section, bit, glyph_bits)),
         static_cast<int>(number_at(section, bit + bits, glyph_bits)),
         {}});
    begins.push_back(table_end +
                     number_at(section, bit + 2 * bits, offset_bits));
  }
  begins.push_back(section.size());
  for (size_t i = 0; i < count; ++i) {
    entries[i].record.assign(
        section.begin() + static_cast<ptrdiff_t>(begins[i]),
        section.begin() + static_cast<ptrdiff_t>(begins[i + 1]));
  }
  return entries;
}

std::vector<std::vector<Point>> read_morph(const std::vector<uint8_t>& record,
                                           const MinimalOutline& first,
                                           const MinimalOutline& second,
                                           double progress,
                                           int chords) {
  Bits bits(record);
  const int width = bits.u(4);
  std::vector<std::vector<Point>> out;
  while (const int kind = bits.u(2)) {
    const int pieces = bits.u(7);
    Track a(first, bits, width);
    Track b(second, bits, width);
    double size = 1;
    if (kind == 2) {
      size = a.begin_point(progress);
    } else {
      a.begin();
    }
    if (kind == 3) {
      size = b.begin_point(1 - progress);
    } else {
      b.begin();
    }
    std::vector<std::pair<Curve, Curve>> read;
    for (int i = 0; i < pieces; ++i) {
      const Curve from = a.move();
      read.emplace_back(from, b.move());
    }
    std::vector<Point> polygon;
    const size_t n = read.size();
    // Cuts open after an eighth of the time, and close an eighth before its
    // end.
    const auto mix = [&](size_t piece, size_t other, size_t point) {
      const auto& [from, to] = read[piece];
      const double begin = from.is_cut || read[other].first.is_cut ? 0.125 : 0;
      const double end = to.is_cut || read[other].second.is_cut ? 0.875 : 1;
      const double part =
          std::min(std::max((progress - begin) / (end - begin), 0.0), 1.0);
      return (1 - part) * from.p[point] + part * to.p[point];
    };
    for (size_t i = 0; i < n; ++i) {
      const Point p[3] = {mix(i, (i + n - 1) % n, 0), mix(i, i, 1),
                          mix(i, (i + 1) % n, 2)};
      for (int k = 0; k < chords; ++k) {
        const double t = static_cast<double>(k) / chords;
        polygon.push_back((1 - t) * (1 - t) * p[0] + 2 * t * (1 - t) * p[1] +
                          t * t * p[2]);
      }
    }
    // A piece begins where the one before ends, the first where the last does.
    if (length(mix(n - 1, 0, 2) - polygon.front()) > 1e-6) {
      polygon.clear();
    }
    resize(polygon, static_cast<size_t>(chords), size);
    out.push_back(std::move(polygon));
  }
  return out;
}

}  // namespace inkcell::gen::test
