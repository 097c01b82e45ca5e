#include "pipeline/font_hints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "parallel.hpp"
#include "rom/outline_font.hpp"

namespace inkcell::gen {
namespace {

// Whether outlines are pixels of a size that lies between these [px]: straight
// lines between points of one grid. Fitting could only move them away from it.
constexpr int kLeastPixels = 5;
constexpr int kMostPixels = 32;

bool is_pixel_font(const std::vector<Outline>& outlines) {
  std::vector<double> places;  // [u]
  for (const Outline& outline : outlines) {
    for (const Contour& contour : outline.contours) {
      for (const Segment& segment : contour.segments) {
        if (segment.kind != Segment::Kind::line) {
          return false;
        }
        places.insert(places.end(), {segment.p[0].x, segment.p[0].y});
      }
    }
  }
  constexpr double kRounding = 1;
  for (int pixels = kLeastPixels; pixels <= kMostPixels; ++pixels) {
    const double step = 1024.0 / pixels;
    if (std::all_of(places.begin(), places.end(), [step](double place) {
          return std::abs(std::remainder(place, step)) <= kRounding;
        })) {
      return !places.empty();
    }
  }
  return false;
}

}  // namespace

FontHints find_hints(const RomContent& content, int jobs) {
  const size_t count = content.glyphs.size();
  std::vector<Outline> outlines(count);
  std::vector<GlyphFeatures> features(count);
  parallel_for(count, jobs, [&](size_t i) {
    outlines[i] = decoded_outline(content, i);
    features[i] = find_features(outlines[i]);
  });
  if (is_pixel_font(outlines)) {
    return {};
  }
  FontHints hints;
  hints.face = find_face(features, content.glyph_of);
  const double u = 1024.0 / content.metrics.units_per_em;
  for (size_t i = 0; i < count; ++i) {
    const GlyphMetrics& metrics = content.glyphs[i].metrics;
    hints.glyphs.push_back(make_glyph_hints(
        features[i], hints.face, {metrics.x_min * u, metrics.x_max * u}));
  }
  return hints;
}

}  // namespace inkcell::gen
