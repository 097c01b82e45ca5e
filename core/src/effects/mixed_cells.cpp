#include "effects/mixed_cells.hpp"

#include <stddef.h>

#include "base/words.hpp"
#include "place/cell_raster.hpp"
#include "raster/upright_tile.hpp"

namespace inkcell {
namespace detail {
namespace {

struct Steps {
  uint8_t entries[256];

  constexpr Steps() noexcept : entries() {
    for (int32_t i = 0; i < 256; ++i) {
      entries[i] = static_cast<uint8_t>(i);
    }
  }
};
constexpr Steps kSteps;

CoverageRamp ramp_of(int32_t reach_q8) noexcept {
  const int32_t half_q10 = reach_q8 * 4 * 128 / 127;
  return {-half_q10, half_q10,
          (256u << 14) / static_cast<uint32_t>(2 * half_q10), kSteps.entries};
}

Rect widened(const Rect& pixels, const BandPlan& plan) noexcept {
  return {pixels.x0 - plan.margin_x, pixels.y0 - plan.margin_y,
          pixels.x1 + plan.margin_x, pixels.y1 + plan.margin_y};
}

// Fills the pixels that may show, given where the first row of a tile begins.
// Not inline: its frame is off the stack when a tile is mixed.
__attribute__((noinline)) void fill_tile(const CellRaster& raster,
                                         const CellBand& band,
                                         const Rect& pixels,
                                         uint8_t* lines) noexcept {
  const CellMap& map = band.map();
  const Rect shown = intersect(pixels, map.samples);
  if (is_empty(shown)) {
    return;
  }
  GlyphPoint at = map.first;
  at.advance(map.right, static_cast<uint32_t>(shown.x0 - map.samples.x0));
  at.advance(map.up, static_cast<uint32_t>(map.samples.y0 - shown.y0));
  const Stripes* const stripes = band.stripes();
  lines += (stripes == nullptr ? 1 : 3) *
           ((shown.y0 - pixels.y0) * kTileColumns + shown.x0 - pixels.x0);
  if (raster.may_show(map, shown.x0, shown.y0, at)) {
    const CoverTile cover = stripes != nullptr && map.style.is_upright()
                                ? stripes->cover_upright
                                : raster.cover;
    cover(band, at, shown.x1 - shown.x0, shown.y1 - shown.y0, lines);
  }
}

// Tile by tile, `kCount` bytes a pixel. Rows around pixels serve two tiles: no
// mixer changes them.
template <int32_t kCount>
__attribute__((noinline)) void mix_tiles(const CellRaster& raster,
                                         const CellBand& band,
                                         const BandPlan& plan,
                                         MixCells mix,
                                         GlyphJob& job) noexcept {
  constexpr int32_t kRows = kCount == 1 ? kTileRows : 4;
  const Rect all =
      intersect(widened(band.map().samples, plan), job.sink->window);
  uint32_t words[size_t{kRows * kCount * kTileColumns} / 4];
  auto* const bytes = reinterpret_cast<uint8_t*>(words);
  job.band.bytes = bytes;
  job.band.stride = kCount * kTileColumns;
  Rect& part = job.pixels;
  for (part.x0 = all.x0; part.x0 < all.x1; part.x0 = part.x1) {
    // A pixel of one byte begins a word if its x is a multiple of 4.
    const int32_t lead = kCount == 1 ? (part.x0 - plan.margin_x) & 3 : 0;
    part.x1 = min(part.x0 + kTileColumns - lead - 2 * plan.margin_x, all.x1);
    job.column = static_cast<uint8_t>(kCount * (lead + plan.margin_x));
    int32_t kept = 0;  // rows, of the tile above
    for (part.y0 = all.y0; part.y0 < all.y1; part.y0 = part.y1) {
      part.y1 = min(part.y0 + kRows - 2 * plan.margin_y, all.y1);
      Rect pixels = widened(part, plan);
      job.band.rows = pixels.y1 - pixels.y0;
      job.band.last_column = kCount * (lead + pixels.x1 - pixels.x0) - 1;
      pixels.y0 += kept;
      uint8_t* const rows = job.band.row(kept);
      clear_pixels(rows, (kRows - kept) * job.band.stride);
      fill_tile(raster, band, pixels, rows + kCount * lead);
      mix(job);
      kept = 2 * plan.margin_y;
      __builtin_memcpy(bytes, job.band.row(kRows - kept),
                       static_cast<size_t>(kept * job.band.stride));
    }
  }
}

}  // namespace

void mix_cells(const GlyphField& field,
               const TextStyle& style,
               const FinePoint& origin,
               const Sink& sink,
               const BandPlan& plan,
               const Stripes* stripes,
               MixCells mix) noexcept {
  Placed placed;
  if (!placed.set_near(origin)) {
    return;
  }
  const CellRaster& raster = raster_of(style);
  const uint32_t shown_u = (static_cast<uint32_t>(plan.shown_q8) << 8) /
                               static_cast<uint32_t>(style.size().raw) +
                           1;
  // A third of a pixel, if it has stripes.
  const auto beyond_u =
      stripes == nullptr
          ? int32_t{0}
          : static_cast<int32_t>((22u << 10) /
                                 static_cast<uint32_t>(style.size().raw)) +
                1;
  CellMap map(field, style, placed, static_cast<int32_t>(shown_u << 10),
              beyond_u);
  if (!raster.clip(map, widened(sink.window, plan))) {
    return;
  }
  GlyphJob job = {};
  job.band.reach_q8 = max(plan.outside_q8, plan.inside_q8);
  job.row = plan.margin_y;
  job.style = &style;
  job.sink = &sink;
  const CellBand band(raster, map, ramp_of(job.band.reach_q8), stripes);
  if (stripes == nullptr) {
    mix_tiles<1>(raster, band, plan, mix, job);
  } else {
    mix_tiles<3>(raster, band, plan, mix, job);
  }
}

void toggle_rows(const Band& band) noexcept {
  for (int32_t row = 0; row != band.rows; ++row) {
    uint8_t* at = band.row(row);
    uint32_t before = 0;
    for (uint8_t* const end = at + band.last_column + 1; at != end; ++at) {
      const uint32_t inside = *at >> 7;
      const uint32_t nearness = ((*at ^ (0u - inside)) << 1) & 254;
      *at = static_cast<uint8_t>(nearness | (inside ^ before));
      before = inside;
    }
  }
}

}  // namespace detail
}  // namespace inkcell
