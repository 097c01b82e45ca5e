// Samples: what one covers, and which of a row have distances, that is, are
// not kOutside.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "limits.hpp"

namespace inkcell::kinetic {

/// The coverage of a sample's square: it stands for the middle of its step.
/// [1/64]
inline int32_t coverage_of(int8_t sample) noexcept {
  return clamp(2 * sample + 33, 0, 64);
}

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
  __builtin_memset(row, DistanceGrid::kOutside, static_cast<size_t>(first));
  __builtin_memset(row + end, DistanceGrid::kOutside,
                   static_cast<size_t>(width - end));
}

/// The span of a row of `width` samples; {width, 0} if there is none. Reads
/// four samples at a time.
inline KnownSpan known_span(const int8_t* row, int32_t width) noexcept {
  constexpr uint32_t kFourOutside = 0x80808080;
  const auto word = [&](int32_t x) {
    return detail::load_any_u32(reinterpret_cast<const uint8_t*>(row + x));
  };
  KnownSpan span = {0, width};
  while (span.first + 4 <= width && word(span.first) == kFourOutside) {
    span.first += 4;
  }
  while (span.first < width && row[span.first] == DistanceGrid::kOutside) {
    ++span.first;
  }
  if (span.first == width) {
    return {width, 0};
  }
  while (span.end >= span.first + 4 && word(span.end - 4) == kFourOutside) {
    span.end -= 4;
  }
  while (row[span.end - 1] == DistanceGrid::kOutside) {
    --span.end;
  }
  return span;
}

/// That of several rows, as far as they are in the grid.
inline KnownSpan known_span(const DistanceGrid& grid,
                            int32_t first_row,
                            int32_t last_row) noexcept {
  KnownSpan span = {grid.width(), 0};
  last_row = min(last_row, grid.height() - 1);
  for (int32_t row = max(first_row, 0); row <= last_row; ++row) {
    span = united(span, known_span(grid.row(row), grid.width()));
  }
  return span;
}

}  // namespace inkcell::kinetic
