#include "trace/contour_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "inkcell/field/cell.hpp"

namespace inkcell::design {
namespace {

// A square has no edge if its centre is farther from it than this many sizes:
// half the diagonal, and the error of a cell's distances.
constexpr double kReach = 0.9;
constexpr double kSlack_u = 2;

// The most squares, 8 em by 8 em; each takes five bytes.
constexpr double kMostSquares = 8192.0 * 8192.0;

// Loops of fewer points, about 2 u across, are errors of the field.
constexpr size_t kLeastPoints = 8;

Q16_16 to_q16(double value) {
  return Q16_16::from_raw(static_cast<int32_t>(std::lround(value * 65536)));
}

// A distance and its gradient, and where they are defined. [u]
struct Terrain {
  std::function<double(double x, double y)> distance;
  std::function<Point(double x, double y)> gradient;
  int x0_u = 0;
  int y0_u = 0;
  int x1_u = 0;
  int y1_u = 0;
};

class Walker {
 public:
  explicit Walker(Terrain terrain)
      : field_(std::move(terrain)),
        width_(field_.x1_u - field_.x0_u + 3),
        height_(field_.y1_u - field_.y0_u + 3) {
    const size_t count =
        static_cast<size_t>(width_) * static_cast<size_t>(height_);
    values_.assign(count, std::numeric_limits<float>::quiet_NaN());
    visited_.assign(count, 0);
  }

  // Walks all contours that cross a square of 2^log2 u.
  void look_into(int x, int y, int log2) {
    if (log2 == 0) {
      begin_at(x, y);
      return;
    }
    const int half = 1 << (log2 - 1);
    if (std::fabs(value(x + half, y + half)) > kReach * 2 * half + kSlack_u) {
      return;
    }
    for (int i = 0; i < 4; ++i) {
      look_into(x + (i & 1) * half, y + (i >> 1) * half, log2 - 1);
    }
  }

  std::vector<Loop> take_loops() { return std::move(loops_); }

 private:
  double distance(double x, double y) const { return field_.distance(x, y); }

  // Corners of squares are integers; the grid has a margin of one row and
  // column of squares.
  size_t index(int x, int y) const {
    return static_cast<size_t>(y - field_.y0_u + 1) *
               static_cast<size_t>(width_) +
           static_cast<size_t>(x - field_.x0_u + 1);
  }
  bool within(int x, int y) const {
    return x >= field_.x0_u - 1 && x < field_.x1_u + 1 &&
           y >= field_.y0_u - 1 && y < field_.y1_u + 1;
  }

  float value(int x, int y) {
    float& v = values_[index(x, y)];
    if (std::isnan(v)) {
      v = static_cast<float>(distance(x, y));
    }
    return v;
  }

  // Corners and sides of a square are numbered counter-clockwise from the
  // lower left corner and the lower side.
  static int corner_x(int x, int corner) {
    return x + (corner == 1 || corner == 2 ? 1 : 0);
  }
  static int corner_y(int y, int corner) { return y + (corner >= 2 ? 1 : 0); }

  bool inside(int x, int y, int corner) {
    return value(corner_x(x, corner & 3), corner_y(y, corner & 3)) > 0;
  }
  // Whether the contour enters through a side: only its first corner has ink.
  bool enters(int x, int y, int side) {
    return inside(x, y, side) && !inside(x, y, side + 1);
  }
  bool leaves(int x, int y, int side) {
    return !inside(x, y, side) && inside(x, y, side + 1);
  }

  void begin_at(int x, int y) {
    for (int side = 0; side < 4; ++side) {
      if (enters(x, y, side) && (visited_[index(x, y)] >> side & 1) == 0) {
        walk(x, y, side);
      }
    }
  }

  int exit_of(int x, int y, int entry) {
    const int next = (entry + 1) & 3;
    const int before = (entry + 3) & 3;
    if (leaves(x, y, next) && leaves(x, y, before)) {
      // Two contours: the centre decides which corners are connected.
      return distance(x + 0.5, y + 0.5) > 0 ? next : before;
    }
    return leaves(x, y, next)     ? next
           : leaves(x, y, before) ? before
                                  : (entry + 2) & 3;
  }

  void walk(int x, int y, int side) {
    Loop loop;
    while (within(x, y) && (visited_[index(x, y)] >> side & 1) == 0) {
      visited_[index(x, y)] =
          static_cast<uint8_t>(visited_[index(x, y)] | 1 << side);
      add_point(loop, crossing(x, y, side));
      const int exit = exit_of(x, y, side);
      x += exit == 1 ? 1 : exit == 3 ? -1 : 0;
      y += exit == 2 ? 1 : exit == 0 ? -1 : 0;
      side = (exit + 2) & 3;
    }
    if (loop.points.size() >= kLeastPoints) {
      loops_.push_back(std::move(loop));
    }
  }

  // The point on a side where the distance is 0.
  Point crossing(int x, int y, int side) {
    const int c1 = (side + 1) & 3;
    Point a{static_cast<double>(corner_x(x, side)),
            static_cast<double>(corner_y(y, side))};
    Point b{static_cast<double>(corner_x(x, c1)),
            static_cast<double>(corner_y(y, c1))};
    double da = value(corner_x(x, side), corner_y(y, side));
    double db = value(corner_x(x, c1), corner_y(y, c1));
    Point middle = a;
    for (int round = 0; round < 6; ++round) {
      // A saturated end only tells the side.
      const bool is_far = std::max(std::fabs(da), std::fabs(db)) > 4;
      const double f = is_far ? 0.5 : da / (da - db);
      middle = a + f * (b - a);
      const double d = distance(middle.x, middle.y);
      if (std::fabs(d) < 1.0 / 512) {
        break;
      }
      (d > 0 ? a : b) = middle;
      (d > 0 ? da : db) = d;
    }
    return middle;
  }

  void add_point(Loop& loop, const Point& point) {
    if (!loop.points.empty() && length(loop.points.back() - point) < 1e-3) {
      return;
    }
    const Point g = field_.gradient(point.x, point.y);
    // Ink is on the left: the gradient turned clockwise.
    loop.points.push_back(point);
    loop.tangents.push_back(unit({g.y, -g.x}));
  }

  Terrain field_;
  int width_;
  int height_;
  std::vector<float> values_;
  std::vector<uint8_t> visited_;  // sides through which a contour entered
  std::vector<Loop> loops_;
};

void look_into_leaves(
    const GlyphField& field, int x, int y, int log2, Walker& walker) {
  const Cell cell = locate(field, x, y);
  if (cell.size_log2 < log2) {
    const int half = 1 << (log2 - 1);
    for (int i = 0; i < 4; ++i) {
      look_into_leaves(field, x + (i & 1) * half, y + (i >> 1) * half, log2 - 1,
                       walker);
    }
  } else if (!cell.is_saturated()) {
    walker.look_into(x, y, log2);
  }
}

}  // namespace

double distance_u(const GlyphField& field, const Point& p) {
  return distance_at(field, to_q16(p.x), to_q16(p.y)).raw / 1024.0;
}

std::vector<Loop> walk_contours(const GlyphField& field) {
  Terrain terrain;
  terrain.distance = [&field](double x, double y) {
    return distance_u(field, {x, y});
  };
  terrain.gradient = [&field](double x, double y) {
    const Gradient g = gradient_at(field, to_q16(x), to_q16(y));
    return Point{static_cast<double>(g.x.raw), static_cast<double>(g.y.raw)};
  };
  terrain.x0_u = field.x0_u;
  terrain.y0_u = field.y0_u;
  terrain.x1_u = field.x1_u();
  terrain.y1_u = field.y1_u();
  Walker walker(terrain);
  const int tile = 1 << field.tile_log2;
  for (int y = field.y0_u; y < field.y1_u(); y += tile) {
    for (int x = field.x0_u; x < field.x1_u(); x += tile) {
      look_into_leaves(field, x, y, field.tile_log2, walker);
    }
  }
  return walker.take_loops();
}

std::vector<Loop> walk_contours(
    const std::function<double(const Point&)>& distance, const gen::Box& box) {
  constexpr int kTileLog2 = 7;
  constexpr double kStep_u = 1.0 / 64;
  Terrain terrain;
  terrain.distance = [&distance](double x, double y) {
    return distance({x, y});
  };
  terrain.gradient = [&distance](double x, double y) {
    return Point{distance({x + kStep_u, y}) - distance({x - kStep_u, y}),
                 distance({x, y + kStep_u}) - distance({x, y - kStep_u})};
  };
  if (!((box.x1 - box.x0) * (box.y1 - box.y0) <= kMostSquares)) {
    throw gen::GeometryError(
        gen::GeometryError::Kind::too_large,
        "an edge is followed within 8 em by 8 em; make the glyph, or the "
        "radius of its blend, smaller");
  }
  const auto tiles = [](double low, double high) {
    return static_cast<int>(std::ceil((high - low) / (1 << kTileLog2))) + 1;
  };
  terrain.x0_u = static_cast<int>(std::floor(box.x0)) - 1;
  terrain.y0_u = static_cast<int>(std::floor(box.y0)) - 1;
  terrain.x1_u = terrain.x0_u + (tiles(box.x0, box.x1) << kTileLog2);
  terrain.y1_u = terrain.y0_u + (tiles(box.y0, box.y1) << kTileLog2);
  Walker walker(terrain);
  for (int y = terrain.y0_u; y < terrain.y1_u; y += 1 << kTileLog2) {
    for (int x = terrain.x0_u; x < terrain.x1_u; x += 1 << kTileLog2) {
      walker.look_into(x, y, kTileLog2);
    }
  }
  return walker.take_loops();
}

}  // namespace inkcell::design
