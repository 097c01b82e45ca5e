// The leaves of an upright glyph that hold pixels, in object order: tile by
// tile, each once.
//
// A node's pixels are divided where its middle lies, so that a leaf is found
// with its pixels, and a node without any is not entered: work is bounded by
// pixels, whatever the bytes say.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/strip.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// A square of the grid, from its corner, and the pixels whose centres it holds,
// from those of the tour.
struct TourLeaf {
  uint32_t reference;
  int32_t x_u;
  int32_t y_u;
  uint32_t log2;
  Rect pixels;
};

// `Leaves` has tile(number) and child(node, number), references; is_node(
// reference); and draw(TourLeaf), which is called for all but kOutside.
template <typename Leaves>
class CellTour {
 public:
  CellTour(const GlyphField& field,
           const TextStyle& style,
           const Upright& upright,
           Leaves& leaves) noexcept
      : leaves_(leaves),
        size_q6_(static_cast<uint32_t>(style.size().raw)),
        step_q16_(style.step_along_q16()),
        columns_(upright.pixels.x1 - upright.pixels.x0),
        rows_(upright.pixels.y1 - upright.pixels.y0),
        left_q16_(upright.at.x_q16 - field.x0_u * (1 << 16)),
        top_q16_(upright.at.y_q16 - field.y0_u * (1 << 16)),
        tiles_x_(field.tiles_x),
        tile_log2_(field.tile_log2) {}

  __attribute__((noinline)) void run() noexcept {
    const int32_t size_u = int32_t{1} << tile_log2_;
    for (int32_t top = 0, bottom = 0; top < rows_; top = bottom) {
      const int32_t y_u = (height_at(top) >> 16) & -size_u;
      bottom = row_below(y_u, top, rows_);
      for (int32_t left = 0, right = 0; left < columns_; left = right) {
        const int32_t x_u = (place_at(left) >> 16) & -size_u;
        right = column_from(x_u + size_u, left, columns_);
        const uint32_t tile =
            (static_cast<uint32_t>(y_u) >> tile_log2_) * tiles_x_ +
            (static_cast<uint32_t>(x_u) >> tile_log2_);
        TourLeaf at = {leaves_.tile(tile),
                       x_u,
                       y_u,
                       tile_log2_,
                       {left, top, right, bottom}};
        visit(at);
      }
    }
  }

 private:
  // A node on the way to a leaf. A window has at most 65535 columns or rows.
  struct Fork {
    uint16_t node;
    uint16_t next;  // child
    uint16_t left;
    uint16_t centre;
    uint16_t right;
    uint16_t top;
    uint16_t middle;
    uint16_t bottom;
  };

  // Where the centre of a pixel lies in the grid.
  int32_t place_at(int32_t column) const noexcept {
    return left_q16_ + column * step_q16_;
  }
  int32_t height_at(int32_t row) const noexcept {
    return top_q16_ - row * step_q16_;
  }

  // How many pixels lie before a place that is `way_q16` behind the first of
  // them, at most 2048 u; `most` at the most.
  int32_t pixels_before(int32_t way_q16, int32_t most) const noexcept {
    if (way_q16 <= 0) {
      return 0;
    }
    // A guess from a px being 65536 u / size: right, or up to two too low.
    auto count = static_cast<int32_t>(
        ((static_cast<uint32_t>(way_q16) >> 13) * size_q6_) >> 19);
    if (count >= most) {
      return most;
    }
    int32_t left = way_q16 - count * step_q16_;
    if (left > 0) {
      ++count;
      left -= step_q16_;
    }
    if (left > 0) {
      ++count;
    }
    return min(count, most);
  }

  // The first column, from `first` on, whose centre is not before `x_u`; `end`
  // at the most.
  int32_t column_from(int32_t x_u, int32_t first, int32_t end) const noexcept {
    return first +
           pixels_before(x_u * (1 << 16) - place_at(first), end - first);
  }
  // The first row whose centre is below `y_u`.
  int32_t row_below(int32_t y_u, int32_t first, int32_t end) const noexcept {
    return first +
           pixels_before(height_at(first) - y_u * (1 << 16) + 1, end - first);
  }

  // Divides the pixels of a node. Squares of 1 u have no nodes.
  __attribute__((noinline)) void enter(Fork& fork,
                                       const TourLeaf& square) const noexcept {
    const Rect& all = square.pixels;
    const int32_t half_u = int32_t{1} << (square.log2 - 1);
    fork.node = static_cast<uint16_t>(square.reference);
    fork.next = 0;
    fork.left = static_cast<uint16_t>(all.x0);
    fork.centre =
        static_cast<uint16_t>(column_from(square.x_u + half_u, all.x0, all.x1));
    fork.right = static_cast<uint16_t>(all.x1);
    fork.top = static_cast<uint16_t>(all.y0);
    fork.middle =
        static_cast<uint16_t>(row_below(square.y_u + half_u, all.y0, all.y1));
    fork.bottom = static_cast<uint16_t>(all.y1);
  }

  // Goes through all of a tile.
  __attribute__((noinline)) void visit(TourLeaf& at) noexcept {
    if (!leaves_.is_node(at.reference)) {
      if (at.reference != format::glyph::kOutside) {
        leaves_.draw(at);
      }
      return;
    }
    if (at.log2 == 0) {
      return;
    }
    Fork forks[format::glyph::kMaxTileLog2];
    Fork* fork = forks;
    enter(*fork, at);
    --at.log2;
    while (true) {
      if (fork->next == 4) {
        if (fork == forks) {
          return;
        }
        --fork;
        ++at.log2;
        continue;
      }
      const uint32_t number = fork->next++;
      const bool is_right = (number & 1) != 0;
      const bool is_upper = (number & 2) != 0;
      at.pixels = {is_right ? fork->centre : fork->left,
                   is_upper ? fork->top : fork->middle,
                   is_right ? fork->right : fork->centre,
                   is_upper ? fork->middle : fork->bottom};
      if (is_empty(at.pixels)) {
        continue;
      }
      at.reference = leaves_.child(fork->node, number);
      if (at.reference == format::glyph::kOutside) {
        continue;
      }
      const int32_t size_u = int32_t{1} << at.log2;
      at.x_u = (at.x_u & (-2 * size_u)) + (is_right ? size_u : 0);
      at.y_u = (at.y_u & (-2 * size_u)) + (is_upper ? size_u : 0);
      if (!leaves_.is_node(at.reference)) {
        leaves_.draw(at);
      } else if (at.log2 > 0) {
        ++fork;
        enter(*fork, at);
        --at.log2;
      }
    }
  }

  Leaves& leaves_;
  uint32_t size_q6_;
  int32_t step_q16_;
  int32_t columns_;
  int32_t rows_;
  int32_t left_q16_;  // the first pixel, from the grid's corner
  int32_t top_q16_;
  uint32_t tiles_x_;
  uint32_t tile_log2_;
};

}  // namespace detail
}  // namespace inkcell
