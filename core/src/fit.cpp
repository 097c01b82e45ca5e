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

// Bends whose control points were moved are fuller. [px, Q10]
constexpr int32_t kFuller = 30;

int32_t round_px(int32_t value) noexcept {
  return (value + kPx / 2) & ~(kPx - 1);
}

// A stroke about as wide as most are is as wide as they are.
__attribute__((noinline)) int32_t common_width(int32_t width,
                                               int32_t most) noexcept {
  return magnitude(width - most) < greater(16, most * 77 >> 8) ? most : width;
}

__attribute__((noinline)) int32_t whole_width(int32_t width) noexcept {
  return greater(kPx, round_px(width));
}

}  // namespace

// The functions of these classes are `inline` for the linker: the compiler can
// then drop those that it joins to their only caller.

// Fits heights: bars in zones first, then those between them.
class HeightFit {
 public:
  explicit HeightFit(const Fit& fit) noexcept : fit_(fit) {}

  void read(GlyphHints& hints) noexcept;
  void fit_free() noexcept;
  void write(AxisMap& map) const noexcept;

 private:
  enum State : uint8_t { kFree, kInZone, kFitted };

  struct Edge {
    int32_t at_u;
    int32_t to;
  };
  struct Item {
    Edge edges[2];
    YHint::Kind kind;
    State state;
    bool is_top;

    bool is_bar() const noexcept { return kind <= YHint::serif; }
    const Edge& low() const noexcept { return edges[0]; }
    const Edge& high() const noexcept { return edges[1]; }
    void set(int32_t to, int32_t width) noexcept {
      edges[0].to = to;
      edges[1].to = to + width;
    }
  };
  // Between the nearest bars around something. Of a bar that there is not the
  // place in the glyph is unset.
  struct Room {
    Edge floor;
    Edge ceiling;

    int32_t height() const noexcept { return ceiling.to - floor.to; }
  };
  // Where there is no bar: farther away than any is. No two bars are half as
  // far from each other.
  static constexpr int32_t kFar = 1 << 15;

  bool is_crisp() const noexcept { return fit_.levels_ == 2; }
  int32_t width_of(const YHint& hint) const noexcept;
  int32_t height_between(int32_t at_u2) const noexcept;
  Room room_of(const Item& item) const noexcept;
  void fit_bar(Item& item) noexcept;
  void fit_end(Item& item) noexcept;

  const Fit& fit_;
  Item* end_ = items_;
  Item items_[GlyphHints::kMostY];
};

inline int32_t HeightFit::width_of(const YHint& hint) const noexcept {
  const bool is_serif = hint.kind == YHint::serif;
  int32_t width = fit_.bar_q6_;
  if (is_serif || !hint.is_standard) {
    width = fit_.height_q6(hint.high_u) - fit_.height_q6(hint.low_u);
    if (is_serif) {
      return !is_crisp() ? width : fit_.drops_serifs_ ? 0 : kPx;
    }
    width = common_width(width, fit_.bar_q6_);
  }
  return is_crisp() ? whole_width(width) : greater(width, kLeastStroke);
}

inline void HeightFit::read(GlyphHints& hints) noexcept {
  for (uint32_t i = hints.y_count(); i != 0; --i) {
    const YHint hint = hints.next_y();
    Item& item = *end_++;
    item.edges[0].at_u = hint.low_u;
    item.edges[1].at_u = hint.high_u;
    item.kind = hint.kind;
    item.is_top = hint.is_top;
    item.state = kFree;
    const int32_t width = item.is_bar() ? width_of(hint) : 0;
    int32_t to = 0;
    if (hint.zone < fit_.hints_.zone_count()) {
      const Fit::Zone& zone = fit_.zones_[hint.zone];
      to = hint.is_round ? zone.round_q6 : zone.flat_q6;
      if (hint.is_top) {
        to -= width;
      }
      item.state = kInZone;
    }
    // Of a free bar the width alone counts as yet.
    item.set(to, width);
  }
}

// Where a height goes by what lies in zones. [2 u]
inline int32_t HeightFit::height_between(int32_t at_u2) const noexcept {
  const Edge* below = nullptr;
  const Edge* above = nullptr;
  for (const Item* item = items_; item != end_; ++item) {
    if (item->state != kInZone) {
      continue;
    }
    for (const Edge& edge : item->edges) {
      if (2 * edge.at_u <= at_u2) {
        below = below == nullptr || edge.at_u >= below->at_u ? &edge : below;
      } else {
        above = above == nullptr || edge.at_u < above->at_u ? &edge : above;
      }
    }
  }
  const Edge* const near = below != nullptr ? below : above;
  if (below != nullptr && above != nullptr) {
    return below->to + (above->to - below->to) * (at_u2 - 2 * below->at_u) /
                           (2 * (above->at_u - below->at_u));
  }
  const int32_t height = (at_u2 * fit_.y_scale_q16_ + (1 << 16)) >> 17;
  return near == nullptr ? height
                         : height + near->to - fit_.height_q6(near->at_u);
}

// Bars that are not fitted yet leave no limits.
inline HeightFit::Room HeightFit::room_of(const Item& item) const noexcept {
  Room room;
  room.floor.to = -kFar;
  room.ceiling.to = kFar;
  for (const Item* other = items_; other != end_; ++other) {
    if (!other->is_bar() || other->state == kFree) {
      continue;
    }
    if (other->high().at_u <= item.low().at_u) {
      if (other->high().to > room.floor.to) {
        room.floor = other->high();
      }
    } else if (other->low().at_u >= item.high().at_u) {
      if (other->low().to < room.ceiling.to) {
        room.ceiling = other->low();
      }
    }
  }
  return room;
}

// A bar that lies in no zone: in the rows that are nearest and leave a free one
// on both sides, as far as there is room.
inline void HeightFit::fit_bar(Item& item) noexcept {
  const Room room = room_of(item);
  const int32_t gap = is_crisp() ? kPx : kLeastStroke;
  const int32_t floor = room.floor.to;
  const int32_t ceiling = room.ceiling.to;
  const int32_t left = room.height() - 2 * gap;
  int32_t width = item.high().to - item.low().to;
  int32_t middle = height_between(item.low().at_u + item.high().at_u);
  if (left < width) {
    width = lesser(width, greater(kLeastSqueezed, left));
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

// A free end keeps a row open to the bar that it points to, but no farther than
// to its own.
inline void HeightFit::fit_end(Item& item) noexcept {
  const Room room = room_of(item);
  const int32_t open = room.height();
  if (open >= kFar / 2) {
    return;
  }
  const int32_t whole_u = room.ceiling.at_u - room.floor.at_u;
  // Whether the map leaves less than a row.
  const int32_t open_u = item.is_top ? room.ceiling.at_u - item.low().at_u
                                     : item.low().at_u - room.floor.at_u;
  if (open * open_u < kPx * whole_u) {
    const int32_t kept = lesser(kPx, greater(open, 0));
    item.set(item.is_top ? room.ceiling.to - kept : room.floor.to + kept, 0);
    item.state = kFitted;
  }
}

// Ends when all bars are fitted.
inline void HeightFit::fit_free() noexcept {
  for (Item* item = items_; item != end_; ++item) {
    if (item->is_bar() && item->state == kFree) {
      fit_bar(*item);
    }
  }
  for (Item* item = items_; item != end_; ++item) {
    if (item->kind == YHint::end) {
      fit_end(*item);
    }
  }
}

inline void HeightFit::write(AxisMap& map) const noexcept {
  for (const Item* item = items_; item != end_; ++item) {
    if (item->state == kFree) {
      continue;
    }
    fit_.add_knot(map, item->low().at_u, item->low().to);
    if (item->is_bar()) {
      fit_.add_knot(map, item->high().at_u, item->high().to);
    }
  }
}

// Fits x: stems to cells of whole pixels, with whole pixels between them.
class AcrossFit {
 public:
  explicit AcrossFit(const Fit& fit) noexcept : fit_(fit) {}

  // The hints of y were read. Returns the advance.
  int32_t fit(const GlyphMetrics& metrics, GlyphHints& hints) noexcept;
  void write(AxisMap& map) const noexcept;

 private:
  // Or an end of the ink, which is a stem without a width.
  struct Stem {
    int32_t left_u;
    int32_t right_u;
    int32_t cell;   // whole pixels
    int32_t width;  // in the middle of it
    int32_t gap;    // before the cell
  };

  void add(int32_t left_u,
           int32_t right_u,
           int32_t cell,
           int32_t width) noexcept;
  void read(GlyphHints& hints) noexcept;
  int32_t set_gaps() noexcept;
  void make_alike() noexcept;
  int32_t whole_gaps() noexcept;
  int32_t whole_ink(bool is_symmetric) noexcept;

  bool has_stems() const noexcept { return end_ > stems_ + 2; }

  const Fit& fit_;
  // With both ends of the ink; none: nothing is fitted.
  Stem* end_ = stems_;
  Stem stems_[GlyphHints::kMostX + 2];
};

inline void AcrossFit::add(int32_t left_u,
                           int32_t right_u,
                           int32_t cell,
                           int32_t width) noexcept {
  Stem* const stem = end_;
  stem->left_u = left_u;
  stem->right_u = right_u;
  stem->cell = cell;
  stem->width = width;
  end_ = stem + 1;
}

inline void AcrossFit::read(GlyphHints& hints) noexcept {
  for (uint32_t i = hints.x_count(); i != 0; --i) {
    const XHint hint = hints.next_x();
    if (hint.is_foot ||
        (end_ != stems_ + 1 && hint.left_u <= end_[-1].right_u)) {
      continue;
    }
    int32_t width = fit_.stem_q6_;
    if (!hint.is_standard) {
      width = common_width(fit_.px_q6(hint.right_u) - fit_.px_q6(hint.left_u),
                           width);
    }
    const int32_t cell = whole_width(width);
    if (fit_.levels_ == 2) {
      width = cell;
    } else {
      width =
          lesser(greater(greater(width, kLeastStroke), cell - kStemShoulder),
                 cell + kStemShoulder);
    }
    add(hint.left_u, hint.right_u, cell, width);
  }
}

// As designed. Returns where the ink ends.
inline int32_t AcrossFit::set_gaps() noexcept {
  int32_t from = 0;
  for (Stem* stem = stems_; stem != end_; ++stem) {
    const int32_t middle =
        ((stem->left_u + stem->right_u) * fit_.size_q6_ + (1 << 10)) >> 11;
    const int32_t half = stem->cell >> 1;
    stem->gap = middle - half - from;
    from = middle + half;
  }
  return from;
}

// Gaps of one kind that differ by little are alike, so that m has two counters
// of one width, and symmetric letters stay symmetric.
inline void AcrossFit::make_alike() noexcept {
  Stem* const last = end_ - 1;
  for (Stem* one = stems_ + 2; one <= last; ++one) {
    // At the ends of the ink, or between stems.
    Stem* other = one == last ? stems_ + 1 : stems_ + 2;
    do {
      const int32_t difference = magnitude(one->gap - other->gap);
      if (difference < 6 || 25 * difference < 2 * magnitude(one->gap)) {
        one->gap = (one->gap + other->gap) >> 1;
        other->gap = one->gap;
      }
      ++other;
    } while (one != last && other < one);
  }
}

// Returns the width of the ink.
inline int32_t AcrossFit::whole_gaps() noexcept {
  make_alike();
  int32_t total = 0;
  int32_t least = 0;  // where the ink begins and ends
  Stem* const last = end_ - 1;
  for (Stem* stem = stems_ + 1; stem <= last; ++stem) {
    stem->gap = greater(round_px(stem->gap), stem != last ? least : 0);
    total += stem->gap + stem->cell;
    least = kPx;
  }
  return total;
}

// Of ink without stems. Symmetric ink has an odd number of pixels if a stem
// has, so that its apex is as wide.
inline int32_t AcrossFit::whole_ink(bool is_symmetric) noexcept {
  const int32_t width = stems_[1].gap;
  int32_t total = whole_width(width);
  const int32_t stem = whole_width(fit_.stem_q6_);
  if (is_symmetric && total > kPx && ((total ^ stem) & kPx) != 0) {
    total += width > total ? kPx : -kPx;
    total = total < 2 * kPx && width > 100 ? 3 * kPx : total;
  }
  stems_[1].gap = total;
  return total;
}

inline int32_t AcrossFit::fit(const GlyphMetrics& metrics,
                              GlyphHints& hints) noexcept {
  const int32_t advance = fit_.px_q6(fit_.u_of(metrics.advance));
  if (metrics.x_max <= metrics.x_min || metrics.advance == 0) {
    return round_px(advance);
  }
  int32_t left_u = fit_.u_of(metrics.x_min);
  int32_t right_u = fit_.u_of(metrics.x_max);
  const int32_t left_inset_u = hints.left_inset_u();
  const int32_t right_inset_u = hints.right_inset_u();
  if (fit_.drops_serifs_ && left_inset_u + right_inset_u < right_u - left_u) {
    left_u += left_inset_u;
    right_u -= right_inset_u;
  }
  add(left_u, left_u, 0, 0);
  read(hints);
  add(right_u, right_u, 0, 0);
  const bool is_stemless = !has_stems();
  const int32_t right = advance - set_gaps();
  const int32_t total =
      is_stemless ? whole_ink(hints.is_symmetric()) : whole_gaps();
  const int32_t left = stems_[0].gap;
  // A column is free to the left of all glyphs but those that overhang.
  const int32_t overhang = -fit_.px_q6(10);
  int32_t first = round_px(left);
  if (left > overhang) {
    first = greater(kPx, first);
  }
  stems_[0].gap = first;
  int32_t after = right;
  if (right > 0) {
    after -= greater(0, first - left) >> 1;
  }
  after = round_px(after);
  if (left > overhang && right > overhang) {
    after = greater(after, 0);
  }
  return greater(first + total + after, 0);
}

inline void AcrossFit::write(AxisMap& map) const noexcept {
  // Ends of the ink that are a stem's own need no knots.
  constexpr int32_t kNear_u = 4;
  const Stem* stem = stems_;
  const Stem* end = end_;
  int32_t at = 0;
  if (has_stems()) {
    if (stem[1].left_u < stem->left_u + kNear_u) {
      at = stem->gap;
      ++stem;
    }
    if (end[-1].left_u <= end[-2].right_u + kNear_u) {
      --end;
    }
  }
  for (; stem != end; ++stem) {
    at += stem->gap;
    const int32_t left = at + ((stem->cell - stem->width) >> 1);
    at += stem->cell;
    fit_.add_knot(map, stem->left_u, left);
    if (stem->width != 0) {
      fit_.add_knot(map, stem->right_u, left + stem->width);
    }
  }
}

// Font units, at most 64 em of them.
inline int32_t Fit::u_of(int32_t units) const noexcept {
  constexpr int32_t kMost_u = 1 << 16;
  // In two parts, as the product may pass 2^31.
  const int32_t whole = units * (u_per_unit_q14_ >> 14);
  const int32_t part = units * (u_per_unit_q14_ & ((1 << 14) - 1));
  const int32_t u = whole + ((part + (1 << 13)) >> 14);
  return lesser(greater(u, -kMost_u), kMost_u);
}

inline void Fit::add_knot(AxisMap& map,
                          int32_t at_u,
                          int32_t to_q6) const noexcept {
  const int32_t from_q8 = (at_u * size_q6_ + (1 << 7)) >> 8;
  static_cast<void>(
      map.add(from_q8, from_q8 + ((to_q6 * 4 - from_q8) * strength_q8_ >> 8)));
}

inline void Fit::set_zones() noexcept {
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
                 static_cast<int16_t>(magnitude(beyond) < kLeastOvershoot
                                          ? flat
                                          : flat + beyond)};
  }
}

inline void Fit::set_weight() noexcept {
  if (hints_.stem_width_u() == 0) {
    return;
  }
  // Half of what a stem gains. [px, Q10]
  const int32_t more = (whole_width(stem_q6_) - stem_q6_) * 8;
  const int32_t weight = hints_.has_contrast()
                             ? lesser(greater(more, 0), 51)
                             : lesser(greater(more - kFuller, -256), 123);
  crisp_weight_q10_ = static_cast<int16_t>(-weight);
}

Status Fit::make(const Font& font,
                 const Brush& brush,
                 const FitOptions& options,
                 Fit& out) noexcept {
  if (options.strength_q8 > FitOptions::kAll || options.levels > 4 ||
      options.levels % 2 != 0) {
    return Status::bad_argument;
  }
  INKCELL_TRY(GridHints::open(font, out.hints_));
  out.is_across_ = false;
  out.strength_q8_ = 0;
  out.crisp_weight_q10_ = 0;
  const int32_t size_q6 = brush.size().raw;
  if (size_q6 >= kEnds.raw) {
    return Status::ok;
  }
  uint32_t strength = options.strength_q8;
  if (options.levels == 0 && size_q6 > kFades.raw) {
    strength = strength * static_cast<uint32_t>(kEnds.raw - size_q6) /
               static_cast<uint32_t>(kEnds.raw - kFades.raw);
  }
  if (strength != 0) {
    out.levels_ = options.levels;
    out.is_across_ = options.across && !out.hints_.empty();
    out.drops_serifs_ = options.levels == 2 && size_q6 < kSerifsFrom;
    out.strength_q8_ = static_cast<uint16_t>(strength);
    out.size_q6_ = size_q6;
    out.u_per_unit_q14_ =
        static_cast<int32_t>((uint32_t{1024} << 14) / font.units_per_em());
    out.stem_q6_ = out.px_q6(out.hints_.stem_width_u());
    out.bar_q6_ = out.px_q6(out.hints_.bar_width_u());
    out.set_zones();
    out.set_weight();
  }
  return Status::ok;
}

// A place to the nearest pixel.
__attribute__((noinline)) void Fit::to_grid(int64_t& at_q10) const noexcept {
  const int32_t part =
      static_cast<int32_t>((static_cast<uint32_t>(at_q10) + 512) & 1023) - 512;
  at_q10 -= part * strength_q8_ >> 8;
}

// The functions of both fitters.
class GridFit {
 public:
  static void fit(uint16_t glyph,
                  const GlyphMetrics& metrics,
                  const void* options,
                  FinePoint& origin,
                  GlyphWarp& warp) noexcept {
    const Fit& fit = *static_cast<const Fit*>(options);
    GlyphHints hints(fit.hints_, glyph);
    fit_heights(fit, hints, origin, warp);
    if (fit.is_across_) {
      fit.to_grid(origin.x_q10);
      static_cast<void>(fit_across(fit, metrics, hints, &warp.x));
    }
  }

  static void heights(uint16_t glyph,
                      const GlyphMetrics&,
                      const void* options,
                      FinePoint& origin,
                      GlyphWarp& warp) noexcept {
    const Fit& fit = *static_cast<const Fit*>(options);
    GlyphHints hints(fit.hints_, glyph);
    fit_heights(fit, hints, origin, warp);
  }

  static bool has_advances(const void* options) noexcept {
    return static_cast<const Fit*>(options)->has_advances();
  }
  static bool has_none(const void*) noexcept { return false; }

  static int32_t advance_px(const Font& font,
                            uint16_t glyph,
                            const void* options) noexcept {
    const Fit& fit = *static_cast<const Fit*>(options);
    GlyphHints hints(fit.hints_, glyph);
    for (uint32_t i = hints.y_count(); i != 0; --i) {
      static_cast<void>(hints.next_y());
    }
    GlyphMetrics metrics;
    static_cast<void>(font.glyph_metrics(glyph, metrics));
    return fit_across(fit, metrics, hints, nullptr) >> 6;
  }

 private:
  // Each apart, so that one has the stack while the other does not run.
  __attribute__((noinline)) static void fit_heights(const Fit& fit,
                                                    GlyphHints& hints,
                                                    FinePoint& origin,
                                                    GlyphWarp& warp) noexcept {
    warp.clear();
    if (fit.strength_q8_ == 0) {
      return;
    }
    // The baseline lies between two rows.
    fit.to_grid(origin.y_q10);
    HeightFit heights(fit);
    heights.read(hints);
    heights.fit_free();
    heights.write(warp.y);
  }

  // Without a map for the advance alone, which it returns.
  __attribute__((noinline)) static int32_t fit_across(
      const Fit& fit,
      const GlyphMetrics& metrics,
      GlyphHints& hints,
      AxisMap* map) noexcept {
    AcrossFit across(fit);
    const int32_t advance = across.fit(metrics, hints);
    if (map != nullptr) {
      across.write(*map);
    }
    return advance;
  }
};

const Fitter kGridFit = {GridFit::fit, GridFit::has_advances,
                         GridFit::advance_px};
const Fitter kFitHeights = {GridFit::heights, GridFit::has_none, nullptr};

}  // namespace inkcell
