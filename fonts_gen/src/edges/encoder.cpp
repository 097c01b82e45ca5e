#include "edges/encoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "edges/bit_costs.hpp"
#include "edges/code.hpp"
#include "edges/refine.hpp"
#include "inkcell/format/rom.hpp"
#include "shape/points.hpp"
#include "target/metric.hpp"

namespace inkcell {
namespace gen {
namespace {

// What a saturated square says, beyond every band. [u]
constexpr float kSaturated_u = 1024;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Fields that are stated for the whole grid, not for a square of it.
constexpr size_t kMostShared = 15;

// Squares of this size are not divided. [u, log2]
constexpr int kSmallestLog2 = 0;

// Finished leaves are tested once more, 16 times to the largest px. [u px]
constexpr double kFinePx_u = 64;

// What the largest heap of a record holds: four references each.
constexpr uint32_t kMostSplits =
    format::linked::kMaxUnits / format::linked::kNodeUnits;

// A leaf that costs no more than this is not worth looking below.
constexpr double kCheap = 12;

// What the test points may show: some of the tolerance stays for what they do
// not see, and for the device's filter table, whose steps are 1/255 and more.
// What still goes wrong the closed loop finds. [1/255]
double limit_of(const Target& options) {
  return std::max(options.tolerance - 1.25, options.tolerance / 2);
}

// The grid of a shape that cells of primitives reach.
Grid near_grid(const Shape& shape, const Target& options) {
  const Grid grid = lay_grid(shape, options);
  const int limit = format::edges::kGridLimit;
  if (grid.x0_u < -limit || grid.y0_u < -limit ||
      grid.x0_u + (grid.tiles_x << grid.tile_log2) > limit ||
      grid.y0_u + (grid.tiles_y << grid.tile_log2) > limit) {
    throw GeometryError(GeometryError::Kind::too_large,
                        "the glyph reaches farther than cells of primitives");
  }
  return grid;
}

// In how many rows of tiles each field is used.
std::vector<int> rows_of_fields(const EdgeTree& tree) {
  std::vector<int> rows(tree.fields.size());
  std::vector<int> last(tree.fields.size(), -1);
  for (const TreeNode& node : tree.nodes) {
    if (node.kind != TreeNode::Kind::leaf) {
      continue;
    }
    const int row = (node.y_u - tree.grid.y0_u) >> tree.grid.tile_log2;
    for (int i = 0; i < primitive_count(node.join); ++i) {
      const uint16_t field = node.uses[static_cast<size_t>(i)].field;
      rows[field] += last[field] != row ? 1 : 0;
      last[field] = row;
    }
  }
  return rows;
}

}  // namespace

EdgeEncoder::EdgeEncoder(const Shape& shape, const Target& options)
    : grid_(near_grid(shape, options)),
      fine_step_u_(std::max(1, static_cast<int>(kFinePx_u / options.max_px))),
      steps_(steps_for(options)),
      points_(shape, Metric(options), grid_, limit_of(options)),
      candidates_(points_, steps_, options),
      shared_log2_(shared_log2(grid_)),
      shared_x_u_(grid_.x0_u + (grid_.tiles_x << (grid_.tile_log2 - 1))),
      shared_y_u_(grid_.y0_u + (grid_.tiles_y << (grid_.tile_log2 - 1))) {}

// Fields that several rows of tiles use are written once, before the rows.
// Which they are shows when the rows may borrow from each other.
EdgeTree EdgeEncoder::encode() {
  shared_.clear();
  share(encode_rows(true));
  EdgeTree tree = encode_rows(false);
  if (drop_unshared(tree)) {
    tree = encode_rows(false);
  }
  polish_fields(points_, candidates_, tree.fields.size(), tree);
  return tree;
}

std::vector<Point> EdgeEncoder::find_misses(const EdgeTree& tree) {
  std::vector<Point> out;
  for (const TreeNode& node : tree.nodes) {
    Point miss;
    if (node.kind != TreeNode::Kind::split && find_miss(tree, node, miss)) {
      out.push_back(miss);
    }
  }
  return out;
}

// The worst point of a leaf, if it misses.
bool EdgeEncoder::find_miss(const EdgeTree& tree,
                            const TreeNode& leaf,
                            Point& out) {
  std::array<Primitive, 3> models;
  const bool is_leaf = leaf.kind == TreeNode::Kind::leaf;
  const auto count =
      is_leaf ? static_cast<size_t>(primitive_count(leaf.join)) : size_t{0};
  for (size_t i = 0; i < count; ++i) {
    models[i] = Primitive(tree.fields[leaf.uses[i].field]);
  }
  const float saturated =
      leaf.kind == TreeNode::Kind::inside ? kSaturated_u : -kSaturated_u;
  const int size = 1 << leaf.size_log2;
  const int step = std::min(fine_step_u_, size);
  float worst = 0;
  for (int y = leaf.y_u; y <= leaf.y_u + size; y += step) {
    for (int x = leaf.x_u; x <= leaf.x_u + size; x += step) {
      std::array<FieldValue, 3> values;
      for (size_t i = 0; i < count; ++i) {
        double gx = 0;
        double gy = 0;
        models[i].gradient(x, y, gx, gy);
        values[i] = {static_cast<float>(models[i].value(x, y)),
                     static_cast<float>(gx), static_cast<float>(gy)};
      }
      const float v = is_leaf ? join_values(leaf.join, values) : saturated;
      float low = 0;
      float high = 0;
      points_.allow(points_.truth().at(x, y).distance_u, low, high);
      const float miss = std::max(low - v, v - high);
      if (miss > worst) {
        worst = miss;
        out = {static_cast<double>(x), static_cast<double>(y)};
      }
    }
  }
  return worst > 0;
}

EdgeTree EdgeEncoder::encode_rows(bool borrow) {
  EdgeTree tree;
  tree.grid = grid_;
  tree.steps = steps_;
  tree.shared = shared_;
  fields_.clear();
  sure_splits_ = 0;
  List first;
  for (const PrimitiveCode& code : shared_) {
    first.push_back(static_cast<uint16_t>(fields_.size()));
    fields_.push_back(shared_field(code));
  }
  List list = first;
  for (int row = 0; row < grid_.tiles_y; ++row) {
    if (!borrow) {
      list = first;
    }
    for (int column = 0; column < grid_.tiles_x; ++column) {
      Coded coded = encode_square(grid_.x0_u + (column << grid_.tile_log2),
                                  grid_.y0_u + (row << grid_.tile_log2),
                                  grid_.tile_log2, list, kUnlimited);
      fields_.insert(fields_.end(), coded.fields.begin(), coded.fields.end());
      tree.nodes.insert(tree.nodes.end(), coded.nodes.begin(),
                        coded.nodes.end());
      tree.failures += coded.failures;
      list = std::move(coded.list);
    }
  }
  tree.fields = fields_;
  return tree;
}

// States the fields that several rows of `tree` use for the whole grid, where
// their codes are finer, and moves them to where they serve all of their cells.
void EdgeEncoder::share(EdgeTree tree) {
  const std::vector<int> rows = rows_of_fields(tree);
  std::vector<PrimitiveNumbers> fields;  // the shared ones first
  std::vector<PrimitiveNumbers> others;
  std::vector<size_t> places(rows.size());
  std::vector<bool> is_shared(rows.size());
  for (size_t f = 0; f < rows.size(); ++f) {
    is_shared[f] = rows[f] >= 2 && !is_arc(tree.fields[f]) &&
                   tree.shared.size() < kMostShared;
    if (is_shared[f]) {
      places[f] = fields.size();
      tree.shared.push_back(shared_code(tree.fields[f]));
      fields.push_back(shared_field(tree.shared.back()));
    } else {
      places[f] = others.size();
      others.push_back(tree.fields[f]);
    }
  }
  for (TreeNode& node : tree.nodes) {
    if (node.kind != TreeNode::Kind::leaf) {
      continue;
    }
    for (size_t i = 0; i < static_cast<size_t>(primitive_count(node.join));
         ++i) {
      PrimitiveUse& use = node.uses[i];
      const bool here = is_shared[use.field];
      use.is_new &= !here;
      use.field =
          static_cast<uint16_t>(places[use.field] + (here ? 0 : fields.size()));
    }
  }
  const size_t count = fields.size();
  tree.fields = std::move(fields);
  tree.fields.insert(tree.fields.end(), others.begin(), others.end());
  polish_fields(points_, candidates_, count, tree);
  shared_ = std::move(tree.shared);
}

bool EdgeEncoder::drop_unshared(const EdgeTree& tree) {
  const std::vector<int> rows = rows_of_fields(tree);
  std::vector<PrimitiveCode> kept;
  for (size_t f = 0; f < shared_.size(); ++f) {
    if (rows[f] >= 2) {
      kept.push_back(shared_[f]);
    }
  }
  const bool dropped = kept.size() != shared_.size();
  shared_ = std::move(kept);
  return dropped;
}

// The straight field nearest to `field`, with the precision of the whole grid.
PrimitiveCode EdgeEncoder::shared_code(const PrimitiveNumbers& field) const {
  const Primitive model(field);
  const double turn = std::atan2(model.ny, model.nx) / (2 * kPi);
  PrimitiveCode code;
  if (field.nx_q14 == 0 || field.ny_q14 == 0) {
    code.kind = PrimitiveKind::axis;
    code.angle = static_cast<uint32_t>(std::lround(turn * 4) & 3);
  } else {
    const int turns = 1 << steps_.angle_bits(shared_log2_);
    code.kind = PrimitiveKind::line;
    code.angle = static_cast<uint32_t>(std::lround(turn * turns) & (turns - 1));
  }
  code.d0 =
      steps_.quantised_d0(model.value(shared_x_u_, shared_y_u_), shared_log2_);
  return code;
}

PrimitiveNumbers EdgeEncoder::shared_field(const PrimitiveCode& code) const {
  return field_numbers(code, steps_, shared_log2_, shared_x_u_, shared_y_u_);
}

TreeNode EdgeEncoder::node(TreeNode::Kind kind,
                           int x_u,
                           int y_u,
                           int log2) const {
  TreeNode node;
  node.kind = kind;
  node.size_log2 = static_cast<uint8_t>(log2);
  node.x_u = static_cast<int16_t>(x_u);
  node.y_u = static_cast<int16_t>(y_u);
  return node;
}

EdgeEncoder::Coded EdgeEncoder::settle(
    const Leaf& leaf, int x_u, int y_u, int log2, const List& list) const {
  Coded coded;
  coded.list = list;
  coded.cost = leaf.bits + leaf.loss;
  TreeNode at = node(TreeNode::Kind::leaf, x_u, y_u, log2);
  at.join = leaf.join;
  const auto count = static_cast<size_t>(primitive_count(leaf.join));
  for (size_t i = 0; i < count; ++i) {
    const Candidate& c = *leaf.members[i];
    PrimitiveUse& use = at.uses[i];
    use.is_new = c.is_new;
    use.code = c.code;
    use.field = c.id;
    if (c.is_new) {
      use.field = static_cast<uint16_t>(fields_.size() + coded.fields.size());
      coded.fields.push_back(c.field);
    }
  }
  for (size_t i = count; i-- > 0;) {
    List& recent = coded.list;
    recent.erase(std::remove(recent.begin(), recent.end(), at.uses[i].field),
                 recent.end());
    recent.insert(recent.begin(), at.uses[i].field);
  }
  coded.list.resize(std::min(coded.list.size(), size_t{kRecentFields}));
  coded.nodes.push_back(at);
  return coded;
}

// The four quarters of a square. False if they cost more than `budget`.
bool EdgeEncoder::divide(
    int x_u, int y_u, int log2, const List& list, double budget, Coded& out) {
  out.nodes.push_back(node(TreeNode::Kind::split, x_u, y_u, log2));
  out.cost = node_bits(log2, node_symbol::kSplit);
  out.list = list;
  const int half = 1 << (log2 - 1);
  const size_t fields_before = fields_.size();
  for (int quarter = 0; quarter < 4 && out.cost < budget; ++quarter) {
    Coded part = encode_square(x_u + (quarter % 2 != 0 ? half : 0),
                               y_u + (quarter / 2 != 0 ? half : 0), log2 - 1,
                               out.list, budget - out.cost);
    fields_.insert(fields_.end(), part.fields.begin(), part.fields.end());
    out.nodes.insert(out.nodes.end(), part.nodes.begin(), part.nodes.end());
    out.fields.insert(out.fields.end(), part.fields.begin(), part.fields.end());
    out.list = std::move(part.list);
    out.cost += part.cost;
    out.failures += part.failures;
  }
  fields_.resize(fields_before);
  return out.cost < budget;
}

EdgeEncoder::Coded EdgeEncoder::encode_square(
    int x_u, int y_u, int log2, const List& list, double budget) {
  const Points points = points_.collect(x_u, y_u, log2);
  bool inside = false;
  if (points_.saturated(points, inside)) {
    Coded coded;
    coded.list = list;
    coded.nodes.push_back(
        node(inside ? TreeNode::Kind::inside : TreeNode::Kind::outside, x_u,
             y_u, log2));
    coded.cost =
        node_bits(log2, inside ? node_symbol::kInside : node_symbol::kOutside);
    return coded;
  }
  std::vector<CandidateSource::Known> known;
  for (const uint16_t number : list) {
    known.push_back({number, fields_[number]});
  }
  std::vector<Candidate> candidates = candidates_.find_reused(known, points);
  for (Candidate& c : candidates_.find_new(x_u, y_u, log2, points, known)) {
    candidates.push_back(std::move(c));
  }
  Leaf leaf;
  const bool found = search_.find(log2, points, candidates, leaf);
  const bool last = log2 <= kSmallestLog2;
  const bool good =
      found && (last || leaf.join == Join::single || leaf.bits <= kCheap);
  if (!found && !last && !(budget < kUnlimited) &&
      ++sure_splits_ > kMostSplits) {
    throw GeometryError(GeometryError::Kind::too_complex,
                        "the glyph has more cells than the format");
  }
  if (!good && !last) {
    Coded divided;
    const double most =
        found ? std::min(budget, leaf.bits + leaf.loss) : budget;
    if (divide(x_u, y_u, log2, list, most, divided) || !found) {
      return divided;
    }
  }
  if (found) {
    return settle(leaf, x_u, y_u, log2, list);
  }
  Coded failed;
  failed.list = list;
  failed.nodes.push_back(node(points.d[points.size() / 2] > 0
                                  ? TreeNode::Kind::inside
                                  : TreeNode::Kind::outside,
                              x_u, y_u, log2));
  failed.cost = node_bits(log2, node_symbol::kOutside);
  failed.failures = 1;
  return failed;
}

}  // namespace gen
}  // namespace inkcell
