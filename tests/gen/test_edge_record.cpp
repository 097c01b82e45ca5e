// Trees of primitives as records, read with the device's own code.
#include <gtest/gtest.h>

#include "edges/record.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "edge_target.hpp"
#include "edge_trees.hpp"
#include "edges/code.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

bool is_linked(const std::vector<uint8_t>& record) {
  return (record[1] & 0x80) != 0;
}

int count_at(const std::vector<uint8_t>& record, size_t offset) {
  return record[offset] | record[offset + 1] << 8;
}

struct Tally {
  int compared = 0;
  int rounded = 0;
  int saturated = 0;
};

// Every square and its value, at points of whole u.
void expect_tree(const EdgeTree& tree, const GlyphField& field, Tally& tally) {
  for (const TreeNode& node : tree.nodes) {
    if (node.kind == TreeNode::Kind::split) {
      continue;
    }
    const int size = 1 << node.size_log2;
    const int step = std::max(1, size / 8);
    for (int y = node.y_u; y < node.y_u + size; y += step) {
      for (int x = node.x_u; x < node.x_u + size; x += step) {
        const Cell cell = locate(field, x, y);
        ASSERT_EQ(cell.x0_u, node.x_u);
        ASSERT_EQ(cell.y0_u, node.y_u);
        ASSERT_EQ(cell.size_log2, node.size_log2);
        if (node.kind != TreeNode::Kind::leaf) {
          ASSERT_TRUE(cell.is_saturated());
          ASSERT_EQ(cell.inside, node.kind == TreeNode::Kind::inside);
          ++tally.saturated;
          continue;
        }
        ASSERT_FALSE(cell.is_saturated());
        const PlainValue plain = value_at(tree, node, x, y);
        // Readers need not know distances from 512 u on.
        if (plain.close_call || std::fabs(plain.value) > 500) {
          continue;
        }
        // As field.hpp states at distance_at.
        const double error =
            0.01 + (plain.rounded ? std::fabs(plain.value) / 128 : 0);
        ASSERT_NEAR(distance_u(field, x, y), plain.value, error)
            << x << ' ' << y << " join " << static_cast<int>(node.join);
        ++tally.compared;
        tally.rounded += plain.rounded ? 1 : 0;
      }
    }
  }
}

TEST(FieldRecord, SaysWhatTheTreeSays) {
  std::mt19937 random(6);
  Tally tally;
  int narrow = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    TreeOptions options;
    options.tiles_x = 1 + round % 3;
    options.tiles_y = 1 + round / 3 % 2;
    options.depth = 2 + round % 3;
    options.steps = steps_for(edge_target(8, round % 2 == 0 ? 64 : 24, 16));
    const EdgeTree tree = random_tree(random, options);
    const std::vector<uint8_t> record = edge_record(tree);
    narrow += is_linked(record) ? 0 : 1;
    expect_tree(tree, open_record(record), tally);
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(tally.compared, 20000);
  EXPECT_GT(tally.rounded, 500);
  EXPECT_GT(tally.saturated, 2000);
  EXPECT_GT(narrow, 30);
}

// A tile without a split, all of one leaf.
EdgeTree one_leaf(Join join, const std::vector<PrimitiveNumbers>& fields) {
  EdgeTree tree;
  tree.grid = {8, -128, -128, 1, 1};
  tree.fields = fields;
  TreeNode node;
  node.kind = TreeNode::Kind::leaf;
  node.size_log2 = 8;
  node.x_u = -128;
  node.y_u = -128;
  node.join = join;
  for (size_t i = 0; i < fields.size(); ++i) {
    node.uses[i].is_new = true;
    node.uses[i].field = static_cast<uint16_t>(i);
  }
  tree.nodes = {node};
  return tree;
}

PrimitiveNumbers line(int c_q4) {
  return {16384, 0, static_cast<int16_t>(c_q4), 0, 0};
}

PrimitiveNumbers arc(int c_q4, int bend) {
  return {0, 16384, static_cast<int16_t>(c_q4), 0, static_cast<int16_t>(bend)};
}

// Turns a tree of one leaf into one of four.
void repeat(EdgeTree& tree) {
  TreeNode quarter = tree.nodes[0];
  TreeNode split;
  split.kind = TreeNode::Kind::split;
  split.size_log2 = 8;
  split.x_u = -128;
  split.y_u = -128;
  tree.nodes = {split};
  quarter.size_log2 = 7;
  for (int i = 0; i < 4; ++i) {
    quarter.x_u = static_cast<int16_t>(i % 2 * 128 - 128);
    quarter.y_u = static_cast<int16_t>(i / 2 * 128 - 128);
    tree.nodes.push_back(quarter);
  }
}

TEST(FieldRecord, HasTheBytesOfTheDocument) {
  EdgeTree tree = one_leaf(Join::max_min, {line(16), arc(-32, 64), line(48)});
  const std::vector<uint8_t> expected = {
      2,    8,    0x80, 0xff, 0x80, 0xff, 1, 1,  // type, tile, x0, y0, tiles
      0,    0,    1,    0,    2,    0,           // nodes, arcs, lines
      0,    0,    1,    0,                       // pairs, triples
      0,    0,    0,    0x40, 0xe0, 0xff, 0, 0, 64, 0,  // the arc
      0,    0x40, 0,    0,    16,   0,                  // lines
      0,    0x40, 0,    0,    48,   0,                  //
      3,    1,    0,    2,                              // max(f1, min(f0, f2))
      2 + 3};
  EXPECT_EQ(edge_record(tree), expected);
}

TEST(FieldRecord, PairsSayByTheirOrderWhatTheyAre) {
  for (const Join join : {Join::min2, Join::max2}) {
    for (const bool swapped : {false, true}) {
      EdgeTree tree = one_leaf(
          join, {line(swapped ? 160 : -160), arc(swapped ? -80 : 80, 0)});
      const std::vector<uint8_t> record = edge_record(tree);
      ASSERT_EQ(record.size(), 18u + 12 + 2 + 1);
      EXPECT_EQ(record[30] < record[31], join == Join::min2);
      Tally tally;
      expect_tree(tree, open_record(record), tally);
      EXPECT_GT(tally.compared, 30);
    }
  }
}

TEST(FieldRecord, EqualFieldsAndLeavesAreWrittenOnce) {
  EdgeTree once = one_leaf(Join::min3, {line(1), line(2), arc(3, 9)});
  EdgeTree many = once;
  repeat(many);
  // The same three again under other numbers.
  many.fields.insert(many.fields.end(), once.fields.begin(), once.fields.end());
  for (PrimitiveUse& use : many.nodes[2].uses) {
    use.field = static_cast<uint16_t>(use.field + 3);
  }
  // Bytes that do not count in a line.
  many.fields[3].along_q4 = 77;
  const std::vector<uint8_t> record = edge_record(many);
  EXPECT_EQ(count_at(record, 8), 1);
  EXPECT_EQ(count_at(record, 10), 1);
  EXPECT_EQ(count_at(record, 12), 2);
  EXPECT_EQ(count_at(record, 14), 0);
  EXPECT_EQ(count_at(record, 16), 1);
  EXPECT_EQ(record.size(), edge_record(once).size() + 4);
  Tally tally;
  expect_tree(many, open_record(record), tally);
}

TEST(FieldRecord, FieldsThatNoLeafNamesAreLeftOut) {
  EdgeTree tree = one_leaf(Join::single, {line(1)});
  const std::vector<uint8_t> before = edge_record(tree);
  tree.fields.push_back(arc(5, 5));
  tree.fields.push_back(line(6));
  EXPECT_EQ(edge_record(tree), before);
}

// A tile of 4^levels leaves, each of a line of its own.
EdgeTree many_lines(int levels) {
  EdgeTree tree;
  tree.grid = {8, -128, -128, 1, 1};
  struct Grow {
    EdgeTree& tree;
    int last;
    void square(int x, int y, int log2) {
      TreeNode node;
      node.size_log2 = static_cast<uint8_t>(log2);
      node.x_u = static_cast<int16_t>(x);
      node.y_u = static_cast<int16_t>(y);
      if (log2 > last) {
        node.kind = TreeNode::Kind::split;
        tree.nodes.push_back(node);
        const int half = 1 << (log2 - 1);
        for (int i = 0; i < 4; ++i) {
          square(x + i % 2 * half, y + i / 2 * half, log2 - 1);
        }
        return;
      }
      node.kind = TreeNode::Kind::leaf;
      node.uses[0].is_new = true;
      node.uses[0].field = static_cast<uint16_t>(tree.fields.size());
      tree.fields.push_back(line(static_cast<int>(tree.fields.size())));
      tree.nodes.push_back(node);
    }
  };
  Grow{tree, 8 - levels}.square(-128, -128, 8);
  return tree;
}

TEST(FieldRecord, TurnsToLinksWhereNumbersDoNotFitBytes) {
  // 2 + 21 nodes + 64 lines; then 2 + 85 nodes + 256 lines.
  EXPECT_FALSE(is_linked(edge_record(many_lines(3))));
  const EdgeTree large = many_lines(4);
  const std::vector<uint8_t> record = edge_record(large);
  ASSERT_TRUE(is_linked(record));
  Tally tally;
  expect_tree(large, open_record(record), tally);
  EXPECT_GT(tally.compared, 10000);
}

// 225 tiles of a line each; some meet the first one.
EdgeTree mosaic(int pairs) {
  EdgeTree tree;
  tree.grid = {4, -128, -128, 15, 15};
  for (int i = 0; i < 225; ++i) {
    TreeNode node;
    node.kind = TreeNode::Kind::leaf;
    node.size_log2 = 4;
    node.x_u = static_cast<int16_t>(16 * (i % 15) - 128);
    node.y_u = static_cast<int16_t>(16 * (i / 15) - 128);
    node.uses[0].field = static_cast<uint16_t>(i);
    if (i > 0 && i <= pairs) {
      node.join = i % 2 == 0 ? Join::min2 : Join::max2;
    }
    tree.nodes.push_back(node);
    tree.fields.push_back(line(i));
  }
  return tree;
}

TEST(FieldRecord, UsesEveryNumberOfAByte) {
  for (const int pairs : {28, 29, 30}) {
    const EdgeTree tree = mosaic(pairs);
    const std::vector<uint8_t> record = edge_record(tree);
    // 2 and 225 lines.
    EXPECT_EQ(is_linked(record), 2 + 225 + pairs > 256);
    Tally tally;
    expect_tree(tree, open_record(record), tally);
    EXPECT_GT(tally.compared, 10000);
  }
}

TEST(FieldRecord, LinkedRecordsSayTheSame) {
  std::mt19937 random(7);
  int linked = 0;
  for (int round = 0; round < 20; ++round) {
    TreeOptions options;
    options.tiles_x = 2;
    options.tiles_y = 2;
    options.depth = 5;
    options.steps = steps_for(edge_target(8, 64, 16));
    const EdgeTree tree = random_tree(random, options);
    const std::vector<uint8_t> record = edge_record(tree);
    linked += is_linked(record) ? 1 : 0;
    Tally tally;
    expect_tree(tree, open_record(record), tally);
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(linked, 5);
}

TEST(FieldRecord, RefusesWhatTheFormatCannotHold) {
  // 1024 lines of 3 units, and 341 nodes of 4; then four times as much.
  EXPECT_TRUE(is_linked(edge_record(many_lines(5))));
  try {
    edge_record(many_lines(6));
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.kind(), GeometryError::Kind::too_complex);
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
