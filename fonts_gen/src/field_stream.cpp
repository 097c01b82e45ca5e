#include "field_stream.hpp"

#include <algorithm>
#include <cstdlib>

#include "bit_costs.hpp"
#include "field_code.hpp"
#include "field_model.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace gen {
namespace {

// Bits, the first in the highest place of a byte.
class BitWriter {
 public:
  void put(uint32_t value, int bits) {
    for (int i = bits - 1; i >= 0; --i) {
      if (used_ == 0) {
        bytes_.push_back(0);
      }
      bytes_.back() = static_cast<uint8_t>(bytes_.back() |
                                           ((value >> i & 1) << (7 - used_)));
      used_ = (used_ + 1) % 8;
    }
  }

  std::vector<uint8_t> take() {
    used_ = 0;
    return std::move(bytes_);
  }

 private:
  std::vector<uint8_t> bytes_;
  int used_ = 0;
};

// The code of `symbol` among canonical ones: ascending by length, then symbol.
uint32_t canonical_code(const uint8_t* lengths, int count, int symbol) {
  uint32_t code = 0;
  const int length = lengths[symbol];
  for (int i = 0; i < count; ++i) {
    if (lengths[i] != 0 &&
        (lengths[i] < length || (lengths[i] == length && i < symbol))) {
      code += 1u << (length - lengths[i]);
    }
  }
  return code;
}

class Stream {
 public:
  Stream(const FieldTree& tree, SymbolCounts* counts)
      : tree_(tree), coding_(tree.coding), counts_(counts) {}

  std::vector<uint8_t> shared(int log2) {
    bits_.put(static_cast<uint32_t>(tree_.shared.size()), 4);
    for (const FieldCode& code : tree_.shared) {
      bits_.put(static_cast<uint32_t>(code.kind), 2);
      field(code, log2);
    }
    return bits_.take();
  }

  // The nodes from `next` on that lie in the row of tiles `row`.
  std::vector<uint8_t> row(int row, size_t& next) {
    for (; next < tree_.nodes.size(); ++next) {
      const TreeNode& node = tree_.nodes[next];
      if ((node.y_u - tree_.grid.y0_u) >> tree_.grid.tile_log2 != row) {
        break;
      }
      square(node);
    }
    return bits_.take();
  }

 private:
  template <size_t kContexts, size_t kSymbols>
  void symbol(const uint8_t (&lengths)[kContexts][kSymbols],
              int context,
              int symbol,
              uint64_t (SymbolCounts::*count)[kContexts][kSymbols]) {
    const uint8_t* row = lengths[context];
    bits_.put(canonical_code(row, static_cast<int>(kSymbols), symbol),
              row[symbol]);
    if (counts_ != nullptr) {
      ++(counts_->*count)[context][symbol];
    }
  }

  void square(const TreeNode& node) {
    int kind = node_symbol::kSplit;
    switch (node.kind) {
      case TreeNode::Kind::split:
        break;
      case TreeNode::Kind::outside:
        kind = node_symbol::kOutside;
        break;
      case TreeNode::Kind::inside:
        kind = node_symbol::kInside;
        break;
      case TreeNode::Kind::leaf:
        kind = node_symbol::kJoin + static_cast<int>(node.join);
        break;
    }
    symbol(packed_codes::kNodeLengths, node_context(node.size_log2), kind,
           &SymbolCounts::node);
    if (node.kind == TreeNode::Kind::leaf) {
      leaf(node);
    }
  }

  void leaf(const TreeNode& node) {
    const bool nested = is_nested(node.join);
    int previous = -1;
    bool after_new = false;
    for (int i = 0; i < field_count(node.join); ++i) {
      const bool first = i == 0 || (nested && i == 1);
      if (first) {
        previous = -1;
        after_new = false;
      }
      const FieldUse& use = node.uses[static_cast<size_t>(i)];
      const int context = kind_context(i, after_new);
      if (use.is_new) {
        symbol(packed_codes::kKindLengths, context,
               kind_symbol::kNew + static_cast<int>(use.code.kind),
               &SymbolCounts::kind);
        field(use.code, node.size_log2);
      } else {
        symbol(packed_codes::kKindLengths, context, kind_symbol::kReuse,
               &SymbolCounts::kind);
        symbol(packed_codes::kRankLengths, rank_context(first),
               use.rank - previous - 1, &SymbolCounts::rank);
        previous = use.rank;
      }
      after_new = use.is_new;
    }
  }

  void field(const FieldCode& code, int log2) {
    const int width = d0_bits(coding_, log2);
    bits_.put(static_cast<uint32_t>(code.d0 + (1 << (width - 1))), width);
    bits_.put(code.angle, has_angle(code.kind) ? angle_bits(coding_, log2) : 2);
    if (!is_bent(code.kind)) {
      return;
    }
    const auto size = static_cast<uint32_t>(std::abs(code.bend) - 1);
    const uint32_t k = coding_.bend_bits(static_cast<uint32_t>(log2));
    for (uint32_t i = 0; i < size >> k; ++i) {
      bits_.put(1, 1);
    }
    bits_.put(0, 1);
    bits_.put(size & ((1u << k) - 1), static_cast<int>(k));
    bits_.put(code.bend < 0 ? 1u : 0u, 1);
  }

  const FieldTree& tree_;
  const PackedCoding& coding_;
  SymbolCounts* counts_;
  BitWriter bits_;
};

}  // namespace

std::vector<uint8_t> packed_record(const FieldTree& tree,
                                   SymbolCounts* counts) {
  const Grid& grid = tree.grid;
  Stream stream(tree, counts);
  const std::vector<uint8_t> shared = stream.shared(shared_log2(grid));
  std::vector<std::vector<uint8_t>> rows;
  size_t next = 0;
  bool wide = false;
  for (int row = 0; row < grid.tiles_y; ++row) {
    rows.push_back(stream.row(row, next));
    wide |= row + 1 < grid.tiles_y && rows.back().size() > 255;
  }
  std::vector<uint8_t> out;
  const auto put = [&](int value) {
    out.push_back(static_cast<uint8_t>(value));
  };
  put(3 | (wide ? 0x80 : 0));
  put(grid.tiles_x | grid.tiles_y << 4);
  const int corner = (grid.x0_u & 0xfff) | (grid.y0_u & 0xfff) << 12;
  put(corner);
  put(corner >> 8);
  put(corner >> 16);
  for (size_t row = 0; row + 1 < rows.size(); ++row) {
    put(static_cast<int>(rows[row].size()));
    if (wide) {
      put(static_cast<int>(rows[row].size() >> 8));
    }
  }
  out.insert(out.end(), shared.begin(), shared.end());
  for (const std::vector<uint8_t>& row : rows) {
    out.insert(out.end(), row.begin(), row.end());
  }
  return out;
}

size_t expanded_bytes(const FieldTree& tree, int first_row, int row_count) {
  namespace linked = format::linked;
  const auto field_units = [&](size_t field) {
    return is_arc(tree.fields[field]) ? linked::kArcUnits : linked::kLineUnits;
  };
  size_t units =
      static_cast<size_t>(tree.grid.tiles_x) * static_cast<size_t>(row_count);
  for (size_t field = 0; field < tree.shared.size(); ++field) {
    units += field_units(field);
  }
  for (const TreeNode& node : tree.nodes) {
    const int row = (node.y_u - tree.grid.y0_u) >> tree.grid.tile_log2;
    if (row < first_row || row >= first_row + row_count) {
      continue;
    }
    units += node.kind == TreeNode::Kind::split ? linked::kNodeUnits : 0;
    if (node.kind != TreeNode::Kind::leaf) {
      continue;
    }
    const auto count = static_cast<size_t>(field_count(node.join));
    for (size_t i = 0; i < count; ++i) {
      units += node.uses[i].is_new ? field_units(node.uses[i].field) : 0;
    }
    units += count == 2 ? linked::kPairUnits : 0;
    units += count == 3 ? linked::kTripleUnits : 0;
  }
  return 2 * units;
}

}  // namespace gen
}  // namespace inkcell
