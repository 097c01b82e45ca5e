#include "raster/draw_cells.hpp"

#include "place/cell_raster.hpp"
#include "raster/cell_band.hpp"
#include "raster/upright_tile.hpp"

namespace inkcell {
namespace detail {
namespace {

// Whether words at any address are as fast as others, as port/pixel has it.
#if defined(__ARM_FEATURE_UNALIGNED) || defined(__x86_64__)
constexpr bool kWordsAnywhere = true;
#else
constexpr bool kWordsAnywhere = false;
#endif

// How far from the ink the filter, or a painter, shows something. [u] Painters
// may show all of the ink, also where the filter's ramp begins inside.
int32_t reach_u_q10(const TextStyle& style) noexcept {
  const int32_t reach = -style.transparent_u_q10();
  return style.effect().cells != nullptr ? max(reach, 0) : reach;
}

// Not inline: a frame for the tile.
__attribute__((noinline)) void draw_tiles(const CellRaster& raster,
                                          CellMap& map,
                                          const CellBand& band,
                                          const Sink& sink) noexcept {
  const Rect& box = map.samples;
  GlyphPoint& at = map.first;
  int32_t rows;
  for (int32_t y = box.y0; y < box.y1; y += rows) {
    rows = min(box.y1 - y, kTileRows);
    int32_t count;
    for (int32_t x = box.x0; x < box.x1; x += count) {
      Tile tile;
      // Coverage of an x that is a multiple of 4 begins a word, so that sinks
      // of 8 bits can copy words.
      const int32_t first = kWordsAnywhere ? 0 : x & 3;
      count = min(box.x1 - x, kTileColumns - first);
      uint8_t* const line = tile.row(0) + first;
      tile.clear(rows);
      if (raster.may_show(map, x, y, at) &&
          raster.cover(band, at, count, rows, line)) {
        for (int32_t row = 0; row < rows; ++row) {
          sink.coverage(sink.context, x, y + row, line + row * kTileColumns,
                        count);
        }
      }
      at.advance(map.right, static_cast<uint32_t>(count));
    }
    at.advance(map.right, static_cast<uint32_t>(box.x0 - box.x1));
    at.advance(map.up, 0u - static_cast<uint32_t>(rows));
  }
}

}  // namespace

void draw_plain(const GlyphField& field,
                const TextStyle& style,
                const Placed& placed,
                const Sink& sink) noexcept {
  const CellRaster& raster = raster_of(style);
  CellMap map(field, style, placed, reach_u_q10(style));
  if (raster.clip(map, sink.window)) {
    const CellBand band(raster, map, CoverageRamp(style.filter()));
    draw_tiles(raster, map, band, sink);
  }
}

Rect visible_pixels(const GlyphField& field,
                    const TextStyle& style,
                    const FinePoint& origin,
                    const Rect& window) noexcept {
  return intersect(field_box(field, style, origin), window);
}

}  // namespace detail

Rect field_box(const GlyphField& field,
               const TextStyle& style,
               FinePoint origin) noexcept {
  using namespace detail;
  // Origins that are too far to be seen remain so.
  constexpr int64_t kLimit = Placed::kLimit;
  const Placed placed = {
      static_cast<int32_t>(clamp(origin.x_q10, -kLimit, kLimit - 1)),
      static_cast<int32_t>(clamp(origin.y_q10, -kLimit, kLimit - 1))};
  constexpr int32_t kFar = 1 << 24;
  CellMap map(field, style, placed, reach_u_q10(style));
  if (!raster_of(style).clip(map, {-kFar, -kFar, kFar, kFar})) {
    return {};
  }
  const Rect& box = map.samples;
  const int32_t more = style.effect().reach_px;
  return {box.x0 - more, box.y0 - more, box.x1 + more, box.y1 + more};
}

void draw_field(const GlyphField& field,
                const TextStyle& style,
                FinePoint origin,
                const Sink& sink) noexcept {
  detail::Placed placed;
  if (placed.set(origin)) {
    detail::draw_near(field, style, placed, sink);
  }
}

}  // namespace inkcell
