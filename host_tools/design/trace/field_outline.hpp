// From a field back to curves, and what that costs in truth.
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

/// The edge of a field as lines and cubics, filled on the left: contours walked
/// (contour_walk.hpp), corners found (loop.hpp), curves fitted
/// (curve_fitter.hpp) with the field's own distance as their error.
gen::Outline outline_of(const GlyphField& field,
                        const FieldOutlineOptions& options);

/// A field that the generator makes of a shape, with the record it lies in.
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

/// How far two edges are from each other, both ways. [u]
struct EdgeError {
  double worst = 0;
  double sum = 0;       // of squares, by length
  double length_u = 0;  // of both edges

  double rms() const;
  void add(const EdgeError& other);
};

/// Places every `step_u` on each edge against the other edge.
EdgeError edge_error(const gen::Shape& a, const gen::Shape& b, double step_u);

}  // namespace inkcell::design
