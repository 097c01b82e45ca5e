// Rows of samples: which of them have distances.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/bytes.hpp"
#include "base/math.hpp"

namespace inkcell::detail {

/// A sample without a distance: it is too far outside.
inline constexpr int8_t kOutside = -128;

/// Samples [first, end). Empty if first >= end.
struct KnownSpan {
  int32_t first;
  int32_t end;
};

/// The smallest span that holds both.
inline KnownSpan united(const KnownSpan& a, const KnownSpan& b) noexcept {
  return {min(a.first, b.first), max(a.end, b.end)};
}

/// The span with `by` more samples on both sides, in a row of `width`. An empty
/// one stays empty.
inline KnownSpan grown(const KnownSpan& a, int32_t by, int32_t width) noexcept {
  return {max(a.first - by, 0), a.end == 0 ? 0 : min(a.end + by, width)};
}

/// Sets the samples of a row outside of a span to kOutside.
inline void clear_around(const KnownSpan& span,
                         int8_t* row,
                         int32_t width) noexcept {
  const int32_t first = min(span.first, width);
  const int32_t end = max(span.end, first);
  __builtin_memset(row, kOutside, static_cast<size_t>(first));
  __builtin_memset(row + end, kOutside, static_cast<size_t>(width - end));
}

/// The span of a row of `width` samples; {width, 0} if there is none. Reads
/// four samples at a time.
inline KnownSpan known_span(const int8_t* row, int32_t width) noexcept {
  constexpr uint32_t kFourOutside = 0x80808080;
  const auto word = [&](int32_t x) {
    return load_any_u32(reinterpret_cast<const uint8_t*>(row + x));
  };
  KnownSpan span = {0, width};
  while (span.first + 4 <= width && word(span.first) == kFourOutside) {
    span.first += 4;
  }
  while (span.first < width && row[span.first] == kOutside) {
    ++span.first;
  }
  if (span.first == width) {
    return {width, 0};
  }
  while (span.end >= span.first + 4 && word(span.end - 4) == kFourOutside) {
    span.end -= 4;
  }
  while (row[span.end - 1] == kOutside) {
    --span.end;
  }
  return span;
}

/// That of several rows, as far as they are in the grid.
template <typename Grid>
KnownSpan known_span(const Grid& grid,
                     int32_t first_row,
                     int32_t last_row) noexcept {
  KnownSpan span = {grid.width(), 0};
  last_row = min(last_row, grid.height() - 1);
  for (int32_t row = max(first_row, 0); row <= last_row; ++row) {
    span = united(span, known_span(grid.row(row), grid.width()));
  }
  return span;
}

}  // namespace inkcell::detail
