// Outlines of glyphs as a font describes them, before encoding.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace inkcell::gen {

/// u per em, the unit of all outlines.
inline constexpr double kUPerEm = 1024;

/// A position in u (1/1024 em), y up, origin on the baseline.
struct Point {
  double x = 0;
  double y = 0;
};

/// A piece of a contour. `p` holds 2, 3 or 4 points; the first and the last are
/// on the curve.
struct Segment {
  enum class Kind { line, quadratic, cubic };

  Kind kind = Kind::line;
  Point p[4];
};

/// 1, 2 or 3.
inline int degree_of(const Segment& segment) {
  return static_cast<int>(segment.kind) + 1;
}

inline const Point& end_of(const Segment& segment) {
  return segment.p[degree_of(segment)];
}

inline Segment line_segment(const Point& a, const Point& b) {
  return {Segment::Kind::line, {a, b}};
}

/// A closed curve. Each segment begins at the end of the one before. If the
/// last does not end at the start of the first, a line closes the contour.
struct Contour {
  std::vector<Segment> segments;
};

/// The outline of one glyph. Filled where the winding number is not zero.
struct Outline {
  std::vector<Contour> contours;
};

/// Whether two outlines have contours of the same numbers of segments, and
/// `alike` holds for each pair of segments.
template <typename Alike>
bool correspond(const Outline& a, const Outline& b, Alike alike) {
  return std::equal(a.contours.begin(), a.contours.end(), b.contours.begin(),
                    b.contours.end(), [&](const Contour& s, const Contour& t) {
                      return std::equal(s.segments.begin(), s.segments.end(),
                                        t.segments.begin(), t.segments.end(),
                                        alike);
                    });
}

/// Outlines that geometry cannot process.
class GeometryError : public std::runtime_error {
 public:
  enum class Kind {
    bad_coordinates,  // not a number, or beyond kCoordinateLimit
    too_complex,      // the field has more cells or nodes than the format
    too_large,        // the field reaches farther than the format
    not_united,       // the union of the contours failed
  };

  GeometryError(Kind kind, const std::string& message)
      : std::runtime_error(message), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// Coordinates of an outline lie within +-kCoordinateLimit. [u] The format
/// holds grids up to format::glyph::kGridLimit = 15360 u from the origin; the
/// rest is room for the widest band, 192 u at 4 px/em, and the slack of a tile
/// of 256 u. The tiles of the fixed predicate are larger: with it the grid of
/// an outline within this limit may yet be refused as too_large.
inline constexpr double kCoordinateLimit = 15360 - 192 - 256;

}  // namespace inkcell::gen
