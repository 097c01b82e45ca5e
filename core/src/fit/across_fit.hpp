// Fits x: stems to cells of whole pixels, with whole pixels between them.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "fit/fit_units.hpp"
#include "inkcell/fit.hpp"

namespace inkcell {
namespace detail {

// The most that a stem's width may differ from whole pixels.
constexpr int32_t kStemShoulder = 16;
static_assert(kPx - kStemShoulder >= kLeastStroke, "cells are a pixel");

class AcrossFit {
 public:
  explicit AcrossFit(const Fit& fit) noexcept : fit_(fit) {}

  // Call after the hints of y were read. Returns the advance.
  int32_t fit(const GlyphMetrics& metrics, GlyphHints& hints) noexcept;
  void write(AxisMap& map) const noexcept;

 private:
  // A stem, or an end of the ink as a stem without a width.
  struct Stem {
    int32_t gap;    // before the cell
    int32_t cell;   // whole pixels
    int32_t width;  // centred in the cell
    int16_t left_u;
    int16_t right_u;
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
  // Includes both ends of the ink; none: nothing is fitted.
  Stem* end_ = stems_;
  Stem stems_[GlyphHints::kMostX + 2];
};

inline void AcrossFit::add(int32_t left_u,
                           int32_t right_u,
                           int32_t cell,
                           int32_t width) noexcept {
  Stem* const stem = end_;
  stem->left_u = static_cast<int16_t>(left_u);
  stem->right_u = static_cast<int16_t>(right_u);
  stem->cell = cell;
  stem->width = width;
  end_ = stem + 1;
}

inline void AcrossFit::read(GlyphHints& hints) noexcept {
  for (uint32_t i = hints.x_count(); i != 0; --i) {
    const XHint hint = hints.next_x();
    if (end_ != stems_ + 1 && hint.left_u <= end_[-1].right_u) {
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
      // No thinner than kLeastStroke.
      width = min(max(width, cell - kStemShoulder), cell + kStemShoulder);
    }
    add(hint.left_u, hint.right_u, cell, width);
  }
}

// Sets the gaps to the design's. Returns where the ink ends.
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

// Makes gaps of one kind that differ by little equal: both counters of an m
// have one width, symmetric letters stay symmetric.
inline void AcrossFit::make_alike() noexcept {
  Stem* const last = end_ - 1;
  for (Stem* one = stems_ + 2; one <= last; ++one) {
    // Either at the ends of the ink, or between stems.
    Stem* other = one == last ? stems_ + 1 : stems_ + 2;
    do {
      const int32_t difference = abs(one->gap - other->gap);
      if (difference < 6 || 25 * difference < 2 * abs(one->gap)) {
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
  int32_t least = 0;  // 0 at both ends of the ink, else a pixel
  Stem* const last = end_ - 1;
  for (Stem* stem = stems_ + 1; stem <= last; ++stem) {
    stem->gap = max(round_px(stem->gap), stem != last ? least : 0);
    total += stem->gap + stem->cell;
    least = kPx;
  }
  return total;
}

// The width of ink without stems. If the glyph is symmetric and stems are odd,
// it is odd too, so that its apex is as wide.
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
  // The left column is free in all glyphs but those that overhang.
  const int32_t overhang = -fit_.px_q6(10);
  int32_t first = round_px(left);
  if (left > overhang) {
    first = max(kPx, first);
  }
  stems_[0].gap = first;
  int32_t after = right;
  if (right > 0) {
    after -= max(0, first - left) >> 1;
  }
  after = round_px(after);
  if (left > overhang && right > overhang) {
    after = max(after, 0);
  }
  return max(first + total + after, 0);
}

inline void AcrossFit::write(AxisMap& map) const noexcept {
  // Ends of the ink that coincide with a stem's edge need no knots.
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

}  // namespace detail
}  // namespace inkcell
