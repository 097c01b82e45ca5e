// Glyphs for displays of 1 and 2 bits.
#include "inkcell/bilevel.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "effects/mixed_rows.hpp"

namespace inkcell::detail {
namespace {

// Pixels farther from the ink are never drawn. [px, Q8]
constexpr int32_t kMostReach = 256;

void plan_bilevel(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  // Thresholds, and the nearer of two pixels that a stroke passes between.
  constexpr int32_t kLeastReach = 128 + 16;
  if (static_cast<const Bilevel&>(effect).levels <= 2) {
    plan.outside_q8 = 0;
    plan.inside_q8 = 0;
  }
  plan.outside_q8 = max(plan.outside_q8, kLeastReach);
  plan.inside_q8 = max(plan.inside_q8, kLeastReach);
  plan.ink_margin_q8 = max(plan.ink_margin_q8, kMostReach);
  // The pixels that decide about one.
  plan.margin_x = 2;
  plan.margin_y = 2;
}

// From toggles to what is inside, four pixels at a time.
void resolve(const Band& band) noexcept {
  for (int32_t row = 0; row != band.rows; ++row) {
    uint32_t inside = 0;  // all ones: the pixel to the left is
    uint8_t* at = band.row(row);
    for (uint8_t* const end = at + band.stride; at != end; at += 4) {
      constexpr uint32_t kBits = 0x01010101 * kInsideBit;
      const uint32_t word = load_pixels(at);
      uint32_t bits = word & kBits;
      bits ^= bits << 8;
      bits ^= bits << 16;
      bits ^= inside & kBits;
      inside = 0u - (bits >> 24);
      store_pixels(at, (word & ~kBits) | bits);
    }
  }
}

// Lines of pixels through a band: a row's, or a column's.
struct Line {
  int32_t step;      // to the next pixel [bytes]
  int32_t across;    // to the line below or to the right
  uint32_t crossed;  // the bit of an edge between a pixel and the one before
};

class BilevelRow {
 public:
  BilevelRow(const Bilevel& bilevel, const GlyphJob& job) noexcept
      : row_{1, job.band.stride, kCrossedLeft},
        column_{job.band.stride, 1, kCrossedAbove},
        filter_(job.style->filter()),
        step_q8_(static_cast<uint32_t>(job.band.reach_q8) * 1024 / 254),
        threshold_q10_(clamp(bilevel.threshold_px.raw, -512, 512)),
        has_greys_(bilevel.levels > 2),
        is_fitted_(job.style->is_fitted()) {}

  uint8_t coverage(const uint8_t* at) const noexcept {
    if ((*at & kNearnessMask) == 0) {
      return (*at & kInsideBit) != 0 ? 255 : 0;
    }
    const int32_t d = distance_q10(*at);
    uint8_t coverage = d >= threshold_q10_ ? 255 : 0;
    if (has_greys_) {
      coverage = static_cast<uint8_t>((filter_.coverage(d) + 42) / 85 * 85);
    }
    const uint8_t bridge = has_greys_ ? 170 : 255;
    return coverage < bridge && d < threshold_q10_ && is_bridge(at) ? bridge
                                                                    : coverage;
  }

 private:
  // In the middle of a step. [px, Q10]
  int32_t distance_q10(uint32_t byte) const noexcept {
    const auto distance =
        static_cast<int32_t>((251 - (byte & kNearnessMask)) * step_q8_ >> 8);
    return (byte & kInsideBit) != 0 ? distance : -distance;
  }
  bool is_drawn(uint32_t byte) const noexcept {
    return (byte & kNearnessMask) == 0 ? (byte & kInsideBit) != 0
                                       : distance_q10(byte) >= threshold_q10_;
  }

  // Whether a pixel that is not drawn must stand for a stroke. Where strokes
  // were fitted few pass between pixels, and rows come first: what they draw
  // keeps columns from drawing beside it.
  bool is_bridge(const uint8_t* at) const noexcept {
    return is_dot(at) || stands_for_stroke(row_, at) ||
           (stands_for_stroke(column_, at) &&
            !(is_fitted_ && (stands_for_stroke(row_, at - column_.step) ||
                             stands_for_stroke(row_, at + column_.step))));
  }

  // Whether a pixel is nearer to the outline than all eight around it, none of
  // them drawn or inside: the middle of a part of its own.
  bool is_dot(const uint8_t* at) const noexcept {
    const uint8_t* near = at - column_.step - 1;
    for (int32_t i = 0; i != 9; ++i) {
      // Where some are equal, the first is the dot.
      if ((*near & kInsideBit) != 0 || is_drawn(*near) ||
          (*near & kNearnessMask) + (near < at ? 1u : 0u) >
              (*at & kNearnessMask)) {
        return false;
      }
      near += i % 3 == 2 ? column_.step - 2 : 1;
    }
    return true;
  }

  // Whether a pixel is in the middle of a stroke across a line that draws none
  // of its pixels.
  bool stands_for_stroke(const Line& line, const uint8_t* at) const noexcept {
    const uint8_t* const before = at - line.step;
    const uint8_t* const behind = at + line.step;
    if (is_drawn(*at)) {
      return false;
    }
    if ((*at & kInsideBit) != 0) {
      return is_deepest(at, -line.step, false) &&
             is_deepest(at, line.step, true) &&
             has_ink_around(line, at - line.across) &&
             has_ink_around(line, at + line.across);
    }
    if (is_fitted_ && (is_drawn(*before) || is_drawn(*behind))) {
      return false;
    }
    return ((*at & line.crossed) != 0 && is_nearer(*at, *before, false) &&
            is_stroke(line, at, *at, *before)) ||
           ((*behind & line.crossed) != 0 && is_nearer(*at, *behind, true) &&
            is_stroke(line, behind, *at, *behind));
  }

  // Whether what lies between `at` and the pixel before, both outside, is a
  // stroke: not an end of one, as it goes on in both lines beside, nor what
  // grid fitting has flattened, as it leaves less than all of the way between
  // them.
  bool is_stroke(const Line& line,
                 const uint8_t* at,
                 uint32_t byte,
                 uint32_t other) const noexcept {
    constexpr int32_t kWay = 1000;  // a pixel but what nearness is rounded by
    return !is_fitted_ ||
           (distance_q10(byte) + distance_q10(other) > -kWay &&
            has_ink(line, at - line.across) && has_ink(line, at + line.across));
  }

  // Whether the next pixel of a line lies outside, or inside as the last one,
  // not drawn and less deep. Strokes over more pixels are narrow across the
  // other lines.
  bool is_deepest(const uint8_t* at,
                  int32_t step,
                  bool is_first) const noexcept {
    const uint32_t next = at[step];
    const uint32_t own = *at & kNearnessMask;
    return (next & kInsideBit) == 0 ||
           (!is_drawn(next) && (at[2 * step] & kInsideBit) == 0 &&
            (own < (next & kNearnessMask) ||
             (own == (next & kNearnessMask) && is_first)));
  }
  static bool has_ink_around(const Line& line, const uint8_t* at) noexcept {
    return ((at[-line.step] | *at | at[line.step]) &
            (kInsideBit | line.crossed)) != 0;
  }

  static bool has_ink(const Line& line, const uint8_t* at) noexcept {
    return (((at[-line.step] | *at) & (kInsideBit | line.crossed)) |
            (at[line.step] & line.crossed)) != 0;
  }

  // Whether the other pixel lies outside, is not drawn and farther. Of two that
  // are equally near the first one is drawn.
  bool is_nearer(uint32_t byte, uint32_t other, bool is_first) const noexcept {
    const uint32_t nearness = byte & kNearnessMask;
    const uint32_t others = other & kNearnessMask;
    return (other & kInsideBit) == 0 && !is_drawn(other) &&
           (nearness > others || (nearness == others && is_first));
  }

  Line row_;
  Line column_;
  const Filter& filter_;
  uint32_t step_q8_;       // a 254th of the reach [px, Q18]
  int32_t threshold_q10_;  // [px]
  bool has_greys_;
  bool is_fitted_;
};

void mix_bilevel(const Effect& effect, GlyphBand& band) noexcept {
  const auto& job = static_cast<const GlyphJob&>(band);
  resolve(job.band);
  const BilevelRow row(static_cast<const Bilevel&>(effect), job);
  mix_rows(band,
           [&row](const uint8_t* at) noexcept { return row.coverage(at); });
}

}  // namespace

const Mixer kBilevelMixer = {&kCrossingBand, plan_bilevel, mix_bilevel};

}  // namespace inkcell::detail
