// Fields of a finished tree moved to where they are truest.
#include <gtest/gtest.h>

#include "edges/refine.hpp"

#include <cmath>
#include <limits>

#include "edges/code.hpp"
#include "edges/encoder.hpp"
#include "edges/leaf.hpp"
#include "glyph_outlines.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

Target fields() {
  Target options;
  options.coding = Coding::edges;
  return options;
}

// A letter, its tree, and what judges both.
class FieldPolish : public testing::Test {
 protected:
  FieldPolish()
      : shape_(load_outlines(kDejaVuSans, 0, {'R'})[0]),
        points_(shape_,
                Metric(options_),
                lay_grid(shape_, options_),
                options_.tolerance),
        candidates_(points_, steps_for(options_), options_),
        tree_(EdgeEncoder(shape_, options_).encode()) {}

  // The sum of the squares of all errors; infinite if a cell misses the limit.
  double squares(const EdgeTree& tree) {
    double sum = 0;
    for (const TreeNode& node : tree.nodes) {
      if (node.kind != TreeNode::Kind::leaf) {
        continue;
      }
      const Points points = points_.collect(node.x_u, node.y_u, node.size_log2);
      std::array<Candidate, 3> members;
      Leaf leaf;
      leaf.join = node.join;
      for (size_t m = 0; m < static_cast<size_t>(primitive_count(node.join));
           ++m) {
        members[m].field = tree.fields[node.uses[m].field];
        candidates_.evaluate(members[m], points);
        leaf.members[m] = &members[m];
      }
      const LeafError error = measure_leaf(leaf, points);
      sum += error.failed < points.size()
                 ? std::numeric_limits<double>::infinity()
                 : error.squares;
    }
    return sum;
  }

  // Moves the new field of a leaf by one step of its distance.
  EdgeTree disturbed(size_t node, size_t member) {
    EdgeTree tree = tree_;
    TreeNode& leaf = tree.nodes[node];
    PrimitiveUse& use = leaf.uses[member];
    ++use.code.d0;
    const int half = 1 << leaf.size_log2 >> 1;
    tree.fields[use.field] = field_numbers(use.code, tree.steps, leaf.size_log2,
                                           leaf.x_u + half, leaf.y_u + half);
    return tree;
  }

  Target options_ = fields();
  Shape shape_;
  PointSource points_;
  CandidateSource candidates_;
  EdgeTree tree_;
};

TEST_F(FieldPolish, BringsBackWhatWasMoved) {
  const double best = squares(tree_);
  ASSERT_TRUE(std::isfinite(best));
  int moved = 0;
  for (size_t n = 0; n < tree_.nodes.size(); ++n) {
    const TreeNode& node = tree_.nodes[n];
    if (node.kind != TreeNode::Kind::leaf) {
      continue;
    }
    for (size_t m = 0; m < static_cast<size_t>(primitive_count(node.join));
         ++m) {
      if (!node.uses[m].is_new) {
        continue;
      }
      EdgeTree tree = disturbed(n, m);
      const double worse = squares(tree);
      if (!(worse > best + 0.02)) {
        continue;
      }
      ++moved;
      polish_fields(points_, candidates_, tree.fields.size(), tree);
      EXPECT_LT(squares(tree), std::min(worse, best + 0.02)) << n << ' ' << m;
    }
  }
  EXPECT_GT(moved, 5);
}

TEST_F(FieldPolish, ChangesNumbersAlone) {
  for (size_t n = 0; n < tree_.nodes.size(); ++n) {
    if (tree_.nodes[n].kind != TreeNode::Kind::leaf ||
        !tree_.nodes[n].uses[0].is_new) {
      continue;
    }
    EdgeTree tree = disturbed(n, 0);
    const EdgeTree before = tree;
    polish_fields(points_, candidates_, tree.fields.size(), tree);
    ASSERT_EQ(tree.nodes.size(), before.nodes.size());
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
      const TreeNode& node = tree.nodes[i];
      ASSERT_EQ(node.kind, before.nodes[i].kind);
      ASSERT_EQ(node.join, before.nodes[i].join);
      for (size_t m = 0; m < static_cast<size_t>(primitive_count(node.join)) &&
                         node.kind == TreeNode::Kind::leaf;
           ++m) {
        const PrimitiveUse& use = node.uses[m];
        const PrimitiveUse& old = before.nodes[i].uses[m];
        ASSERT_EQ(use.is_new, old.is_new);
        ASSERT_EQ(use.field, old.field);
        if (!use.is_new) {
          continue;
        }
        ASSERT_EQ(use.code.kind, old.code.kind);
        const int half = 1 << node.size_log2 >> 1;
        ASSERT_TRUE(
            same_primitive(tree.fields[use.field],
                           field_numbers(use.code, tree.steps, node.size_log2,
                                         node.x_u + half, node.y_u + half)));
        if (is_bent(use.code.kind)) {
          ASSERT_NE(use.code.bend, 0);
          ASSERT_LE(tree.steps.bend_bits(use.code.bend, node.size_log2),
                    tree.steps.bend_bits(old.code.bend, node.size_log2));
        }
      }
    }
  }
}

TEST_F(FieldPolish, LeavesFieldsBeyondTheCount) {
  for (size_t f = 0; f < tree_.fields.size(); ++f) {
    EdgeTree tree = tree_;
    tree.fields[f].c_q4 = static_cast<int16_t>(tree.fields[f].c_q4 + 4);
    const std::vector<PrimitiveNumbers> before = tree.fields;
    polish_fields(points_, candidates_, f, tree);
    for (size_t i = f; i < before.size(); ++i) {
      EXPECT_TRUE(same_primitive(tree.fields[i], before[i])) << f << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
