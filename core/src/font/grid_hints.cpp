#include "inkcell/grid_hints.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

namespace grid = format::grid;

// Zones beyond this are read as this. [u]
constexpr int32_t kFarthestZone = 2048;

// Bits that are taken from the highest on.
struct Bits {
  uint32_t word;
  uint32_t used;

  uint32_t take(uint32_t count) noexcept {
    const uint32_t value = word >> (32 - count);
    word <<= count;
    used += count;
    return value;
  }
  bool flag() noexcept { return take(1) != 0; }
  int32_t position_u() noexcept {
    return grid::kPositionBase +
           grid::kPositionStep *
               static_cast<int32_t>(take(grid::kPositionBits));
  }
};

}  // namespace

Status GridHints::open(const Font& font, GridHints& out) noexcept {
  const Span<const uint8_t> section = font.section(format::section::kGrid);
  if (section.size == 0) {
    out = {};
    return Status::ok;
  }
  if (section.size < grid::kBytes) {
    return Status::corrupt;
  }
  const uint8_t* const at = section.data;
  const uint32_t zones = at[grid::kZones];
  const uint32_t offset_bits = at[grid::kOffsetBits];
  const uint32_t bits = offset_bits * (font.glyph_count() + 1u);
  const uint32_t records =
      grid::kBytes + grid::kZoneBytes * zones + (bits + 7) / 8;
  if (zones > grid::kMaxZones || offset_bits > grid::kMaxOffsetBits ||
      records > section.size) {
    return Status::corrupt;
  }
  // Member by member: smaller than to copy a whole one.
  out.section_ = section;
  out.records_ = records;
  out.glyph_count_ = font.glyph_count();
  out.offset_bits_ = static_cast<uint8_t>(offset_bits);
  out.zone_count_ = static_cast<uint8_t>(zones);
  out.flags_ = at[grid::kFlags];
  out.stem_width_u_ = at[grid::kStemWidth];
  out.bar_width_u_ = at[grid::kBarWidth];
  out.x_zone_ = at[grid::kXZone];
  return Status::ok;
}

bool GridHints::has_contrast() const noexcept {
  return (flags_ & grid::kContrast) != 0;
}

bool GridHints::has_few_bars() const noexcept {
  return (flags_ & grid::kFewBars) != 0;
}

GridZone GridHints::zone(uint32_t i) const noexcept {
  const uint8_t* const at = section_.data + grid::kBytes + grid::kZoneBytes * i;
  int32_t flat = detail::load_i16(at + grid::kZoneFlat);
  flat = flat > kFarthestZone ? kFarthestZone : flat;
  flat = flat < -kFarthestZone ? -kFarthestZone : flat;
  return {flat, static_cast<int8_t>(at[grid::kZoneOvershoot]),
          (at[grid::kZoneFlags] & grid::kTopZone) != 0};
}

bool GridHints::record(uint32_t glyph,
                       Span<const uint8_t>& out) const noexcept {
  out = {};
  if (glyph >= glyph_count_) {
    return true;
  }
  const Span<const uint8_t> tables = {section_.data, records_};
  const uint32_t first = 8 * (grid::kBytes + grid::kZoneBytes * zone_count_) +
                         glyph * offset_bits_;
  const uint32_t begin = detail::read_bits(tables, first, offset_bits_);
  const uint32_t end =
      detail::read_bits(tables, first + offset_bits_, offset_bits_);
  if (begin > end || end > section_.size - records_) {
    return false;
  }
  out = {section_.data + records_ + begin, end - begin};
  return true;
}

static_assert(GlyphHints::kMostY + 1 == 1u << grid::kHeightCountBits &&
                  GlyphHints::kMostX + 1 == 1u << grid::kAcrossCountBits,
              "as many as can be stored");

GlyphHints::GlyphHints(const GridHints& hints, uint32_t glyph) noexcept
    : hints_(hints) {
  if (hints.empty() || !hints.record(glyph, record_) || empty()) {
    return;
  }
  Bits bits = {window(), 0};
  is_symmetric_ = bits.flag();
  const bool has_insets = bits.flag();
  y_count_ = static_cast<uint8_t>(bits.take(grid::kHeightCountBits));
  x_count_ = static_cast<uint8_t>(bits.take(grid::kAcrossCountBits));
  if (has_insets) {
    left_inset_u_ = static_cast<uint8_t>(2 * bits.take(grid::kInsetBits));
    right_inset_u_ = static_cast<uint8_t>(2 * bits.take(grid::kInsetBits));
  }
  bit_ = bits.used;
}

// 25 bits at least, from the highest on; 0 beyond the record. The last four
// bytes are read where fewer are left: a header lies before all records.
uint32_t GlyphHints::window() const noexcept {
  static_assert(grid::kBytes >= 4, "bytes before the first record");
  const auto size = static_cast<uint32_t>(record_.size);  // below 2^20
  const uint32_t first = bit_ / 8;
  if (first >= size) {
    return 0;
  }
  const uint32_t past = first + 4 > size ? first + 4 - size : 0;
  return __builtin_bswap32(detail::load_any_u32(record_.data + first - past))
         << (8 * past + bit_ % 8);
}

YHint GlyphHints::next_y() noexcept {
  Bits bits = {window(), 0};
  YHint hint = {};
  hint.kind = static_cast<YHint::Kind>(bits.take(grid::kHeightKindBits));
  hint.zone = YHint::kNoZone;
  const bool is_stroke = hint.kind <= YHint::serif;
  if (hint.kind != YHint::edge) {
    hint.is_top = bits.flag();
  }
  int32_t at_u;
  if (hint.kind == YHint::edge || (is_stroke && bits.flag())) {
    hint.zone = static_cast<uint8_t>(bits.take(grid::kZoneBits));
    hint.is_round = bits.flag();
    at_u = 0;
    if (hint.zone < hints_.zone_count()) {
      const GridZone zone = hints_.zone(hint.zone);
      at_u = zone.flat_u + (hint.is_round ? zone.overshoot_u : 0);
      hint.is_top = is_stroke ? hint.is_top : zone.is_top;
    }
  } else {
    at_u = bits.position_u();
  }
  int32_t low_u = at_u;
  int32_t high_u = at_u;
  if (is_stroke) {
    hint.is_standard = bits.flag();
    const int32_t width_u =
        hint.is_standard
            ? hints_.bar_width_u()
            : 2 * static_cast<int32_t>(bits.take(grid::kWidthBits));
    (hint.is_top ? low_u : high_u) += hint.is_top ? -width_u : width_u;
  }
  hint.low_u = low_u;
  hint.high_u = high_u;
  bit_ += bits.used;
  return hint;
}

XHint GlyphHints::next_x() noexcept {
  Bits bits = {window(), 0};
  XHint hint = {};
  hint.is_foot = bits.flag();
  const int32_t left_u = bits.position_u();
  int32_t right_u = left_u;
  if (!hint.is_foot) {
    hint.is_standard = bits.flag();
    right_u += hint.is_standard
                   ? hints_.stem_width_u()
                   : 2 * static_cast<int32_t>(bits.take(grid::kWidthBits));
  }
  hint.left_u = left_u;
  hint.right_u = right_u;
  bit_ += bits.used;
  return hint;
}

}  // namespace inkcell
