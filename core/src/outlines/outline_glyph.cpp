#include "outlines/outline_glyph.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "place/style_parts.hpp"

namespace inkcell::detail {
namespace {

namespace word = format::outline;

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

// The first `width` bits, 1 to 16, as two's complement.
inline uint32_t signed_top(uint32_t window, uint32_t width) noexcept {
  return static_cast<uint32_t>(static_cast<int32_t>(window) >> (32 - width));
}

// A factor of at most 1 or so. [Q30]
int32_t times_q30(int32_t scale, int32_t factor_q30) noexcept {
  return static_cast<int32_t>((int64_t{scale} * factor_q30 + (1 << 29)) >> 30);
}

bool map_slanted(const Style& style, OutlineMap& map) noexcept {
  const int32_t scale = map.axes[0].per_x;
  const Style::Axes& axes = style.axes();
  map = {
      {{times_q30(scale, axes.x_right.raw), times_q30(scale, axes.y_right.raw)},
       {-times_q30(scale, axes.x_up.raw), -times_q30(scale, axes.y_up.raw)}}};
  return (axes.x_right.raw >> 15) * int64_t{axes.y_up.raw >> 15} <
         (axes.x_up.raw >> 15) * int64_t{axes.y_right.raw >> 15};
}

// (a p + b q) / 2^30, for any a and b below 2^42, p and q below 2^31. Not
// inline for its size.
__attribute__((noinline)) int64_t turned(int64_t a,
                                         int64_t p,
                                         int64_t b,
                                         int64_t q) noexcept {
  // The products pass 64 bits, those of the halves do not.
  constexpr int64_t kLow = (1 << 20) - 1;
  const int64_t high = (a >> 20) * p + (b >> 20) * q;
  const int64_t low = (a & kLow) * p + (b & kLow) * q;
  return (high + (low >> 20)) >> 10;
}

FinePoint place_slanted(const Style& style,
                        const FinePoint& origin,
                        int64_t along_q10,
                        int64_t across_q10) noexcept {
  const Style::Axes& axes = style.axes();
  return {origin.x_q10 +
              turned(along_q10, axes.x_right.raw, across_q10, axes.y_right.raw),
          origin.y_q10 -
              turned(along_q10, axes.x_up.raw, across_q10, axes.y_up.raw)};
}

}  // namespace

__attribute__((noinline)) int32_t mixed(int32_t a,
                                        int32_t x,
                                        int32_t b,
                                        int32_t y) noexcept {
  constexpr int32_t kLow = (1 << 14) - 1;
  return sum(sum(product(a >> 14, x), product(b >> 14, y)),
             ((a & kLow) * x + (b & kLow) * y + (1 << 13)) >> 14);
}

const Slant kSlant = {map_slanted, place_slanted};

bool OutlineRecord::find(const Font& font, uint16_t glyph) noexcept {
  bytes = font.record(glyph);
  // A glyph that has a record has metrics.
  static_cast<void>(font.glyph_metrics(glyph, metrics));
  return is_outline(bytes) && font.has_outlines();
}

// Font units times px per grid unit. [px, Q18]
int32_t OutlineGlyph::scaled(int32_t units, int32_t per_unit) const noexcept {
  const int32_t value = product(units, per_unit);
  const int32_t shift = font_->outline_coding().grid_shift;
  return shift >= 0
             ? value >> shift
             : static_cast<int32_t>(static_cast<uint32_t>(value) << -shift);
}

int32_t OutlineGlyph::moved(const OutlineMap::Axis& axis,
                            int32_t x,
                            int32_t y) const noexcept {
  return sum(scaled(x, axis.per_x), scaled(y, axis.per_y));
}

bool OutlineGlyph::find(const Font& font,
                        uint16_t glyph,
                        Q26_6 size,
                        const Style* slanted,
                        InkEnds (&ink)[2],
                        bool& is_mirrored) noexcept {
  if (!record_.find(font, glyph)) {
    return false;
  }
  font_ = &font;
  const int32_t scale = scale_of(font, size, font.outline_coding());
  map_ = {{{scale, 0}, {0, -scale}}};
  is_mirrored =
      slanted != nullptr && StyleParts::slant(*slanted).map(*slanted, map_);
  const GlyphMetrics& box = record_.metrics;
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 2
#endif
  for (int32_t i = 0; i != 2; ++i) {
    const OutlineMap::Axis& axis = map_.axes[i];
    InkEnds& ends = ink[i];
    ends.low = ends.high = moved(axis, box.x_min, box.y_min);
    const int32_t sides[] = {scaled(box.x_max - box.x_min, axis.per_x),
                             scaled(box.y_max - box.y_min, axis.per_y)};
    for (const int32_t side : sides) {
      int32_t& end = side < 0 ? ends.low : ends.high;
      end = sum(end, side);
    }
  }
  return true;
}

void OutlinePlace::find_box(const Placed& placed,
                            const BandPlan& plan,
                            int32_t origin_q8,
                            const InkEnds (&ink)[2],
                            Rect& box) noexcept {
  const int32_t at_q10[] = {placed.x_q10, placed.y_q10};
  const int32_t moved_q8[] = {plan.moved_x_q8, plan.moved_y_q8};
  const int32_t samples[] = {plan.columns, plan.rows};
  int32_t low[2];
  int32_t high[2];
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 2
#endif
  for (int32_t i = 0; i != 2; ++i) {
    const int32_t reach = (plan.ink_margin_q8 + moved_q8[i]) * 1024;
    low[i] = px_before(at_q10[i], sum(ink[i].low, kPxQ18 - 1 - reach));
    high[i] = px_before(at_q10[i], sum(ink[i].high, reach)) + 1;
  }
  box = {low[0], low[1], high[0], high[1]};
  low[0] = first_column(box);
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 2
#endif
  for (int32_t i = 0; i != 2; ++i) {
    // Half of a 256th, so that points are rounded to the nearest.
    origin_q18_[i] = sum(512 - origin_q8 * 1024,
                         product(place_from(at_q10[i], low[i]), samples[i]));
    OutlineMap::Axis& axis = map_.axes[i];
    axis = {product(axis.per_x, samples[i]), product(axis.per_y, samples[i])};
  }
}

// `part`: the component that the record is of a composite, or null. Steps begin
// at the lower left corner of its box.
void OutlineGlyph::begin_part(const OutlineRecord& record,
                              const Component* part) noexcept {
  const int32_t x = scaled(record.metrics.x_min, 1);
  const int32_t y = scaled(record.metrics.y_min, 1);
  int32_t pen_q18[2];
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 2
#endif
  for (int32_t i = 0; i != 2; ++i) {
    OutlineMap::Axis axis = map_.axes[i];
    int32_t at = origin_q18_[i];
    if (part != nullptr) {
      at = sum(at, moved(axis, part->dx(), part->dy()));
      if (part->has_matrix) {
        const int32_t* const matrix = part->matrix_q14();
        axis = {mixed(axis.per_x, matrix[0], axis.per_y, matrix[2]),
                mixed(axis.per_x, matrix[1], axis.per_y, matrix[3])};
      }
    }
    part_map_.axes[i] = axis;
    pen_q18[i] = sum(at, sum(product(x, axis.per_x), product(y, axis.per_y)));
  }
  reader_.begin(record.bytes, pen_q18);
}

void OutlineGlyph::rewind() noexcept {
  reader_.set_budget(font_->outline_coding().max_points);
  if (!record_.is_composite()) {
    begin_part(record_, nullptr);
    return;
  }
  components_.begin();
  if (!next_component()) {
    reader_.set_budget(0);
  }
}

bool OutlineGlyph::next_component() noexcept {
  Component part;
  while (components_.next(record_.bytes, part)) {
    OutlineRecord record;
    if (record.find(*font_, part.glyph) && !record.is_composite()) {
      begin_part(record, &part);
      return true;
    }
  }
  return false;
}

ScreenPoint* OutlineGlyph::read(ScreenPoint* out, int32_t room) noexcept {
  const OutlineCoding& coding = font_->outline_coding();
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

uint32_t last_bits_from(const uint8_t* bytes,
                        uint32_t size,
                        uint32_t first) noexcept {
  if (first >= size) {
    return 0;
  }
  if (size >= 4) {
    return load_big_u32(bytes + size - 4) << (8 * (first + 4 - size) & 31);
  }
  uint32_t window = 0;
  for (uint32_t i = first; i != first + 4; ++i) {
    window = window << 8 | (i < size ? bytes[i] : 0u);
  }
  return window;
}

ScreenPoint* OutlineReader::read(const OutlineCoding& coding,
                                 const OutlineMap& map,
                                 ScreenPoint* out,
                                 int32_t room) noexcept {
  const uint8_t* const record = record_;
  const uint32_t size = size_;
  const uint32_t shift = 32u - coding.code_bits;
  const auto table_of = [&coding](uint32_t number) {
    return coding.tables + (number << coding.code_bits << 1);
  };
  uint32_t number = place_ >> kPlaceBits;
  const uint8_t* table = table_of(number);
  const OutlineMap::Axis& right = map.axes[0];
  const OutlineMap::Axis& down = map.axes[1];
  uint32_t bit = place_ & ((1u << kPlaceBits) - 1);
  uint32_t x = x_q18_;
  uint32_t y = y_q18_;
  const int32_t count = min(room, budget_);
  budget_ -= count;
  ScreenPoint* last = out + count;
  while (out != last) {
    // A contour's first point in a round of its own.
    const bool is_start = start_.kind() == kStart;
    ScreenPoint* const stop = is_start ? out + 1 : last;
    do {
      uint32_t window = bits_from(record, size, bit);
      const uint32_t code = load_u16(table + 2 * (window >> shift));
      const uint32_t change = code >> word::kTableShift;
      if (__builtin_expect(change != 0, 0)) {
        number ^= change & coding.last_table;
        table = table_of(number);
      }
      const uint32_t length = code & word::kLengthMask;
      const uint32_t kind = code >> word::kKindShift & word::kKindMask;
      window <<= length;
      if (__builtin_expect(kind == word::kEndOfContour, 0)) {
        bit += length + 1;
        *out++ = {start_.x_q8, start_.y_q8_kind | int32_t{kCorner}};
        start_.y_q8_kind = kStart;
        if (window >> 31 == 0) {
          record_ = nullptr;
          budget_ += static_cast<int32_t>(last - out);
          last = out;
        }
        break;
      }
      const uint32_t x_bits = code >> word::kXBitsShift & word::kWidthMask;
      const uint32_t y_bits = code >> word::kYBitsShift & word::kWidthMask;
      const uint32_t bits = length + x_bits + y_bits;
      bit += bits;
      if (x_bits != 0) {
        const uint32_t dx = signed_top(window, x_bits);
        x += dx * static_cast<uint32_t>(right.per_x);
        y += dx * static_cast<uint32_t>(down.per_x);
        window <<= x_bits;
      }
      if (y_bits != 0) {
        if (__builtin_expect(bits > 25, 0)) {
          window = bits_from(record, size, bit - y_bits);
        }
        const uint32_t dy = signed_top(window, y_bits);
        x += dy * static_cast<uint32_t>(right.per_y);
        y += dy * static_cast<uint32_t>(down.per_y);
      }
      *out++ = ScreenPoint::at(static_cast<int32_t>(x) >> 10,
                               static_cast<int32_t>(y) >> 10, kind);
    } while (out != stop);
    ScreenPoint& start = out[-1];
    // An empty contour has none: its end is kind kStart already.
    if (is_start && start.kind() != kStart) {
      start_ = {start.x_q8, start.y_q8_kind & ~3};
      start.y_q8_kind |= int32_t{kStart};
    }
  }
  place_ = bit | number << kPlaceBits;
  x_q18_ = x;
  y_q18_ = y;
  return out;
}

}  // namespace inkcell::detail
