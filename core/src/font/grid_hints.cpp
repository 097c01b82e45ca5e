#include "inkcell/grid_hints.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

namespace grid = format::grid;

// Zones beyond this are read as this. [u]
constexpr int32_t kFarthestZone = 2048;

// [2 u -> u]
int32_t position_u(uint32_t at) noexcept {
  return grid::kPositionBase + grid::kPositionStep * static_cast<int32_t>(at);
}
// Of any height, as gaps count from there. [u -> 2 u]
uint32_t position_of(int32_t at_u) noexcept {
  return static_cast<uint32_t>(at_u - grid::kPositionBase) >> 1;
}

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
  const uint32_t code_bits = at[grid::kCodeBits];
  if (zones > grid::kMaxZones || code_bits > grid::kMaxCodeBits ||
      grid::kBytes + grid::kZoneBytes * zones +
              (2 * grid::kTables << code_bits) >
          section.size) {
    return Status::corrupt;
  }
  // Member by member: smaller than to copy a whole one.
  out.section_ = at;
  out.code_bits_ = static_cast<uint8_t>(code_bits);
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
  const uint8_t* const at = section_ + grid::kBytes + grid::kZoneBytes * i;
  return {detail::clamp(detail::load_i16(at + grid::kZoneFlat), -kFarthestZone,
                        kFarthestZone),
          static_cast<int8_t>(at[grid::kZoneOvershoot]),
          (at[grid::kZoneFlags] & grid::kTopZone) != 0};
}

static_assert(GlyphHints::kMostY == grid::kHeightCountMask &&
                  GlyphHints::kMostX == grid::kStemCountMask,
              "as many as can be stored");

GlyphHints::GlyphHints(const GridHints& hints,
                       const Span<const uint8_t>& record) noexcept
    : hints_(hints),
      end_(record.end()),
      size_(static_cast<uint32_t>(record.size)) {
  if (hints.empty() || size_ == 0) {
    return;
  }
  const uint8_t* const section = hints.section_;
  y_at_ = uint32_t{section[grid::kFirstY]} << grid::kFirstShift;
  x_at_ = uint32_t{section[grid::kFirstX]} << grid::kFirstShift;
  static_assert(
      kYShift == grid::kHeightCountShift && kSymmetric == grid::kSymmetric,
      "as they are stored");
  head_ = take(grid::kHeads);
  if ((head_ & grid::kHasInsets) != 0) {
    constexpr uint32_t kMask = (1u << grid::kInsetBits) - 1;
    const uint32_t bits = window();
    left_inset_u_ = static_cast<uint8_t>(2 * (bits & kMask));
    right_inset_u_ =
        static_cast<uint8_t>(2 * (bits >> grid::kInsetBits & kMask));
    bit_ += 2 * grid::kInsetBits;
  }
}

// 25 bits at least, from the lowest on; 0 beyond the record. Three bytes before
// it may be read: a header lies before all records.
uint32_t GlyphHints::window() const noexcept {
  const uint32_t first = bit_ / 8;
  if (first >= size_) {
    return 0;
  }
  return __builtin_bswap32(detail::load_any_u32(end_ - first - 4)) >> bit_ % 8;
}

// The number of the next code word.
uint32_t GlyphHints::take(uint32_t table) noexcept {
  const uint32_t bits = window();
  const uint32_t code_bits = hints_.code_bits_;
  const uint32_t word = bits & ~(~0u << code_bits);
  const uint8_t* const words =
      hints_.section_ + grid::kBytes + grid::kZoneBytes * hints_.zone_count_;
  const uint32_t entry =
      detail::load_u16(words + 2 * ((table << code_bits) + word));
  const uint32_t length = entry & grid::kLengthMask;
  const uint32_t extra = entry >> grid::kExtraShift & grid::kExtraMask;
  bit_ += length + extra;
  return (entry >> grid::kBaseShift) + (bits >> length & ~(~0u << extra));
}

// [u]
int32_t GlyphHints::take_width(uint32_t table, bool& is_standard) noexcept {
  const uint32_t stored = take(table) & grid::kWidthMask;
  is_standard = stored == 0;
  if (stored != 0) {
    return static_cast<int32_t>(2 * stored);
  }
  return table == grid::kWidthsY ? hints_.bar_width_u() : hints_.stem_width_u();
}

YHint GlyphHints::next_y() noexcept {
  YHint hint;
  const uint32_t what = take(grid::kHeights);
  hint.kind =
      static_cast<YHint::Kind>(what >> grid::kKindShift & grid::kKindMask);
  hint.is_top = (what & grid::kTop) != 0;
  hint.is_round = (what & grid::kRound) != 0;
  const bool is_stroke = hint.kind <= YHint::serif;
  const uint32_t zone = what >> grid::kZoneShift & grid::kZoneMask;
  hint.zone = static_cast<uint8_t>(zone - 1);  // kNoZone is -1
  int32_t at_u = 0;
  if (zone == 0) {
    at_u = position_u((y_at_ + take(grid::kGapsY)) & grid::kPositionMask);
  } else if (zone <= hints_.zone_count()) {
    const GridZone read = hints_.zone(zone - 1);
    at_u = read.flat_u + (hint.is_round ? read.overshoot_u : 0);
    hint.is_top = is_stroke ? hint.is_top : read.is_top;
  }
  hint.is_standard = false;
  int32_t width_u = 0;
  if (is_stroke) {
    width_u = take_width(grid::kWidthsY, hint.is_standard);
  }
  hint.low_u = at_u - (hint.is_top ? width_u : 0);
  hint.high_u = hint.low_u + width_u;
  y_at_ = position_of(hint.low_u);
  return hint;
}

XHint GlyphHints::next_x() noexcept {
  XHint hint;
  hint.left_u = position_u((x_at_ + take(grid::kGapsX)) & grid::kPositionMask);
  hint.right_u = hint.left_u + take_width(grid::kWidthsX, hint.is_standard);
  x_at_ = position_of(hint.right_u);
  return hint;
}

}  // namespace inkcell
