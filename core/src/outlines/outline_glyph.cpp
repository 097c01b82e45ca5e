#include "outlines/outline_glyph.hpp"

#include "base/math.hpp"
#include "base/modular.hpp"
#include "inkcell/format/rom.hpp"
#include "outlines/slant.hpp"

namespace inkcell {
namespace detail {
namespace {

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
OutlineMap mapped(const OutlineMap& map, const int32_t* part) noexcept {
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

// The pixel whose centre is the last one at or before a place, as far from an
// origin. [px, Q18; Q10] Of the place the whole px apart: it may be far away.
int32_t px_before(int32_t at_q10, int32_t away_q18) noexcept {
  const int32_t part = (at_q10 & 1023) * 256 - kPxQ18 / 2;
  return (at_q10 >> 10) + (sum(away_q18, part) >> 18);
}

}  // namespace

bool OutlineRecord::find(const Font& font, uint16_t glyph) noexcept {
  bytes = font.record(glyph);
  return is_outline(bytes) && outline_coding(font).code_bits != 0 &&
         font.glyph_metrics(glyph, metrics) == Status::ok;
}

// Font units times px per grid unit. [px, Q18]
int32_t OutlineGlyph::scaled(int32_t units, int32_t per_unit) const noexcept {
  const int32_t value = product(units, per_unit);
  const int32_t shift = outline_coding(*font_).grid_shift;
  return shift >= 0
             ? value >> shift
             : static_cast<int32_t>(static_cast<uint32_t>(value) << -shift);
}

int32_t OutlineGlyph::moved(int32_t x,
                            int32_t per_x,
                            int32_t y,
                            int32_t per_y) const noexcept {
  return sum(scaled(x, per_x), scaled(y, per_y));
}

// The ends of the glyph's box along the screen's x or y. `per_x`, `per_y`:
// where grid units lead. [px, Q18]
void OutlineGlyph::find_ends(int32_t per_x,
                             int32_t per_y,
                             int32_t& low,
                             int32_t& high) const noexcept {
  const GlyphMetrics& box = record_.metrics;
  low = high = moved(box.x_min, per_x, box.y_min, per_y);
  const int32_t sides[] = {scaled(box.x_max - box.x_min, per_x),
                           scaled(box.y_max - box.y_min, per_y)};
  for (const int32_t side : sides) {
    int32_t& end = side < 0 ? low : high;
    end = sum(end, side);
  }
}

bool OutlineGlyph::open(const Font& font,
                        uint16_t glyph,
                        Q26_6 size,
                        const Style* slanted,
                        InkRange& ink) noexcept {
  if (!record_.find(font, glyph)) {
    return false;
  }
  font_ = &font;
  const int32_t scale = scale_of(font, size, outline_coding(font));
  map_ = {scale, 0, 0, -scale};
  is_mirrored_ = slanted != nullptr && slanted->slant().map(*slanted, map_);
  find_ends(map_.x_right, map_.y_right, ink.left, ink.right);
  find_ends(map_.x_down, map_.y_down, ink.top, ink.bottom);
  return true;
}

void OutlineGlyph::place(const Placed& placed,
                         const Sampling& sampling,
                         int32_t origin_q8,
                         const InkRange& ink,
                         Rect& box) noexcept {
  const int32_t x_q10 = placed.x_q10;
  const int32_t y_q10 = placed.y_q10;
  const int32_t reach_x = (sampling.shown_q8 + sampling.moved_x_q8) * 1024;
  const int32_t reach_y = (sampling.shown_q8 + sampling.moved_y_q8) * 1024;
  box = {px_before(x_q10, sum(ink.left, kPxQ18 - 1 - reach_x)),
         px_before(y_q10, sum(ink.top, kPxQ18 - 1 - reach_y)),
         px_before(x_q10, sum(ink.right, reach_x)) + 1,
         px_before(y_q10, sum(ink.bottom, reach_y)) + 1};
  // Half of a 256th, so that points are rounded to the nearest.
  const int32_t origin = 512 - origin_q8 * 1024;
  const int32_t columns = sampling.columns;
  const int32_t rows = sampling.rows;
  x_q18_ = sum(origin, product(place_from(x_q10, first_column(box)), columns));
  y_q18_ = sum(origin, product(place_from(y_q10, box.y0), rows));
  map_ = {product(map_.x_right, columns), product(map_.x_down, rows),
          product(map_.y_right, columns), product(map_.y_down, rows)};
}

// The part's map is in place. Steps begin at the lower left corner of its box.
void OutlineGlyph::begin_part(const OutlineRecord& record,
                              int32_t x_q18,
                              int32_t y_q18) noexcept {
  const int32_t x = scaled(record.metrics.x_min, 1);
  const int32_t y = scaled(record.metrics.y_min, 1);
  const OutlineMap& map = part_map_;
  reader_.begin(
      record.bytes,
      sum(x_q18, sum(product(x, map.x_right), product(y, map.y_right))),
      sum(y_q18, sum(product(x, map.x_down), product(y, map.y_down))));
}

void OutlineGlyph::rewind() noexcept {
  reader_.set_budget(outline_coding(*font_).max_points);
  if (record_.is_composite()) {
    components_.begin();
    if (!next_component()) {
      reader_.set_budget(0);
    }
  } else {
    part_map_ = map_;
    begin_part(record_, x_q18_, y_q18_);
  }
}

bool OutlineGlyph::next_component() noexcept {
  Component part;
  while (components_.next(record_.bytes, part)) {
    OutlineRecord record;
    if (record.find(*font_, part.glyph) && !record.is_composite()) {
      part_map_ = part.has_matrix ? mapped(map_, part.matrix_q14()) : map_;
      begin_part(
          record,
          sum(x_q18_, moved(part.dx(), map_.x_right, part.dy(), map_.y_right)),
          sum(y_q18_, moved(part.dx(), map_.x_down, part.dy(), map_.y_down)));
      return true;
    }
  }
  return false;
}

ScreenPoint* OutlineGlyph::read(ScreenPoint* out, int32_t room) noexcept {
  const OutlineCoding& coding = outline_coding(*font_);
  while (!is_done() && room != 0) {
    ScreenPoint* const end = reader_.read(coding, part_map_, out, room);
    room -= static_cast<int32_t>(end - out);
    out = end;
    if (reader_.has_ended() && !(record_.is_composite() && next_component())) {
      reader_.set_budget(0);
    }
  }
  return out;
}

}  // namespace detail
}  // namespace inkcell
