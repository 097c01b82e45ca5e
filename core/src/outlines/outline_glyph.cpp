#include "outlines/outline_glyph.hpp"

#include "base/math.hpp"
#include "base/modular.hpp"
#include "inkcell/format/rom.hpp"
#include "outlines/slant.hpp"

namespace inkcell {
namespace detail {
namespace {

namespace composite = format::composite;

constexpr int32_t kPxQ18 = 1 << 18;

// [px per grid unit, Q18]
int32_t scale_of(const Font& font,
                 Q26_6 size_px,
                 const OutlineCoding& coding) noexcept {
  // At most 2^16 sizes: 32 bits hold this.
  const uint32_t shift = static_cast<uint32_t>(12 + coding.grid_shift);
  const uint32_t size = static_cast<uint32_t>(size_px.raw) << shift;
  const uint32_t em = font.units_per_em();
  return static_cast<int32_t>((size + em / 2) / em);
}

// A row of a map times a column of a component's, which is in Q14 and 16 bits
// wide: rounded, modulo 2^32, without products of 64 bits.
int32_t mixed(int32_t a, int32_t x, int32_t b, int32_t y) noexcept {
  constexpr int32_t kLow = (1 << 14) - 1;
  return sum(sum(product(a >> 14, x), product(b >> 14, y)),
             ((a & kLow) * x + (b & kLow) * y + (1 << 13)) >> 14);
}

// A map after that of a component.
OutlineMap mapped(const OutlineMap& map, const int32_t (&part)[4]) noexcept {
  return {mixed(map.x_right, part[0], map.y_right, part[2]),
          mixed(map.x_down, part[0], map.y_down, part[2]),
          mixed(map.x_right, part[1], map.y_right, part[3]),
          mixed(map.x_down, part[1], map.y_down, part[3])};
}

// From a pixel to a place, modulo 2^32. [px, Q10; px -> Q18]
int32_t place_from(int32_t at_q10, int32_t px) noexcept {
  return static_cast<int32_t>(
      (static_cast<uint32_t>(at_q10) - (static_cast<uint32_t>(px) << 10)) << 8);
}

}  // namespace

// Font units times px per grid unit. [px, Q18]
int32_t OutlineGlyph::scaled(int32_t units, int32_t per_unit) const noexcept {
  const int32_t value = product(units, per_unit);
  const int32_t shift = outline_coding(*font_).grid_shift;
  return shift >= 0
             ? value >> shift
             : static_cast<int32_t>(static_cast<uint32_t>(value) << -shift);
}

// Along the screen's x or y: the pixels whose centres lie within the reach of
// the glyph's box, moved by `map` if that is not null. `per_x`, `per_y`: where
// grid units lead. [px, Q18]
OutlineGlyph::Axis OutlineGlyph::axis_of(const GlyphMetrics& metrics,
                                         int32_t per_x,
                                         int32_t per_y,
                                         int32_t at_q10,
                                         const OutlineSampling& sampling,
                                         int32_t moved_q8,
                                         const AxisMap* map) const noexcept {
  int32_t low = sum(scaled(metrics.x_min, per_x), scaled(metrics.y_min, per_y));
  int32_t high = low;
  const int32_t sides[] = {scaled(metrics.x_max - metrics.x_min, per_x),
                           scaled(metrics.y_max - metrics.y_min, per_y)};
  for (const int32_t side : sides) {
    int32_t& end = side < 0 ? low : high;
    end = sum(end, side);
  }
  int32_t reach = (sampling.reach_q8 + moved_q8) * 1024;
  if (map != nullptr && map->count != 0) {
    sampling.warp_range(*map, per_y < 0 ? -1 : 1, low, high);
    reach += 1 << 11;  // roundings
  }
  // Of the place the whole px apart: it may be far away.
  const int32_t part = (at_q10 & 1023) * 256 - kPxQ18 / 2;
  return {(at_q10 >> 10) + (sum(sum(low, part), kPxQ18 - 1 - reach) >> 18),
          (at_q10 >> 10) + (sum(sum(high, part), reach) >> 18) + 1};
}

bool OutlineGlyph::open(const Font& font,
                        const GlyphMetrics& metrics,
                        Span<const uint8_t> record,
                        Q26_6 size,
                        const Style* slanted,
                        const Placed& placed,
                        const OutlineSampling& sampling,
                        const GlyphWarp* warp,
                        Rect& box) noexcept {
  font_ = &font;
  x_min_ = metrics.x_min;
  y_min_ = metrics.y_min;
  record_ = record;
  const OutlineCoding& coding = outline_coding(font);
  if (coding.code_bits == 0) {
    return false;
  }
  is_composite_ = record_.data[0] == composite::kType;
  const int32_t scale = scale_of(font, size, coding);
  map_ = {scale, 0, 0, -scale};
  is_mirrored_ = slanted != nullptr && slanted->slant().map(*slanted, map_);
  const Axis x =
      axis_of(metrics, map_.x_right, map_.y_right, placed.x_q10, sampling,
              sampling.moved_x_q8, warp == nullptr ? nullptr : &warp->x);
  const Axis y =
      axis_of(metrics, map_.x_down, map_.y_down, placed.y_q10, sampling,
              sampling.moved_y_q8, warp == nullptr ? nullptr : &warp->y);
  box = {x.low_px, y.low_px, x.high_px, y.high_px};
  // Half of a 256th, so that points are rounded to the nearest.
  const int32_t origin = 512 - sampling.origin_q8 * 1024;
  const int32_t left_px = first_column(box);
  x_q18_ =
      sum(origin, product(place_from(placed.x_q10, left_px), sampling.columns));
  y_q18_ =
      sum(origin, product(place_from(placed.y_q10, box.y0), sampling.rows));
  map_.x_right = product(map_.x_right, sampling.columns);
  map_.y_right = product(map_.y_right, sampling.columns);
  map_.x_down = product(map_.x_down, sampling.rows);
  map_.y_down = product(map_.y_down, sampling.rows);
  return true;
}

// Steps begin at the lower left corner of the part's box.
void OutlineGlyph::begin_part(int32_t x_min,
                              int32_t y_min,
                              Span<const uint8_t> record,
                              int32_t x_q18,
                              int32_t y_q18) noexcept {
  const int32_t shift = outline_coding(*font_).grid_shift;
  const int32_t x = shift >= 0 ? x_min >> shift : x_min * (1 << -shift);
  const int32_t y = shift >= 0 ? y_min >> shift : y_min * (1 << -shift);
  const OutlineMap& map = part_map_;
  reader_.begin(
      record, outline_coding(*font_),
      sum(x_q18, sum(product(x, map.x_right), product(y, map.y_right))),
      sum(y_q18, sum(product(x, map.x_down), product(y, map.y_down))));
}

void OutlineGlyph::rewind() noexcept {
  points_left_ = outline_coding(*font_).max_points;
  part_map_ = map_;
  if (is_composite_) {
    components_ = ComponentReader(record_);
    if (!next_component()) {
      points_left_ = 0;
    }
  } else {
    begin_part(x_min_, y_min_, record_, x_q18_, y_q18_);
  }
}

bool OutlineGlyph::next_component() noexcept {
  Component part;
  while (components_.next(part)) {
    const Span<const uint8_t> record = font_->record(part.glyph);
    if (is_outline(record) && record.data[0] != composite::kType) {
      GlyphMetrics metrics;
      static_cast<void>(font_->glyph_metrics(part.glyph, metrics));
      part_map_ = part.has_matrix ? mapped(map_, part.matrix_q14) : map_;
      begin_part(metrics.x_min, metrics.y_min, record,
                 sum(x_q18_, sum(scaled(part.dx, map_.x_right),
                                 scaled(part.dy, map_.y_right))),
                 sum(y_q18_, sum(scaled(part.dx, map_.x_down),
                                 scaled(part.dy, map_.y_down))));
      return true;
    }
  }
  return false;
}

ScreenPoint* OutlineGlyph::read(ScreenPoint* out, int32_t room) noexcept {
  const OutlineCoding& coding = outline_coding(*font_);
  while (!is_done() && room != 0) {
    ScreenPoint* const end =
        reader_.read(coding, part_map_, out, min(room, int32_t{points_left_}));
    const auto count = static_cast<int32_t>(end - out);
    room -= count;
    points_left_ = static_cast<uint16_t>(points_left_ - count);
    out = end;
    if (reader_.is_done() && !(is_composite_ && next_component())) {
      points_left_ = 0;
    }
  }
  return out;
}

}  // namespace detail
}  // namespace inkcell
