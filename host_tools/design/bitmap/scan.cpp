#include "bitmap/scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace inkcell::design {
namespace {

// x and y go from -1 to 1.
constexpr size_t kTerms = 6;
using Terms = std::array<double, kTerms>;

// Each round separates paper and ink better, as the light is more even.
constexpr int kRounds = 4;

// The most pixels that are sampled: all of a small scan. No surface is fitted
// to fewer than kLeastPaper.
constexpr size_t kMostLooks = size_t{1} << 20;
constexpr size_t kLeastPaper = 100;

// A scan is enlarged to this many pixels an em, by at most kMostFactor and to
// at most kMostEnlarged pixels.
constexpr double kEnlarged_px_per_em = 1024;
constexpr int kMostFactor = 8;
constexpr size_t kMostEnlarged = size_t{1} << 26;

// The surface ends where paper would be darker. [of 255]
constexpr double kLeastGrey = 16;

Terms terms_at(const Bitmap& scan, size_t i) {
  const auto width = static_cast<size_t>(scan.width);
  const double x = (2.0 * static_cast<double>(i % width) + 1) / scan.width - 1;
  const double y = (2.0 * static_cast<double>(i / width) + 1) / scan.height - 1;
  return {1, x, y, x * x, x * y, y * y};
}

double value_of(const Terms& surface, const Terms& terms) {
  double value = 0;
  for (size_t k = 0; k < kTerms; ++k) {
    value += surface[k] * terms[k];
  }
  return value;
}

// Gaussian elimination; the matrix is positive definite if the places determine
// a surface.
std::optional<Terms> solve(std::array<std::array<double, kTerms + 1>, kTerms> m,
                           double count) {
  for (size_t k = 0; k < kTerms; ++k) {
    if (!(m[k][k] > 1e-6 * count)) {
      return std::nullopt;
    }
    for (size_t r = 0; r < kTerms; ++r) {
      const double f = r == k ? 0 : m[r][k] / m[k][k];
      for (size_t c = k; c <= kTerms; ++c) {
        m[r][c] -= f * m[k][c];
      }
    }
  }
  Terms result;
  for (size_t k = 0; k < kTerms; ++k) {
    result[k] = m[k][kTerms] / m[k][k];
  }
  return result;
}

// Fits the grey of the paper to the pixels of `scan` that are lighter than the
// threshold of `levelled`, by least squares.
std::optional<Terms> paper_of(const Bitmap& scan, const Bitmap& levelled) {
  std::array<std::array<double, kTerms + 1>, kTerms> m = {};
  const int threshold = otsu_threshold(levelled);
  const size_t step = scan.ink.size() / kMostLooks + 1;
  size_t count = 0;
  for (size_t i = 0; i < scan.ink.size(); i += step) {
    if (levelled.ink[i] >= threshold) {
      continue;
    }
    const Terms terms = terms_at(scan, i);
    for (size_t r = 0; r < kTerms; ++r) {
      for (size_t c = 0; c < kTerms; ++c) {
        m[r][c] += terms[r] * terms[c];
      }
      m[r][kTerms] += terms[r] * (255 - scan.ink[i]);
    }
    ++count;
  }
  return count < kLeastPaper ? std::nullopt
                             : solve(m, static_cast<double>(count));
}

int factor_for(const Bitmap& scan, double px_per_em) {
  int factor = 1;
  while (factor < kMostFactor && factor * px_per_em < kEnlarged_px_per_em) {
    ++factor;
  }
  while (factor > 1 && scan.ink.size() * static_cast<size_t>(factor * factor) >
                           kMostEnlarged) {
    --factor;
  }
  return factor;
}

// Enlarges by bilinear interpolation.
Bitmap enlarged(const Bitmap& scan, int factor) {
  Bitmap result;
  result.width = scan.width * factor;
  result.height = scan.height * factor;
  result.ink.reserve(scan.ink.size() * static_cast<size_t>(factor * factor));
  for (int y = 0; y < result.height; ++y) {
    const double from_y = (y + 0.5) / factor - 0.5;
    const int y0 = static_cast<int>(std::floor(from_y));
    for (int x = 0; x < result.width; ++x) {
      const double from_x = (x + 0.5) / factor - 0.5;
      const int x0 = static_cast<int>(std::floor(from_x));
      const double right = from_x - x0;
      const auto row = [&](int at) {
        return scan.at(x0, at) +
               right * (scan.at(x0 + 1, at) - scan.at(x0, at));
      };
      const double ink = row(y0) + (from_y - y0) * (row(y0 + 1) - row(y0));
      result.ink.push_back(static_cast<uint8_t>(std::lround(ink)));
    }
  }
  return result;
}

}  // namespace

void level_light(Bitmap& scan) {
  const Bitmap source = scan;
  for (int round = 0; round < kRounds; ++round) {
    const std::optional<Terms> paper = paper_of(source, scan);
    if (!paper) {
      return;
    }
    for (size_t i = 0; i < scan.ink.size(); ++i) {
      const double white =
          std::max(value_of(*paper, terms_at(scan, i)), kLeastGrey);
      const double grey = 255 * (255 - source.ink[i]) / white;
      scan.ink[i] =
          static_cast<uint8_t>(std::lround(255 - std::min(grey, 255.0)));
    }
  }
}

void divide_scan(Bitmap& scan, MasterOptions& options) {
  level_light(scan);
  const int threshold = otsu_threshold(scan);
  const int factor = factor_for(scan, options.place.px_per_em);
  if (factor > 1) {
    if (options.tolerance_u == 0) {
      options.tolerance_u = pixel_tolerance(scan, options.place);
    }
    scan = enlarged(scan, factor);
    options.place.px_per_em *= factor;
    options.place.origin_x *= factor;
    options.place.origin_y *= factor;
    options.least_area_px *= factor * factor;
  }
  make_bilevel(scan, threshold);
}

}  // namespace inkcell::design
