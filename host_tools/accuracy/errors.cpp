// Gathers errors of pixels.
#include "errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace inkcell::tools {
namespace {

// Which of two equally bad places is named.
bool comes_first(const ErrorPlace& a, const ErrorPlace& b) {
  return std::tie(a.code_point, a.phase, a.y, a.x) <
         std::tie(b.code_point, b.phase, b.y, b.x);
}

}  // namespace

void ErrorStatistics::add(const ErrorPlace& place, bool in_box) {
  const double error = std::fabs(place.drawn - place.exact);
  if (error > worst_ || (error == worst_ && comes_first(place, worst_place_))) {
    worst_ = error;
    worst_place_ = place;
  }
  if (in_box) {
    box_sum_ += std::llround(error * kSumScale);
    ++box_pixels_;
  }
  if (place.exact > 0 && place.exact < 255) {
    const size_t bin = static_cast<size_t>(error * kBinsPerStep);
    ++partial_[std::min(bin, partial_.size() - 1)];
  }
}

void ErrorStatistics::add(const ErrorStatistics& other) {
  if (other.worst_ > worst_ ||
      (other.worst_ == worst_ &&
       comes_first(other.worst_place_, worst_place_))) {
    worst_ = other.worst_;
    worst_place_ = other.worst_place_;
  }
  box_sum_ += other.box_sum_;
  box_pixels_ += other.box_pixels_;
  for (size_t i = 0; i < partial_.size(); ++i) {
    partial_[i] += other.partial_[i];
  }
}

double ErrorStatistics::mean() const {
  return box_pixels_ == 0 ? 0
                          : static_cast<double>(box_sum_) / kSumScale /
                                static_cast<double>(box_pixels_);
}

double ErrorStatistics::percentile(double share) const {
  const int64_t all =
      std::accumulate(partial_.begin(), partial_.end(), int64_t{0});
  int64_t below = 0;
  for (size_t i = 0; i < partial_.size(); ++i) {
    below += partial_[i];
    if (all > 0 &&
        static_cast<double>(below) >= share * static_cast<double>(all)) {
      return static_cast<double>(i + 1) / kBinsPerStep;
    }
  }
  return 0;
}

}  // namespace inkcell::tools
