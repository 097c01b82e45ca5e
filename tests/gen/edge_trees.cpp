// Trees of fields made by hand, and what docs/FORMAT.md says they are worth.
#include "edge_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edges/code.hpp"
#include "inkcell/format/cell.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

// Values nearer to each other are a close call. [u]
constexpr double kClose = 0.1;

struct Term {
  double v;
  double gx;
  double gy;
};

Term negated(const Term& a) {
  return {-a.v, -a.gx, -a.gy};
}

// Two values that meet in a min.
double meet(const Term& a, const Term& b, PlainValue& flags) {
  const double least = std::min(a.v, b.v);
  const double c = a.gx * b.gx + a.gy * b.gy;
  const double from_a = a.v - c * b.v;
  const double from_b = b.v - c * a.v;
  const double sine2 = 1 - c * c;
  const double hair = 0.01 * (std::fabs(a.v) + std::fabs(b.v));
  if (least >= 0 || from_a > hair || from_b > hair) {
    return least;
  }
  flags.rounded = true;
  if (from_a > 0 || from_b > 0) {
    return least;
  }
  flags.close_call |= std::fabs(sine2 - 0.022) < 0.004;
  if (sine2 < 0.022) {
    return least;
  }
  return -std::hypot(a.v, from_b / std::sqrt(sine2));
}

class RandomTree {
 public:
  RandomTree(std::mt19937& random, const TreeOptions& options)
      : random_(random), options_(options) {}

  EdgeTree make() {
    Grid& grid = tree_.grid;
    grid.tile_log2 = 8;
    grid.tiles_x = options_.tiles_x;
    grid.tiles_y = options_.tiles_y;
    grid.x0_u = between(-1984, 1984 - 256 * grid.tiles_x);
    grid.y0_u = between(-1984, 1984 - 256 * grid.tiles_y);
    tree_.steps = options_.steps;
    const int log2 = shared_log2(grid);
    for (int i = between(0, 15); i > 0; --i) {
      const PrimitiveCode code = any_code(log2);
      tree_.shared.push_back(code);
      tree_.fields.push_back(field_numbers(code, tree_.steps, log2,
                                           grid.x0_u + 128 * grid.tiles_x,
                                           grid.y0_u + 128 * grid.tiles_y));
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
    return tree_;
  }

 private:
  int between(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }

  PrimitiveCode any_code(int log2) {
    const PrimitiveSteps& steps = tree_.steps;
    PrimitiveCode code;
    code.kind = static_cast<PrimitiveKind>(between(0, 3));
    // Small distances are what glyphs have.
    const int most = 1 << (steps.d0_bits(log2) - 1);
    code.d0 = between(-most, most - 1) / between(1, 8);
    code.angle = static_cast<uint32_t>(between(
        0, has_angle(code.kind) ? (1 << steps.angle_bits(log2)) - 1 : 3));
    if (is_bent(code.kind)) {
      code.bend = between(1, std::min(steps.most_bend(log2), 250));
      code.bend /= between(1, code.bend);
      code.bend *= between(0, 1) != 0 ? 1 : -1;
    }
    return code;
  }

  bool allowed(const PrimitiveNumbers& field,
               int x_u,
               int y_u,
               int size) const {
    if (!options_.within_limits) {
      return true;
    }
    const Primitive model(field);
    for (const int x : {x_u, x_u + size}) {
      for (const int y : {y_u, y_u + size}) {
        const double w = model.nx * y - model.ny * x + model.cw;
        if (std::fabs(model.value(x, y)) > 480 ||
            (model.k != 0 && std::fabs(w) > 250) ||
            std::fabs(2 * model.k * w) > 0.5) {
          return false;
        }
      }
    }
    return true;
  }

  void square(int x_u, int y_u, int log2) {
    TreeNode node;
    node.size_log2 = static_cast<uint8_t>(log2);
    node.x_u = static_cast<int16_t>(x_u);
    node.y_u = static_cast<int16_t>(y_u);
    const int choice = between(0, 9);
    if (log2 > 0 && log2 > 8 - options_.depth && choice < 5) {
      node.kind = TreeNode::Kind::split;
      tree_.nodes.push_back(node);
      const int half = 1 << log2 >> 1;
      for (int quarter = 0; quarter < 4; ++quarter) {
        square(x_u + quarter % 2 * half, y_u + quarter / 2 * half, log2 - 1);
      }
      return;
    }
    if (choice < 8 && leaf(node)) {
      return;
    }
    node.kind =
        choice % 2 == 0 ? TreeNode::Kind::outside : TreeNode::Kind::inside;
    tree_.nodes.push_back(node);
  }

  // False if fields of that kind are not allowed there.
  bool leaf(TreeNode& node) {
    node.kind = TreeNode::Kind::leaf;
    node.join = static_cast<Join>(between(0, kJoins - 1));
    const int count = primitive_count(node.join);
    const bool nested = is_nested(node.join);
    std::vector<PrimitiveNumbers> fresh;
    bool after_new = false;
    int rank = 0;
    int first_rank = -1;
    for (int i = 0; i < count; ++i) {
      if (i == 0 || (nested && i == 1)) {
        after_new = false;
        rank = 0;
      }
      PrimitiveUse& use = node.uses[static_cast<size_t>(i)];
      rank += between(0, 2) * between(0, 2);
      // No leaf names a field twice.
      if (nested && i > 0 && rank == first_rank) {
        ++rank;
      }
      if (!after_new && rank < static_cast<int>(list_.size()) &&
          between(0, 2) != 0) {
        use.field = list_[static_cast<size_t>(rank)];
        first_rank = i == 0 ? rank : first_rank;
        ++rank;
      } else {
        after_new = true;
        use.is_new = true;
        use.code = any_code(node.size_log2);
        const int half = 1 << node.size_log2 >> 1;
        use.field = static_cast<uint16_t>(tree_.fields.size() + fresh.size());
        fresh.push_back(field_numbers(use.code, tree_.steps, node.size_log2,
                                      node.x_u + half, node.y_u + half));
      }
      const PrimitiveNumbers& field =
          use.is_new ? fresh.back() : tree_.fields[use.field];
      if (!allowed(field, node.x_u, node.y_u, 1 << node.size_log2)) {
        return false;
      }
    }
    tree_.fields.insert(tree_.fields.end(), fresh.begin(), fresh.end());
    for (int i = count - 1; i >= 0; --i) {
      const uint16_t field = node.uses[static_cast<size_t>(i)].field;
      list_.erase(std::remove(list_.begin(), list_.end(), field), list_.end());
      list_.insert(list_.begin(), field);
    }
    list_.resize(std::min(list_.size(), size_t{16}));
    tree_.nodes.push_back(node);
    return true;
  }

  std::mt19937& random_;
  const TreeOptions& options_;
  EdgeTree tree_;
  std::vector<uint16_t> list_;
};

}  // namespace

PlainValue plain_value(Join join,
                       const std::vector<Primitive>& fields,
                       double x,
                       double y) {
  const bool greatest = takes_greatest(join);
  std::vector<Term> terms;
  for (const Primitive& field : fields) {
    Term term = {field.value(x, y), 0, 0};
    field.gradient(x, y, term.gx, term.gy);
    terms.push_back(greatest ? negated(term) : term);
  }
  PlainValue out;
  double v = terms[0].v;
  if (join == Join::min2 || join == Join::max2) {
    v = meet(terms[0], terms[1], out);
  } else if (join == Join::min3 || join == Join::max3) {
    std::sort(terms.begin(), terms.end(),
              [](const Term& a, const Term& b) { return a.v < b.v; });
    v = meet(terms[0], terms[1], out);
    out.close_call |= terms[2].v - terms[1].v < kClose;
  } else if (is_nested(join)) {
    Term inner = terms[1].v >= terms[2].v ? terms[1] : terms[2];
    out.close_call |= std::fabs(terms[1].v - terms[2].v) < kClose;
    inner.v = -meet(negated(terms[1]), negated(terms[2]), out);
    v = meet(terms[0], inner, out);
  }
  out.value = greatest ? -v : v;
  return out;
}

EdgeTree random_tree(std::mt19937& random, const TreeOptions& options) {
  return RandomTree(random, options).make();
}

const TreeNode& square_at(const EdgeTree& tree, int x_u, int y_u) {
  const auto holds = [&](const TreeNode& node) {
    const int size = 1 << node.size_log2;
    return node.kind != TreeNode::Kind::split && x_u >= node.x_u &&
           x_u < node.x_u + size && y_u >= node.y_u && y_u < node.y_u + size;
  };
  return *std::find_if(tree.nodes.begin(), tree.nodes.end(), holds);
}

PlainValue value_at(const EdgeTree& tree, const TreeNode& leaf, int x, int y) {
  std::vector<Primitive> fields;
  for (int i = 0; i < primitive_count(leaf.join); ++i) {
    fields.emplace_back(tree.fields[leaf.uses[static_cast<size_t>(i)].field]);
  }
  return plain_value(leaf.join, fields, x, y);
}

bool same_pictures(const GlyphField& a, const GlyphField& b, int step) {
  if (a.x0_u != b.x0_u || a.y0_u != b.y0_u || a.x1_u() != b.x1_u() ||
      a.y1_u() != b.y1_u()) {
    return false;
  }
  for (int y = a.y0_u; y < a.y1_u(); y += step) {
    for (int x = a.x0_u; x < a.x1_u(); x += step) {
      const Cell in_a = locate(a, x, y);
      const Cell in_b = locate(b, x, y);
      if (in_a.x0_u != in_b.x0_u || in_a.y0_u != in_b.y0_u ||
          in_a.size_log2 != in_b.size_log2 ||
          in_a.is_saturated() != in_b.is_saturated() ||
          distance_u(a, x, y) != distance_u(b, x, y)) {
        return false;
      }
    }
  }
  return true;
}

GlyphField open_record(const std::vector<uint8_t>& bytes) {
  GlyphField field;
  EXPECT_EQ(GlyphField::open({bytes.data(), bytes.size()}, field), Status::ok);
  return field;
}

double distance_u(const GlyphField& field, int x_u, int y_u) {
  return distance_at(field, Q16_16::from_int(x_u), Q16_16::from_int(y_u)).raw /
         1024.0;
}

}  // namespace test
}  // namespace gen
}  // namespace inkcell
