// Converts a field back to curves, and measures the error.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/curve_fitter.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "shape/outline.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell::design {

struct FieldOutlineOptions {
  double tolerance_u = 0.3;  // of the curves from the field's edge
  bool extremes = true;
};

/// The edge of a field as lines and cubics, filled on the left. Walks contours
/// (contour_walk.hpp), finds corners (loop.hpp) and fits curves
/// (curve_fitter.hpp) by the field's own distance.
gen::Outline outline_of(const GlyphField& field,
                        const FieldOutlineOptions& options);

/// A field that the generator makes of a shape, and its record.
class ShapeField {
 public:
  /// `options` say how true, for which sizes. `shape` must not be empty.
  /// Throws gen::GeometryError.
  ShapeField(const gen::Shape& shape, const gen::Target& options);

  const GlyphField& field() const { return field_; }
  size_t bytes() const { return record_.size(); }

 private:
  std::vector<uint8_t> record_;
  GlyphField field_;
};

/// The distance between two edges, in both directions. [u]
struct EdgeError {
  double worst = 0;
  double sum = 0;       // of squares, by length
  double length_u = 0;  // of both edges

  double rms() const;
  void add(const EdgeError& other);
};

/// Compares points every `step_u` on each edge with the other edge.
EdgeError edge_error(const gen::Shape& a, const gen::Shape& b, double step_u);

}  // namespace inkcell::design
