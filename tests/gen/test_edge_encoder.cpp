// Shapes made into trees of primitives.
#include <gtest/gtest.h>

#include "edges/encoder.hpp"

#include <algorithm>
#include <cmath>

#include "edge_target.hpp"
#include "edge_trees.hpp"
#include "edges/code.hpp"
#include "edges/record.hpp"
#include "glyph_outlines.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

// The rules that all users of trees depend on: order of the squares, fields in
// the order in which they are met, reused ones among the last 16.
class Rules {
 public:
  explicit Rules(const EdgeTree& tree) : tree_(tree) {}

  void check() {
    const Grid& grid = tree_.grid;
    const int log2 = shared_log2(grid);
    for (const PrimitiveCode& code : tree_.shared) {
      expect_field(code, log2, grid.x0_u + 128 * grid.tiles_x,
                   grid.y0_u + 128 * grid.tiles_y);
    }
    for (int row = 0; row < grid.tiles_y; ++row) {
      list_.clear();
      for (size_t f = 0; f < tree_.shared.size(); ++f) {
        list_.push_back(static_cast<uint16_t>(f));
      }
      for (int column = 0; column < grid.tiles_x; ++column) {
        square(grid.x0_u + 256 * column, grid.y0_u + 256 * row, 8);
      }
    }
    EXPECT_EQ(next_, tree_.nodes.size());
    EXPECT_EQ(known_, tree_.fields.size());
    EXPECT_LE(tree_.shared.size(), 15u);
  }

 private:
  void expect_field(const PrimitiveCode& code, int log2, int x, int y) {
    ASSERT_LT(known_, tree_.fields.size());
    EXPECT_TRUE(same_primitive(tree_.fields[known_],
                               field_numbers(code, tree_.steps, log2, x, y)));
    ++known_;
  }

  void square(int x_u, int y_u, int log2) {
    ASSERT_LT(next_, tree_.nodes.size());
    const TreeNode& node = tree_.nodes[next_++];
    ASSERT_EQ(node.x_u, x_u);
    ASSERT_EQ(node.y_u, y_u);
    ASSERT_EQ(node.size_log2, log2);
    if (node.kind == TreeNode::Kind::split) {
      const int half = 1 << (log2 - 1);
      for (int i = 0; i < 4; ++i) {
        square(x_u + i % 2 * half, y_u + i / 2 * half, log2 - 1);
      }
    } else if (node.kind == TreeNode::Kind::leaf) {
      leaf(node);
    }
  }

  void leaf(const TreeNode& node) {
    const bool nested = is_nested(node.join);
    bool after_new = false;
    const int count = primitive_count(node.join);
    for (int i = 0; i < count; ++i) {
      if (nested && i == 1) {
        after_new = false;
      }
      const PrimitiveUse& use = node.uses[static_cast<size_t>(i)];
      if (use.is_new) {
        EXPECT_EQ(use.field, known_);
        const int half = 1 << node.size_log2 >> 1;
        expect_field(use.code, node.size_log2, node.x_u + half,
                     node.y_u + half);
        after_new = true;
        continue;
      }
      EXPECT_FALSE(after_new);
      EXPECT_NE(std::find(list_.begin(), list_.end(), use.field), list_.end());
    }
    for (int i = count - 1; i >= 0; --i) {
      const uint16_t field = node.uses[static_cast<size_t>(i)].field;
      list_.erase(std::remove(list_.begin(), list_.end(), field), list_.end());
      list_.insert(list_.begin(), field);
    }
    list_.resize(std::min(list_.size(), size_t{16}));
  }

  const EdgeTree& tree_;
  size_t next_ = 0;
  size_t known_ = 0;
  std::vector<uint16_t> list_;
};

size_t leaves_of(const EdgeTree& tree) {
  return static_cast<size_t>(std::count_if(
      tree.nodes.begin(), tree.nodes.end(),
      [](const TreeNode& node) { return node.kind == TreeNode::Kind::leaf; }));
}

TEST(EdgeEncoder, TreesKeepTheRules) {
  for (const char* file : {kDejaVuSans, kLiberationSerif, kRoboto}) {
    for (const Outline& glyph : load_outlines(file, 0, {'a'})) {
      const Shape shape(glyph);
      EdgeEncoder encoder(shape, edge_target(8, 32, 16));
      const EdgeTree tree = encoder.encode();
      EXPECT_EQ(tree.failures, 0);
      EXPECT_GT(leaves_of(tree), 10u);
      Rules(tree).check();
    }
  }
}

TEST(EdgeEncoder, SaysTheSameWhenAskedAgain) {
  const Shape shape(load_outlines(kDejaVuSans, 0, {'e'})[0]);
  EdgeEncoder encoder(shape, edge_target(8, 32, 16));
  const std::vector<uint8_t> first = edge_record(encoder.encode());
  EXPECT_EQ(edge_record(encoder.encode()), first);
  EdgeEncoder other(shape, edge_target(8, 32, 16));
  EXPECT_EQ(edge_record(other.encode()), first);
}

TEST(EdgeEncoder, PointsThatWereMissedAreMet) {
  const Shape shape(outline({circle(200, 200, 150)}));
  const Target options = edge_target(8, 64, 16);
  EdgeEncoder encoder(shape, options);
  const Metric metric(options);
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) {
    points.push_back(
        {200 + 151.3 * std::cos(0.17 * i), 200 + 151.3 * std::sin(0.17 * i)});
    encoder.add_point(points.back());
  }
  const std::vector<uint8_t> record = edge_record(encoder.encode());
  const GlyphField field = open_record(record);
  for (const Point& p : points) {
    const auto q16 = [](double u) {
      return Q16_16::from_raw(static_cast<int32_t>(std::lround(u * 65536)));
    };
    const double read = distance_at(field, q16(p.x), q16(p.y)).raw / 1024.0;
    EXPECT_LE(metric.error(shape.distance(p.x, p.y), read),
              options.tolerance - 0.7);
  }
}

// A square has four sides, a circle one arc in each cell: not many fields.
TEST(EdgeEncoder, SimpleShapesTakeFewFields) {
  const Target options = edge_target(8, 64, 16);
  const Shape square(outline({rectangle(0, 0, 600, 600)}));
  EdgeTree tree = EdgeEncoder(square, options).encode();
  Rules(tree).check();
  EXPECT_EQ(tree.failures, 0);
  EXPECT_LE(tree.fields.size(), 8u);
  for (const PrimitiveNumbers& field : tree.fields) {
    EXPECT_FALSE(is_arc(field));
    EXPECT_TRUE(field.nx_q14 == 0 || field.ny_q14 == 0);
  }
  const Shape disk(outline({circle(0, 0, 300)}));
  tree = EdgeEncoder(disk, options).encode();
  Rules(tree).check();
  EXPECT_EQ(tree.failures, 0);
  EXPECT_LE(tree.fields.size(), 40u);
  EXPECT_TRUE(std::any_of(tree.fields.begin(), tree.fields.end(), is_arc));
}

TEST(EdgeEncoder, FewerBytesForLargerTolerances) {
  const Shape shape(load_outlines(kLiberationSerif, 0, {'S'})[0]);
  size_t before = 1000000;
  for (const double tolerance : {6.0, 16.0, 40.0}) {
    EdgeEncoder encoder(shape, edge_target(8, 48, tolerance));
    const size_t bytes = edge_record(encoder.encode()).size();
    EXPECT_LT(bytes, before) << tolerance;
    before = bytes;
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
