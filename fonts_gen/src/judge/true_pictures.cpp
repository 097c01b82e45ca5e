#include "judge/true_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "shape/area_gains.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Pixels this far from an edge are covered or not. Rounding of floats stays
// below the rest. [px]
constexpr float kReach_px = 0.5F + 1.0F / 4096;

constexpr float kFar = 1;  // [px^2]

// The nearest whole numbers, for |x| < 2^20: quicker than std::floor where it
// is a call.
constexpr int kOffset = 1 << 20;
int floor_of(double x) {
  return static_cast<int>(x + kOffset) - kOffset;
}
int ceil_of(double x) {
  return -floor_of(-x);
}

// The edges of a closed polygon with fewer corners, of which none is new: each
// stays within `stray` of the edges that it replaces, which run along it.
void simplify(const Edge* edges,
              size_t count,
              double stray,
              std::vector<Edge>& out) {
  // Whether one edge may replace [first, last).
  const auto is_near = [&](size_t first, size_t last) {
    const Point from = edges[first].a;
    const Point chord = edges[last - 1].b - from;
    const double size = length(chord);
    if (size == 0) {
      return false;
    }
    for (size_t i = first; i + 1 < last; ++i) {
      const Point p = edges[i].b - from;
      const double along = dot(p, chord);
      if (along < 0 || along > size * size ||
          std::fabs(cross(chord, p)) > stray * size) {
        return false;
      }
    }
    return true;
  };
  for (size_t first = 0; first < count;) {
    size_t last = first + 1;
    while (last < count && is_near(first, last + 1)) {
      ++last;
    }
    out.push_back({edges[first].a, edges[last - 1].b});
    first = last;
  }
}

// The pixels of a picture that are near an edge.
class Splat {
 public:
  Splat(const PictureSetting& setting,
        const Rect& pixels,
        std::vector<float>& squares,
        std::vector<uint8_t>& toggles)
      : px_per_u_(setting.px / 1024.0),
        origin_x_(setting.phase_x / 64.0 - 0.5 - pixels.x0),
        origin_y_(setting.phase_y / 64.0 - 0.5 - pixels.y0),
        width_(pixels.x1 - pixels.x0),
        height_(pixels.y1 - pixels.y0),
        squares_(squares),
        toggles_(toggles) {
    const size_t count =
        static_cast<size_t>(width_) * static_cast<size_t>(height_);
    squares_.assign(count, kFar);
    toggles_.assign(count, 0);
  }

  // In px: pixel centres are whole numbers, y grows downwards.
  void add(const Edge& edge) {
    const double ax = edge.a.x * px_per_u_ + origin_x_;
    const double ay = origin_y_ - edge.a.y * px_per_u_;
    const double bx = edge.b.x * px_per_u_ + origin_x_;
    const double by = origin_y_ - edge.b.y * px_per_u_;
    const double dx = bx - ax;
    const double dy = by - ay;
    const double square = dx * dx + dy * dy;
    const double low_x = std::min(ax, bx) - kReach_px;
    const double high_x = std::max(ax, bx) + kReach_px;
    const int y0 = std::max(0, ceil_of(std::min(ay, by) - kReach_px));
    const int y1 =
        std::min(height_, floor_of(std::max(ay, by) + kReach_px) + 1);
    // Where the line crosses a row, and how far beside it pixels are in reach.
    const bool is_level = dy == 0;
    const double slope = is_level ? 0 : dx / dy;
    const double beside =
        is_level ? kInfinity : kReach_px * std::sqrt(square) / std::fabs(dy);
    const auto part_x = static_cast<float>(dx / square);
    const auto part_y = static_cast<float>(dy / square);
    const auto fdx = static_cast<float>(dx);
    const auto fdy = static_cast<float>(dy);
    for (int y = y0; y < y1; ++y) {
      const double crossing = ax + (y - ay) * slope;
      if ((ay <= y) != (by <= y)) {
        toggle(y, crossing);
      }
      const int x0 = std::max(0, ceil_of(std::max(low_x, crossing - beside)));
      const int x1 =
          std::min(width_, floor_of(std::min(high_x, crossing + beside)) + 1);
      const auto py = static_cast<float>(y - ay);
      float* row = squares_.data() + index(0, y);
      for (int x = x0; x < x1; ++x) {
        const auto px = static_cast<float>(x - ax);
        float t = px * part_x + py * part_y;
        t = t < 0 ? 0 : t;
        t = t > 1 ? 1 : t;
        const float ex = px - t * fdx;
        const float ey = py - t * fdy;
        const float d = ex * ex + ey * ey;
        row[x] = d < row[x] ? d : row[x];
      }
    }
  }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) +
           static_cast<size_t>(x);
  }

  void toggle(int y, double crossing) {
    const int x = std::max(0, ceil_of(crossing));
    if (x < width_) {
      toggles_[index(x, y)] ^= 1;
    }
  }

  double px_per_u_;
  double origin_x_;  // of the glyph
  double origin_y_;
  int width_;
  int height_;
  std::vector<float>& squares_;
  std::vector<uint8_t>& toggles_;
};

// Coverage of a row.
void cover(const float* squares,
           const uint8_t* toggles,
           size_t count,
           int16_t* out) {
  constexpr float kWhole = 255.0F * TruePictures::kUnit;
  bool inside = false;
  for (size_t i = 0; i < count; ++i) {
    inside ^= toggles[i] != 0;
    const float away =
        squares[i] < 0.25F ? kWhole * (0.5F - std::sqrt(squares[i])) : 0;
    out[i] = static_cast<int16_t>((inside ? kWhole - away : away) + 0.5F);
  }
}

}  // namespace

Rect PictureSetting::pixels_of(const Box& box, double margin_px) const {
  const double px_per_u = px / 1024.0;
  const double dx = phase_x / 64.0 - 0.5;
  const double dy = phase_y / 64.0 - 0.5;
  return {floor_of(box.x0 * px_per_u + dx - margin_px) + 1,
          floor_of(-box.y1 * px_per_u + dy - margin_px) + 1,
          ceil_of(box.x1 * px_per_u + dx + margin_px),
          ceil_of(-box.y0 * px_per_u + dy + margin_px)};
}

// One polygon for an octave of sizes.
const std::vector<Edge>& TruePictures::border_for(int px) {
  if (px > border_px_ || 2 * px <= border_px_) {
    border_px_ = 1;
    while (border_px_ < px) {
      border_px_ *= 2;
    }
    border_.clear();
    const std::vector<Edge>& edges = shape_.edges();
    for (size_t first = 0, i = 0; i < edges.size(); ++i) {
      if (edges[i].b == edges[first].a) {
        simplify(edges.data() + first, i + 1 - first,
                 kStray_px * 1024 / border_px_, border_);
        first = i + 1;
      }
    }
  }
  return border_;
}

void TruePictures::draw_distances(const PictureSetting& setting,
                                  const Rect& pixels) {
  Splat splat(setting, pixels, squares_, toggles_);
  for (const Edge& edge : border_for(setting.px)) {
    splat.add(edge);
  }
  const auto width = static_cast<size_t>(pixels.x1 - pixels.x0);
  picture_.resize(squares_.size());
  for (size_t row = 0; row < picture_.size(); row += width) {
    cover(squares_.data() + row, toggles_.data() + row, width,
          picture_.data() + row);
  }
}

// Rows are turned upside down: edges that go up in the glyph go up in them.
void TruePictures::draw_areas(const PictureSetting& setting,
                              const Rect& pixels) {
  const int width = pixels.x1 - pixels.x0;
  const int height = pixels.y1 - pixels.y0;
  // A pixel to the left, and two to the right, for what lies beyond.
  const int stride = width + 3;
  const auto last_x = static_cast<double>(width + 1);
  const auto last_y = static_cast<double>(height);
  gains_.assign(static_cast<size_t>(stride) * static_cast<size_t>(height), 0);
  const auto place = [&](const Point& p) {
    return Point{
        p.x / setting.u_per_px() + setting.phase_x / 64.0 - pixels.x0 + 1,
        p.y / setting.u_per_px() - setting.phase_y / 64.0 + pixels.y1};
  };
  for (const Edge& edge : border_for(setting.px)) {
    const Point a = place(edge.a);
    const Point b = place(edge.b);
    for_rows_of({a.x, std::clamp(a.y, 0.0, last_y)},
                {b.x, std::clamp(b.y, 0.0, last_y)},
                [&](int row, Point low, Point high, bool is_up) {
                  low.x = std::clamp(low.x, 0.0, last_x);
                  high.x = std::clamp(high.x, 0.0, last_x);
                  add_gains(
                      low, high, is_up,
                      gains_.data() + static_cast<ptrdiff_t>(row) * stride);
                });
  }
  picture_.clear();
  for (int row = height; row-- != 0;) {
    const double* gains = gains_.data() + static_cast<ptrdiff_t>(row) * stride;
    double sum = *gains;
    for (int x = 0; x < width; ++x) {
      sum += *++gains;
      picture_.push_back(static_cast<int16_t>(
          std::lround(255 * kUnit * std::clamp(sum, 0.0, 1.0))));
    }
  }
}

const int16_t* TruePictures::next(const PictureSetting& setting,
                                  const Rect& pixels) {
  const size_t at = at_++;
  if (at < kept_.size()) {
    return kept_[at].data();
  }
  if (measure_ == Measure::area) {
    draw_areas(setting, pixels);
  } else {
    draw_distances(setting, pixels);
  }
  if (at == kept_.size() && kept_pixels_ + picture_.size() <= kMostKept) {
    kept_pixels_ += picture_.size();
    kept_.push_back(picture_);
  }
  return picture_.data();
}

}  // namespace inkcell::gen
