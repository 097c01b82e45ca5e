// A glyph on the canvas: fill, outline, points, cells, what tools draw.
#pragma once

#include <imgui.h>

#include "editor/window/panels.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design::editor {

/// Draws into the canvas whose upper left corner is `origin`.
class OutlineLayer {
 public:
  OutlineLayer(Panels& panels, ImVec2 origin);

  void draw_zones() const;
  void draw_guides() const;
  void draw_layers() const;
  void draw_background() const;
  void draw_fill() const { draw_ink(colour::fill); }
  void draw_components() const;
  /// Glyph and components in black, as a reader sees them.
  void draw_black() const;
  void draw_parts() const;
  /// Centre lines, knots and nibs.
  void draw_strokes() const;
  void draw_cells() const;
  void draw_contours() const;
  void draw_points() const;
  void draw_marks() const;
  /// The line of text of the Spacing tool.
  void draw_line() const;

 private:
  void draw_ink(ImU32 ink) const;
  ImVec2 map(double x, double y) const;
  std::shared_ptr<const tools::Image> background() const;
  void fill(const gen::Shape& shape,
            double scale,
            ImU32 colour,
            double x = 0) const;
  void outline(const PointContour& contour, ImU32 colour) const;
  bool shows_handle(size_t contour, size_t point) const;
  void handles(size_t contour) const;
  void draw_centre_line(const Stroke& stroke) const;
  void draw_nib(const StrokePoint& knot,
                const Nib& nib,
                bool has_handles) const;

  Panels& panels_;
  ImVec2 origin_;
  const View& view_;
  GlyphPointer glyph_;
  ImDrawList& list_;
};

}  // namespace inkcell::design::editor
