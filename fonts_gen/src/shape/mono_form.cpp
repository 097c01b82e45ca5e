#include "shape/mono_form.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>
#include <utility>

#include "shape/clipper_units.hpp"
#include "shape/flatten.hpp"

namespace inkcell::gen {
namespace {

using ClipperLib::Paths;

constexpr uint8_t kFaint = 96;

// Along the border so much stays, 3/4 px at 16 px/em. [u]
constexpr double kRim_u = 48;

// Holes and islands of less area, and necks and cuts of less width, are left
// out: half a pixel at 24 px/em. [Clipper's units^2, u]
constexpr double kSpeck = 910 * kClipperUnits_per_u * kClipperUnits_per_u;
constexpr double kNeck_u = 20;

// Chords of curves are short, so that curves are found in them. [u]
constexpr double kChordBound_u = 1.0 / 64;
constexpr double kJoined_u = 1.0 / 32;

// Parts whose lightness differs by less are of one tone. [1/255]
constexpr double kContrast = 40;

constexpr const char* kFailure = "its layers could not be united";

// What is seen of a layer.
struct SeenPart {
  Paths paths;
  double area = 0;   // [Clipper's units^2]
  double light = 0;  // 0..255
};

Paths polygons_of(const Outline& outline) {
  Paths paths;
  for (const Contour& contour : outline.contours) {
    ClipperLib::Path path;
    for (const Point& p : flatten(contour, kChordBound_u)) {
      path.push_back(to_clipper(p));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

Paths combined(const Paths& a, ClipperLib::ClipType type, const Paths& b) {
  ClipperLib::Clipper clipper;
  const bool has_a = clipper.AddPaths(a, ClipperLib::ptSubject, true);
  const bool has_b = clipper.AddPaths(b, ClipperLib::ptClip, true);
  // Without area Clipper reports a failure.
  return has_a || has_b ? executed(clipper, type, kFailure) : Paths();
}

Paths grown(const Paths& paths, double by_u) {
  constexpr double kMiterLimit = 4;
  ClipperLib::ClipperOffset offset(kMiterLimit);
  offset.AddPaths(paths, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Paths result;
  offset.Execute(result, by_u * kClipperUnits_per_u);
  return result;
}

double area_of(const Paths& paths) {
  double sum = 0;
  for (const ClipperLib::Path& path : paths) {
    sum += ClipperLib::Area(path);
  }
  return std::abs(sum);
}

double light_of(const Paint& paint) {
  return 0.299 * paint.red + 0.587 * paint.green + 0.114 * paint.blue;
}

// From the uppermost one on; `whole` becomes their union.
std::vector<SeenPart> seen_parts(const std::vector<PaintedOutline>& layers,
                                 Paths& whole) {
  const bool has_strong = std::any_of(
      layers.begin(), layers.end(),
      [](const auto& layer) { return layer.paint.opacity >= kFaint; });
  std::vector<SeenPart> parts;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    if (has_strong && layer->paint.opacity < kFaint) {
      continue;
    }
    const Paths all = polygons_of(layer->outline);
    SeenPart part;
    part.paths = combined(all, ClipperLib::ctDifference, whole);
    part.area = area_of(part.paths);
    part.light = light_of(layer->paint);
    if (part.area > 0) {
      parts.push_back(std::move(part));
      whole = combined(all, ClipperLib::ctUnion, whole);
    }
  }
  return parts;
}

// Splits parts into two tones, so that lightness varies least within each, and
// returns the one with less area; nothing if they hardly differ.
Paths minor_tone(std::vector<SeenPart> parts) {
  std::stable_sort(
      parts.begin(), parts.end(),
      [](const SeenPart& a, const SeenPart& b) { return a.light < b.light; });
  double area = 0;
  double light = 0;
  for (const SeenPart& part : parts) {
    area += part.area;
    light += part.area * part.light;
  }
  double best = 0;
  size_t split = 0;
  double dark_area = 0;  // of the parts before the split
  double sum_area = 0;
  double sum_light = 0;
  for (size_t i = 0; i + 1 < parts.size(); ++i) {
    sum_area += parts[i].area;
    sum_light += parts[i].area * parts[i].light;
    const double contrast =
        (light - sum_light) / (area - sum_area) - sum_light / sum_area;
    const double between = sum_area * (area - sum_area) * contrast * contrast;
    if (contrast >= kContrast && between > best) {
      best = between;
      split = i + 1;
      dark_area = sum_area;
    }
  }
  const bool is_dark_minor = 2 * dark_area <= area;
  const size_t first = is_dark_minor ? 0 : split;
  const size_t end = is_dark_minor ? split : parts.size();
  Paths minor;
  for (size_t i = first; i < end; ++i) {
    minor.insert(minor.end(), parts[i].paths.begin(), parts[i].paths.end());
  }
  return minor;
}

// Without necks, cuts, specks and needless corners.
Paths cleaned(const Paths& paths) {
  Paths result = grown(grown(grown(paths, kNeck_u / 2), -kNeck_u), kNeck_u / 2);
  result.erase(std::remove_if(result.begin(), result.end(),
                              [](const ClipperLib::Path& path) {
                                return std::abs(ClipperLib::Area(path)) <
                                       kSpeck;
                              }),
               result.end());
  ClipperLib::CleanPolygons(result, kJoined_u * kClipperUnits_per_u);
  return result;
}

}  // namespace

Outline mono_form(const std::vector<PaintedOutline>& layers) {
  Paths whole;
  std::vector<SeenPart> parts = seen_parts(layers, whole);
  const Paths holes =
      combined(minor_tone(std::move(parts)), ClipperLib::ctIntersection,
               grown(whole, -kRim_u));
  const Paths form = cleaned(combined(whole, ClipperLib::ctDifference, holes));
  return outline_of(form.empty() ? whole : form);
}

}  // namespace inkcell::gen
