#include "inkcell/fit.hpp"

#include "inkcell/format.hpp"
#include "order.hpp"

namespace inkcell {
namespace {

using detail::greater;
using detail::lesser;
using detail::magnitude;

// All lengths are [px, Q6] unless their names say otherwise.
constexpr int32_t kPx = 1 << 6;

// Fractions of an x-height from here on are rounded up: 1/8 px.
constexpr int32_t kRoundUp = kPx - kPx / 8;
// Shorter x-heights are not scaled.
constexpr int32_t kLeastHeight = 96;
// Round edges pass their zone from this much on.
constexpr int32_t kLeastOvershoot = 38;
// Strokes of displays with many levels are no thinner; and the room that is
// left beside bars.
constexpr int32_t kLeastStroke = 48;
// What a bar keeps where three of them have little room.
constexpr int32_t kLeastSqueezed = 32;
// Bars from here on begin at a row; thinner ones stand in the middle of one.
constexpr int32_t kWholeBar = 60;
// By how much a stem's width may differ from whole pixels.
constexpr int32_t kStemShoulder = 16;
// Serifs are whole pixels from this size on, and are left out below.
constexpr int32_t kSerifsFrom = 12 << 6;

constexpr int32_t kMaxStems = 6;

int32_t round_px(int32_t value) noexcept {
  return (value + kPx / 2) & ~(kPx - 1);
}

// A stroke about as wide as most are is as wide as they are.
__attribute__((noinline)) int32_t common_width(int32_t width, int32_t most) noexcept {
  return magnitude(width - most) < greater(16, most * 77 >> 8) ? most : width;
}

int32_t whole_width(int32_t width) noexcept {
  return greater(kPx, round_px(width));
}

}  // namespace

// Fits heights: bars in zones first, then those between them.
class HeightFit {
 public:
  explicit HeightFit(const Fit& fit) noexcept : fit_(fit) {}

  void read(GlyphHints& hints) noexcept;
  void fit_bars() noexcept;
  void fit_ends() noexcept;
  void write(AxisMap& map) const noexcept;

 private:
  // Two knots each, or one.
  static constexpr int32_t kMost = AxisMap::kMaxKnots;

  enum State : uint8_t { kFree, kInZone, kFitted };

  struct Edge {
    int32_t at_u;
    int32_t to;
  };
  struct Item {
    Edge low;
    Edge high;
    YHint::Kind kind;
    State state;
    bool is_top;

    bool is_bar() const noexcept { return kind <= YHint::serif; }
    void set(int32_t to, int32_t width) noexcept {
      low.to = to;
      high.to = to + width;
    }
  };
  // The nearest bars around something.
  struct Room {
    const Item* below = nullptr;
    const Item* above = nullptr;
  };

  bool is_crisp() const noexcept { return fit_.levels_ == 2; }
  int32_t width_of(const Item& item, bool is_standard) const noexcept;
  int32_t height_between(int32_t at_u2) const noexcept;
  Room room_of(const Item& item) const noexcept;
  void fit_bar(Item& item) noexcept;

  const Fit& fit_;
  int32_t count_ = 0;
  Item items_[kMost];
};

int32_t HeightFit::width_of(const Item& item, bool is_standard) const noexcept {
  const int32_t width =
      fit_.height_q6(item.high.at_u) - fit_.height_q6(item.low.at_u);
  if (item.kind == YHint::serif) {
    return !is_crisp() ? width : fit_.drops_serifs_ ? 0 : kPx;
  }
  const int32_t common =
      is_standard ? fit_.bar_q6_ : common_width(width, fit_.bar_q6_);
  return is_crisp() ? whole_width(common) : greater(common, kLeastStroke);
}

void HeightFit::read(GlyphHints& hints) noexcept {
  for (uint32_t i = hints.y_count(); i != 0; --i) {
    const YHint hint = hints.next_y();
    if (count_ == kMost) {
      continue;  // all must be read, as those of x follow
    }
    Item& item = items_[count_++];
    item.low.at_u = hint.low_u;
    item.high.at_u = hint.high_u;
    item.kind = hint.kind;
    item.is_top = hint.is_top;
    item.state = kFree;
    const int32_t width =
        item.is_bar() ? width_of(item, hint.is_standard) : 0;
    int32_t to = 0;
    if (hint.zone < fit_.hints_.zone_count()) {
      const Fit::Zone& zone = fit_.zones_[hint.zone];
      to = hint.is_round ? zone.round_q6 : zone.flat_q6;
      to -= item.is_bar() && item.is_top ? width : 0;
      item.state = kInZone;
    }
    // Of a free bar the width alone counts as yet.
    item.set(to, width);
  }
}

// Where a height goes by what lies in zones. [2 u]
int32_t HeightFit::height_between(int32_t at_u2) const noexcept {
  const Edge* below = nullptr;
  const Edge* above = nullptr;
  const Item* const end = items_ + count_;
  for (const Item* item = items_; item != end; ++item) {
    if (item->state != kInZone) {
      continue;
    }
    for (const Edge* edge = &item->low; edge <= &item->high; ++edge) {
      if (2 * edge->at_u <= at_u2) {
        below = below == nullptr || edge->at_u >= below->at_u ? edge : below;
      } else {
        above = above == nullptr || edge->at_u < above->at_u ? edge : above;
      }
    }
  }
  const Edge* const near = below != nullptr ? below : above;
  const int32_t height = (at_u2 * fit_.y_scale_q16_ + (1 << 16)) >> 17;
  if (near == nullptr) {
    return height;
  }
  if (below == nullptr || above == nullptr) {
    return height + near->to - fit_.height_q6(near->at_u);
  }
  return below->to + (above->to - below->to) * (at_u2 - 2 * below->at_u) /
                         (2 * (above->at_u - below->at_u));
}

// Bars that are not fitted yet leave no limits.
HeightFit::Room HeightFit::room_of(const Item& item) const noexcept {
  Room room;
  const Item* const end = items_ + count_;
  for (const Item* other = items_; other != end; ++other) {
    if (!other->is_bar() || other->state == kFree) {
      continue;
    }
    if (other->high.at_u <= item.low.at_u) {
      if (room.below == nullptr || other->high.to > room.below->high.to) {
        room.below = other;
      }
    } else if (other->low.at_u >= item.high.at_u) {
      if (room.above == nullptr || other->low.to < room.above->low.to) {
        room.above = other;
      }
    }
  }
  return room;
}

// A bar that lies in no zone: in the rows that are nearest and leave a free one
// on both sides, as far as there is room.
void HeightFit::fit_bar(Item& item) noexcept {
  const Room room = room_of(item);
  const int32_t gap = is_crisp() ? kPx : kLeastStroke;
  // Far away where there is none.
  const int32_t floor = room.below == nullptr ? -(1 << 15) : room.below->high.to;
  const int32_t ceiling = room.above == nullptr ? 1 << 15 : room.above->low.to;
  int32_t width = item.high.to - item.low.to;
  int32_t middle = height_between(item.low.at_u + item.high.at_u);
  if (ceiling - floor < width + 2 * gap) {
    width = lesser(width, greater(lesser(width, kLeastSqueezed),
                                  ceiling - floor - 2 * gap));
    middle = (floor + ceiling) >> 1;
  }
  int32_t low;
  if (is_crisp() || width >= kWholeBar) {
    width = is_crisp() ? whole_width(width) : width;
    low = round_px(middle - (width >> 1));
    if (low < floor + gap && low + kPx + width <= ceiling) {
      low += kPx;
    }
    if (low + width > ceiling - gap && low - kPx >= floor) {
      low -= kPx;
    }
  } else {
    low = (middle & ~(kPx - 1)) + ((kPx - width) >> 1);
  }
  low = lesser(greater(low, floor), ceiling - width);
  item.set(low, width);
  item.state = kFitted;
}

void HeightFit::fit_bars() noexcept {
  for (int32_t i = 0; i != count_; ++i) {
    if (items_[i].is_bar() && items_[i].state == kFree) {
      fit_bar(items_[i]);
    }
  }
}

// Free ends keep a row open to the bar that they point to, but no farther than
// to their own.
void HeightFit::fit_ends() noexcept {
  for (int32_t i = 0; i != count_; ++i) {
    Item& item = items_[i];
    if (item.kind != YHint::end) {
      continue;
    }
    const Room room = room_of(item);
    if (room.below == nullptr || room.above == nullptr) {
      continue;
    }
    const Edge& below = room.below->high;
    const Edge& above = room.above->low;
    const int32_t open = above.to - below.to;
    const int32_t whole_u = above.at_u - below.at_u;
    // Whether the map leaves less than a row.
    const int32_t open_u = item.is_top ? above.at_u - item.low.at_u
                                       : item.low.at_u - below.at_u;
    if (open * open_u < kPx * whole_u) {
      const int32_t kept = lesser(kPx, greater(open, 0));
      item.set(item.is_top ? above.to - kept : below.to + kept, 0);
      item.state = kFitted;
    }
  }
}

void HeightFit::write(AxisMap& map) const noexcept {
  const Item* const end = items_ + count_;
  for (const Item* item = items_; item != end; ++item) {
    if (item->state == kFree) {
      continue;
    }
    fit_.add_knot(map, item->low.at_u, item->low.to);
    if (item->is_bar()) {
      fit_.add_knot(map, item->high.at_u, item->high.to);
    }
  }
}

// Fits x: stems to cells of whole pixels, with whole pixels between them.
class AcrossFit {
 public:
  explicit AcrossFit(const Fit& fit) noexcept : fit_(fit) {}

  // The hints of y were read. Returns the advance.
  int32_t fit(const Font& font, uint16_t glyph, GlyphHints& hints) noexcept;
  void write(AxisMap& map) const noexcept;

 private:
  struct Stem {
    int32_t left_u;
    int32_t right_u;
    int32_t cell;   // whole pixels
    int32_t width;  // in the middle of it
  };

  void read(GlyphHints& hints) noexcept;
  int32_t middle_of(const Stem& stem) const noexcept {
    return ((stem.left_u + stem.right_u) * fit_.size_q6_ + (1 << 10)) >> 11;
  }
  void set_gaps() noexcept;
  void make_alike() noexcept;
  int32_t whole_total(bool is_symmetric) const noexcept;

  const Fit& fit_;
  int32_t count_ = 0;
  int32_t left_u_ = 0;  // of the ink
  int32_t right_u_ = 0;
  int32_t first_ = 0;  // where the ink begins
  int32_t total_ = 0;  // and how wide it is; 0: nothing is fitted
  Stem stems_[kMaxStems];
  int32_t gaps_[kMaxStems + 1];  // before each stem and after the last
};

void AcrossFit::read(GlyphHints& hints) noexcept {
  for (uint32_t i = hints.x_count(); i != 0 && count_ != kMaxStems; --i) {
    const XHint hint = hints.next_x();
    if (hint.is_foot ||
        (count_ != 0 && hint.left_u <= stems_[count_ - 1].right_u)) {
      continue;
    }
    const int32_t width =
        hint.is_standard
            ? fit_.stem_q6_
            : common_width(fit_.px_q6(hint.right_u) - fit_.px_q6(hint.left_u),
                           fit_.stem_q6_);
    const int32_t cell = whole_width(width);
    Stem& stem = stems_[count_++];
    stem.left_u = hint.left_u;
    stem.right_u = hint.right_u;
    stem.cell = cell;
    stem.width = fit_.levels_ == 2
                     ? cell
                     : lesser(greater(greater(width, kLeastStroke),
                                      cell - kStemShoulder),
                              cell + kStemShoulder);
  }
}

// Gaps of one kind that differ by little are alike, so that m has two counters
// of one width, and symmetric letters stay symmetric.
void AcrossFit::make_alike() noexcept {
  for (int32_t i = 1; i <= count_; ++i) {
    for (int32_t j = 0; j != i; ++j) {
      const bool is_inner = i != count_;
      if (is_inner == (j == 0)) {
        continue;
      }
      const int32_t difference = magnitude(gaps_[i] - gaps_[j]);
      if (difference < 6 || 25 * difference < 2 * magnitude(gaps_[i])) {
        gaps_[i] = (gaps_[i] + gaps_[j]) >> 1;
        gaps_[j] = gaps_[i];
      }
    }
  }
}

void AcrossFit::set_gaps() noexcept {
  int32_t from = fit_.px_q6(left_u_);
  for (int32_t i = 0; i != count_; ++i) {
    const int32_t middle = middle_of(stems_[i]);
    const int32_t half = stems_[i].cell >> 1;
    gaps_[i] = middle - half - from;
    from = middle + half;
  }
  gaps_[count_] = fit_.px_q6(right_u_) - from;
  make_alike();
  for (int32_t i = 0; i <= count_; ++i) {
    const bool is_inner = i != 0 && i != count_;
    gaps_[i] = greater(round_px(gaps_[i]), is_inner ? kPx : 0);
    total_ += gaps_[i] + (i != count_ ? stems_[i].cell : 0);
  }
}

// Of ink without stems. Symmetric ink has an odd number of pixels if a stem
// has, so that its apex is as wide.
int32_t AcrossFit::whole_total(bool is_symmetric) const noexcept {
  const int32_t width = fit_.px_q6(right_u_) - fit_.px_q6(left_u_);
  int32_t total = whole_width(width);
  const int32_t stem = whole_width(fit_.stem_q6_);
  if (is_symmetric && total > kPx && ((total ^ stem) & kPx) != 0) {
    total += width > total ? kPx : -kPx;
    total = total < 2 * kPx && width > 100 ? 3 * kPx : total;
  }
  return total;
}

int32_t AcrossFit::fit(const Font& font,
                       uint16_t glyph,
                       GlyphHints& hints) noexcept {
  GlyphMetrics metrics;
  if (font.glyph_metrics(glyph, metrics) != Status::ok) {
    return 0;
  }
  // Lines of 64 em, and ink of 4.
  const int32_t advance = fit_.px_q6(fit_.u_of(metrics.advance, 1 << 16));
  if (metrics.x_max <= metrics.x_min || metrics.advance == 0) {
    return round_px(advance);
  }
  left_u_ = fit_.u_of(metrics.x_min, 1 << 12);
  right_u_ = fit_.u_of(metrics.x_max, 1 << 12);
  const int32_t insets = hints.left_inset_u() + hints.right_inset_u();
  if (fit_.drops_serifs_ && insets < right_u_ - left_u_) {
    left_u_ += hints.left_inset_u();
    right_u_ -= hints.right_inset_u();
  }
  read(hints);
  if (count_ != 0) {
    set_gaps();
  } else {
    total_ = whole_total(hints.is_symmetric());
  }
  const int32_t left = fit_.px_q6(left_u_);
  const int32_t right = advance - fit_.px_q6(right_u_);
  // A column is free to the left of all glyphs but those that overhang.
  const int32_t overhang = -fit_.px_q6(10);
  first_ = round_px(left);
  if (left > overhang) {
    first_ = greater(kPx, first_);
  }
  int32_t after = right;
  if (right > 0) {
    after -= greater(0, first_ - left) >> 1;
  }
  after = round_px(after);
  if (left > overhang && right > overhang) {
    after = greater(after, 0);
  }
  return greater(first_ + total_ + after, 0);
}

void AcrossFit::write(AxisMap& map) const noexcept {
  if (total_ == 0) {
    return;
  }
  // Ends of the ink that are a stem's own need no knots.
  constexpr int32_t kNear_u = 4;
  int32_t at = first_;
  if (count_ == 0 || stems_[0].left_u >= left_u_ + kNear_u) {
    fit_.add_knot(map, left_u_, at);
  }
  for (int32_t i = 0; i != count_; ++i) {
    const Stem& stem = stems_[i];
    at += gaps_[i];
    const int32_t shoulder = (stem.cell - stem.width) >> 1;
    fit_.add_knot(map, stem.left_u, at + shoulder);
    fit_.add_knot(map, stem.right_u, at + shoulder + stem.width);
    at += stem.cell;
  }
  if (count_ == 0 || right_u_ > stems_[count_ - 1].right_u + kNear_u) {
    fit_.add_knot(map, right_u_, first_ + total_);
  }
}

// Font units, at most `limit` u of them.
int32_t Fit::u_of(int32_t units, int32_t limit) const noexcept {
  const auto u = static_cast<int32_t>(
      (int64_t{units} * u_per_unit_q14_ + (1 << 13)) >> 14);
  return lesser(greater(u, -limit), limit);
}

void Fit::add_knot(AxisMap& map, int32_t at_u, int32_t to_q6) const noexcept {
  const int32_t from_q8 = (at_u * size_q6_ + (1 << 7)) >> 8;
  static_cast<void>(map.add(
      from_q8, from_q8 + ((to_q6 * 4 - from_q8) * strength_q8_ >> 8)));
}

void Fit::set_zones() noexcept {
  y_scale_q16_ = size_q6_ * (1 << 6);
  const uint32_t count = hints_.zone_count();
  if (hints_.x_zone() < count) {
    const int32_t natural = px_q6(hints_.zone(hints_.x_zone()).flat_u);
    if (natural >= kLeastHeight) {
      const int32_t fitted = (natural + kRoundUp) & ~(kPx - 1);
      // At most 40 px, and half as much more.
      y_scale_q16_ = static_cast<int32_t>(static_cast<uint32_t>(size_q6_) * 64 *
                                          static_cast<uint32_t>(fitted) /
                                          static_cast<uint32_t>(natural));
    }
  }
  for (uint32_t i = 0; i != count; ++i) {
    const GridZone read = hints_.zone(i);
    const int32_t flat = round_px(height_q6(read.flat_u));
    const int32_t beyond = px_q6(read.overshoot_u);
    zones_[i] = {static_cast<int16_t>(flat),
                 static_cast<int16_t>(
                     flat + (magnitude(beyond) < kLeastOvershoot ? 0 : beyond)),
                 read.is_top};
  }
}

void Fit::set_weight() noexcept {
  // Half of what a stem gains. [px, Q10]
  int32_t more = (whole_width(stem_q6_) - stem_q6_) * 8;
  if (hints_.has_contrast()) {
    more = lesser(greater(more, 0), 51);
  }
  crisp_weight_q10_ =
      static_cast<int16_t>(-lesser(greater(more, -256), 123));
}

Status Fit::make(const Font& font,
                 const Brush& brush,
                 const FitOptions& options,
                 Fit& out) noexcept {
  if (options.strength_q8 > FitOptions::kAll ||
      (options.levels != 0 && options.levels != 2 && options.levels != 4)) {
    return Status::bad_argument;
  }
  Fit fit;
  INKCELL_TRY(GridHints::open(font, fit.hints_));
  const int32_t size_q6 = brush.size().raw;
  if (size_q6 < kEnds.raw) {
    uint32_t strength = options.strength_q8;
    if (options.levels == 0 && size_q6 > kFades.raw) {
      strength = strength * static_cast<uint32_t>(kEnds.raw - size_q6) /
                 static_cast<uint32_t>(kEnds.raw - kFades.raw);
    }
    fit.strength_q8_ = static_cast<uint16_t>(strength);
  }
  if (fit.strength_q8_ != 0) {
    fit.size_q6_ = size_q6;
    fit.levels_ = options.levels;
    fit.is_across_ = options.across && !fit.hints_.empty();
    fit.drops_serifs_ = options.levels == 2 && size_q6 < kSerifsFrom;
    fit.u_per_unit_q14_ = static_cast<int32_t>((uint32_t{1024} << 14) /
                                               font.units_per_em());
    fit.stem_q6_ = fit.px_q6(fit.hints_.stem_width_u());
    fit.bar_q6_ = fit.px_q6(fit.hints_.bar_width_u());
    fit.set_zones();
    if (fit.hints_.stem_width_u() != 0) {
      fit.set_weight();
    }
  }
  out = fit;
  return Status::ok;
}

void Fit::fit(const Font& font,
              uint16_t glyph,
              FinePoint& origin,
              GlyphWarp& warp) const noexcept {
  warp.clear();
  if (strength_q8_ == 0) {
    return;
  }
  const auto to_grid_q10 = [this](int64_t at_q10) noexcept {
    const auto part = static_cast<int32_t>((at_q10 + 512) & 1023) - 512;
    return at_q10 - (part * strength_q8_ >> 8);
  };
  // The baseline lies between two rows.
  origin.y_q10 = to_grid_q10(origin.y_q10);
  GlyphHints hints(hints_, glyph);
  if (!hints.empty()) {
    HeightFit heights(*this);
    heights.read(hints);
    heights.fit_bars();
    heights.fit_ends();
    heights.write(warp.y);
  }
  if (is_across_) {
    origin.x_q10 = to_grid_q10(origin.x_q10);
    AcrossFit across(*this);
    static_cast<void>(across.fit(font, glyph, hints));
    across.write(warp.x);
  }
}

int32_t Fit::advance_px(const Font& font, uint16_t glyph) const noexcept {
  GlyphHints hints(hints_, glyph);
  for (uint32_t i = hints.y_count(); i != 0; --i) {
    static_cast<void>(hints.next_y());
  }
  return AcrossFit(*this).fit(font, glyph, hints) >> 6;
}

namespace {

void fit_glyph(const Font& font,
               uint16_t glyph,
               const void* options,
               FinePoint& origin,
               GlyphWarp& warp) noexcept {
  static_cast<const Fit*>(options)->fit(font, glyph, origin, warp);
}
bool has_advances(const void* options) noexcept {
  return static_cast<const Fit*>(options)->has_advances();
}
int32_t advance_px(const Font& font,
                   uint16_t glyph,
                   const void* options) noexcept {
  return static_cast<const Fit*>(options)->advance_px(font, glyph);
}

}  // namespace

const Fitter kGridFit = {fit_glyph, has_advances, advance_px};

}  // namespace inkcell
