// A drawing of one colour in an SVG file, as an outline.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "shape/affine.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// A rectangle in user units, y down.
struct ViewBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// An SVG file: paths and basic shapes in groups, with transforms, both rules
/// of filling, and strokes of constant width. Whatever else would be drawn is
/// an error: text, pictures, <use>, style sheets, gradients, clip paths, masks,
/// dashes, part transparency, several colours.
class SvgDrawing {
 public:
  /// Throws Error that names the file.
  explicit SvgDrawing(const std::filesystem::path& file);
  ~SvgDrawing();
  SvgDrawing(const SvgDrawing&) = delete;
  SvgDrawing& operator=(const SvgDrawing&) = delete;

  /// The attribute viewBox, else width and height; nothing without either.
  /// Throws Error if it encloses nothing.
  std::optional<ViewBox> view_box() const;

  /// What is drawn, mapped from user units, y down, to u, y up, by `to_u`: ink
  /// on the left, no winding number below 0. Curves stay curves, also along
  /// strokes, within kStrokeBound_u. Chords replace them in strokes that turn
  /// tighter than half the pen, and in fills whose contours cross, unless the
  /// rule is nonzero and all turn the same way.
  ///
  /// Throws Error that names the file, the line, the element and the remedy.
  Outline outline(const Affine& to_u) const;

 private:
  struct Document;

  std::filesystem::path file_;
  std::unique_ptr<Document> document_;
};

/// How far the border of a stroke may be from the exact one. [u] 1/1024 px at
/// 64 px/em.
inline constexpr double kStrokeBound_u = 1.0 / 64;

}  // namespace inkcell::gen
