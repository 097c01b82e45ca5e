// Packed records, expanded by the device, against direct ones.
#include <gtest/gtest.h>

#include "field_stream.hpp"

#include <algorithm>
#include <random>

#include "bit_costs.hpp"
#include "field_code.hpp"
#include "field_encoder.hpp"
#include "field_record.hpp"
#include "field_trees.hpp"
#include "glyph_outlines.hpp"
#include "inkcell/packed.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

AdfOptions fields(double min_px, double max_px, double tolerance) {
  AdfOptions options;
  options.cells = CellKind::fields;
  options.coding = Coding::packed;
  options.min_px = min_px;
  options.max_px = max_px;
  options.tolerance = tolerance;
  return options;
}

// A packed glyph as the device knows it: the coding from the font's header.
struct Packed {
  explicit Packed(const FieldTree& tree)
      : record(packed_record(tree, nullptr)),
        header(coding_bytes(tree.coding)) {
    EXPECT_EQ(PackedGlyph::open({record.data(), record.size()},
                                PackedCoding::read(header.data()), glyph),
              Status::ok);
  }

  std::vector<uint8_t> record;
  std::array<uint8_t, 8> header;
  PackedGlyph glyph;
};

// Memory of 2-byte units, so that it is aligned.
class Memory {
 public:
  explicit Memory(size_t bytes) : units_(bytes / 2), bytes_(bytes) {}
  Workspace workspace() {
    return {reinterpret_cast<uint8_t*>(units_.data()), bytes_};
  }

 private:
  std::vector<uint16_t> units_;
  size_t bytes_;
};

// Expands whole and row by row, in memory that just suffices and in a little
// less, and compares with `direct` at every `step`-th point.
void expect_expands(const FieldTree& tree, const GlyphField& direct, int step) {
  const Packed packed(tree);
  const auto rows = static_cast<uint32_t>(tree.grid.tiles_y);
  const size_t size = expanded_bytes(tree, 0, tree.grid.tiles_y);
  Memory memory(size);
  GlyphField whole;
  ASSERT_EQ(expand(packed.glyph, 0, rows, memory.workspace(), whole),
            Status::ok);
  EXPECT_EQ(2 * size_t{whole.heap_units}, size);
  EXPECT_TRUE(same_pictures(whole, direct, step));
  Memory small(size - 1);
  GlyphField none;
  EXPECT_EQ(expand(packed.glyph, 0, rows, small.workspace(), none),
            Status::buffer_small);
  EXPECT_EQ(none.tiles_x, 0);
  for (uint32_t row = 0; row < rows; ++row) {
    const size_t row_size = expanded_bytes(tree, static_cast<int>(row), 1);
    EXPECT_LE(row_size, size);
    Memory row_memory(row_size);
    GlyphField part;
    ASSERT_EQ(expand(packed.glyph, row, 1, row_memory.workspace(), part),
              Status::ok);
    EXPECT_EQ(2 * size_t{part.heap_units}, row_size);
    EXPECT_EQ(part.y0_u, direct.y0_u + 256 * static_cast<int>(row));
    EXPECT_EQ(part.y1_u(), part.y0_u + 256);
    for (int y = part.y0_u; y < part.y1_u(); y += step) {
      for (int x = part.x0_u; x < part.x1_u(); x += step) {
        ASSERT_EQ(distance_u(part, x, y), distance_u(direct, x, y))
            << x << ' ' << y;
      }
    }
    Memory row_small(row_size - 1);
    EXPECT_EQ(expand(packed.glyph, row, 1, row_small.workspace(), part),
              Status::buffer_small);
  }
}

TEST(FieldStream, RandomTreesExpandToTheDirectForm) {
  std::mt19937 random(8);
  int shared = 0;
  int wide = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    TreeOptions options;
    options.tiles_x = 1 + round % 4;
    options.tiles_y = 1 + round / 4 % 3;
    options.depth = 2 + round % 4;
    options.coding =
        coding_for(fields(8, round % 2 == 0 ? 64 : 24, 1 + 4 * (round % 10)));
    options.within_limits = round % 3 != 0;
    const FieldTree tree = random_tree(random, options);
    shared += tree.shared.empty() ? 0 : 1;
    wide += (packed_record(tree, nullptr)[0] & 0x80) != 0 ? 1 : 0;
    const std::vector<uint8_t> direct = direct_record(tree);
    expect_expands(tree, open_record(direct), 7);
  }
  EXPECT_GT(shared, 20);
  EXPECT_GT(wide, 3);
}

// Steps and widths of all kinds, those that no generator chooses too.
TEST(FieldStream, AnyCodingExpands) {
  std::mt19937 random(9);
  const auto below = [&](unsigned n) {
    return static_cast<uint8_t>(random() % n);
  };
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    TreeOptions options;
    options.tiles_x = 1 + round % 2;
    options.tiles_y = 1 + round / 2 % 2;
    options.coding.d0_step = static_cast<uint8_t>(1 + below(255));
    options.coding.bend_step = static_cast<uint8_t>(1 + below(255));
    options.coding.d0_base = static_cast<uint8_t>(1 + below(16));
    options.coding.d0_log2 = below(9);
    options.coding.angle_base = static_cast<uint8_t>(1 + below(16));
    options.coding.bend_k = static_cast<uint16_t>(
        below(9) | below(9) << 4 | below(9) << 8 | below(9) << 12);
    options.within_limits = false;
    const FieldTree tree = random_tree(random, options);
    const std::vector<uint8_t> direct = direct_record(tree);
    expect_expands(tree, open_record(direct), 9);
  }
}

// The fields of the device's heap are those of the tree, number by number.
TEST(FieldStream, FieldsAreTheSameBitByBit) {
  std::mt19937 random(10);
  int checked = 0;
  for (int round = 0; round < 40; ++round) {
    TreeOptions options;
    options.depth = 0;
    options.coding = coding_for(fields(8, 64, 16));
    options.within_limits = false;
    FieldTree tree = random_tree(random, options);
    if (tree.nodes[0].kind != TreeNode::Kind::leaf) {
      continue;
    }
    const Packed packed(tree);
    Memory memory(expanded_bytes(tree, 0, 1));
    GlyphField field;
    ASSERT_EQ(expand(packed.glyph, 0, 1, memory.workspace(), field),
              Status::ok);
    const uint8_t* at = memory.workspace().data + 2;  // behind the tile
    for (const FieldNumbers& numbers : tree.fields) {
      const auto next = [&] {
        const int value = static_cast<int16_t>(at[0] | at[1] << 8);
        at += 2;
        return value;
      };
      EXPECT_EQ(next(), numbers.nx_q14);
      EXPECT_EQ(next(), numbers.ny_q14);
      EXPECT_EQ(next(), numbers.c_q4);
      ++checked;
      if (is_arc(numbers)) {
        EXPECT_EQ(next(), numbers.along_q4);
        EXPECT_EQ(next(), numbers.bend);
      }
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(FieldStream, GlyphsExpandToTheDirectForm) {
  const struct {
    const char* file;
    std::vector<uint32_t> letters;
  } faces[] = {{kDejaVuSans, {'a', 'W'}},
               {kLiberationSerif, {'&', 'g'}},
               {kRoboto, {'8', '.'}}};
  for (const auto& face : faces) {
    for (const Outline& glyph : load_outlines(face.file, 0, face.letters)) {
      const Shape shape(glyph);
      FieldEncoder encoder(shape, fields(8, 32, 16));
      const FieldTree tree = encoder.encode();
      const std::vector<uint8_t> direct = direct_record(tree);
      expect_expands(tree, open_record(direct), 3);
    }
  }
}

TEST(FieldStream, EmptyTilesTakeNextToNothing) {
  FieldTree tree;
  tree.grid = {8, -1984, -1984, 15, 15};
  tree.coding = coding_for(fields(8, 64, 16));
  for (int i = 0; i < 225; ++i) {
    TreeNode node;
    node.size_log2 = 8;
    node.x_u = static_cast<int16_t>(256 * (i % 15) - 1984);
    node.y_u = static_cast<int16_t>(256 * (i / 15) - 1984);
    node.kind = i % 4 == 0 ? TreeNode::Kind::inside : TreeNode::Kind::outside;
    tree.nodes.push_back(node);
  }
  const std::vector<uint8_t> direct = direct_record(tree);
  expect_expands(tree, open_record(direct), 64);
  const size_t bits =
      15 * static_cast<size_t>(std::max(node_bits(8, node_symbol::kInside),
                                        node_bits(8, node_symbol::kOutside)));
  EXPECT_LE(packed_record(tree, nullptr).size(),
            5 + 14 + 1 + 15 * (bits / 8 + 1));
}

// What the encoder counts is what the writer writes.
TEST(FieldStream, TakesTheBitsThatItsSymbolsCost) {
  std::mt19937 random(11);
  for (int round = 0; round < 30; ++round) {
    TreeOptions options;
    options.coding = coding_for(fields(8, 64, 16));
    FieldTree tree = random_tree(random, options);
    double bits = 0;
    for (const TreeNode& node : tree.nodes) {
      bits += node_bits(node.size_log2,
                        node.kind == TreeNode::Kind::split ? node_symbol::kSplit
                        : node.kind == TreeNode::Kind::outside
                            ? node_symbol::kOutside
                        : node.kind == TreeNode::Kind::inside
                            ? node_symbol::kInside
                            : node_symbol::kJoin + static_cast<int>(node.join));
      if (node.kind != TreeNode::Kind::leaf) {
        continue;
      }
      const bool nested = is_nested(node.join);
      int previous = -1;
      bool after_new = false;
      for (int i = 0; i < field_count(node.join); ++i) {
        const bool first = i == 0 || (nested && i == 1);
        after_new &= !first;
        previous = first ? -1 : previous;
        const FieldUse& use = node.uses[static_cast<size_t>(i)];
        if (use.is_new) {
          bits +=
              kind_bits(i, after_new,
                        kind_symbol::kNew + static_cast<int>(use.code.kind));
          bits += d0_bits(tree.coding, node.size_log2);
          bits += has_angle(use.code.kind)
                      ? angle_bits(tree.coding, node.size_log2)
                      : 2;
          bits += is_bent(use.code.kind)
                      ? bend_bits(tree.coding, use.code.bend, node.size_log2)
                      : 0;
          after_new = true;
        } else {
          bits += kind_bits(i, after_new, kind_symbol::kReuse);
          bits += rank_bits(first, use.rank - previous - 1);
          previous = use.rank;
        }
      }
    }
    double shared = 4;
    for (const FieldCode& code : tree.shared) {
      shared += 2 + d0_bits(tree.coding, 8);
      shared += has_angle(code.kind) ? angle_bits(tree.coding, 8) : 2;
      shared += is_bent(code.kind) ? bend_bits(tree.coding, code.bend, 8) : 0;
    }
    const auto bytes = [](double count) {
      return (static_cast<size_t>(count) + 7) / 8;
    };
    SymbolCounts counts;
    EXPECT_EQ(packed_record(tree, &counts).size(),
              5 + bytes(shared) + bytes(bits));
    uint64_t squares = 0;
    for (const auto& context : counts.node) {
      for (const uint64_t count : context) {
        squares += count;
      }
    }
    EXPECT_EQ(squares, tree.nodes.size());
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
