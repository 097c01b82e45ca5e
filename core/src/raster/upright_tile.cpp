// Tiles of upright maps. Their leaves are found from top to bottom; where each
// of them ends is kept in the column that it begins at:
//
//        a a b b b        row 0 finds a and b,
//        a a b b b        row 1 nothing new,
//        c d b b b        row 2 finds c and d.
#include "raster/upright_tile.hpp"

#include "raster/paint_leaf.hpp"

namespace inkcell {
namespace detail {
namespace {

// From this width and height together on it pays to ask which primitives
// matter. [samples]
constexpr int32_t kMinPruned = 8;

// How many samples lie no further on than `way_q16`, the first of them at 0;
// `most` at the most. [u]
inline int32_t samples_upto(uint32_t way_q16,
                            uint32_t step_q16,
                            [[maybe_unused]] uint32_t size_q6,
                            int32_t most) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No division there. A guess from a sample being 65536 u / size: right, or up
  // to two too low.
  auto count = static_cast<int32_t>(((way_q16 >> 13) * size_q6) >> 19) + 1;
  uint32_t at_q16 = static_cast<uint32_t>(count) * step_q16;
  for (; at_q16 <= way_q16; at_q16 += step_q16) {
    ++count;
  }
#else
  const auto count = static_cast<int32_t>(way_q16 / step_q16) + 1;
#endif
  return min(count, most);
}

GlyphPoint point_at(const CellMap& map,
                    GlyphPoint first,
                    uint32_t x,
                    uint32_t y) noexcept {
  first.advance(map.right, x);
  first.advance(map.up, 0u - y);
  return first;
}

}  // namespace

// Half of the leaves of small text have one sample. Without loops, and what
// leads to other samples, one function serves all of them.
__attribute__((noinline)) uint8_t CellBand::byte_of(
    TileLeaf& leaf) const noexcept {
  const int32_t sign = leaf.sign;
  const auto value = [&](uint32_t i) __attribute__((always_inline)) {
    return ArcValue(leaf.parts[i], scale_, 0).at(leaf.place, bend_shift(), 0);
  };
  const auto place = [&leaf]() __attribute__((always_inline)) {
    return leaf.place;
  };
  // A single one has no sign.
  int32_t distance = value(0);
  if (leaf.count != 1) {
    const int32_t first = with_sign(distance, sign);
    const int32_t second = with_sign(value(1), sign);
    distance = with_sign(leaf.count == 2
                             ? min_of_two(leaf, first, second, place)
                             : min_of_three(leaf, first, second,
                                            with_sign(value(2), sign), place),
                         sign);
  }
  return ramp_.byte_of(distance);
}

__attribute__((noinline)) void CellBand::paint_points(
    TileLeaf& leaf, const GlyphPoint& at) const noexcept {
  Cursor cursor(map_, at);
  const TileSpan* span = leaf.spans;
  uint8_t* out = leaf.line;
  for (int32_t rows = leaf.height;;) {
    const int32_t count =
        span == nullptr ? leaf.width : span->end - span->begin;
    for (uint8_t* const end = out + count; out != end; ++out) {
      leaf.place = cursor.place();
      *out = byte_of(leaf);
      cursor.advance(1);
    }
    if (--rows == 0) {
      return;
    }
    int32_t back = -count;
    if (span != nullptr) {
      back = span[1].begin - span->end;
      ++span;
    }
    cursor.next_row(leaf, back);
    out += kTileColumns + back;
  }
}

__attribute__((noinline)) void CellBand::prune_box(
    TileLeaf& leaf) const noexcept {
  if (!leaf.has_primitives()) {
    leaf.disable_skip();
    return;
  }
  const uint32_t width_q8 = (leaf.width - 1u) << 8;
  const uint32_t depth_q8 = (leaf.height - 1u) << 8;
  Extent all;
  all.half_x_q8 = (width_q8 + 1) >> 1;
  all.half_y_q8 = (depth_q8 + 1) >> 1;
  all.middle = {leaf.place.x_q8 + (width_q8 >> 1),
                leaf.place.y_q8 - (depth_q8 >> 1)};
  all.right = nullptr;
  prune(leaf, all);
}

inline void CellBand::paint_box(TileLeaf& leaf) const noexcept {
  const GlyphPoint none = {};
  if (leaf.count == 0) {
    uint8_t* line = leaf.line;
    for (int32_t rows = leaf.height; rows != 0; --rows, line += kTileColumns) {
      fill_inside(line, leaf.width);
    }
  } else if (!kHasPrimitives || !kFastCells) {
    return;
  } else if (leaf.count == 1) {
    if (leaf.has_lines(1)) {
      paint<RowValues<LineValue, LineRow, 1>>(leaf, none);
    } else {
      paint<RowValues<ArcValue, ArcRow, 1>>(leaf, none);
    }
  } else if (leaf.count == 2) {
    if (leaf.has_lines(2)) {
      paint<RowValues<LineValue, LineRow, 2>>(leaf, none);
    } else {
      paint<RowValues<ArcValue, ArcRow, 2>>(leaf, none);
    }
  } else if (leaf.has_lines(3)) {
    paint<RowValues<LineValue, LineRow, 3>>(leaf, none);
  } else {
    paint<RowValues<ArcValue, ArcRow, 3>>(leaf, none);
  }
}

// leaf.place: of the first sample, in the cell. [u, Q16]
__attribute__((noinline)) void CellBand::paint_samples(
    TileLeaf& leaf) const noexcept {
  if (leaf.width + leaf.height == 2) {
    *leaf.line = ramp_.byte_of(
        samples_px_q22(map_.style, leaf, leaf.place.x_q8, leaf.place.y_q8));
    return;
  }
  paint<SampleRows>(leaf, {});
}

// `kOfSamples`: leaves have no primitives.
template <bool kHasStripes, bool kOfSamples>
__attribute__((always_inline)) inline bool CellBand::cover_rows(
    const CellBand& band,
    const GlyphPoint& first,
    int32_t width,
    int32_t height,
    uint8_t* lines) noexcept {
  const CellMap& map = band.map_;
  constexpr int32_t kBytes = kHasStripes ? 3 : 1;
  const auto step = static_cast<uint32_t>(map.right.x_q16);
  // drawn[x] = last_row << 5 | width - 1 of the leaf whose first column is x;
  // 0: none.
  uint32_t words[kTileColumns / 4];
  static_assert(kTileRows <= 8 && kTileColumns <= 32, "3 and 5 bits");
  auto* const drawn = reinterpret_cast<uint8_t*>(words);
  Tile::clear_row(words);
  const uint8_t* shown = nullptr;  // the last leaf
  const uint32_t left_q8 = q8_of(first.x_q20);
  const uint32_t top_q8 = q8_of(first.y_q20);
  int32_t y = 0;
  while (true) {
    const auto down_y = static_cast<uint32_t>(y);
    const uint32_t y_q16 = first.y_q16 - down_y * step;
    const uint32_t y_q8 = top_q8 - (down_y << 8);
    int32_t next = height;
    int32_t x = 0;
    do {
      const uint32_t last = drawn[x];
      const auto last_y = static_cast<int32_t>(last >> 5);
      if (y != 0 && last_y >= y) {
        x += static_cast<int32_t>(last & 31) + 1;
        next = min(next, last_y + 1);
        continue;
      }
      TileLeaf leaf;
      const auto right_x = static_cast<uint32_t>(x);
      const uint32_t x_q16 = first.x_q16 + right_x * step;
      if (kHasStripes && !is_in_grid(map.field, {x_q16, y_q16, 0, 0})) {
        shown = lines + kBytes * x;
        band.paint_beyond(point_at(map, first, right_x, down_y),
                          lines + kBytes * x);
        next = y + 1;
        ++x;
        continue;
      }
      find_leaf(map.field, x_q16 >> 16, y_q16 >> 16, leaf);
      const uint32_t mask = (uint32_t{1 << 16} << leaf.size_log2) - 1;
      int32_t right = 1;
      int32_t down = 1;
      if (__builtin_expect(mask >= step, 1)) {
        right = samples_upto(~x_q16 & mask, step, map.size_q6(), width - x);
        down = samples_upto(y_q16 & mask, step, map.size_q6(), height - y);
        drawn[x] = static_cast<uint8_t>((y + down) * 32 + right - 33);
        next = min(next, y + down);
      } else {
        next = y + 1;
      }
      if (__builtin_expect(leaf.count != 0 || leaf.is_inside, 1)) {
        uint8_t* const line = lines + kBytes * x;
        leaf.place = {left_q8 + (right_x << 8), y_q8};
        if (!kHasStripes && !kOfSamples && leaf.count != 0 &&
            right + down == 2) {
          shown = line;
          *line = band.byte_of(leaf);
        } else {
          leaf.line = line;
          leaf.width = static_cast<uint8_t>(right);
          leaf.height = static_cast<uint8_t>(down);
          if (kHasPrimitives && kFastCells && leaf.count != 0 &&
              right + down >= kMinPruned) {
            band.prune_box(leaf);
          } else {
            leaf.disable_skip();
          }
          if (leaf.count != 0 || leaf.is_inside) {
            shown = line;
            if (kHasStripes) {
              leaf.spans = nullptr;
              band.stripes_->paint(band, leaf,
                                   point_at(map, first, right_x, down_y));
            } else if (kOfSamples && leaf.count != 0) {
              leaf.place = {x_q16 & mask, y_q16 & mask};
              band.paint_samples(leaf);
            } else if (kFastCells || leaf.count == 0) {
              band.paint_box(leaf);
            } else {
              leaf.spans = nullptr;
              band.paint_points(leaf, point_at(map, first, right_x, down_y));
            }
          }
        }
      }
      x += right;
    } while (x < width);
    if (next == height) {
      return shown != nullptr;
    }
    lines += kBytes * (next - y) * kTileColumns;
    y = next;
  }
}

bool CellBand::cover_pixels(const CellBand& band,
                            const GlyphPoint& first,
                            int32_t width,
                            int32_t height,
                            uint8_t* lines) noexcept {
  if (has_fields(band.map_.field)) {
    return cover_rows<false, false>(band, first, width, height, lines);
  }
  return cover_rows<false, true>(band, first, width, height, lines);
}

bool CellBand::cover_stripes(const CellBand& band,
                             const GlyphPoint& first,
                             int32_t width,
                             int32_t height,
                             uint8_t* lines) noexcept {
  return cover_rows<true, false>(band, first, width, height, lines);
}

const CellRaster kUprightCells = {clip_upright, nullptr, CellBand::cover_pixels,
                                  nullptr};
}  // namespace detail
}  // namespace inkcell
