#include "editor/knot_drag.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/segments.hpp"
#include "shape/points.hpp"

namespace inkcell::design::editor {
namespace {

constexpr int kChords = 24;  // of a piece, where the pointer hits it

struct OnLine {
  PointId knot;  // the one before
  Point at;
};

// The place of a centre line nearest to `at`.
std::optional<OnLine> nearest_on_line(const Editor& editor,
                                      const std::vector<Stroke>& strokes,
                                      Point at,
                                      double reach) {
  std::optional<OnLine> best;
  for (size_t s = 0; s < strokes.size(); ++s) {
    // The knot before a place: of paths through their points, the piece's.
    const std::vector<StrokePoint>& points = strokes[s].points;
    const std::vector<gen::Segment> pieces =
        centre_line(editor.project(), strokes[s]);
    for (size_t i = 0; i < pieces.size(); ++i) {
      for (int k = 0; k <= kChords; ++k) {
        const Point p = point_at(pieces[i], static_cast<double>(k) / kChords);
        const double d = length(p - at);
        if (d < reach) {
          reach = d;
          best = OnLine{{s, i}, p};
        }
      }
    }
    if (best && best->knot.contour == s && !strokes[s].is_smooth) {
      double nearest = INFINITY;
      for (size_t i = 0; i + 1 < points.size(); ++i) {
        const double d =
            distance_to_piece(best->at, points[i].at, points[i + 1].at);
        if (d < nearest) {
          nearest = d;
          best->knot.point = i;
        }
      }
    }
  }
  return best;
}

std::string nib_text(const Nib& nib) {
  char text[96];
  std::snprintf(text, sizeof text, "%.0f x %.0f, %.0f degrees", nib.width,
                nib.height, nib.angle / gen::kDegree);
  return text;
}

}  // namespace

bool KnotDrag::press(Editor& editor, const Pointer& pointer) {
  grip_ = Grip::none;
  return press_handle(editor, pointer) || press_knot(editor, pointer);
}

// Nibs have handles where one knot is selected.
bool KnotDrag::press_handle(const Editor& editor, const Pointer& pointer) {
  if (editor.knots.size() != 1) {
    return false;
  }
  grabbed_ = *editor.knots.begin();
  const Stroke stroke = strokes_of(*editor.glyph())[grabbed_.contour];
  const NibHandles handles = handles_of(stroke.points[grabbed_.point],
                                        nibs_of(stroke)[grabbed_.point]);
  const double along = length(handles.along - pointer.at);
  const double across = length(handles.across - pointer.at);
  if (std::min(along, across) >= pointer.reach) {
    return false;
  }
  grip_ = along <= across ? Grip::along : Grip::across;
  return true;
}

bool KnotDrag::press_knot(Editor& editor, const Pointer& pointer) {
  const GlyphPointer glyph = editor.glyph();
  const std::vector<Stroke> strokes = strokes_of(*glyph);
  double nearest = pointer.reach;
  for (size_t s = 0; s < strokes.size(); ++s) {
    for (size_t i = 0; i < strokes[s].points.size(); ++i) {
      const double d = length(strokes[s].points[i].at - pointer.at);
      if (d < nearest) {
        nearest = d;
        grabbed_ = {s, i};
        grip_ = Grip::knots;
      }
    }
  }
  if (grip_ == Grip::none) {
    return false;
  }
  if (pointer.twice) {
    grip_ = Grip::none;
    editor.run(toggle_corner(*glyph, grabbed_));
  } else if (pointer.shift && editor.knots.count(grabbed_) != 0) {
    editor.knots.erase(grabbed_);
  } else {
    if (!pointer.shift && editor.knots.count(grabbed_) == 0) {
      editor.select_nothing();
    }
    editor.knots.insert(grabbed_);
  }
  return true;
}

bool KnotDrag::press_line(Editor& editor, const Pointer& pointer) {
  const GlyphPointer glyph = editor.glyph();
  const std::vector<Stroke> strokes = strokes_of(*glyph);
  const auto hit = nearest_on_line(editor, strokes, pointer.at, pointer.reach);
  if (!hit) {
    return false;
  }
  editor.select_nothing();
  if (pointer.twice) {
    editor.run(add_knot(*glyph, hit->knot, hit->at));
    editor.knots = {{hit->knot.contour, hit->knot.point + 1}};
    return true;
  }
  for (size_t i = 0; i < strokes[hit->knot.contour].points.size(); ++i) {
    editor.knots.insert({hit->knot.contour, i});
  }
  grabbed_ = hit->knot;
  grip_ = Grip::knots;
  return true;
}

std::optional<Point> KnotDrag::knot(const Editor& editor) const {
  if (grip_ != Grip::knots || editor.knots.count(grabbed_) == 0) {
    return std::nullopt;
  }
  const GlyphPointer glyph = editor.stored();
  return strokes_of(*glyph)[grabbed_.contour].points[grabbed_.point].at;
}

std::string KnotDrag::drag_nib(Editor& editor, const Pointer& pointer) const {
  if (editor.knots.count(grabbed_) == 0) {
    return "";  // it was deselected
  }
  const GlyphPointer glyph = editor.stored();
  const Stroke stroke = strokes_of(*glyph)[grabbed_.contour];
  const Nib nib = with_handle(stroke.points[grabbed_.point],
                              nibs_of(stroke)[grabbed_.point],
                              grip_ == Grip::along, pointer.at, pointer.shift);
  editor.propose(set_nib(*glyph, grabbed_, nib));
  return nib_text(nib);
}

void select_knots(Editor& editor, const Selection& kept, Point a, Point b) {
  editor.knots = kept;
  const auto [x0, x1] = std::minmax(a.x, b.x);
  const auto [y0, y1] = std::minmax(a.y, b.y);
  const std::vector<Stroke> strokes = strokes_of(*editor.glyph());
  for (size_t s = 0; s < strokes.size(); ++s) {
    for (size_t i = 0; i < strokes[s].points.size(); ++i) {
      const Point p = strokes[s].points[i].at;
      if (p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1) {
        editor.knots.insert({s, i});
      }
    }
  }
}

}  // namespace inkcell::design::editor
