#include "outlines/contour_order.hpp"

#include <algorithm>
#include <limits>

#include "outlines/point_bits.hpp"

namespace inkcell::gen {
namespace {

struct Pen {
  int x;
  int y;
};

int move_bits(const Pen& from, const GridPoint& to) {
  return step_bits(to.x - from.x) + step_bits(to.y - from.y);
}

// A start of a contour and its cost.
struct Start {
  size_t contour = 0;
  size_t point = 0;
  int bits = std::numeric_limits<int>::max();
};

// Bits of the step to the start, less those of the closing edge, which is not
// stored.
int start_bits(const Pen& pen, const MinimalContour& contour, size_t start) {
  const size_t n = contour.points.size();
  const GridPoint& first = contour.points[start];
  const GridPoint& last = contour.points[(start + n - 1) % n];
  return move_bits(pen, first) - move_bits({last.x, last.y}, first);
}

bool may_start(const MinimalContour& contour, size_t point) {
  const auto corner = [](const GridPoint& p) {
    return p.kind == PointKind::corner;
  };
  const PointKind wanted =
      std::any_of(contour.points.begin(), contour.points.end(), corner)
          ? PointKind::corner
          : PointKind::smooth;
  return contour.points[point].kind == wanted;
}

}  // namespace

void order_contours(int x, int y, MinimalOutline& outline) {
  Pen pen{x, y};
  std::vector<MinimalContour>& contours = outline.contours;
  for (size_t done = 0; done < contours.size(); ++done) {
    Start best;
    for (size_t c = done; c < contours.size(); ++c) {
      for (size_t p = 0; p < contours[c].points.size(); ++p) {
        if (may_start(contours[c], p)) {
          const int bits = start_bits(pen, contours[c], p);
          if (bits < best.bits) {
            best = {c, p, bits};
          }
        }
      }
    }
    std::swap(contours[done], contours[best.contour]);
    std::vector<GridPoint>& points = contours[done].points;
    std::rotate(points.begin(),
                points.begin() + static_cast<ptrdiff_t>(best.point),
                points.end());
    points.front().kind = PointKind::corner;
    pen = {points.back().x, points.back().y};
  }
}

}  // namespace inkcell::gen
