// The fields of a leaf, combined. `Field` is what evaluates one: where it needs
// to be told where its leaf or its point lies, that comes with `where`.
#pragma once

#include <stdint.h>

#include "distance/field_leaves.hpp"

namespace inkcell {
namespace detail {

template <typename Field>
struct TwoFields {
  int32_t sign;
  Field a;
  Field b;

  template <typename... Where>
  __attribute__((always_inline)) TwoFields(const FieldLeaf& leaf,
                                           const FieldScale& scale,
                                           const Where&... where) noexcept
      : sign(leaf.sign),
        a(leaf.field[0], where..., scale, sign),
        b(leaf.field[1], where..., scale, sign) {}

  // Calls `what` with each field.
  template <typename What>
  __attribute__((always_inline)) void each(const What& what) noexcept {
    what(a);
    what(b);
  }
  __attribute__((always_inline)) bool is_steady() const noexcept {
    return a.is_steady() && b.is_steady();
  }
  template <typename Number, typename... Where>
  __attribute__((always_inline)) int32_t combined(
      const FieldLeaves& leaves,
      const FieldLeaf& leaf,
      const Number& number,
      const Where&... where) const noexcept {
    const int32_t shift = leaves.bend_shift();
    return with_sign(
        leaves.least_of_two(leaf, a.value(where..., shift, sign),
                            b.value(where..., shift, sign), number),
        sign);
  }
};

template <typename Field>
struct ThreeFields : TwoFields<Field> {
  using TwoFields<Field>::sign;
  using TwoFields<Field>::a;
  using TwoFields<Field>::b;
  Field c;

  template <typename... Where>
  __attribute__((always_inline)) ThreeFields(const FieldLeaf& leaf,
                                             const FieldScale& scale,
                                             const Where&... where) noexcept
      : TwoFields<Field>(leaf, scale, where...),
        c(leaf.field[2], where..., scale, sign) {}

  template <typename What>
  __attribute__((always_inline)) void each(const What& what) noexcept {
    TwoFields<Field>::each(what);
    what(c);
  }
  __attribute__((always_inline)) bool is_steady() const noexcept {
    return TwoFields<Field>::is_steady() && c.is_steady();
  }
  template <typename Number, typename... Where>
  __attribute__((always_inline)) int32_t combined(
      const FieldLeaves& leaves,
      const FieldLeaf& leaf,
      const Number& number,
      const Where&... where) const noexcept {
    const int32_t shift = leaves.bend_shift();
    return with_sign(
        leaves.least_of_three(leaf, a.value(where..., shift, sign),
                              b.value(where..., shift, sign),
                              c.value(where..., shift, sign), number),
        sign);
  }
};

}  // namespace detail
}  // namespace inkcell
