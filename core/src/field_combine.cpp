#include "field_combine.hpp"

namespace inkcell {
namespace detail {

// The lesser of the values of fields i and j, rounded at their vertex: what is
// rarely needed is set up again.
int32_t rounded_at(const FieldPage& page,
                   const LeafFields& leaf,
                   uint32_t i,
                   uint32_t j,
                   const int32_t* values,
                   PixelPlace place) noexcept {
  const auto gradient = [&page, place](uint32_t unit) noexcept {
    return gradient_q14(page.field, unit, place.x_q8, place.y_q8, page.scale);
  };
  return rounded_q22(values[i], gradient(leaf.units[i]), values[j],
                     gradient(leaf.units[j]));
}

// The lesser of two values, rounded where that changes coverage.
inline int32_t least_of(const FieldPage& page,
                        const LeafFields& leaf,
                        uint32_t i,
                        uint32_t j,
                        const int32_t* values,
                        PixelPlace place) noexcept {
  if (values[i] > values[j]) {
    const uint32_t other = i;
    i = j;
    j = other;
  }
  const int32_t lesser = values[i];
  // Where the greater one is farther from 0 no vertex is near.
  if (lesser < 0 && lesser > -page.reach_q22 && lesser + values[j] < 0) {
    return rounded_at(page, leaf, i, j, values, place);
  }
  return lesser;
}

// The distance of a leaf of two or three fields from their values, which may be
// changed.
int32_t combined(const FieldPage& page,
                 const LeafFields& leaf,
                 int32_t* values,
                 PixelPlace place) noexcept {
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.is_nested) {
    values[1] = with_sign(values[1], -1);
    values[2] = with_sign(values[2], -1);
    const int32_t inner =
        with_sign(least_of(page, leaf, 1, 2, values, place), -1);
    second = values[1] <= values[2] ? 1 : 2;
    values[second] = inner;
  } else if (leaf.count == 3) {
    if (values[0] > values[1] && values[0] > values[2]) {
      first = 1;  // without the greatest
      second = 2;
    } else if (values[1] > values[2]) {
      second = 2;
    }
  }
  return least_of(page, leaf, first, second, values, place);
}

}  // namespace detail
}  // namespace inkcell
