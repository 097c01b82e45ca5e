// Pictures that a glyph should be, near enough to tell which pixels need a
// second look.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "inkcell/geometry.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// A picture: its size, and where the glyph's origin lies within its pixel.
struct PictureSetting {
  int px = 0;
  int phase_x = 0;  // [1/64 px]
  int phase_y = 0;

  double u_per_px() const { return 1024.0 / px; }
  /// The centre of a pixel in the glyph. [u]
  double x_u(int x) const { return (x + 0.5 - phase_x / 64.0) * u_per_px(); }
  double y_u(int y) const { return (phase_y / 64.0 - y - 0.5) * u_per_px(); }

  /// The pixels whose centres are in `box` or less than `margin_px` around.
  Rect pixels_of(const Box& box, double margin_px) const;
};

/// What a pixel shows: the filter `text` of its distance from the border, 255
/// clamp(0.5 + distance in px), or the area of it that is filled.
enum class Measure : uint8_t { distance, area };

/// True coverage of a shape. Its border is simplified: chords of curves are
/// joined where that moves the border by kStray_px at most. So a picture costs
/// little, and each of its pixels is within kBound of the truth. The same on
/// every machine.
///
/// Pictures are asked for in the same order again and again; the first ones are
/// kept. Not for several threads at once; refers to the shape.
class TruePictures {
 public:
  /// Coverage has this unit. [1/255 / kUnit]
  static constexpr int kUnit = 128;
  /// The largest error, in kUnit.
  static constexpr int kBound = 66;

  /// `shape` must not be empty.
  TruePictures(const Shape& shape, Measure measure)
      : shape_(shape), measure_(measure) {}

  /// Begins with the first picture again.
  void rewind() { at_ = 0; }

  /// The coverage of `pixels`, row by row from the top. Valid until the next
  /// call.
  const int16_t* next(const PictureSetting& setting, const Rect& pixels);

 private:
  // The border moves by this at most. [px]
  static constexpr double kStray_px = 1.0 / 1024;

  static constexpr size_t kMostKept = size_t{1} << 22;  // [pixels]

  const std::vector<Edge>& border_for(int px);

  void draw_distances(const PictureSetting& setting, const Rect& pixels);
  void draw_areas(const PictureSetting& setting, const Rect& pixels);

  const Shape& shape_;
  Measure measure_;
  std::vector<Edge> border_;  // simplified for sizes up to border_px_
  int border_px_ = 0;
  std::vector<std::vector<int16_t>> kept_;
  size_t kept_pixels_ = 0;
  size_t at_ = 0;
  std::vector<int16_t> picture_;  // one that is not kept
  // Of each pixel the squared distance to the border [px^2], if it matters, and
  // whether an odd number of edges lies between it and the pixel to its left.
  std::vector<float> squares_;
  std::vector<uint8_t> toggles_;
  std::vector<double> gains_;  // see add_gains()
};

}  // namespace inkcell::gen
