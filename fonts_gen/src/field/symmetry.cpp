#include "field/symmetry.hpp"

#include <algorithm>

namespace inkcell::gen {
namespace {

namespace refs = format::glyph;

struct Place {
  int x;
  int y;
};

Place map(const Symmetry& s, Place p) {
  return {s.xx * p.x + s.xy * p.y, s.yx * p.x + s.yy * p.y};
}

Symmetry inverse(const Symmetry& s) {
  return {s.xx, s.yx, s.xy, s.yy};
}

class Permutation {
 public:
  Permutation(const SampleTree& from, const Symmetry& symmetry)
      : from_(from), back_(inverse(symmetry)), to_(from) {
    const bool swaps = symmetry.xx == 0;
    to_.tiles_x = swaps ? from.tiles_y : from.tiles_x;
    to_.tiles_y = swaps ? from.tiles_x : from.tiles_y;
    to_.references.assign(static_cast<size_t>(tiles()), refs::kOutside);
    to_.cells.clear();
  }

  SampleTree run() {
    for (int tile = 0; tile < tiles(); ++tile) {
      const uint16_t reference = write(from_.references[source_of_tile(tile)]);
      to_.references[static_cast<size_t>(tile)] = reference;
    }
    return std::move(to_);
  }

 private:
  int tiles() const { return to_.tiles_x * to_.tiles_y; }

  // Positions are about the middle of the grid, in half tiles.
  size_t source_of_tile(int tile) const {
    const Place p = map(back_, {2 * (tile % to_.tiles_x) + 1 - to_.tiles_x,
                                2 * (tile / to_.tiles_x) + 1 - to_.tiles_y});
    return static_cast<size_t>((p.y + from_.tiles_y - 1) / 2 * from_.tiles_x +
                               (p.x + from_.tiles_x - 1) / 2);
  }

  size_t source_of_child(size_t child) const {
    const Place p = map(back_, {(child & 1) != 0 ? 1 : -1,  //
                                (child & 2) != 0 ? 1 : -1});
    return (p.y > 0 ? 2u : 0u) + (p.x > 0 ? 1u : 0u);
  }

  // The byte of a cell for sample k of nine, counted row by row from below. The
  // centre, k = 4, has bytes of its own.
  static size_t byte_of(int k) {
    return format::samples::kOffsets + static_cast<size_t>(k < 4 ? k : k - 1);
  }

  SampleCell cell(const SampleCell& from) const {
    SampleCell to = from;
    for (int k = 0; k < 9; ++k) {
      if (k != 4) {
        const Place p = map(back_, {k % 3 - 1, k / 3 - 1});
        to[byte_of(k)] = from[byte_of((p.y + 1) * 3 + p.x + 1)];
      }
    }
    return to;
  }

  // Appends the tree of a reference of `from_`; returns the new reference. In
  // the order of Forest::write, so that the identity changes no byte.
  uint16_t write(uint16_t reference) {
    if ((reference & refs::kCellFlag) != 0) {
      to_.cells.push_back(cell(from_.cells[reference ^ refs::kCellFlag]));
      return static_cast<uint16_t>(refs::kCellFlag | (to_.cells.size() - 1));
    }
    if (reference < refs::kFirstNode) {
      return reference;
    }
    const size_t from = static_cast<size_t>(tiles()) +
                        4 * static_cast<size_t>(reference - refs::kFirstNode);
    const size_t first = to_.references.size();
    const int node = to_.node_count();
    to_.references.resize(first + 4);
    for (size_t child = 0; child < 4; ++child) {
      const uint16_t written =
          write(from_.references[from + source_of_child(child)]);
      to_.references[first + child] = written;
    }
    return static_cast<uint16_t>(refs::kFirstNode + node);
  }

  const SampleTree& from_;
  Symmetry back_;
  SampleTree to_;
};

}  // namespace

SampleTree permuted(const SampleTree& tree,
                    const Symmetry& symmetry,
                    int dx_u,
                    int dy_u) {
  const Place a = map(symmetry, {tree.x0_u, tree.y0_u});
  const Place b = map(symmetry, {tree.x0_u + (tree.tiles_x << tree.tile_log2),
                                 tree.y0_u + (tree.tiles_y << tree.tile_log2)});
  SampleTree result = Permutation(tree, symmetry).run();
  result.x0_u = std::min(a.x, b.x) + dx_u;
  result.y0_u = std::min(a.y, b.y) + dy_u;
  const int x1_u = std::max(a.x, b.x) + dx_u;
  const int y1_u = std::max(a.y, b.y) + dy_u;
  if (std::min(result.x0_u, result.y0_u) < -refs::kGridLimit ||
      std::max(x1_u, y1_u) > refs::kGridLimit) {
    throw GeometryError(GeometryError::Kind::too_large,
                        "the glyph reaches beyond 15 em from its origin");
  }
  return result;
}

}  // namespace inkcell::gen
