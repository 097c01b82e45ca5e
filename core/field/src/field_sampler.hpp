// Distances and gradients at points that lie close to each other, in the glyph
// and on the screen.
#pragma once

#include <stdint.h>

#include "cell_values.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/style.hpp"
#include "tree.hpp"

namespace inkcell::detail {

// A place in a glyph, from the origin, y up. [u]
struct FieldPlace {
  int64_t x_q16;
  int64_t y_q16;

  void move(const GlyphStep& step, int32_t count) noexcept {
    x_q16 += int64_t{step.x_q16} * count;
    y_q16 += int64_t{step.y_q16} * count;
  }
};

// Keeps the leaf of the last point.
class FieldSampler {
 public:
  explicit FieldSampler(const GlyphField& field) noexcept : tree_{field} {}

  // The leaf of the last point; beyond the grid it is saturated outside, 1 u
  // wide.
  const FieldLeaf& leaf() const noexcept { return leaf_; }

  // Whether the last point's leaf holds all that is so near to it. [u]
  bool has_room(uint32_t reach_q16) const noexcept {
    const auto has = [this, reach_q16](uint32_t place) noexcept {
      return place >= reach_q16 && mask() - place >= reach_q16;
    };
    return is_found_ && has(x_in_leaf()) && has(y_in_leaf());
  }

  // [u] Positive inside.
  int32_t distance_q10(const FieldPlace& at) noexcept;
  Gradient gradient(const FieldPlace& at) noexcept;
  FieldPoint point(const FieldPlace& at) noexcept;

 private:
  void seek(const FieldPlace& at) noexcept;
  uint32_t x_in_leaf() const noexcept { return x_q16_ & mask(); }
  uint32_t y_in_leaf() const noexcept { return y_q16_ & mask(); }
  uint32_t mask() const noexcept { return (1u << (leaf_.size_log2 + 16)) - 1; }

  FieldTree tree_;
  FieldLeaf leaf_ = {nullptr, 0, false};
  uint32_t x_q16_ = 0;  // from the grid's corner
  uint32_t y_q16_ = 0;
  bool is_found_ = false;  // the leaf lies in the grid
};

// How much less than Style::size() a stretched style enlarges the distance
// to an edge of this gradient: |g| over the length of g on the screen. An edge
// at f in the glyph is there at f times that, to first order: exactly where f
// is a plane. [Q15, at most 1]
int32_t gain_q15(const Style& style, const Gradient& gradient) noexcept;

// The distance at a place on the screen, within +-32 px. [px, Q10]
int32_t screen_distance_q10(const Style& style,
                            FieldSampler& sampler,
                            const FieldPlace& at) noexcept;

}  // namespace inkcell::detail
