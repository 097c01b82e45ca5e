// The strokes that a glyph is made of: centre lines, knots and nibs.
#include "editor/strokes.hpp"

#include "editor/segments.hpp"
#include "editor/window/outline_layer.hpp"

namespace inkcell::design::editor {
namespace {

constexpr int kNibCorners = 48;
constexpr int kChordsOfPiece = 24;

}  // namespace

void OutlineLayer::draw_strokes() const {
  attempt(panels_.editor, [this] {
    const Selection& knots = panels_.editor.knots;
    const std::vector<Stroke> strokes = strokes_of(*glyph_);
    for (size_t s = 0; s < strokes.size(); ++s) {
      draw_centre_line(strokes[s]);
      const std::vector<Nib> nibs = nibs_of(strokes[s]);
      for (size_t i = 0; i < nibs.size(); ++i) {
        const StrokePoint& knot = strokes[s].points[i];
        const bool is_selected = knots.count({s, i}) != 0;
        if (is_selected) {
          draw_nib(knot, nibs[i], knots.size() == 1);
        }
        const ImVec2 at = map(knot.at.x, knot.at.y);
        const float half = px(3.4f);
        if (knot.is_corner) {
          list_.AddRectFilled({at.x - half, at.y - half},
                              {at.x + half, at.y + half},
                              is_selected ? colour::selected : colour::corner);
        } else {
          list_.AddCircleFilled(
              at, half + px(0.6f),
              is_selected ? colour::selected : colour::smooth);
        }
      }
    }
  });
}

void OutlineLayer::draw_centre_line(const Stroke& stroke) const {
  for (const gen::Segment& piece :
       centre_line(panels_.editor.project(), stroke)) {
    const bool is_line = piece.kind == gen::Segment::Kind::line;
    const int chords = is_line ? 1 : kChordsOfPiece;
    for (int i = 0; i < chords; ++i) {
      const Point a = point_at(piece, static_cast<double>(i) / chords);
      const Point b = point_at(piece, static_cast<double>(i + 1) / chords);
      list_.AddLine(map(a.x, a.y), map(b.x, b.y), colour::guide, px(1.6f));
    }
  }
}

// The border of a nib, with its handles.
void OutlineLayer::draw_nib(const StrokePoint& knot,
                            const Nib& nib,
                            bool has_handles) const {
  const std::vector<Point> border = nib_polygon(nib, kNibCorners);
  for (size_t i = 0; i < border.size(); ++i) {
    const Point a = knot.at + border[i];
    const Point b = knot.at + border[(i + 1) % border.size()];
    list_.AddLine(map(a.x, a.y), map(b.x, b.y), colour::selected, px(1.2f));
  }
  if (!has_handles) {
    return;
  }
  const NibHandles handles = handles_of(knot, nib);
  const ImVec2 from = map(knot.at.x, knot.at.y);
  for (const Point end : {handles.along, handles.across}) {
    const ImVec2 at = map(end.x, end.y);
    list_.AddLine(from, at, colour::handle);
    list_.AddCircleFilled(at, px(3.4f), colour::paper);
    list_.AddCircle(at, px(3.4f), colour::handle, 0, px(1.3f));
  }
}

}  // namespace inkcell::design::editor
