#include "master_oracle.hpp"

#include <cmath>

#include "outlines/curves.hpp"
#include "outlines/unite.hpp"

namespace inkcell::design::test {
namespace {

constexpr double kCorner_u = 3;
constexpr double kCornerTurn = 0.17;  // [radians]
constexpr int kGreyRows = 16;
constexpr double kMargin_u = 16;

// Adds the ink between the crossings of a row to each pixel. [px]
void add_row(std::vector<double>& row,
             const std::vector<double>& crossings,
             double x0_u,
             double px_u) {
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const double a = (crossings[i] - x0_u) / px_u;
    const double b = (crossings[i + 1] - x0_u) / px_u;
    for (int x = static_cast<int>(std::max(a, 0.0));
         x < b && x < static_cast<int>(row.size()); ++x) {
      row[static_cast<size_t>(x)] +=
          std::min(b, x + 1.0) - std::max(a, static_cast<double>(x));
    }
  }
}

}  // namespace

Bitmap draw_master(const gen::Shape& shape,
                   double px_per_em,
                   bool is_grey,
                   MasterPlace& place) {
  const double px = 1024 / px_per_em;
  const gen::Box& box = shape.box();
  place.px_per_em = px_per_em;
  place.origin_x = std::ceil((kMargin_u - box.x0) / px);
  place.origin_y = std::ceil((kMargin_u + box.y1) / px);
  Bitmap bitmap;
  bitmap.width =
      static_cast<int>(place.origin_x + (box.x1 + kMargin_u) / px) + 1;
  bitmap.height =
      static_cast<int>(place.origin_y + (kMargin_u - box.y0) / px) + 1;
  const int rows = is_grey ? kGreyRows : 1;
  std::vector<double> crossings;
  for (int y = 0; y < bitmap.height; ++y) {
    std::vector<double> row(static_cast<size_t>(bitmap.width), 0);
    for (int i = 0; i < rows; ++i) {
      shape.crossings((place.origin_y - y - (i + 0.5) / rows) * px, crossings);
      if (is_grey) {
        add_row(row, crossings, -place.origin_x * px, px);
        continue;
      }
      for (size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const double a = crossings[k] / px + place.origin_x - 0.5;
        const double b = crossings[k + 1] / px + place.origin_x - 0.5;
        for (int x = static_cast<int>(std::ceil(a)); x < b; ++x) {
          row[static_cast<size_t>(x)] = 1;
        }
      }
    }
    for (const double ink : row) {
      bitmap.ink.push_back(
          static_cast<uint8_t>(std::lround(255 * std::min(ink / rows, 1.0))));
    }
  }
  return bitmap;
}

std::vector<Point> corners_of(const gen::Outline& source) {
  std::vector<Point> corners;
  for (const gen::Contour& contour : gen::unite(source).contours) {
    for (size_t i = 0; i < contour.segments.size(); ++i) {
      const gen::Segment& next =
          contour.segments[(i + 1) % contour.segments.size()];
      const double angle = turn(gen::direction_at_end(contour.segments[i]),
                                gen::direction_at_start(next));
      if (std::fabs(angle) > kCornerTurn) {
        corners.push_back(next.p[0]);
      }
    }
  }
  return corners;
}

bool is_near_any(const Point& p, const std::vector<Point>& corners) {
  return std::any_of(corners.begin(), corners.end(), [&p](const Point& c) {
    return length(c - p) < kCorner_u;
  });
}

void compare_edges(const gen::Shape& from,
                   const gen::Shape& to,
                   const std::vector<Point>& corners,
                   Errors& off_corners,
                   Errors& all) {
  for (const gen::Edge& edge : from.edges()) {
    const Point middle = 0.5 * (edge.a + edge.b);
    for (const Point& p : {edge.a, middle}) {
      const double d = to.distance(p.x, p.y);
      const double weight = length(edge.b - edge.a);
      all.note(d, weight);
      if (!is_near_any(p, corners)) {
        off_corners.note(d, weight);
      }
    }
  }
}

}  // namespace inkcell::design::test
