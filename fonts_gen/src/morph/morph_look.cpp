#include "morph/morph_look.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "morph/morph_check.hpp"
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

// `is_ink`: islands of ink, else holes. Ink is joined by corners, background is
// not.
Parts parts_of(const Coverage& picture, bool is_ink, float least) {
  constexpr int kSteps[8][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  const auto belongs = [&](size_t i) {
    return (picture.cover[i] >= least) == is_ink;
  };
  Parts parts;
  std::vector<bool> seen(picture.cover.size());
  std::vector<int> stack;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] || !belongs(i)) {
      continue;
    }
    int size = 0;
    seen[i] = true;
    for (stack = {static_cast<int>(i)}; !stack.empty(); ++size) {
      const int at = stack.back();
      stack.pop_back();
      for (int k = 0; k < (is_ink ? 8 : 4); ++k) {
        const int x = at % picture.width + kSteps[k][0];
        const int y = at / picture.width + kSteps[k][1];
        const auto next = static_cast<size_t>(y * picture.width + x);
        if (x >= 0 && y >= 0 && x < picture.width && y < picture.height &&
            !seen[next] && belongs(next)) {
          seen[next] = true;
          stack.push_back(static_cast<int>(next));
        }
      }
    }
    if (i != 0) {  // else it is the background around all
      parts.count += size < kSpeck_px ? 0 : 1;
      parts.has_speck = parts.has_speck || size < kSpeck_px;
    }
  }
  return parts;
}

// Of pictures from one end to the other. A pixel is ink if at least that much
// of it is covered.
int blemished_frames(const std::vector<Coverage>& pictures,
                     bool is_ink,
                     float least) {
  const Parts ends[] = {parts_of(pictures.front(), is_ink, least),
                        parts_of(pictures.back(), is_ink, least)};
  const int most = std::max(ends[0].count, ends[1].count);
  int blemished = 0;
  int specks = 0;  // in a row
  for (size_t i = 1; i + 1 < pictures.size(); ++i) {
    const Parts parts = parts_of(pictures[i], is_ink, least);
    const bool has_speck =
        parts.has_speck && !ends[0].has_speck && !ends[1].has_speck;
    specks = has_speck ? specks + 1 : 0;
    blemished += parts.count > most || specks > 1 ? 1 : 0;
  }
  return blemished;
}

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

int blemished_frames(const MorphPair& pair) {
  constexpr int kChords = 5;
  constexpr double kSizes_px[] = {24, 48, 96};
  // Narrower strokes are in pieces at rest, too.
  constexpr double kLeastStroke_px = 1.5;
  int blemished = 0;
  const double stroke_u = std::min(stroke_of(morph_polygons(pair, 0, kChords)),
                                   stroke_of(morph_polygons(pair, 1, kChords)));
  for (const double px : kSizes_px) {
    if (stroke_u * px < kLeastStroke_px * kUPerEm) {
      continue;
    }
    std::vector<Coverage> pictures;
    for (int frame = 0; frame <= kFrames; ++frame) {
      pictures.push_back(coverage_of(
          morph_polygons(pair, static_cast<double>(frame) / kFrames, kChords),
          px));
    }
    // Also as if strokes were a bit bolder, or finer: a mouth that is about to
    // close counts as closed, wherever the grid lies.
    blemished += blemished_frames(pictures, false, 0.4F) +
                 blemished_frames(pictures, false, 0.5F) +
                 blemished_frames(pictures, true, 0.5F) +
                 blemished_frames(pictures, true, 0.6F);
  }
  return blemished;
}

}  // namespace inkcell::gen
