// The line of text of the Spacing tool.
#include <algorithm>

#include "editor/spacing.hpp"
#include "editor/window/outline_layer.hpp"
#include "model/bearings.hpp"
#include "model/contours.hpp"

namespace inkcell::design::editor {
namespace {

// The shape of a glyph of the line, kept while the glyph does not change.
std::shared_ptr<const gen::Shape> shape_in_line(Panels& panels,
                                                const Project& project,
                                                const PlacedGlyph& placed) {
  for (const LineShape& kept : panels.line_shapes) {
    if (kept.glyph == placed.glyph) {
      return kept.shape;
    }
  }
  std::shared_ptr<const gen::Shape> shape;
  attempt(panels.editor, [&] {
    shape =
        std::make_shared<const gen::Shape>(outline_of(project, *placed.glyph));
  });
  panels.line_shapes.push_back({placed.glyph, shape});
  return shape;
}

}  // namespace

void OutlineLayer::draw_line() const {
  const Project project = panels_.editor.shown_project();
  const std::vector<PlacedGlyph> line =
      line_of_text(project, panels_.editor.preview.text);
  const double scale = gen::kUPerEm / project.units_per_em();
  constexpr size_t kMostKept = 200;
  if (panels_.line_shapes.size() > kMostKept) {
    panels_.line_shapes.clear();
  }
  const Value& info = project.font->info;
  const double em = project.units_per_em();
  const float top = map(0, info.value("ascender", 0.8 * em)).y;
  const float bottom = map(0, info.value("descender", -0.2 * em)).y;
  ImGui::PushFont(tools::small_font());
  for (const PlacedGlyph& placed : line) {
    const bool is_shown = placed.name == panels_.editor.glyph_name();
    const auto shape = shape_in_line(panels_, project, placed);
    if (shape != nullptr && !shape->empty()) {
      fill(*shape, scale, colour::ink, placed.x);
    }
    const float edges[] = {map(placed.x, 0).x,
                           map(placed.x + placed.glyph->width, 0).x};
    for (const float x : edges) {
      for (float y = top; y < bottom; y += px(8)) {
        list_.AddLine({x, y}, {x, std::min(y + px(4), bottom)},
                      is_shown ? colour::tool : colour::zone);
      }
    }
    const auto caption = [&](float y, ImU32 colour, double value) {
      char text[32];
      std::snprintf(text, sizeof text, "%g", value);
      list_.AddText(
          {(edges[0] + edges[1] - ImGui::CalcTextSize(text).x) / 2, y}, colour,
          text);
    };
    caption(bottom + px(4), colour::faint, placed.glyph->width);
    if (placed.kern != 0) {
      list_.AddRectFilled({map(placed.x - placed.kern, 0).x, bottom + px(20)},
                          {edges[0], bottom + px(24)}, colour::selected);
      char text[32];
      std::snprintf(text, sizeof text, "%g", placed.kern);
      list_.AddText({edges[0] - px(8), bottom + px(26)}, colour::selected,
                    text);
    }
  }
  ImGui::PopFont();
}

}  // namespace inkcell::design::editor
