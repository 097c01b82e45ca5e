// A view of consecutive elements: the only way a buffer enters the library.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/assert.hpp"

namespace inkcell {

/// A pointer and a count. Owns nothing: the memory must outlive the view.
/// Standard layout, two words.
template <typename T>
struct Span {
  T* data = nullptr;
  size_t size = 0;  // elements

  constexpr Span() noexcept = default;
  constexpr Span(T* first, size_t count) noexcept : data(first), size(count) {}
  template <size_t kCount>
  constexpr Span(T (&array)[kCount]) noexcept : data(array), size(kCount) {}

  /// A view of mutable elements serves as a view of constant ones.
  constexpr operator Span<const T>() const noexcept { return {data, size}; }

  /// i < size.
  constexpr T& operator[](size_t i) const noexcept {
    INKCELL_ASSERT(i < size);
    return data[i];
  }
  constexpr T* begin() const noexcept { return data; }
  constexpr T* end() const noexcept { return data + size; }
};

}  // namespace inkcell
