#include "bitmap/distance_transform.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell::design {
namespace {

// Columns processed together: a row of them is one cache line.
constexpr size_t kColumns = 16;

constexpr float kFar = 1e10f;

// Converts squared distances along a row to those of the plane: the lower
// envelope of parabolas at the pixels.
class Envelope {
 public:
  explicit Envelope(size_t size) : foot_(size), from_(size + 1), in_(size) {}

  void run(float* row, size_t size) {
    std::copy(row, row + size, in_.begin());
    size_t last = 0;
    size_t first = 0;
    while (first < size && in_[first] >= kFar) {
      ++first;
    }
    if (first == size) {
      return;
    }
    foot_[0] = first;
    from_[0] = -kFar;
    from_[1] = kFar;
    for (size_t q = first + 1; q < size; ++q) {
      if (in_[q] >= kFar) {
        continue;
      }
      float s = meeting(foot_[last], q);
      while (last > 0 && s <= from_[last]) {
        s = meeting(foot_[--last], q);
      }
      foot_[++last] = q;
      from_[last] = s;
      from_[last + 1] = kFar;
    }
    size_t k = 0;
    for (size_t q = 0; q < size; ++q) {
      while (from_[k + 1] < static_cast<float>(q)) {
        ++k;
      }
      const float d = static_cast<float>(q) - static_cast<float>(foot_[k]);
      row[q] = d * d + in_[foot_[k]];
    }
  }

 private:
  float meeting(size_t p, size_t q) const {
    const float a = static_cast<float>(p);
    const float b = static_cast<float>(q);
    return ((in_[q] - in_[p]) / (b - a) + a + b) / 2;
  }

  std::vector<size_t> foot_;
  std::vector<float> from_;
  std::vector<float> in_;
};

// Distance to the nearest pixel whose ink is `wanted`.
std::vector<float> distances_to(const Bitmap& bitmap, bool wanted) {
  const size_t width = static_cast<size_t>(bitmap.width);
  const size_t height = static_cast<size_t>(bitmap.height);
  std::vector<float> result(width * height, kFar);
  // Passes down and up: the distance to the nearest pixel in the column.
  for (size_t x0 = 0; x0 < width; x0 += kColumns) {
    const size_t count = std::min(kColumns, width - x0);
    for (const bool up : {false, true}) {
      float distance[kColumns];
      std::fill(distance, distance + kColumns, 1e5f);
      for (size_t i = 0; i < height; ++i) {
        const size_t at = (up ? height - 1 - i : i) * width + x0;
        for (size_t k = 0; k < count; ++k) {
          distance[k] =
              (bitmap.ink[at + k] >= 128) == wanted ? 0 : distance[k] + 1;
          if (distance[k] < 1e5f) {
            result[at + k] =
                std::min(result[at + k], distance[k] * distance[k]);
          }
        }
      }
    }
  }
  Envelope envelope(width);
  for (size_t y = 0; y < height; ++y) {
    envelope.run(result.data() + y * width, width);
  }
  return result;
}

}  // namespace

std::vector<float> signed_distances(const Bitmap& bitmap) {
  std::vector<float> to_ink = distances_to(bitmap, true);
  const std::vector<float> to_paper = distances_to(bitmap, false);
  for (size_t i = 0; i < to_ink.size(); ++i) {
    to_ink[i] = to_ink[i] > 0 ? 0.5f - std::sqrt(to_ink[i])
                              : std::sqrt(to_paper[i]) - 0.5f;
  }
  return to_ink;
}

}  // namespace inkcell::design
