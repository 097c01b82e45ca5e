#include "shape/distance_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

// Edges that turn by more than this meet in a corner. [sine; 15 degrees] A
// circle of 1 u, in chords of kFlatteningBound, turns by less.
constexpr double kCornerSine = 0.26;

// Chains and corners, at most as many as edges, are numbered in 16 bits.
constexpr size_t kMostEdges = 32767;

// Edges are looked up by squares of this size. [u]
constexpr int kSquare_u = 16;

double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}

bool is_corner(const Edge& in, const Edge& out) {
  const double ux = in.b.x - in.a.x;
  const double uy = in.b.y - in.a.y;
  const double vx = out.b.x - out.a.x;
  const double vy = out.b.y - out.a.y;
  const double scale = length(ux, uy) * length(vx, vy);
  const double cross = ux * vy - uy * vx;
  const double dot = ux * vx + uy * vy;
  return std::fabs(cross) > kCornerSine * scale || dot < 0;
}

}  // namespace

DistanceLattice::DistanceLattice(
    const Shape& shape, int x0_u, int y0_u, int width_u, int height_u)
    : shape_(shape),
      x0_u_(x0_u),
      y0_u_(y0_u),
      width_u_(width_u),
      blocks_x_(width_u / kSquare_u + 1) {
  blocks_.resize(static_cast<size_t>(blocks_x_) *
                 static_cast<size_t>(height_u / kSquare_u + 1));
  const size_t points =
      static_cast<size_t>(width_u + 1) * static_cast<size_t>(height_u + 1);
  samples_.resize(points);
  known_.resize(points);
  find_chains();
}

void DistanceLattice::find_chains() {
  const std::vector<Edge>& edges = shape_.edges();
  const size_t count = edges.size();
  if (count > kMostEdges) {
    throw GeometryError(
        GeometryError::Kind::too_complex,
        "the outline has too many pieces for cells of primitives");
  }
  next_.resize(count);
  chain_of_.assign(count, -1);
  corner_before_.assign(count, -1);
  for (size_t begin = 0; begin < count;) {
    size_t end = begin + 1;
    while (end < count && edges[end].a.x == edges[end - 1].b.x &&
           edges[end].a.y == edges[end - 1].b.y &&
           !(edges[end - 1].b.x == edges[begin].a.x &&
             edges[end - 1].b.y == edges[begin].a.y)) {
      ++end;
    }
    const size_t size = end - begin;
    size_t start = begin;
    for (size_t i = begin; i < end; ++i) {
      next_[i] = static_cast<uint32_t>(i + 1 == end ? begin : i + 1);
      const size_t previous = i == begin ? end - 1 : i - 1;
      if (is_corner(edges[previous], edges[i])) {
        corner_before_[i] = static_cast<int16_t>(corners_.size());
        corners_.push_back({edges[i].a, -1, -1, static_cast<uint32_t>(previous),
                            static_cast<uint32_t>(i)});
        start = i;
      }
    }
    // From a corner, if there is one, once around.
    chains_.push_back({static_cast<uint32_t>(start), 0});
    for (size_t step = 0; step < size; ++step) {
      const size_t i = begin + (start - begin + step) % size;
      if (step > 0 && corner_before_[i] >= 0) {
        chains_.push_back({static_cast<uint32_t>(i), 0});
      }
      chain_of_[i] = static_cast<int16_t>(chains_.size() - 1);
      ++chains_.back().edge_count;
    }
    for (size_t i = begin; i < end; ++i) {
      if (corner_before_[i] >= 0) {
        Corner& corner = corners_[static_cast<size_t>(corner_before_[i])];
        const size_t previous = i == begin ? end - 1 : i - 1;
        corner.before = chain_of_[previous];
        corner.after = chain_of_[i];
      }
    }
    begin = end;
  }
}

// As Neighbourhood::part: an edge farther from the centre than the nearest one
// and a whole diagonal is nowhere in the square the nearest.
const DistanceLattice::Block& DistanceLattice::block_of(int x_u, int y_u) {
  const int bx = (x_u - x0_u_) / kSquare_u;
  const int by = (y_u - y0_u_) / kSquare_u;
  Block& block = blocks_[static_cast<size_t>(by * blocks_x_ + bx)];
  if (!block.ready) {
    block.ready = true;
    const double cx = x0_u_ + (bx + 0.5) * kSquare_u;
    const double cy = y0_u_ + (by + 0.5) * kSquare_u;
    const std::vector<Edge>& edges = shape_.edges();
    std::vector<double> squares(edges.size());
    double least = kInfinity;
    for (size_t i = 0; i < edges.size(); ++i) {
      squares[i] =
          squared_distance_to_segment({cx, cy}, edges[i].a, edges[i].b);
      least = std::min(least, squares[i]);
    }
    const double reach = std::sqrt(least) + kSquare_u * 1.4143 + 1e-6;
    for (size_t i = 0; i < edges.size(); ++i) {
      if (squares[i] <= reach * reach) {
        const double dx = edges[i].b.x - edges[i].a.x;
        const double dy = edges[i].b.y - edges[i].a.y;
        block.edges.push_back({edges[i].a.x, edges[i].a.y, dx, dy,
                               1 / (dx * dx + dy * dy),
                               static_cast<uint32_t>(i)});
      }
    }
  }
  return block;
}

TruthSample DistanceLattice::measure(const Block& block,
                                     double x,
                                     double y) const {
  double best = kInfinity;
  double best_t = 0;
  uint32_t nearest = 0;
  for (const NearEdge& edge : block.edges) {
    const double px = x - edge.ax;
    const double py = y - edge.ay;
    double t = (px * edge.dx + py * edge.dy) * edge.inverse;
    t = t < 0 ? 0 : t;
    t = t > 1 ? 1 : t;
    const double rx = px - t * edge.dx;
    const double ry = py - t * edge.dy;
    const double square = rx * rx + ry * ry;
    if (square < best) {
      best = square;
      best_t = t;
      nearest = edge.number;
    }
  }
  TruthSample sample;
  const double size = std::sqrt(best);
  const Edge& edge = shape_.edges()[nearest];
  bool inside = false;
  if (best_t > 0 && best_t < 1) {
    inside = (edge.b.x - edge.a.x) * (y - edge.a.y) -
                 (edge.b.y - edge.a.y) * (x - edge.a.x) >
             0;
  } else {
    inside = shape_.inside(x, y);
    const uint32_t vertex = best_t > 0 ? next_[nearest] : nearest;
    sample.corner = corner_before_[vertex];
  }
  sample.distance_u = static_cast<float>(inside ? size : -size);
  sample.chain = chain_of_[nearest];
  return sample;
}

const TruthSample& DistanceLattice::at(int x_u, int y_u) {
  const size_t index =
      static_cast<size_t>(y_u - y0_u_) * static_cast<size_t>(width_u_ + 1) +
      static_cast<size_t>(x_u - x0_u_);
  if (!known_[index]) {
    known_[index] = true;
    samples_[index] = measure(block_of(x_u, y_u), x_u, y_u);
  }
  return samples_[index];
}

TruthSample DistanceLattice::at_point(double x_u, double y_u) {
  return measure(block_of(static_cast<int>(std::floor(x_u)),
                          static_cast<int>(std::floor(y_u))),
                 x_u, y_u);
}

}  // namespace gen
}  // namespace inkcell
