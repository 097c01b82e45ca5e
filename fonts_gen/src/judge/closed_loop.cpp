#include "judge/closed_loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "inkcell/field/draw.hpp"
#include "inkcell/style.hpp"
#include "judge/canvas.hpp"

namespace inkcell::gen {
namespace {

// How far around the ink box the mean is taken. [px]
constexpr double kMargin_px = 1.5;

// The size up to which every whole one is drawn at every phase. [px]
constexpr int kDensePx = 128;

// The glyph's origin within its pixel: a lattice of rank 1, y = 5 x modulo 1,
// in an order whose beginnings are spread out too. [1/64 px]
struct Phase {
  int x;
  int y;
};
constexpr std::array<Phase, kLoopPhases> kPhases = {{{0, 0},
                                                     {32, 32},
                                                     {16, 16},
                                                     {48, 48},
                                                     {8, 40},
                                                     {40, 8},
                                                     {24, 56},
                                                     {56, 24}}};

int phases_at(int px, int phases) {
  const double share = static_cast<double>(kDensePx) / px;
  const int needed = static_cast<int>(std::ceil(phases * share * share));
  return std::clamp(needed, 1, phases);
}

inkcell::Point origin_of(const PictureSetting& setting) {
  return {Q26_6::from_raw(setting.phase_x), Q26_6::from_raw(setting.phase_y)};
}

// How far the coverage of a pixel is from the filter `text` of the distance, in
// real numbers. [1/255]
double error_at(const PictureSetting& setting,
                int x,
                int y,
                double drawn,
                DistanceMap& map) {
  const double distance_px =
      map.distance(setting.x_u(x), setting.y_u(y)) / setting.u_per_px();
  return std::fabs(drawn - 255 * std::clamp(0.5 + distance_px, 0.0, 1.0));
}

bool is_worse(const LoopMiss& a, const LoopMiss& b) {
  return a.error > b.error;
}

// A pixel of a picture, and how wrong it is.
struct WrongPixel {
  PictureSetting setting;
  int x = 0;
  int y = 0;
  double error = 0;  // [1/255]
};

// Pixels this near to the tolerance, in shares of it, may miss it at other
// positions and sizes: the worst one of each place is followed.
constexpr double kFollowed = 0.65;
constexpr size_t kMostFollowed = 64;

// From a position to the next ones, coarse steps first, each so often at most.
// [1/64 px]
constexpr int kFollowSteps[] = {4, 2, 1};
constexpr int kMostMoves = 3;

// Gathers the errors of one size after another.
class Gathering {
 public:
  explicit Gathering(const LoopOptions& options) : options_(options) {}

  void begin(int px) {
    size_ = SizeError();
    size_.px = px;
    worst_pixel_ = WrongPixel();
    sum_ = 0;
    pixels_ = 0;
  }

  void end() {
    size_.mean = pixels_ > 0 ? sum_ / pixels_ : 0;
    keep_worst(worst_pixel_);
    result_.worst_mean = std::max(result_.worst_mean, size_.mean);
    result_.sizes.push_back(size_);
  }

  // A pixel counts for the worst; add_mean() has it count for the mean.
  void add(const PictureSetting& setting, int x, int y, double error) {
    if (error > size_.worst) {
      size_.worst = error;
      worst_pixel_ = {setting, x, y, error};
    }
    if (error > kFollowed * options_.tolerance) {
      WrongPixel& worst = wrong_[place_of(setting, x, y)];
      if (error > worst.error) {
        worst = {setting, x, y, error};
      }
    }
    if (error > options_.tolerance) {
      add_miss(miss_at({setting, x, y, error}));
    }
  }

  // Only pixels with larger errors matter, if the worst one of this size is at
  // least so large. [1/255]
  double least_that_matters(double worst) const {
    return std::min(std::max(size_.worst, worst),
                    kFollowed * options_.tolerance);
  }

  // Pixels to follow, the worst first.
  std::vector<WrongPixel> followed() const {
    std::vector<WrongPixel> pixels;
    for (const auto& place : wrong_) {
      pixels.push_back(place.second);
    }
    std::stable_sort(pixels.begin(), pixels.end(),
                     [](const WrongPixel& a, const WrongPixel& b) {
                       return a.error > b.error;
                     });
    pixels.resize(std::min(pixels.size(), kMostFollowed));
    return pixels;
  }

  // A pixel at a position that is tried besides.
  void add_between(const WrongPixel& pixel) {
    keep_worst(pixel);
    for (SizeError& size : result_.sizes) {
      if (size.px == pixel.setting.px) {
        size.worst = std::max(size.worst, pixel.error);
      }
    }
    if (pixel.error > options_.tolerance) {
      add_miss(miss_at(pixel));
    }
  }

  bool has_misses() const { return result_.miss_count != 0; }
  void add_mean(double sum, int pixels) {
    sum_ += sum;
    pixels_ += pixels;
  }

  LoopResult finish() {
    std::sort_heap(result_.misses.begin(), result_.misses.end(), is_worse);
    return std::move(result_);
  }

 private:
  // An octave of sizes, and the corner of a square of 1 to 2 px.
  using Place = std::array<int, 3>;
  static Place place_of(const PictureSetting& setting, int x, int y) {
    int octave = 0;
    std::frexp(setting.px, &octave);
    const double side_u = std::ldexp(2048, -octave);
    return {octave, static_cast<int>(std::floor(setting.x_u(x) / side_u)),
            static_cast<int>(std::floor(setting.y_u(y) / side_u))};
  }

  static LoopMiss miss_at(const WrongPixel& pixel) {
    const PictureSetting& setting = pixel.setting;
    return {setting.x_u(pixel.x), setting.y_u(pixel.y), setting.px,
            pixel.error};
  }

  void keep_worst(const WrongPixel& pixel) {
    if (pixel.error > result_.worst) {
      result_.worst = pixel.error;
      result_.worst_pixel = miss_at(pixel);
    }
  }

  // Misses are a heap with the least bad one on top.
  void add_miss(const LoopMiss& miss) {
    std::vector<LoopMiss>& heap = result_.misses;
    ++result_.miss_count;
    if (heap.size() == options_.max_misses) {
      if (heap.empty() || miss.error <= heap.front().error) {
        return;
      }
      std::pop_heap(heap.begin(), heap.end(), is_worse);
      heap.pop_back();
    }
    heap.push_back(miss);
    std::push_heap(heap.begin(), heap.end(), is_worse);
  }

  const LoopOptions& options_;
  LoopResult result_;
  SizeError size_;
  WrongPixel worst_pixel_;             // of the current size
  std::map<Place, WrongPixel> wrong_;  // the worst one of each place
  double sum_ = 0;
  double pixels_ = 0;
};

// Errors of a row against a true picture. [1/255 / TruePictures::kUnit]
struct RowErrors {
  int most = 0;
  int sum = 0;
};

RowErrors row_errors(const uint8_t* drawn, const int16_t* truth, int count) {
  RowErrors errors;
  for (int i = 0; i < count; ++i) {
    const int error = std::abs(drawn[i] * TruePictures::kUnit - truth[i]);
    errors.most = std::max(errors.most, error);
    errors.sum += error;
  }
  return errors;
}

// Compares `pixels` of a picture with the near truth, and those that may matter
// with the exact one.
void compare_inked(const PictureSetting& setting,
                   const Canvas& canvas,
                   const Rect& pixels,
                   Measure measure,
                   LoopTruth& truth,
                   Gathering& gathering) {
  constexpr double kUnit = TruePictures::kUnit;
  const int width = pixels.x1 - pixels.x0;
  const int16_t* const picture = truth.pictures.next(setting, pixels);
  const auto row_of = [&](int y) {
    return picture + static_cast<ptrdiff_t>(y - pixels.y0) * width;
  };
  std::vector<int> most;  // of each row, [1/255 / kUnit]
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const RowErrors errors =
        row_errors(canvas.row(pixels.x0, y), row_of(y), width);
    most.push_back(errors.most);
    gathering.add_mean(errors.sum / kUnit, width);
  }
  // The worst pixel is at least so wrong.
  const double worst =
      (*std::max_element(most.begin(), most.end()) - TruePictures::kBound) /
      kUnit;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const auto matters = [&](int near) {
      return (near + TruePictures::kBound) / kUnit >=
             gathering.least_that_matters(worst);
    };
    if (!matters(most[static_cast<size_t>(y - pixels.y0)])) {
      continue;
    }
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const int drawn = canvas.at(x, y);
      const int near =
          std::abs(drawn * TruePictures::kUnit - row_of(y)[x - pixels.x0]);
      if (matters(near)) {
        gathering.add(setting, x, y,
                      measure == Measure::area
                          ? near / kUnit
                          : error_at(setting, x, y, drawn, truth.map));
      }
    }
  }
}

// No ink belongs to pixels x0 <= x < x1 of a row.
void expect_nothing(const PictureSetting& setting,
                    const Canvas& canvas,
                    int x0,
                    int x1,
                    int y,
                    Gathering& gathering) {
  for (int x = x0; x < x1; ++x) {
    if (canvas.at(x, y) != 0) {
      gathering.add(setting, x, y, canvas.at(x, y));
    }
  }
}

void compare(const PictureSetting& setting,
             const Canvas& canvas,
             const Rect& inked,
             Measure measure,
             LoopTruth* truth,
             Gathering& gathering) {
  const Rect& area = canvas.area();
  for (int y = area.y0; y < area.y1; ++y) {
    if (truth == nullptr || y < inked.y0 || y >= inked.y1) {
      expect_nothing(setting, canvas, area.x0, area.x1, y, gathering);
    } else {
      expect_nothing(setting, canvas, area.x0, inked.x0, y, gathering);
      expect_nothing(setting, canvas, inked.x1, area.x1, y, gathering);
    }
  }
  if (truth != nullptr) {
    compare_inked(setting, canvas, inked, measure, *truth, gathering);
  }
}

Style style_of(int px, Measure measure) {
  if (px < 4 || px > 1024) {
    throw std::invalid_argument("the closed loop draws 4 to 1024 px/em");
  }
  return Style(Q26_6::from_int(px),
               measure == Measure::area ? kFilterArea : kFilterText);
}

// The worst of the nine pixels around one, at another position or size.
WrongPixel worst_around(const LoopGlyph& glyph,
                        DistanceMap& map,
                        const WrongPixel& middle) {
  const PictureSetting& setting = middle.setting;
  WrongPixel worst = {setting, middle.x, middle.y, 0};
  Canvas canvas(Rect{middle.x - 1, middle.y - 1, middle.x + 2, middle.y + 2});
  glyph.draw(style_of(setting.px, Measure::distance), origin_of(setting),
             canvas.sink());
  for (int y = middle.y - 1; y < middle.y + 2; ++y) {
    for (int x = middle.x - 1; x < middle.x + 2; ++x) {
      // No ink belongs beyond the map, which reaches kMargin_px around it.
      const double drawn = canvas.at(x, y);
      const double error = map.holds(setting.x_u(x), setting.y_u(y))
                               ? error_at(setting, x, y, drawn, map)
                               : drawn;
      if (error > worst.error) {
        worst = {setting, x, y, error};
      }
    }
  }
  return worst;
}

// The pixel with the same point of the glyph at its centre, but for 1/128 px,
// at another size.
WrongPixel at_size(const WrongPixel& pixel, int px) {
  const double x = pixel.setting.x_u(pixel.x) * px / 1024 - 0.5;
  const double y = -pixel.setting.y_u(pixel.y) * px / 1024 - 0.5;
  WrongPixel result;
  result.x = static_cast<int>(std::ceil(x));
  result.y = static_cast<int>(std::ceil(y));
  result.setting.px = px;
  result.setting.phase_x = static_cast<int>(std::lround(64 * (result.x - x)));
  result.setting.phase_y = static_cast<int>(std::lround(64 * (result.y - y)));
  return result;
}

// Goes to positions beside this one, and to the next sizes, as long as the
// pixel gets worse.
WrongPixel follow(const LoopGlyph& glyph,
                  const LoopOptions& options,
                  DistanceMap& map,
                  WrongPixel at) {
  for (const int step : kFollowSteps) {
    for (int move = 0; move < kMostMoves; ++move) {
      WrongPixel next = at;
      const auto look_at = [&](const WrongPixel& beside) {
        const WrongPixel found = worst_around(glyph, map, beside);
        if (found.error > next.error) {
          next = found;
        }
      };
      for (int i = 0; i < 9; ++i) {
        WrongPixel beside = at;
        beside.setting.phase_x += (i % 3 - 1) * step;
        beside.setting.phase_y += (i / 3 - 1) * step;
        if (i != 4) {
          look_at(beside);
        }
      }
      for (const int px : {at.setting.px - 1, at.setting.px + 1}) {
        if (px >= options.min_px && px <= options.max_px) {
          look_at(at_size(at, px));
        }
      }
      if (next.error <= at.error) {
        break;
      }
      at = next;
    }
  }
  return at;
}

}  // namespace

std::vector<int> loop_sizes(int min_px, int max_px) {
  std::vector<int> sizes;
  for (int px = min_px; px < max_px; px += std::max(1, px / (kDensePx / 2))) {
    sizes.push_back(px);
  }
  sizes.push_back(max_px);
  return sizes;
}

ClosedLoop::ClosedLoop(const Shape& shape, const LoopOptions& options)
    : shape_(shape), options_(options) {
  if (!shape.empty()) {
    truth_.emplace(shape, options.measure, kMargin_px * 1024 / options.min_px);
  }
}

LoopResult ClosedLoop::draw_and_compare(const GlyphField& field) {
  return draw_sizes(
      {[&](const Style& style, inkcell::Point origin) {
         return field_box(field, style, origin);
       },
       [&](const Style& style, inkcell::Point origin, const Sink& sink) {
         draw_field(field, style, origin, sink);
       }},
      false);
}

LoopResult ClosedLoop::draw_and_compare(const LoopGlyph& glyph) {
  return draw_sizes(glyph, options_.measure == Measure::distance);
}

LoopResult ClosedLoop::draw_sizes(const LoopGlyph& glyph, bool follows) {
  Gathering gathering(options_);
  if (truth_) {
    truth_->pictures.rewind();
  }
  for (const int px : loop_sizes(options_.min_px, options_.max_px)) {
    const Style style = style_of(px, options_.measure);
    gathering.begin(px);
    for (int i = 0; i < phases_at(px, options_.phases); ++i) {
      const Phase& phase = kPhases[static_cast<size_t>(i)];
      const PictureSetting setting{px, phase.x, phase.y};
      const inkcell::Point origin = origin_of(setting);
      const Rect inked =
          truth_ ? setting.pixels_of(shape_.box(), kMargin_px) : Rect();
      Canvas canvas(bounding_box(inked, glyph.box(style, origin)));
      glyph.draw(style, origin, canvas.sink());
      compare(setting, canvas, inked, options_.measure,
              truth_ ? &*truth_ : nullptr, gathering);
    }
    gathering.end();
  }
  if (truth_ && follows && !gathering.has_misses()) {
    for (const WrongPixel& pixel : gathering.followed()) {
      gathering.add_between(follow(glyph, options_, truth_->map, pixel));
    }
  }
  return gathering.finish();
}

}  // namespace inkcell::gen
