// Errors of pixels, gathered: worst, mean, percentile.
#pragma once

#include <array>
#include <cstdint>

namespace inkcell::tools {

/// Where an error was found.
struct ErrorPlace {
  char32_t code_point = 0;
  int phase = 0;
  int x = 0;  // of the pixel, relative to the glyph's origin, y down
  int y = 0;
  int drawn = 0;     // [1/255]
  double exact = 0;  // [1/255]
};

/// Sums are kept in whole numbers, so that the order of threads does not show.
class ErrorStatistics {
 public:
  /// A pixel that should be `place.exact` and is `place.drawn`. `in_box`: it
  /// counts for the mean.
  void add(const ErrorPlace& place, bool in_box);

  /// Adds what another one has gathered.
  void add(const ErrorStatistics& other);

  double worst() const { return worst_; }
  const ErrorPlace& worst_place() const { return worst_place_; }

  /// Over the pixels of all glyph boxes.
  double mean() const;

  /// Of all pixels whose exact coverage is neither 0 nor 255, this share is at
  /// most so wrong. Resolution 1/16.
  double percentile(double share) const;

  int64_t pixels() const { return box_pixels_; }

 private:
  static constexpr int kBinsPerStep = 16;
  static constexpr int kSumScale = 65536;

  double worst_ = -1;
  ErrorPlace worst_place_;
  int64_t box_sum_ = 0;  // in 1 / kSumScale
  int64_t box_pixels_ = 0;
  std::array<int64_t, 256 * kBinsPerStep> partial_{};
};

}  // namespace inkcell::tools
