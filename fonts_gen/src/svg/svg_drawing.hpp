// An SVG drawing, as an outline or as layers of colours.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "shape/affine.hpp"
#include "shape/outline.hpp"
#include "shape/paint.hpp"

namespace inkcell::gen {

/// A rectangle in user units, y down.
struct ViewBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// An SVG file: paths and basic shapes in groups, with transforms, both fill
/// rules, and strokes of constant width. Anything else that would be drawn is
/// an error: text, pictures, <use>, style sheets, gradients, clip paths, masks,
/// dashes; for outline() also partial transparency and several colours.
class SvgDrawing {
 public:
  /// Throws Error that names the file.
  explicit SvgDrawing(const std::filesystem::path& file);
  ~SvgDrawing();
  SvgDrawing(const SvgDrawing&) = delete;
  SvgDrawing& operator=(const SvgDrawing&) = delete;

  /// The attribute viewBox, else width and height; nothing if there is neither.
  /// Throws Error if it is empty.
  std::optional<ViewBox> view_box() const;

  /// The drawing, mapped by `to_u` from user units, y down, to u, y up. Ink is
  /// on the left, no winding number is below 0. Curves stay curves, also the
  /// borders of strokes, within kStrokeBound_u. They become chords in strokes
  /// that turn more tightly than half the pen, and in fills whose contours
  /// cross, unless the rule is nonzero and all contours have one direction.
  ///
  /// Throws Error that names the file, the line, the element and the remedy.
  Outline outline(const Affine& to_u) const;

  /// The same as layers, from below; neighbours of one opaque colour are one.
  std::vector<PaintedOutline> layers(const Affine& to_u) const;

 private:
  struct Document;

  std::vector<PaintedOutline> read(const Affine& to_u, bool has_colours) const;

  std::filesystem::path file_;
  std::unique_ptr<Document> document_;
};

/// The largest distance of a stroke's border from the exact one. [u] 1/1024 px
/// at 64 px/em.
inline constexpr double kStrokeBound_u = 1.0 / 64;

}  // namespace inkcell::gen
