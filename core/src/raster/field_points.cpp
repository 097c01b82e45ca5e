// Cells of primitives in pixel order. A leaf is kept while points lie in its
// square; its fields are evaluated at each of them from their records, so that
// only their values are on the stack.
#include "raster/field_points.hpp"

#include "distance/field_leaves.hpp"
#include "distance/point_terms.hpp"

namespace inkcell {
namespace detail {
namespace {

class Points : public FieldLeaves {
 public:
  using FieldLeaves::FieldLeaves;
  using FieldLeaves::find_leaf;

  // The distance at leaf.place. [px, Q22]
  int32_t distance(const FieldLeaf& leaf) const noexcept {
    int32_t values[3];
    const uint32_t count = evaluate(leaf, values);
    // Two are three of which one is never the least.
    const int32_t least =
        count == 1
            ? values[0]
            : least_of_three(leaf, values[0], values[1],
                             count == 2 ? INT32_MAX : values[2], RowNumber{0});
    return with_sign(least, leaf.sign);
  }

 private:
  // What the fields say there, with the leaf's sign. Returns how many of them
  // matter; if it is one, the first value.
  //
  // Not inline: what it needs of the stack is free again when a vertex is
  // rounded.
  __attribute__((noinline)) uint32_t evaluate(const FieldLeaf& leaf,
                                              int32_t* values) const noexcept {
    for (uint32_t i = 0; i < leaf.count; ++i) {
      const ArcAt term(leaf.field[i], scale_, leaf.sign);
      const int32_t value = term.value(leaf.place, bend_shift(), leaf.sign);
      values[i] = value;
      if (value <= -reach_q22_ && (i == 0 || !leaf.is_nested)) {
        values[0] = value;
        return 1;
      }
    }
    return leaf.count;
  }
};

}  // namespace

// Not inline: all rows share it.
__attribute__((noinline)) void draw_points(const GlyphField& field,
                                           const TextStyle& style,
                                           const Stretching* stretching,
                                           SlantedPoint& at,
                                           Range row,
                                           SpanWriter& writer) noexcept {
  const Points points(field, scale_of(style), reach_of(style.filter()));
  const GlyphStep& right = style.right();
  int32_t x = row.begin;
  while (x < row.end) {
    FieldLeaf leaf;
    points.find_leaf(at.x_q16 >> 16, at.y_q16 >> 16, leaf);
    const uint32_t log2 = uint32_t{leaf.size_log2} + 16;
    const uint32_t column = at.x_q16 >> log2;
    const uint32_t line = at.y_q16 >> log2;
    do {
      uint8_t coverage = leaf.count == 0 && leaf.is_inside ? 255 : 0;
      if (leaf.count != 0) {
        leaf.place = {q8_of(at.x_q20), q8_of(at.y_q20)};
        const int32_t distance_q22 =
            stretching == nullptr
                ? points.distance(leaf)
                : stretching->value(*stretching, points, leaf, leaf.place);
        coverage = style.filter().coverage(distance_q22 >> 12);
      }
      writer.put(x, coverage);
      at.go(right);
      ++x;
    } while (x < row.end && at.x_q16 >> log2 == column &&
             at.y_q16 >> log2 == line);
  }
}

}  // namespace detail
}  // namespace inkcell
