// Gathers errors of pixels.
#include "errors.hpp"

#include <cmath>

namespace inkcell::tools {

double ErrorPlace::error() const {
  return std::fabs(drawn - exact);
}

void GlyphErrors::add(const ErrorPlace& place, bool in_box) {
  const double error = place.error();
  if (error > worst_) {
    worst_ = error;
    worst_place_ = place;
  }
  if (in_box) {
    box_sum_ += error;
    ++box_pixels_;
  }
}

double GlyphErrors::mean() const {
  return box_pixels_ == 0 ? 0 : box_sum_ / static_cast<double>(box_pixels_);
}

void ErrorSummary::add(const GlyphErrors& errors) {
  if (errors.worst() > worst()) {
    worst_place_ = errors.worst_place();
  }
  if (errors.mean() > worst_mean_) {
    worst_mean_ = errors.mean();
    worst_mean_character_ = errors.worst_place().code_point;
  }
  if (errors.pixels() > 0) {
    mean_sum_ += errors.mean();
    ++glyphs_;
  }
}

void ErrorSummary::add(const ErrorSummary& other) {
  if (other.worst() > worst()) {
    worst_place_ = other.worst_place_;
  }
  if (other.worst_mean_ > worst_mean_) {
    worst_mean_ = other.worst_mean_;
    worst_mean_character_ = other.worst_mean_character_;
  }
  mean_sum_ += other.mean_sum_;
  glyphs_ += other.glyphs_;
}

double ErrorSummary::mean() const {
  return glyphs_ == 0 ? 0 : mean_sum_ / static_cast<double>(glyphs_);
}

}  // namespace inkcell::tools
