#include "editor/window/icons.hpp"

#include <algorithm>
#include <vector>

namespace inkcell::design::editor {
namespace {

// An icon on a grid of 16 x 16.
class Icon {
 public:
  Icon(ImVec2 at, float side, ImU32 colour)
      : at_(at), unit_(side / 16), colour_(colour) {}

  void lines(const std::vector<ImVec2>& places, bool closed) const {
    std::vector<ImVec2> points;
    for (const ImVec2 place : places) {
      points.push_back(map(place));
    }
    ImGui::GetWindowDrawList()->AddPolyline(
        points.data(), static_cast<int>(points.size()), colour_,
        closed ? ImDrawFlags_Closed : ImDrawFlags_None, width());
  }
  void fill(const std::vector<ImVec2>& places) const {
    std::vector<ImVec2> points;
    for (const ImVec2 place : places) {
      points.push_back(map(place));
    }
    ImGui::GetWindowDrawList()->AddConvexPolyFilled(
        points.data(), static_cast<int>(points.size()), colour_);
  }
  void circle(ImVec2 centre, float radius, bool filled) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (filled) {
      list.AddCircleFilled(map(centre), radius * unit_, colour_, 24);
    } else {
      list.AddCircle(map(centre), radius * unit_, colour_, 64, width());
    }
  }
  void curve(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d, float thick) const {
    ImGui::GetWindowDrawList()->AddBezierCubic(map(a), map(b), map(c), map(d),
                                               colour_, thick * unit_, 24);
  }

 private:
  ImVec2 map(ImVec2 place) const {
    return {at_.x + unit_ * place.x, at_.y + unit_ * place.y};
  }
  float width() const { return std::max(1.3f * unit_, 1.4f); }

  ImVec2 at_;
  float unit_;
  ImU32 colour_;
};

}  // namespace

void draw_icon(ToolKind kind, ImVec2 at, float side, ImU32 colour) {
  const Icon icon(at, side, colour);
  switch (kind) {
    case ToolKind::select:
      icon.fill({{4, 1}, {13, 10}, {8.4f, 10}});
      icon.fill({{4, 1}, {8.4f, 10}, {4, 13.6f}});
      break;
    case ToolKind::pen:
      icon.lines({{8, 1.5f}, {12, 8}, {10, 12}, {6, 12}, {4, 8}}, true);
      icon.lines({{8, 2}, {8, 7}}, false);
      icon.circle({8, 8}, 1.3f, true);
      icon.lines({{5.5f, 14.5f}, {10.5f, 14.5f}}, false);
      break;
    case ToolKind::knife:
      icon.lines({{2, 14}, {7, 9}}, false);
      icon.lines({{6, 8}, {13, 1.5f}, {13.6f, 4.5f}, {8.4f, 10.4f}}, true);
      break;
    case ToolKind::rectangle:
      icon.lines({{2.5f, 4}, {13.5f, 4}, {13.5f, 12}, {2.5f, 12}}, true);
      break;
    case ToolKind::ellipse:
      icon.circle({8, 8}, 5.8f, false);
      break;
    case ToolKind::stroke:
      icon.curve({2.5f, 12}, {5, -1}, {10, 18}, {13.5f, 4}, 2.6f);
      break;
    case ToolKind::measure:
      icon.lines({{2, 11}, {11, 2}, {14, 5}, {5, 14}}, true);
      icon.lines({{5.2f, 7.8f}, {6.8f, 9.4f}}, false);
      icon.lines({{8.2f, 4.8f}, {9.8f, 6.4f}}, false);
      break;
    case ToolKind::spacing:
      icon.lines({{1, 13}, {4.2f, 3}, {7.4f, 13}}, false);
      icon.lines({{2.2f, 9.5f}, {6.2f, 9.5f}}, false);
      icon.lines({{8.6f, 3}, {11.8f, 13}, {15, 3}}, false);
      break;
  }
}

}  // namespace inkcell::design::editor
