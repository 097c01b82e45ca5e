#include "edges/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "edges/code.hpp"
#include "edges/leaf.hpp"
#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

constexpr double kFails = std::numeric_limits<double>::infinity();

// Times that all fields are moved, each while the others rest.
constexpr int kSweeps = 2;

// Steps of the angle and of the bend that are tried, to either side.
constexpr int kReach = 2;

// Of the numbers that promise most, so many are tried, if they promise this
// much. [Points::weight]
constexpr size_t kTrials = 3;
constexpr double kLeastGain = 0.003;

// A leaf, and what its fields say at its points.
struct Cell {
  Leaf leaf;
  Points points;
  std::array<Candidate, 3> members;
  double squares = 0;
  int moved = 0;  // when one of its fields was last moved
};

// Where a field is stated, and which cells use it, as which of their fields.
struct Origin {
  struct Use {
    size_t cell;
    size_t member;
  };

  PrimitiveCode* code = nullptr;
  int x_u = 0;
  int y_u = 0;
  int size_log2 = 0;
  std::vector<Use> uses;
  int tried = -1;  // when it was last tried
};

// Changes of a code, and by how much they would lessen the squares.
struct Move {
  int d0;
  int angle;
  int bend;
  double gain;
};

// The squares that a field answers for, s steps from its numbers: the squares
// there are now, 2 g s and s h s.
struct Parabola {
  double g[3] = {};
  double h[3][3] = {};

  double gain(const Move& move) const {
    const double s[3] = {static_cast<double>(move.d0),
                         static_cast<double>(move.angle),
                         static_cast<double>(move.bend)};
    double gain = 0;
    for (int a = 0; a < 3; ++a) {
      gain -= 2 * g[a] * s[a];
      for (int b = 0; b < 3; ++b) {
        gain -= h[a][b] * s[a] * s[b];
      }
    }
    return gain;
  }
};

class Polish {
 public:
  Polish(PointSource& points,
         const CandidateSource& candidates,
         size_t count,
         EdgeTree& tree)
      : points_(points), candidates_(candidates), tree_(tree), origins_(count) {
    gather();
  }

  void run() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (size_t f = 0; f < origins_.size(); ++f) {
        Origin& origin = origins_[f];
        if (may_move(origin)) {
          origin.tried = ++now_;
          improve(origin, tree_.fields[f]);
        }
      }
    }
  }

 private:
  // Whether anything is new since it was last tried.
  bool may_move(const Origin& origin) const {
    return std::any_of(origin.uses.begin(), origin.uses.end(),
                       [&](const Origin::Use& use) {
                         return cells_[use.cell].moved >= origin.tried;
                       });
  }

  void gather();
  void add_cell(const TreeNode& node);
  Parabola parabola(const Origin& origin, const PrimitiveNumbers& field) const;
  std::vector<Move> moves(const Origin& origin,
                          const PrimitiveNumbers& field) const;
  bool apply(const Move& move, const Origin& origin, PrimitiveCode& code) const;
  void improve(const Origin& origin, PrimitiveNumbers& field);
  bool attempt(const Origin& origin, const PrimitiveNumbers& field);

  PointSource& points_;
  const CandidateSource& candidates_;
  EdgeTree& tree_;
  std::vector<Cell> cells_;
  std::vector<Origin> origins_;  // of each field that may move
  int now_ = 0;                  // fields that were tried so far
};

void Polish::gather() {
  const Grid& grid = tree_.grid;
  for (size_t f = 0; f < std::min(origins_.size(), tree_.shared.size()); ++f) {
    Origin& origin = origins_[f];
    origin.code = &tree_.shared[f];
    origin.x_u = grid.x0_u + (grid.tiles_x << (grid.tile_log2 - 1));
    origin.y_u = grid.y0_u + (grid.tiles_y << (grid.tile_log2 - 1));
    origin.size_log2 = shared_log2(grid);
  }
  for (TreeNode& node : tree_.nodes) {
    if (node.kind != TreeNode::Kind::leaf) {
      continue;
    }
    bool moves = false;
    for (size_t m = 0; m < static_cast<size_t>(primitive_count(node.join));
         ++m) {
      PrimitiveUse& use = node.uses[m];
      if (use.field >= origins_.size()) {
        continue;
      }
      moves = true;
      Origin& origin = origins_[use.field];
      origin.uses.push_back({cells_.size(), m});
      if (use.is_new) {
        const int half = 1 << node.size_log2 >> 1;
        origin.code = &use.code;
        origin.x_u = node.x_u + half;
        origin.y_u = node.y_u + half;
        origin.size_log2 = node.size_log2;
      }
    }
    if (moves) {
      add_cell(node);
    }
  }
  for (Cell& cell : cells_) {
    for (size_t m = 0; m < cell.members.size(); ++m) {
      cell.leaf.members[m] = &cell.members[m];
    }
    const LeafError error = measure_leaf(cell.leaf, cell.points);
    cell.squares = error.failed < cell.points.size() ? kFails : error.squares;
  }
}

void Polish::add_cell(const TreeNode& node) {
  Cell cell;
  cell.leaf.join = node.join;
  cell.points = points_.collect(node.x_u, node.y_u, node.size_log2);
  for (size_t m = 0; m < static_cast<size_t>(primitive_count(node.join)); ++m) {
    cell.members[m].field = tree_.fields[node.uses[m].field];
    candidates_.evaluate(cell.members[m], cell.points);
  }
  cells_.push_back(std::move(cell));
}

// Where the field is what its cell says; the distance from a vertex is left
// out.
Parabola Polish::parabola(const Origin& origin,
                          const PrimitiveNumbers& field) const {
  const PrimitiveSteps& steps = tree_.steps;
  const int log2 = origin.size_log2;
  const double d0_step = steps.d0_step / 64.0;
  const double angle_step = 2 * kPi / (1 << steps.angle_bits(log2));
  const double bend_step = std::ldexp(
      steps.bend_step / 64.0, -2 * PrimitiveSteps::bend_length_log2(log2));
  const Primitive model(field);
  Parabola out;
  for (const Origin::Use& use : origin.uses) {
    const Cell& cell = cells_[use.cell];
    const Points& points = cell.points;
    const std::vector<float>& values = cell.members[use.member].value;
    for (size_t i = 0; i < points.size(); ++i) {
      const float v = values[i];
      if (!(points.weight[i] > 0) || leaf_value(cell.leaf, i) != v) {
        continue;
      }
      const double x = static_cast<double>(points.x[i]) - origin.x_u;
      const double y = static_cast<double>(points.y[i]) - origin.y_u;
      const double u = model.nx * x + model.ny * y;
      const double w = model.nx * y - model.ny * x;
      const double slopes[3] = {d0_step, angle_step * w * (1 - 2 * model.k * u),
                                bend_step * w * w};
      const double miss = static_cast<double>(v - points.d[i]);
      const auto weight = static_cast<double>(points.weight[i]);
      for (int a = 0; a < 3; ++a) {
        out.g[a] += weight * slopes[a] * miss;
        for (int b = 0; b < 3; ++b) {
          out.h[a][b] += weight * slopes[a] * slopes[b];
        }
      }
    }
  }
  return out;
}

// What promises to lessen the squares, the most first.
std::vector<Move> Polish::moves(const Origin& origin,
                                const PrimitiveNumbers& field) const {
  const Parabola at = parabola(origin, field);
  const PrimitiveKind kind = origin.code->kind;
  const int most_angle = has_angle(kind) ? kReach : 0;
  const int most_bend = is_bent(kind) ? kReach : 0;
  std::vector<Move> out;
  if (!(at.h[0][0] > 0)) {
    return out;
  }
  for (int bend = -most_bend; bend <= most_bend; ++bend) {
    for (int angle = -most_angle; angle <= most_angle; ++angle) {
      const double best =
          -(at.g[0] + at.h[0][1] * angle + at.h[0][2] * bend) / at.h[0][0];
      for (const double d0 : {std::floor(best), std::ceil(best)}) {
        Move move = {static_cast<int>(d0), angle, bend, 0};
        move.gain = at.gain(move);
        if (move.gain > kLeastGain) {
          out.push_back(move);
        }
      }
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Move& a, const Move& b) {
    return a.gain > b.gain;
  });
  out.resize(std::min(out.size(), kTrials));
  return out;
}

// False if the code cannot say it, or not with the bits it has.
bool Polish::apply(const Move& move,
                   const Origin& origin,
                   PrimitiveCode& code) const {
  const PrimitiveSteps& steps = tree_.steps;
  const int log2 = origin.size_log2;
  const int old_bend = code.bend;
  code.d0 += move.d0;
  code.bend += move.bend;
  const int angles = 1 << steps.angle_bits(log2);
  code.angle = static_cast<uint32_t>(static_cast<int>(code.angle) + move.angle +
                                     angles) %
               static_cast<uint32_t>(angles);
  const int most = 1 << (steps.d0_bits(log2) - 1);
  if (code.d0 < -most || code.d0 >= most) {
    return false;
  }
  return !is_bent(code.kind) ||
         (code.bend != 0 && std::abs(code.bend) <= steps.most_bend(log2) &&
          steps.bend_bits(code.bend, log2) <= steps.bend_bits(old_bend, log2));
}

void Polish::improve(const Origin& origin, PrimitiveNumbers& field) {
  for (const Move& move : moves(origin, field)) {
    PrimitiveCode code = *origin.code;
    if (!apply(move, origin, code)) {
      continue;
    }
    const PrimitiveNumbers moved = field_numbers(
        code, tree_.steps, origin.size_log2, origin.x_u, origin.y_u);
    if (attempt(origin, moved)) {
      *origin.code = code;
      field = moved;
      return;
    }
  }
}

// Uses `field` in all cells of `origin` if that lessens their squares.
bool Polish::attempt(const Origin& origin, const PrimitiveNumbers& field) {
  double before = 0;
  for (const Origin::Use& use : origin.uses) {
    before += cells_[use.cell].squares;
  }
  std::vector<Candidate> moved(origin.uses.size());
  std::vector<double> squares;
  double after = 0;
  for (size_t u = 0; u < origin.uses.size(); ++u) {
    const Origin::Use& use = origin.uses[u];
    const Cell& cell = cells_[use.cell];
    moved[u].field = field;
    candidates_.evaluate(moved[u], cell.points);
    Leaf leaf = cell.leaf;
    leaf.members[use.member] = &moved[u];
    const LeafError error = measure_leaf(leaf, cell.points);
    after += error.squares;
    if (moved[u].covered == 0 || error.failed < cell.points.size() ||
        after >= before) {
      return false;
    }
    squares.push_back(error.squares);
  }
  for (size_t u = 0; u < origin.uses.size(); ++u) {
    Cell& cell = cells_[origin.uses[u].cell];
    cell.members[origin.uses[u].member] = std::move(moved[u]);
    cell.squares = squares[u];
    cell.moved = now_;
  }
  return true;
}

}  // namespace

void polish_fields(PointSource& points,
                   const CandidateSource& candidates,
                   size_t count,
                   EdgeTree& tree) {
  Polish(points, candidates, count, tree).run();
}

}  // namespace gen
}  // namespace inkcell
