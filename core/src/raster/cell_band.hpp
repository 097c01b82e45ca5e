// Tiles of samples of cells: a few rows of a strip at a time, in which each
// leaf is found and set up once.
#pragma once

#include <stdint.h>

#include "distance/csg.hpp"
#include "distance/stretching.hpp"
#include "place/cell_map.hpp"
#include "place/cell_raster.hpp"
#include "raster/coverage_ramp.hpp"

namespace inkcell {
namespace detail {

// 0: the samples of all leaves of primitives have one loop, each evaluated for
// itself, and none is skipped (docs/PORTING.md).
#ifndef INKCELL_FAST_CELLS
#  define INKCELL_FAST_CELLS 1
#endif
inline constexpr bool kFastCells = INKCELL_FAST_CELLS != 0;

// The most rows and columns of a tile: what the stack can bear.
inline constexpr int32_t kTileRows = kFastCells ? 8 : 4;
inline constexpr int32_t kTileColumns = 24;

// A byte a sample, row by row.
struct Tile {
  uint32_t words[kTileRows * kTileColumns / 4];

  uint8_t* row(int32_t y) noexcept {
    return reinterpret_cast<uint8_t*>(words) + y * kTileColumns;
  }
  void clear(int32_t rows) noexcept {
    for (int32_t y = 0; y < rows; ++y) {
      clear_row(words + y * (kTileColumns / 4));
    }
  }
  static void clear_row(uint32_t* word) noexcept {
    static_assert(kTileColumns == 4 * 6, "words");
    word[0] = word[1] = word[2] = word[3] = word[4] = word[5] = 0;
  }
};

// Samples of a row: begin <= x < end.
struct TileSpan {
  uint8_t begin;
  uint8_t end;
};

// A leaf's samples in a tile.
struct TileLeaf : PlacedLeaf {
  uint8_t width;   // of upright maps
  uint8_t height;  // how many rows
  // How many samples it takes, or fewer, for a distance to gain 1/64 px. [Q15]
  uint16_t skip_q15;
  // All bits, if what follows a sample that is saturated on that side is so,
  // too.
  uint16_t all_outside;
  uint16_t all_inside;
  uint8_t* line;          // where the first sample is drawn
  const TileSpan* spans;  // of its rows, if they are not alike

  // Samples tell nothing of others.
  void disable_skip() noexcept { skip_q15 = all_outside = all_inside = 0; }
};

class CellBand;

// Pixels of three stripes, a byte each.
struct Stripes {
  GlyphPoint next;  // from a stripe to the next one, to the right or below
  // Draws the samples of a leaf, a box if it has no spans; `at` is the first
  // one's middle.
  void (*paint)(const CellBand& band,
                TileLeaf& leaf,
                const GlyphPoint& at) noexcept;
  CoverTile cover_upright;  // of upright maps
};

// What fills tiles: a ramp makes a byte of each distance.
class CellBand : public Csg {
 public:
  CellBand(const CellRaster& raster,
           const CellMap& map,
           const CoverageRamp& ramp,
           const Stripes* stripes = nullptr) noexcept;

  // Fills a tile that is clear, given where its first sample lies. False: it is
  // 0 everywhere. Upright maps: all samples lie in the grid.
  static bool cover_pixels(const CellBand& band,
                           const GlyphPoint& first,
                           int32_t width,
                           int32_t height,
                           uint8_t* lines) noexcept;
  static bool cover_stripes(const CellBand& band,
                            const GlyphPoint& first,
                            int32_t width,
                            int32_t height,
                            uint8_t* lines) noexcept;
  static bool cover_slanted(const CellBand& band,
                            const GlyphPoint& first,
                            int32_t width,
                            int32_t height,
                            uint8_t* lines) noexcept;
  // Draws the stripes in the grid of a pixel whose middle lies beyond it.
  __attribute__((noinline)) void paint_beyond(const GlyphPoint& middle,
                                              uint8_t* line) const noexcept;

  const CellMap& map() const noexcept { return map_; }
  // Null: a pixel is a byte.
  const Stripes* stripes() const noexcept { return stripes_; }

  static void fill_inside(uint8_t* at, int32_t count) noexcept {
    uint8_t* const end = at + count;
    while (end - at >= 4) {
      if ((reinterpret_cast<uintptr_t>(at) & 3) == 0) {
        *reinterpret_cast<uint32_t*>(at) = UINT32_MAX;
        at += 4;
      } else {
        *at++ = 255;
      }
    }
    while (at != end) {
      *at++ = 255;
    }
  }

 private:
  template <bool kHasStripes, bool kOfSamples>
  static bool cover_rows(const CellBand& band,
                         const GlyphPoint& first,
                         int32_t width,
                         int32_t height,
                         uint8_t* lines) noexcept;

  // What a primitive shows of a leaf's samples: nothing, all, or what distances
  // say.
  enum class Side : uint8_t { outside, edge, inside };

  // How a primitive changes from sample to sample, with the leaf's sign. [Q14]
  struct Slopes {
    int32_t least;
    int32_t greatest;
  };

  // The box that holds a leaf's samples.
  struct Extent {
    PixelPlace middle;
    uint32_t half_x_q8;  // from there to the outer ones
    uint32_t half_y_q8;
    // Leads to the next sample, below 2 px along each axis; null: a px right.
    const GlyphStep* right;
  };

  // Distances that are farther than these tell of others. Nearer ones may be
  // rounded, which leads back to the ramp if it lies beside the edge. [px]
  void set_far(int32_t outside_q22, int32_t inside_q22) noexcept {
    // More than what the roundings of two values of an arc make. [px]
    constexpr int32_t kMarginQ22 = 1 << 18;
    far_outside_q22_ = outside_q22 - kMarginQ22;
    far_inside_q22_ = inside_q22 + kMarginQ22;
  }

  // Leaves out the primitives that are saturated in all of a leaf's samples,
  // and says how those that are left change.
  void prune(TileLeaf& leaf, const Extent& all) const noexcept;
  template <bool kIsArc>
  Side side_as(PrimitiveRef primitive,
               const Extent& all,
               int32_t sign,
               Slopes& slopes) const noexcept;
  Side side_of(PrimitiveRef primitive,
               const Extent& all,
               int32_t sign,
               Slopes& slopes) const noexcept;
  Side keep_minimum(TileLeaf& leaf,
                    const Extent& all,
                    Slopes& slopes) const noexcept;
  Side keep_nested(TileLeaf& leaf,
                   const Extent& all,
                   Slopes& slopes) const noexcept;

  void prune_box(TileLeaf& leaf) const noexcept;
  void prune_spans(TileLeaf& leaf, const GlyphPoint& at) const noexcept;

  // Draws a leaf whose samples form a box, or spans of rows.
  void paint_box(TileLeaf& leaf) const noexcept;
  void paint_samples(TileLeaf& leaf) const noexcept;
  // The same of any leaf of primitives; a box if it has no spans.
  void paint_points(TileLeaf& leaf, const GlyphPoint& at) const noexcept;
  void paint_spans(TileLeaf& leaf, const GlyphPoint& at) const noexcept;
  template <typename Values>
  void paint(TileLeaf& leaf, const GlyphPoint& at) const noexcept;
  template <typename Values>
  const uint8_t* paint_row(Values& values,
                           TileLeaf& leaf,
                           uint8_t* line,
                           const uint8_t* end) const noexcept;
  // The byte of a leaf's only sample, at leaf.place.
  uint8_t byte_of(TileLeaf& leaf) const noexcept;

  const CellMap& map_;
  const Stripes* stripes_;
  CoverageRamp ramp_;
  int32_t far_outside_q22_;
  int32_t far_inside_q22_;
  int32_t prune_reach_q22_;
  bool may_prune_;
};

}  // namespace detail
}  // namespace inkcell
