// Outlines of glyphs as a font describes them, before they become fields.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace inkcell {
namespace gen {

/// A position in u (1/1024 em), y up, origin on the baseline.
struct Point {
  double x = 0;
  double y = 0;
};

/// A piece of a contour. `p` holds 2, 3 or 4 points, the first and the last on
/// the curve.
struct Segment {
  enum class Kind { line, quadratic, cubic };

  Kind kind = Kind::line;
  Point p[4];
};

/// A closed curve. Each segment begins where the one before ended; if the last
/// does not end where the first began, a line closes the contour.
struct Contour {
  std::vector<Segment> segments;
};

/// The outline of one glyph. Filled where the winding number is not zero.
struct Outline {
  std::vector<Contour> contours;
};

/// What geometry refuses to work on.
class GeometryError : public std::runtime_error {
 public:
  enum class Kind {
    bad_coordinates,  // not a number, or beyond kCoordinateLimit
    too_complex,      // the field has more cells or tiles than the format
    not_united,       // the union of the contours failed
  };

  GeometryError(Kind kind, const std::string& message)
      : std::runtime_error(message), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// Coordinates of an outline lie within +-kCoordinateLimit. [u] The format
/// holds grids up to 16384 u from the origin; the rest is room for the band.
inline constexpr double kCoordinateLimit = 15000;

}  // namespace gen
}  // namespace inkcell
