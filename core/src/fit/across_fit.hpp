// Fits x: stems to cells of whole pixels, with whole pixels between them, and
// the ink into the advance.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "fit/fit_units.hpp"
#include "inkcell/fit.hpp"

namespace inkcell::detail {

// The most that a stem's width may differ from whole pixels.
constexpr int32_t kStemShoulder = 16;
static_assert(kPx - kStemShoulder >= kLeastStroke, "cells are a pixel");

// What is free beside a glyph at least: of an overhang half a pixel less, in
// whole pixels.
inline int32_t least_room(int32_t room, int32_t least) noexcept {
  constexpr int32_t kHalf = kPx / 2;
  return room > -kHalf ? least : -((-room - kHalf) & ~(kPx - 1));
}

class AcrossFit {
 public:
  explicit AcrossFit(const Fit& fit) noexcept : fit_(fit) {}

  // Call after the hints of y were read. `advance` is whole.
  void fit(const GlyphMetrics& metrics,
           int32_t whole,
           GlyphHints& hints) noexcept {
    const int32_t advance = fit_.px_q6(fit_.u_of(metrics.advance));
    if (metrics.x_max <= metrics.x_min || metrics.advance == 0) {
      return;
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
    right_.designed_q6 = advance - set_gaps();
    left_.designed_q6 = stems_[0].gap;
    // The left column is free in all glyphs but those that overhang.
    const int32_t before = least_room(left_.designed_q6, kPx);
    const bool is_symmetric = hints.is_symmetric();
    const int32_t after = least_room(right_.designed_q6, 0);
    const int32_t most =
        max(whole - before - after, least_ink(is_symmetric, right_u - left_u));
    int32_t total = 0;
    if (is_stemless) {
      total = whole_ink(is_symmetric, most);
    } else {
      total = whole_gaps();
      if (!fit_.drops_serifs_) {
        stems_[1].added += left_inset_u != 0 ? kSerif : 0;
        end_[-1].added += right_inset_u != 0 ? kSerif : 0;
      }
      squeeze(is_symmetric, most, total);
    }
    // The middle of the ink stays where it is, as far as there is room. Halves,
    // and what is near, are behind it, so that letters alike begin alike.
    const int32_t free = whole - total;
    const int32_t middle = round_px(
        ((free + left_.designed_q6 - right_.designed_q6) >> 1) - kPx / 4);
    const int32_t last = free - after;
    left_.fitted_q6 = max(min(middle, last), min(before, max(last, 0)));
    right_.fitted_q6 = free - left_.fitted_q6;
    stems_[0].gap = left_.fitted_q6;
  }

  void write(AxisMap& map) const noexcept {
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

  // Free columns beside the ink, and what they are as designed.
  const FitGap& left() const noexcept { return left_; }
  const FitGap& right() const noexcept { return right_; }

 private:
  // A stem, or an end of the ink as a stem without a width.
  struct Stem {
    int32_t gap;    // before the cell
    int32_t added;  // to the design's
    int32_t cell;   // whole pixels
    int32_t width;  // centred in the cell
    int16_t left_u;
    int16_t right_u;
  };

  void add(int32_t left_u,
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

  void read(GlyphHints& hints) noexcept {
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
      // No thinner than kLeastStroke.
      width = min(max(width, cell - shoulder()), cell + shoulder());
      add(hint.left_u, hint.right_u, cell, width);
    }
  }

  // Sets the gaps to the design's. Returns where the ink ends.
  int32_t set_gaps() noexcept {
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
  void make_alike() noexcept {
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
  int32_t whole_gaps() noexcept {
    make_alike();
    int32_t total = 0;
    int32_t least = 0;  // 0 at both ends of the ink, else a pixel
    Stem* const last = end_ - 1;
    for (Stem* stem = stems_ + 1; stem <= last; ++stem) {
      stem->added = stem->gap;
      stem->gap = max(round_px(stem->gap), stem != last ? least : 0);
      stem->added = stem->gap - stem->added;
      total += stem->gap + stem->cell;
      least = kPx;
    }
    return total;
  }

  // Two dots or bars side by side need a pixel each, and one between them.
  int32_t least_ink(bool is_symmetric, int32_t width_u) const noexcept {
    return fit_.levels_ == 2 && is_symmetric && fit_.px_q6(width_u) > kPx
               ? 3 * kPx
               : kPx;
  }

  // The width of ink without stems. If the glyph is symmetric and stems are
  // odd, it is odd too, so that its apex is as wide; with greys only if there
  // is room.
  int32_t whole_ink(bool is_symmetric, int32_t most) noexcept {
    const int32_t width = stems_[1].gap;
    int32_t total = whole_width(width);
    const int32_t stem = whole_width(fit_.stem_q6_);
    int32_t step = kPx;
    if (is_symmetric && total > kPx) {
      step = fit_.levels_ == 2 ? 2 * kPx : kPx;
      if (((total ^ stem) & kPx) != 0) {
        total += width > total ? kPx : -kPx;
        total = total < 2 * kPx && width > 100 ? 3 * kPx : total;
      }
    }
    while (total > max(most, step)) {
      total -= step;
    }
    stems_[1].gap = total;
    return total;
  }

  // Takes a pixel from the gap that gained most, and from those like it. False:
  // all are narrow.
  bool narrow_gap(bool is_symmetric, int32_t& total) noexcept {
    Stem* const last = end_ - 1;
    const auto is_end = [&](const Stem* stem) noexcept {
      return stem == stems_ + 1 || stem == last;
    };
    const Stem* most = nullptr;
    for (const Stem* stem = stems_ + 1; stem <= last; ++stem) {
      if (stem->gap > (is_end(stem) ? 0 : kPx) &&
          (most == nullptr || stem->added > most->added)) {
        most = stem;
      }
    }
    if (most == nullptr) {
      return false;
    }
    const bool is_outer = is_end(most);
    const int32_t gap = most->gap;
    for (Stem* stem = stems_ + 1; stem <= last; ++stem) {
      if (stem == most ||
          (stem->gap == gap && is_end(stem) == is_outer &&
           (is_symmetric || !is_outer || stem->added > kSerif / 2))) {
        stem->gap -= kPx;
        stem->added -= kPx;
        total -= kPx;
      }
    }
    return true;
  }

  // Takes a pixel from the widest stems. False: all are a pixel.
  bool narrow_cells(int32_t& total) noexcept {
    int32_t most = kPx;
    for (const Stem* stem = stems_; stem != end_; ++stem) {
      most = max(most, stem->cell);
    }
    for (Stem* stem = stems_; most != kPx && stem != end_; ++stem) {
      if (stem->cell == most) {
        stem->cell -= kPx;
        stem->width = min(stem->width, stem->cell + shoulder());
        total -= kPx;
      }
    }
    return most != kPx;
  }

  // Makes the ink no wider than `most`.
  void squeeze(bool is_symmetric, int32_t most, int32_t& total) noexcept {
    while (total > most) {
      if (!narrow_gap(is_symmetric, total) && !narrow_cells(total)) {
        break;
      }
    }
    // Too many stems for whole pixels.
    if (total > most) {
      const auto part = [&](int32_t length) noexcept {
        return length * max(most, 0) / total;
      };
      for (Stem* stem = stems_ + 1; stem != end_; ++stem) {
        stem->gap = part(stem->gap);
        stem->cell = part(stem->cell);
        stem->width = part(stem->width);
      }
      total = max(most, 0);
    }
  }

  // Gaps of serifs are `added` to by this, so that they become narrow first.
  static constexpr int32_t kSerif = 1 << 12;

  bool has_stems() const noexcept { return end_ > stems_ + 2; }
  int32_t shoulder() const noexcept {
    return fit_.levels_ == 2 ? 0 : kStemShoulder;
  }

  const Fit& fit_;
  FitGap left_ = {0, 0};
  FitGap right_ = {0, 0};
  // Includes both ends of the ink; none: nothing is fitted.
  Stem* end_ = stems_;
  Stem stems_[GlyphHints::kMostX + 2];
};

}  // namespace inkcell::detail
