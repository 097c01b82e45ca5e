#include "export/glyf.hpp"

#include <algorithm>
#include <cmath>

#include "fit/vectors.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "outlines/curves.hpp"
#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

constexpr double kMostCoordinate = 16383;

GlyfPoint rounded(const Point& p, bool on_curve) {
  if (!(std::fabs(p.x) <= kMostCoordinate &&
        std::fabs(p.y) <= kMostCoordinate)) {
    throw Error("a point is beyond +-16383 font units, the limit of TrueType");
  }
  return {static_cast<int>(std::lround(p.x)),
          static_cast<int>(std::lround(p.y)), on_curve};
}

// A cubic and the quadratic of the same ends and middle differ by at most
// sqrt(3) / 36 |p3 - 3 p2 + 3 p1 - p0|; n parts of it by 1 / n^3 of that.
int quadratics_for(const gen::Segment& cubic) {
  const Point* p = cubic.p;
  const Point third = p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0];
  const double error = std::sqrt(3.0) / 36 * length(third);
  return std::max(
      1, static_cast<int>(std::ceil(std::cbrt(error / kQuadraticBound))));
}

void add_cubic(const gen::Segment& cubic, GlyfContour& contour) {
  const int count = quadratics_for(cubic);
  for (int i = 0; i < count; ++i) {
    const gen::Segment part =
        gen::part_of(cubic, static_cast<double>(i) / count,
                     static_cast<double>(i + 1) / count);
    const Point* p = part.p;
    contour.push_back(
        rounded(0.25 * (3.0 * p[1] - p[0] + 3.0 * p[2] - p[3]), false));
    contour.push_back(rounded(p[3], true));
  }
}

bool has_cubics(const PointContour& contour) {
  return std::any_of(
      contour.points.begin(), contour.points.end(),
      [](const GlyphPoint& p) { return p.type == PointType::curve; });
}

GlyfContour converted(const PointContour& contour) {
  GlyfContour result;
  if (!has_cubics(contour)) {
    for (const GlyphPoint& p : contour.points) {
      result.push_back(rounded({p.x, p.y}, p.on_curve()));
    }
    return result;
  }
  for (const gen::Segment& s : to_segments(contour, 1).segments) {
    if (s.kind == gen::Segment::Kind::cubic) {
      add_cubic(s, result);
      continue;
    }
    const int last = gen::degree_of(s);
    for (int i = 1; i <= last; ++i) {
      result.push_back(rounded(s.p[i], i == last));
    }
  }
  return result;
}

// Coordinates as differences: one byte with a sign in the flags, two, or none.
struct Coordinates {
  BigEndian bytes;

  unsigned add(int difference, unsigned short_flag, unsigned same_flag) {
    if (difference == 0) {
      return same_flag;
    }
    if (std::abs(difference) < 256) {
      bytes.u8(static_cast<unsigned>(std::abs(difference)));
      return short_flag | (difference > 0 ? same_flag : 0);
    }
    bytes.i16(difference);
    return 0;
  }
};

}  // namespace

std::vector<GlyfContour> glyf_contours(
    const std::vector<PointContour>& contours) {
  std::vector<GlyfContour> result;
  for (const PointContour& contour : contours) {
    if (!contour.open() && contour.points.size() > 1) {
      result.push_back(converted(contour));
    }
  }
  return result;
}

GlyfBox box_of(const std::vector<GlyfContour>& contours) {
  GlyfBox box = {32767, 32767, -32768, -32768};
  for (const GlyfContour& contour : contours) {
    for (const GlyfPoint& p : contour) {
      box = {std::min(box.x0, p.x), std::min(box.y0, p.y),
             std::max(box.x1, p.x), std::max(box.y1, p.y)};
    }
  }
  return box.x0 <= box.x1 ? box : GlyfBox();
}

BigEndian glyf_header(int contours, const GlyfBox& box) {
  BigEndian header;
  header.words(contours, box.x0, box.y0, box.x1, box.y1);
  return header;
}

BigEndian glyf_record(const std::vector<GlyfContour>& contours) {
  if (contours.empty()) {
    return {};
  }
  BigEndian record =
      glyf_header(static_cast<int>(contours.size()), box_of(contours));
  unsigned last = 0;
  for (const GlyfContour& contour : contours) {
    last += static_cast<unsigned>(contour.size());
    record.u16(last - 1);
  }
  record.u16(0);  // no instructions
  constexpr unsigned kOnCurve = 1, kShortX = 2, kShortY = 4, kSameX = 16,
                     kSameY = 32;
  Coordinates x;
  Coordinates y;
  GlyfPoint at;
  for (const GlyfContour& contour : contours) {
    for (const GlyfPoint& p : contour) {
      record.u8((p.on_curve ? kOnCurve : 0) |
                x.add(p.x - at.x, kShortX, kSameX) |
                y.add(p.y - at.y, kShortY, kSameY));
      at = p;
    }
  }
  record.append(x.bytes);
  record.append(y.bytes);
  return record;
}

}  // namespace inkcell::design
