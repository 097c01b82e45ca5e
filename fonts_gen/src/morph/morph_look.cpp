#include "morph/morph_look.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "morph/morph_check.hpp"
#include "shape/pixel_regions.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr int kFrames = 32;
constexpr int kSpeck_px = 2;  // what is smaller

// The part of each pixel that ink covers; a pixel of background is around it.
struct Coverage {
  int width = 0;
  int height = 0;
  std::vector<float> cover;
};

// The signed area of a line's shadow: what lies to the right of it, pixel by
// pixel. [px]
void add_line(Point a, Point b, int width, std::vector<float>& cover) {
  if (a.y == b.y) {
    return;
  }
  const double sign = a.y < b.y ? 1 : -1;
  if (sign < 0) {
    std::swap(a, b);
  }
  const double slope = (b.x - a.x) / (b.y - a.y);
  for (auto y = static_cast<int>(a.y); y < b.y; ++y) {
    const double y0 = std::max(a.y, double(y));
    const double y1 = std::min(b.y, y + 1.0);
    double x0 = a.x + (y0 - a.y) * slope;
    double x1 = a.x + (y1 - a.y) * slope;
    if (x0 > x1) {
      std::swap(x0, x1);
    }
    const double height = sign * (y1 - y0);
    const auto row = static_cast<size_t>(y * width);
    // How much of each pixel lies right of the line, beyond that of the last.
    double before = 0;
    for (auto x = static_cast<int>(x0);; ++x) {
      const auto right_of = [&](double at) {
        // The mean of clamp(at - line, 0, inf).
        return at <= x0   ? 0
               : at >= x1 ? at - (x0 + x1) / 2
                          : (at - x0) * (at - x0) / (2 * (x1 - x0));
      };
      const double part = right_of(x + 1) - right_of(x);
      cover[row + static_cast<size_t>(x)] +=
          static_cast<float>(height * (part - before));
      before = part;
      if (x >= x1) {
        break;
      }
    }
  }
}

Coverage coverage_of(const MorphPolygons& polygons, double px) {
  const double scale = px / kUPerEm;
  Point low = {kInfinity, kInfinity};
  Point high = {-kInfinity, -kInfinity};
  for (const auto& polygon : polygons) {
    for (const Point& p : polygon) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  // The grid of pixels goes through the origin.
  const Point corner = {std::floor(low.x * scale) - 1,
                        std::floor(low.y * scale) - 1};
  Coverage out;
  out.width = static_cast<int>(std::ceil(high.x * scale) - corner.x) + 3;
  out.height = static_cast<int>(std::ceil(high.y * scale) - corner.y) + 2;
  const auto count = static_cast<size_t>(out.width * out.height);
  std::vector<float>& cover = out.cover;
  cover.resize(count);
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      add_line(scale * polygon[i] - corner,
               scale * polygon[(i + 1) % polygon.size()] - corner, out.width,
               cover);
    }
  }
  // What was added is the difference to the pixel before.
  float sum = 0;
  for (size_t i = 0; i < count; ++i) {
    sum = (i % static_cast<size_t>(out.width) == 0 ? 0 : sum) + cover[i];
    cover[i] = std::abs(sum);
  }
  return out;
}

// Holes or islands of pixels, but for specks.
struct Parts {
  int count = 0;
  bool has_speck = false;
};

// Islands of ink or holes: a pixel is ink if at least that much of it is
// covered. Ink is joined by corners, background is not.
Parts parts_of(const Coverage& picture, bool is_ink, float least) {
  const int width = picture.width + 2;
  std::vector<uint8_t> mask(static_cast<size_t>(width * (picture.height + 2)));
  const float* cover = picture.cover.data();
  for (int y = 1; y <= picture.height; ++y) {
    for (int x = 1; x <= picture.width; ++x) {
      mask[static_cast<size_t>(y * width + x)] =
          (*cover++ >= least) == is_ink ? 1 : 0;
    }
  }
  const std::vector<int> sizes = pixel_regions(std::move(mask), width, is_ink);
  Parts parts;
  // The first hole is the background around all.
  for (size_t i = is_ink ? 0 : 1; i < sizes.size(); ++i) {
    parts.count += sizes[i] < kSpeck_px ? 0 : 1;
    parts.has_speck = parts.has_speck || sizes[i] < kSpeck_px;
  }
  return parts;
}

// Parts of one kind in the frames between two ends.
class PartWatch {
 public:
  PartWatch(bool is_ink,
            float least,
            const Coverage& first,
            const Coverage& last)
      : is_ink_{is_ink}, least_{least} {
    for (const Coverage* const end : {&first, &last}) {
      const Parts parts = parts_of(*end, is_ink, least);
      most_ = std::max(most_, parts.count);
      has_speck_ = has_speck_ || parts.has_speck;
    }
  }

  // Whether the next frame has more parts than both ends, or specks that they
  // have not, and so had the frame before.
  bool is_blemished(const Coverage& frame) {
    const Parts parts = parts_of(frame, is_ink_, least_);
    specks_ = parts.has_speck && !has_speck_ ? specks_ + 1 : 0;
    return parts.count > most_ || specks_ > 1;
  }

 private:
  bool is_ink_;
  float least_;
  int most_ = 0;
  bool has_speck_ = false;
  int specks_ = 0;  // frames in a row
};

// The mean width of strokes. [u]
double stroke_of(const MorphPolygons& polygons) {
  double twice = 0;
  double around = 0;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Point& next = polygon[(i + 1) % polygon.size()];
      twice += cross(polygon[i], next);
      around += length(next - polygon[i]);
    }
  }
  return std::abs(twice) / std::max(around, 1.0);
}

}  // namespace

bool has_blemish(const MorphPair& pair) {
  constexpr int kChords = 5;
  constexpr double kSizes_px[] = {24, 48, 96};
  // Narrower strokes are in pieces at rest, too.
  constexpr double kLeastStroke_px = 1.5;
  std::vector<MorphPolygons> frames;
  for (int frame = 0; frame <= kFrames; ++frame) {
    frames.push_back(
        morph_polygons(pair, static_cast<double>(frame) / kFrames, kChords));
  }
  const double stroke_u =
      std::min(stroke_of(frames.front()), stroke_of(frames.back()));
  for (const double px : kSizes_px) {
    if (stroke_u * px < kLeastStroke_px * kUPerEm) {
      continue;
    }
    const Coverage first = coverage_of(frames.front(), px);
    const Coverage last = coverage_of(frames.back(), px);
    // Also as if strokes were a bit bolder, or finer: a mouth that is about to
    // close counts as closed, wherever the grid lies.
    PartWatch watches[] = {{false, 0.4F, first, last},
                           {false, 0.5F, first, last},
                           {true, 0.5F, first, last},
                           {true, 0.6F, first, last}};
    for (int frame = 1; frame < kFrames; ++frame) {
      const Coverage picture =
          coverage_of(frames[static_cast<size_t>(frame)], px);
      for (PartWatch& watch : watches) {
        if (watch.is_blemished(picture)) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace inkcell::gen
