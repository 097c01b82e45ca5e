#include "inkcell/fit.hpp"

#include "hint_bytes.hpp"
#include "order.hpp"

namespace inkcell {
namespace {

using detail::greater;
using detail::lesser;
using detail::magnitude;

constexpr int32_t kPx = 1 << 10;  // [Q10]

// What passes a zone by less than this is cut off.
constexpr int32_t kLeastOvershoot = 614;  // 0.6 px

// Upper zones go up rather than down, by up to 5/8 px: what is a little too
// high reads better than what is too low.
constexpr int32_t kPreferUp = 128;

// Strokes up to this wide become one row.
constexpr int32_t kOneRow = 1280;  // 1.25 px

// Wider ones become whole rows if they need not change by more.
constexpr int32_t kMostWidening = 256;

// Free space between two strokes that is left when there was more.
constexpr int32_t kLeastGap = 768;

// Stems move a glyph by no more. [px]
constexpr int32_t kMostSideways = 256;

// Wider ones are not moved.
constexpr int32_t kWidestStem = 2560;

int32_t round_px(int32_t value_q10) noexcept {
  return (value_q10 + kPx / 2) & ~(kPx - 1);
}

// How high a stroke is drawn.
int32_t fitted_width(int32_t width_q10) noexcept {
  if (width_q10 <= kOneRow) {
    return kPx;
  }
  const int32_t whole = round_px(width_q10);
  return magnitude(whole - width_q10) <= kMostWidening ? whole : width_q10;
}

// [u -> px, Q10]
int32_t to_px_q10(int32_t u, const Brush& brush) noexcept {
  return (u * brush.size().raw) >> 6;
}

}  // namespace

// The edges of one glyph on their way to the grid.
class GlyphFit {
 public:
  // The baseline is moved down by `lowered_q10` px.
  GlyphFit(const Fit& fit, const Brush& brush, int32_t lowered_q10) noexcept
      : fit_(fit),
        size_q6_(brush.size().raw),
        least_shift_q10_(greater(lowered_q10, 0) - RowMap::kMaxShiftQ10),
        shifts_q10_(2 * RowMap::kMaxShiftQ10 - magnitude(lowered_q10)) {}

  void read(Span<const uint8_t> edges) noexcept;
  void fit_bars() noexcept;
  void separate() noexcept;
  void map(RowMap& rows) const noexcept;

  bool has_bars() const noexcept { return has_bars_; }
  bool has_twins() const noexcept { return has_twins_; }

 private:
  struct Edge {
    int32_t glyph_q10;
    int32_t screen_q10;
    uint8_t zone;  // and 1
    uint8_t top;   // of the bar that begins here; 0: none does
    bool is_fixed;
  };

  // Whether an edge that goes there moves, with the baseline, no farther than
  // 1 px.
  bool is_near(const Edge& edge, int32_t screen_q10) const noexcept {
    const int32_t above = screen_q10 - edge.glyph_q10 - least_shift_q10_;
    return static_cast<uint32_t>(above) <= static_cast<uint32_t>(shifts_q10_);
  }
  void fix(Edge& edge, int32_t screen_q10) noexcept {
    if (is_near(edge, screen_q10)) {
      edge.screen_q10 = screen_q10;
      edge.is_fixed = true;
    }
  }
  bool meets_next(uint32_t edge) const noexcept {
    return edges_[edge].zone != 0 &&
           edges_[edge].zone == edges_[edge + 1].zone &&
           edges_[edge].screen_q10 >=
               edges_[edge + 1].screen_q10 - RowMap::kLeastStepQ10;
  }
  uint32_t top_of(uint32_t bottom) const noexcept;
  static int32_t shift_at(const Edge* below,
                          const Edge* above,
                          int32_t height_q10) noexcept;
  static bool has_room(const Edge* below,
                       const Edge* above,
                       const Edge& bottom,
                       const Edge& top,
                       int32_t bottom_q10,
                       int32_t top_q10) noexcept;
  void fit_free_bar(Edge& bottom, Edge& top) noexcept;

  const Fit& fit_;
  int32_t size_q6_;
  int32_t least_shift_q10_;  // of edges, and how much more they may move
  int32_t shifts_q10_;
  uint32_t count_ = 0;
  bool has_bars_ = false;
  bool has_twins_ = false;  // neighbours of one zone
  Edge edges_[RowMap::kMaxKnots];
};

// Edges of zones know where they go.
void GlyphFit::read(Span<const uint8_t> edges) noexcept {
  const Hints& hints = fit_.hints_;
  const uint8_t* const levels = hints.section_.data + format::hints::kBytes;
  uint32_t zone_below = 0;
  Edge* edge = edges_;
  for (const uint8_t byte : edges) {
    const HintEdge read = detail::hint_edge(byte);
    if (read.level >= hints.level_count() ||
        edge == edges_ + RowMap::kMaxKnots) {
      break;
    }
    const HintLevel level = detail::hint_level(levels, read.level);
    const int32_t glyph_q10 = (level.height_u * size_q6_) >> 6;
    edge->glyph_q10 = glyph_q10;
    edge->screen_q10 = glyph_q10;
    edge->top = read.is_bar ? 1 : 0;
    edge->is_fixed = false;
    edge->zone = 0;
    has_bars_ |= read.is_bar;
    if (level.zone != 0 && level.zone <= hints.zone_count()) {
      edge->zone = static_cast<uint8_t>(level.zone);
      has_twins_ |= level.zone == zone_below;
      const int32_t zone_q10 = fit_.zones_q10_[level.zone - 1];
      const int32_t beyond = glyph_q10 - zone_q10;
      const bool is_cut = magnitude(beyond) < kLeastOvershoot;
      const int32_t aim_q10 =
          zone_q10 + (fit_.is_bottom(level.zone) ? 0 : kPreferUp);
      fix(*edge, round_px(aim_q10) + (is_cut ? 0 : round_px(beyond)));
    }
    zone_below = edge->zone;
    ++edge;
  }
  count_ = static_cast<uint32_t>(edge - edges_);
}

// The upper edge of a bar: the next one that is not of the same zone, or the
// outermost of its zone. 0: there is none.
uint32_t GlyphFit::top_of(uint32_t bottom) const noexcept {
  uint32_t top = bottom + 1;
  if (has_twins_) {
    while (top < count_ && edges_[top].zone != 0 &&
           edges_[top].zone == edges_[bottom].zone) {
      ++top;
    }
    while (top + 1 < count_ && edges_[top].zone != 0 &&
           edges_[top + 1].zone == edges_[top].zone) {
      ++top;
    }
  }
  return top < count_ ? top : 0;
}

void GlyphFit::fit_bars() noexcept {
  bool has_free = false;
  for (uint32_t i = 0; i < count_; ++i) {
    Edge& bottom = edges_[i];
    if (bottom.top == 0) {
      continue;
    }
    bottom.top = static_cast<uint8_t>(top_of(i));
    Edge& top = edges_[bottom.top];
    if (bottom.top == 0 || bottom.is_fixed == top.is_fixed) {
      has_free |= !bottom.is_fixed;
      continue;
    }
    const int32_t width = fitted_width(top.glyph_q10 - bottom.glyph_q10);
    if (bottom.is_fixed) {
      fix(top, bottom.screen_q10 + width);
    } else {
      fix(bottom, top.screen_q10 - width);
    }
  }
  for (uint32_t i = 0; has_free && i < count_; ++i) {
    Edge& bottom = edges_[i];
    if (bottom.top != 0 && !bottom.is_fixed && !edges_[bottom.top].is_fixed) {
      fit_free_bar(bottom, edges_[bottom.top]);
    }
  }
}

// By how much the glyph is moved at a height between two edges, either of which
// may be missing.
int32_t GlyphFit::shift_at(const Edge* below,
                           const Edge* above,
                           int32_t height_q10) noexcept {
  const int32_t low =
      below == nullptr ? 0 : below->screen_q10 - below->glyph_q10;
  const int32_t high =
      above == nullptr ? low : above->screen_q10 - above->glyph_q10;
  if (below == nullptr || above == nullptr) {
    return high;
  }
  const int32_t way = above->glyph_q10 - below->glyph_q10;
  // Shifts stay below 2^11 and heights below 2^18, whatever the bytes.
  return way <= 0 ? low
                  : low + (high - low) * (height_q10 - below->glyph_q10) / way;
}

// Whether a bar can be drawn from `bottom_q10` on, and some of the free space
// below and above it is left.
bool GlyphFit::has_room(const Edge* below,
                        const Edge* above,
                        const Edge& bottom,
                        const Edge& top,
                        int32_t bottom_q10,
                        int32_t top_q10) noexcept {
  return (below == nullptr ||
          bottom_q10 - below->screen_q10 >=
              lesser(kLeastGap, bottom.glyph_q10 - below->glyph_q10)) &&
         (above == nullptr ||
          above->screen_q10 - top_q10 >=
              lesser(kLeastGap, above->glyph_q10 - top.glyph_q10));
}

// A bar that belongs to no zone goes to the nearest rows that have room for
// it, or stays where what is around it moves it.
void GlyphFit::fit_free_bar(Edge& bottom, Edge& top) noexcept {
  const Edge* below = &bottom;
  while (below != edges_ && !below->is_fixed) {
    --below;
  }
  below = below->is_fixed ? below : nullptr;
  const Edge* above = &top;
  while (above != edges_ + count_ && !above->is_fixed) {
    ++above;
  }
  above = above != edges_ + count_ ? above : nullptr;
  const int32_t middle = (bottom.glyph_q10 + top.glyph_q10) >> 1;
  const int32_t width = fitted_width(top.glyph_q10 - bottom.glyph_q10);
  const int32_t target = middle + shift_at(below, above, middle) - (width >> 1);
  int32_t place = round_px(target);
  if (!has_room(below, above, bottom, top, place, place + width)) {
    place += target < place ? -kPx : kPx;
    if (!has_room(below, above, bottom, top, place, place + width)) {
      return;
    }
  }
  fix(bottom, place);
  fix(top, place + width);
}

// Edges of one zone that meet keep a step's distance; the outermost one stays.
void GlyphFit::separate() noexcept {
  for (uint32_t i = 1; i < count_; ++i) {
    if (meets_next(i - 1) && fit_.is_bottom(edges_[i].zone)) {
      edges_[i].screen_q10 = edges_[i - 1].screen_q10 + RowMap::kLeastStepQ10;
    }
  }
  for (uint32_t i = count_; i-- > 1;) {
    if (meets_next(i - 1)) {
      edges_[i - 1].screen_q10 = edges_[i].screen_q10 - RowMap::kLeastStepQ10;
    }
  }
  for (uint32_t i = 0; i < count_; ++i) {
    edges_[i].is_fixed &= is_near(edges_[i], edges_[i].screen_q10);
  }
}

void GlyphFit::map(RowMap& rows) const noexcept {
  const Edge* const end = edges_ + count_;
  for (const Edge* edge = edges_; edge != end; ++edge) {
    if (edge->is_fixed) {
      const int32_t shift = edge->screen_q10 - edge->glyph_q10;
      static_cast<void>(
          rows.add(edge->glyph_q10 + fit_.weakened(shift), edge->glyph_q10));
    }
  }
}

Status Fit::make(const Font& font,
                 const Brush& brush,
                 const FitOptions& options,
                 Fit& out) noexcept {
  if (options.strength_q8 > FitOptions::kAll) {
    return Status::bad_argument;
  }
  Fit fit;
  INKCELL_TRY(Hints::open(font, fit.hints_));
  const int32_t size_q6 = brush.size().raw;
  fit.strength_q8_ = options.strength_q8;
  if (size_q6 >= kEnds.raw) {
    fit.strength_q8_ = 0;
  } else if (size_q6 > kFades.raw) {
    fit.strength_q8_ = static_cast<uint16_t>(
        options.strength_q8 * (kEnds.raw - size_q6) / (kEnds.raw - kFades.raw));
  }
  if (fit.strength_q8_ == 0) {
    out = fit;
    return Status::ok;
  }
  for (uint32_t i = 0; i < fit.hints_.zone_count(); ++i) {
    const HintZone zone = fit.hints_.zone(i);
    fit.zones_q10_[i] = to_px_q10(zone.height_u, brush);
    if (zone.is_bottom) {
      fit.bottoms_ |= 2u << i;
    }
  }
  const int32_t stem = to_px_q10(fit.hints_.stem_width_u(), brush);
  if (options.stems && stem <= kWidestStem) {
    fit.stem_q10_ = static_cast<uint16_t>(stem);
  }
  out = fit;
  return Status::ok;
}

// By how much to move the glyph so that its stems stand well in their pixels:
// the mean of what each would take.
int32_t Fit::sideways_q10(uint32_t glyph,
                          const Brush& brush,
                          const FinePoint& origin) const noexcept {
  const HintStems stems = hints_.stems(glyph);
  if (stems.count == 0) {
    return 0;
  }
  // The middle of a stem of an even number of pixels lies between two of them.
  const bool is_even = (round_px(stem_q10_) & kPx) == 0 && stem_q10_ > kPx / 2;
  const int32_t aim = is_even ? 0 : kPx / 2;
  int32_t first = 0;
  int32_t sum = 0;
  for (int32_t i = 0; i < stems.count; ++i) {
    const int32_t middle = to_px_q10(stems.first_u + i * stems.gap_u, brush);
    const auto place = static_cast<int32_t>(origin.x_q10 & (kPx - 1));
    int32_t move = aim - place - middle;
    move = ((move + kPx / 2 - first) & (kPx - 1)) - kPx / 2 + first;
    first = i == 0 ? move : first;
    sum += move;
  }
  int32_t mean = sum / stems.count;
  mean = ((mean + kPx / 2) & (kPx - 1)) - kPx / 2;
  mean = mean > kMostSideways ? kMostSideways : mean;
  return mean < -kMostSideways ? -kMostSideways : mean;
}

void fit_glyph(uint16_t glyph,
               const Brush& brush,
               const void* fit,
               FinePoint& origin,
               RowMap& rows) noexcept {
  const Fit& style = *static_cast<const Fit*>(fit);
  if (style.strength_q8_ == 0 || brush.size().raw >= Fit::kEnds.raw) {
    return;
  }
  // The baseline lies between two rows.
  const auto below = static_cast<int32_t>((origin.y_q10 + kPx / 2) & (kPx - 1));
  const int32_t lowered = kPx / 2 - below;
  origin.y_q10 += style.weakened(lowered);
  if (style.hints_.empty()) {
    return;
  }
  Span<const uint8_t> edges;
  if (!style.hints_.edges(glyph, edges)) {
    return;
  }
  if (style.stem_q10_ != 0) {
    origin.x_q10 += style.weakened(style.sideways_q10(glyph, brush, origin));
  }
  GlyphFit edges_fit(style, brush, lowered);
  edges_fit.read(edges);
  if (edges_fit.has_bars()) {
    edges_fit.fit_bars();
  }
  if (edges_fit.has_twins()) {
    edges_fit.separate();
  }
  edges_fit.map(rows);
}

}  // namespace inkcell
