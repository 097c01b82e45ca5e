#include "edges/record.hpp"

#include <array>
#include <map>
#include <utility>

#include "base/byte_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace gen {
namespace {

constexpr uint8_t kTypeEdges = 2;
constexpr uint8_t kLinkedFlag = 0x80;
constexpr size_t kNarrowNumbers = 256;
constexpr size_t kMostUnits = 8192;  // offsets have 13 bits

void put_field(Bytes& out, const PrimitiveNumbers& field) {
  put_i16(out, field.nx_q14);
  put_i16(out, field.ny_q14);
  put_i16(out, field.c_q4);
  if (is_arc(field)) {
    put_i16(out, field.along_q4);
    put_i16(out, field.bend);
  }
}

void put_grid(Bytes& out, const Grid& grid, uint8_t flag) {
  out.push_back(kTypeEdges);
  out.push_back(static_cast<uint8_t>(grid.tile_log2 | flag));
  put_i16(out, grid.x0_u);
  put_i16(out, grid.y0_u);
  out.push_back(static_cast<uint8_t>(grid.tiles_x));
  out.push_back(static_cast<uint8_t>(grid.tiles_y));
}

// 0 min3, 1 max3, 2 min_max, 3 max_min.
int operator_of(Join join) {
  return (takes_greatest(join) ? 1 : 0) + (is_nested(join) ? 2 : 0);
}

class NarrowRecord {
 public:
  explicit NarrowRecord(const EdgeTree& tree) : tree_(tree) {
    number_fields();
    for (const TreeNode& node : tree.nodes) {
      splits_ += node.kind == TreeNode::Kind::split ? 1 : 0;
      if (node.kind == TreeNode::Kind::leaf) {
        add_leaf(node);
      }
    }
  }

  bool fits() const {
    return 2 + splits_ + fields_.size() + pairs_.size() + triples_.size() <=
           kNarrowNumbers;
  }

  Bytes write() {
    Bytes out;
    put_grid(out, tree_.grid, 0);
    put_u16(out, static_cast<unsigned>(splits_));
    put_u16(out, static_cast<unsigned>(arcs_));
    put_u16(out, static_cast<unsigned>(fields_.size() - arcs_));
    put_u16(out, static_cast<unsigned>(pairs_.size()));
    put_u16(out, static_cast<unsigned>(triples_.size()));
    for (const PrimitiveNumbers* field : fields_) {
      put_field(out, *field);
    }
    for (const auto& triple : triples_in_order_) {
      out.insert(out.end(), triple.begin(), triple.end());
    }
    for (const auto& pair : pairs_in_order_) {
      out.insert(out.end(), pair.begin(), pair.end());
    }
    put_references(out);
    return out;
  }

 private:
  // Arcs first. Equal fields share a number.
  void number_fields() {
    number_of_.resize(tree_.fields.size());
    std::vector<bool> used(tree_.fields.size());
    for (const TreeNode& node : tree_.nodes) {
      if (node.kind == TreeNode::Kind::leaf) {
        for (int i = 0; i < primitive_count(node.join); ++i) {
          used[node.uses[static_cast<size_t>(i)].field] = true;
        }
      }
    }
    for (const bool arc : {true, false}) {
      for (size_t f = 0; f < tree_.fields.size(); ++f) {
        const PrimitiveNumbers& field = tree_.fields[f];
        if (!used[f] || is_arc(field) != arc) {
          continue;
        }
        size_t number = 0;
        while (number < fields_.size() &&
               !same_primitive(*fields_[number], field)) {
          ++number;
        }
        if (number == fields_.size()) {
          fields_.push_back(&field);
          arcs_ += arc ? 1 : 0;
        }
        number_of_[f] = number;
      }
    }
  }

  uint8_t number(const TreeNode& node, size_t i) const {
    return static_cast<uint8_t>(number_of_[node.uses[i].field]);
  }

  std::array<uint8_t, 2> pair_of(const TreeNode& node) const {
    std::array<uint8_t, 2> pair = {number(node, 0), number(node, 1)};
    if ((pair[0] < pair[1]) == takes_greatest(node.join)) {
      std::swap(pair[0], pair[1]);
    }
    return pair;
  }

  std::array<uint8_t, 4> triple_of(const TreeNode& node) const {
    return {static_cast<uint8_t>(operator_of(node.join)), number(node, 0),
            number(node, 1), number(node, 2)};
  }

  void add_leaf(const TreeNode& node) {
    const int count = primitive_count(node.join);
    if (count == 2 && pairs_.emplace(pair_of(node), pairs_.size()).second) {
      pairs_in_order_.push_back(pair_of(node));
    }
    if (count == 3 &&
        triples_.emplace(triple_of(node), triples_.size()).second) {
      triples_in_order_.push_back(triple_of(node));
    }
  }

  uint8_t reference(const TreeNode& node, size_t& next_split) const {
    switch (node.kind) {
      case TreeNode::Kind::outside:
        return 0;
      case TreeNode::Kind::inside:
        return 1;
      case TreeNode::Kind::split:
        return static_cast<uint8_t>(2 + next_split++);
      case TreeNode::Kind::leaf:
        break;
    }
    size_t number = 2 + splits_;
    switch (primitive_count(node.join)) {
      case 1:
        return static_cast<uint8_t>(number + number_of_[node.uses[0].field]);
      case 2:
        return static_cast<uint8_t>(number + fields_.size() +
                                    pairs_.at(pair_of(node)));
      default:
        return static_cast<uint8_t>(number + fields_.size() + pairs_.size() +
                                    triples_.at(triple_of(node)));
    }
  }

  // Tiles, then four for each split in the order of their numbers.
  void put_references(Bytes& out) const {
    const auto tiles = static_cast<size_t>(tree_.grid.tiles_x) *
                       static_cast<size_t>(tree_.grid.tiles_y);
    Bytes references(tiles + 4 * splits_);
    // Places still to fill, the next one last.
    std::vector<size_t> places;
    size_t next_split = 0;
    size_t tile = 0;
    for (const TreeNode& node : tree_.nodes) {
      if (places.empty()) {
        places.push_back(tile++);
      }
      const size_t place = places.back();
      places.pop_back();
      const size_t split = next_split;
      references[place] = reference(node, next_split);
      if (node.kind == TreeNode::Kind::split) {
        for (size_t quarter = 4; quarter-- > 0;) {
          places.push_back(tiles + 4 * split + quarter);
        }
      }
    }
    out.insert(out.end(), references.begin(), references.end());
  }

  const EdgeTree& tree_;
  size_t splits_ = 0;
  size_t arcs_ = 0;
  std::vector<const PrimitiveNumbers*> fields_;
  std::vector<size_t> number_of_;
  std::map<std::array<uint8_t, 2>, size_t> pairs_;
  std::map<std::array<uint8_t, 4>, size_t> triples_;
  std::vector<std::array<uint8_t, 2>> pairs_in_order_;
  std::vector<std::array<uint8_t, 4>> triples_in_order_;
};

// A heap of 16-bit units; references hold a tag and an offset.
class LinkedRecord {
 public:
  explicit LinkedRecord(const EdgeTree& tree) : tree_(tree) {
    const auto tiles = static_cast<size_t>(tree.grid.tiles_x) *
                       static_cast<size_t>(tree.grid.tiles_y);
    heap_.resize(tiles);
    offsets_.assign(tree.fields.size(), 0);
    std::vector<size_t> places;
    size_t tile = 0;
    for (const TreeNode& node : tree.nodes) {
      if (places.empty()) {
        places.push_back(tile++);
      }
      const size_t place = places.back();
      places.pop_back();
      if (node.kind == TreeNode::Kind::split) {
        const size_t block = heap_.size();
        heap_.resize(block + 4);
        for (size_t quarter = 4; quarter-- > 0;) {
          places.push_back(block + quarter);
        }
        heap_[place] = reference(kNode, block);
      } else {
        const uint16_t found = leaf(node);
        heap_[place] = found;
      }
    }
  }

  bool fits() const { return heap_.size() <= kMostUnits; }

  Bytes write() const {
    Bytes out;
    put_grid(out, tree_.grid, kLinkedFlag);
    put_u16(out, static_cast<unsigned>(heap_.size()));
    for (const uint16_t unit : heap_) {
      put_u16(out, unit);
    }
    return out;
  }

 private:
  enum Tag { kNode = 1, kLine, kArc, kLeast, kGreatest, kTriple };

  static uint16_t reference(int tag, size_t offset) {
    return static_cast<uint16_t>(static_cast<size_t>(tag) << 13 |
                                 (offset & (kMostUnits - 1)));
  }

  void add(int unit) { heap_.push_back(static_cast<uint16_t>(unit)); }

  size_t field_offset(uint16_t f) {
    if (offsets_[f] == 0) {
      offsets_[f] = heap_.size();
      const PrimitiveNumbers& field = tree_.fields[f];
      add(field.nx_q14);
      add(field.ny_q14);
      add(field.c_q4);
      if (is_arc(field)) {
        add(field.along_q4);
        add(field.bend);
      }
    }
    return offsets_[f];
  }

  uint16_t leaf(const TreeNode& node) {
    if (node.kind != TreeNode::Kind::leaf) {
      return node.kind == TreeNode::Kind::inside ? 1 : 0;
    }
    const size_t count = static_cast<size_t>(primitive_count(node.join));
    std::array<uint16_t, 3> units{};
    for (size_t i = 0; i < count; ++i) {
      const uint16_t f = node.uses[i].field;
      const bool arc = is_arc(tree_.fields[f]);
      const size_t offset = field_offset(f);
      if (count == 1) {
        return reference(arc ? kArc : kLine, offset);
      }
      units[i] = static_cast<uint16_t>((arc ? 0x8000u : 0u) | offset);
    }
    const size_t at = heap_.size();
    if (count == 3) {
      add(operator_of(node.join));
    }
    for (size_t i = 0; i < count; ++i) {
      add(units[i]);
    }
    if (count == 3) {
      return reference(kTriple, at);
    }
    return reference(takes_greatest(node.join) ? kGreatest : kLeast, at);
  }

  const EdgeTree& tree_;
  std::vector<uint16_t> heap_;
  std::vector<size_t> offsets_;
};

}  // namespace

std::vector<uint8_t> edge_record(const EdgeTree& tree) {
  NarrowRecord narrow(tree);
  if (narrow.fits()) {
    return narrow.write();
  }
  const LinkedRecord linked(tree);
  if (!linked.fits()) {
    throw GeometryError(GeometryError::Kind::too_complex,
                        "the glyph has more cells than the format");
  }
  return linked.write();
}

}  // namespace gen
}  // namespace inkcell
