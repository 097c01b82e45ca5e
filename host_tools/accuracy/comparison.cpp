// Draws a glyph with the core and compares every pixel with the truth.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "areas.hpp"
#include "canvas.hpp"

namespace inkcell::tools {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The mean is over the ink box with this margin; the worst pixel may be a
// little farther. [px]
constexpr double kMeanMargin = 1.5;
constexpr int kWindowMargin = 4;

// Beyond the reach of any filter. [px]
constexpr double kReach = 1;

constexpr std::array<Offset, kMaxPhases> kPhases = {{{0, 0},
                                                     {32, 16},
                                                     {16, 48},
                                                     {48, 32},
                                                     {8, 24},
                                                     {40, 8},
                                                     {24, 56},
                                                     {56, 40}}};

// The generator draws at multiples of 1/8 px, which must not be judged. Random
// offsets are others.
bool may_be_judged(const Offset& offset) {
  return offset.x % 8 == 0 && offset.y % 8 == 0;
}

// The offsets at which a glyph is drawn at a size.
std::vector<Offset> offsets_of(const ComparisonRequest& request,
                               char32_t code_point,
                               double px) {
  if (request.positions == 0) {
    return {kPhases.begin(), kPhases.begin() + request.phases};
  }
  std::seed_seq seeds = {request.seed, static_cast<uint32_t>(code_point),
                         static_cast<uint32_t>(std::lround(px * 64))};
  std::mt19937 random(seeds);
  std::vector<Offset> offsets;
  while (offsets.size() < static_cast<size_t>(request.positions)) {
    const auto bits = random();
    const Offset offset = {static_cast<int>(bits & 63),
                           static_cast<int>(bits >> 6 & 63)};
    if (!may_be_judged(offset)) {
      offsets.push_back(offset);
    }
  }
  return offsets;
}

// A glyph at one size, angle and offset on a canvas of its own.
struct Setting {
  double px = 0;
  double cosine = 1;
  double sine = 0;
  Offset offset;
  InkBox box;  // of the ink, relative to the origin [px, y down]
  int x0 = 0;  // of the canvas, relative to the origin's pixel
  int y0 = 0;
  int width = 0;
  int height = 0;

  double offset_x() const { return offset.x / 64.0; }
  double offset_y() const { return offset.y / 64.0; }
};

InkBox turned_box(const TrueGlyph& truth, const Setting& setting) {
  const double scale = setting.px / 1024;
  InkBox box{1e9, 1e9, -1e9, -1e9};
  for (const double x : {truth.low().x, truth.high().x}) {
    for (const double y : {truth.low().y, truth.high().y}) {
      const double right = scale * (x * setting.cosine - y * setting.sine);
      const double down = -scale * (x * setting.sine + y * setting.cosine);
      box.x0 = std::min(box.x0, right);
      box.x1 = std::max(box.x1, right);
      box.y0 = std::min(box.y0, down);
      box.y1 = std::max(box.y1, down);
    }
  }
  return box;
}

Setting make_setting(const TrueGlyph& truth,
                     double px,
                     double angle,
                     const Offset& offset) {
  Setting setting;
  setting.px = px;
  setting.cosine = std::cos(angle * kPi / 180);
  setting.sine = std::sin(angle * kPi / 180);
  setting.offset = offset;
  if (!truth.empty()) {
    setting.box = turned_box(truth, setting);
  }
  const InkBox& box = setting.box;
  setting.x0 = static_cast<int>(std::floor(box.x0)) - kWindowMargin;
  setting.y0 = static_cast<int>(std::floor(box.y0)) - kWindowMargin;
  setting.width =
      static_cast<int>(std::ceil(box.x1)) + kWindowMargin + 1 - setting.x0;
  setting.height =
      static_cast<int>(std::ceil(box.y1)) + kWindowMargin + 1 - setting.y0;
  return setting;
}

// A pixel's centre relative to the glyph's origin. [px, y down]
Vector centre(const Setting& setting, int x, int y) {
  return {x + setting.x0 + 0.5 - setting.offset_x(),
          y + setting.y0 + 0.5 - setting.offset_y()};
}

bool in_box(const InkBox& box, Vector p) {
  return p.x > box.x0 - kMeanMargin && p.x < box.x1 + kMeanMargin &&
         p.y > box.y0 - kMeanMargin && p.y < box.y1 + kMeanMargin;
}

TrueTiles tiles_for(const TrueGlyph& truth, double px) {
  return TrueTiles(truth, kReach * 1024 / px);
}

// Exact distances at all pixels. [px]
std::vector<double> true_distances(TrueTiles& truth, const Setting& setting) {
  std::vector<double> distances;
  const double u_per_px = 1024 / setting.px;
  for (int y = 0; y < setting.height; ++y) {
    for (int x = 0; x < setting.width; ++x) {
      const Vector p = centre(setting, x, y);
      const Vector in_glyph = {
          u_per_px * (p.x * setting.cosine - p.y * setting.sine),
          u_per_px * (-p.y * setting.cosine - p.x * setting.sine)};
      distances.push_back(truth.distance(in_glyph) / u_per_px);
    }
  }
  return distances;
}

// Exact areas of all pixels, 0..1.
std::vector<double> true_areas(const TrueGlyph& truth, const Setting& setting) {
  const double scale = setting.px / 1024;
  const auto on_canvas = [&](Vector p) {
    return Vector{scale * (p.x * setting.cosine - p.y * setting.sine) +
                      setting.offset_x() - setting.x0,
                  -scale * (p.x * setting.sine + p.y * setting.cosine) +
                      setting.offset_y() - setting.y0};
  };
  std::vector<TrueGlyph::Chord> border;
  for (const TrueGlyph::Chord& piece : truth.border()) {
    border.push_back({on_canvas(piece.a), on_canvas(piece.b)});
  }
  return pixel_areas(border, setting.width, setting.height);
}

// What a filter makes of all pixels. [1/255]
std::vector<double> true_coverage(const ExactFilter& filter,
                                  const TrueGlyph& truth,
                                  TrueTiles& tiles,
                                  const Setting& setting) {
  std::vector<double> coverage = filter.is_area()
                                     ? true_areas(truth, setting)
                                     : true_distances(tiles, setting);
  for (double& pixel : coverage) {
    pixel = filter.is_area() ? 255 * pixel : filter.coverage(pixel);
  }
  return coverage;
}

Image draw(const Font& font,
           uint16_t glyph,
           const Setting& setting,
           const Style& style) {
  Image image(setting.width, setting.height);
  Line line;
  line.glyphs.push_back({0, 0, glyph});
  draw_lines(font, {line}, style,
             make_point(setting.offset_x() - setting.x0,
                        setting.offset_y() - setting.y0),
             image);
  return image;
}

void compare(const Image& drawn,
             const std::vector<double>& exact,
             const Setting& setting,
             char32_t code_point,
             bool inked,
             GlyphErrors& errors) {
  size_t i = 0;
  for (int y = 0; y < setting.height; ++y) {
    for (int x = 0; x < setting.width; ++x) {
      const ErrorPlace place = {code_point,     setting.offset,  x + setting.x0,
                                y + setting.y0, *drawn.at(x, y), exact[i]};
      errors.add(place, inked && in_box(setting.box, centre(setting, x, y)));
      ++i;
    }
  }
}

}  // namespace

double ExactFilter::coverage(double distance_px) const {
  const double ramp = (distance_px - outside_px) / (inside_px - outside_px);
  if (ramp <= 0 || ramp >= 1) {
    return ramp <= 0 ? 0 : 255;
  }
  return 255 * std::pow(ramp, exponent);
}

ExactFilter exact_filter(std::string_view name) {
  static constexpr NamedFilter kArea = {"area", &kFilterArea};
  if (name == kArea.name) {
    return {&kArea};
  }
  static_cast<void>(filter_of(name));  // throws if unknown
  for (const NamedFilter& device : kFilters) {
    if (device.name != name) {
      continue;
    }
    if (name == "text") {
      return {&device, -0.5, 0.5, 1};
    }
    if (name == "motion") {
      return {&device, -0.6, 0.625, 1};
    }
    if (name == "paper_display") {
      return {&device, -0.75, 0.75, 1.1};
    }
    return {&device, -0.5, 0.625, 1.1};
  }
  return {};
}

std::vector<GlyphErrors> compare_glyph(const Subject& subject,
                                       const ComparisonRequest& request) {
  const TrueGlyph& truth = subject.truth;
  std::vector<GlyphErrors> errors(request.sizes.size() *
                                  request.filters.size());
  for (size_t s = 0; s < request.sizes.size(); ++s) {
    TrueTiles tiles = tiles_for(truth, request.sizes[s]);
    for (const Offset& offset :
         offsets_of(request, subject.code_point, request.sizes[s])) {
      const Setting setting =
          make_setting(truth, request.sizes[s], request.angle, offset);
      for (size_t f = 0; f < request.filters.size(); ++f) {
        const ExactFilter& filter = request.filters[f];
        const Style style =
            make_style(setting.px, request.angle, *filter.device->filter);
        compare(draw(subject.font, subject.glyph, setting, style),
                true_coverage(filter, truth, tiles, setting), setting,
                subject.code_point, !truth.empty(),
                errors[s * request.filters.size() + f]);
      }
    }
  }
  return errors;
}

Picture draw_picture(const Subject& subject,
                     const ExactFilter& filter,
                     double px,
                     double angle,
                     Offset offset) {
  const Setting setting = make_setting(subject.truth, px, angle, offset);
  const Style style = make_style(px, angle, *filter.device->filter);
  Picture picture;
  picture.x0 = setting.x0;
  picture.y0 = setting.y0;
  picture.drawn = draw(subject.font, subject.glyph, setting, style);
  TrueTiles tiles = tiles_for(subject.truth, px);
  picture.exact = true_coverage(filter, subject.truth, tiles, setting);
  return picture;
}

}  // namespace inkcell::tools
