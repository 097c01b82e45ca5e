// The display, enlarged, with its overlay.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "window/panels.hpp"

namespace inkcell::tools {
namespace {

constexpr ImU32 kDesk = IM_COL32(226, 230, 236, 255);
constexpr ImU32 kBezel = IM_COL32(44, 48, 56, 255);
constexpr ImU32 kGridLine = IM_COL32(128, 134, 144, 90);
constexpr ImU32 kPointed = IM_COL32(244, 132, 20, 255);
constexpr float kBezelWidth = 10;
constexpr float kRoom = 26;  // around the display that fills the panel
constexpr int kGridZoom = 4;

constexpr ImU32 kLeaf = IM_COL32(72, 150, 235, 255);
constexpr ImU32 kSaturated = IM_COL32(140, 146, 156, 120);
constexpr ImU32 kCurve = IM_COL32(244, 132, 20, 255);
constexpr ImU32 kControl = IM_COL32(120, 160, 220, 200);
constexpr ImU32 kSmooth = IM_COL32(60, 180, 96, 255);
constexpr ImU32 kCorner = IM_COL32(230, 84, 70, 255);
constexpr ImU32 kOffCurve = IM_COL32(120, 160, 220, 255);

struct View {
  ImVec2 at;  // of the display's upper left corner
  float zoom;

  ImVec2 map(Place p) const { return {at.x + zoom * p.x, at.y + zoom * p.y}; }
};

int filling_zoom(ImVec2 room, const Image& image) {
  const auto fits = [](float side, int pixels) {
    return static_cast<int>((side - 2 * px(kRoom)) /
                            static_cast<float>(pixels));
  };
  return std::clamp(
      std::min(fits(room.x, image.width), fits(room.y, image.height)), 1,
      kMostZoom);
}

void draw_grid(const View& view, const Image& image, ImDrawList& list) {
  const auto width = static_cast<float>(image.width);
  const auto height = static_cast<float>(image.height);
  for (float x = 1; x < width; ++x) {
    const ImVec2 top = view.map({x, 0});
    list.AddRectFilled(top, {top.x + 1, top.y + view.zoom * height}, kGridLine);
  }
  for (float y = 1; y < height; ++y) {
    const ImVec2 left = view.map({0, y});
    list.AddRectFilled(left, {left.x + view.zoom * width, left.y + 1},
                       kGridLine);
  }
}

void draw_overlay(const View& view, const Overlay& overlay, ImDrawList& list) {
  for (const bool is_saturated : {true, false}) {
    for (const Overlay::Leaf& leaf : overlay.leaves) {
      if (leaf.is_saturated == is_saturated) {
        const ImVec2 corners[] = {
            view.map(leaf.corners[0]), view.map(leaf.corners[1]),
            view.map(leaf.corners[2]), view.map(leaf.corners[3])};
        list.AddPolyline(corners, 4, is_saturated ? kSaturated : kLeaf,
                         ImDrawFlags_Closed, 1);
      }
    }
  }
  for (const bool is_control : {true, false}) {
    for (const Overlay::Curve& curve : overlay.curves) {
      if (curve.is_control != is_control) {
        continue;
      }
      for (size_t i = 1; i < curve.places.size(); ++i) {
        list.AddLine(view.map(curve.places[i - 1]), view.map(curve.places[i]),
                     is_control ? kControl : kCurve, is_control ? 1.0f : 1.5f);
      }
    }
  }
  const float radius = std::clamp(view.zoom / 4, px(1.5f), px(3.5f));
  for (const Overlay::Dot& dot : overlay.dots) {
    const ImVec2 at = view.map(dot.at);
    if (dot.kind == PointKind::corner) {
      list.AddRectFilled({at.x - radius, at.y - radius},
                         {at.x + radius, at.y + radius}, kCorner);
    } else {
      list.AddCircleFilled(at, radius,
                           dot.kind == PointKind::smooth ? kSmooth : kOffCurve);
    }
  }
}

// Names and frames the pixel below the pointer.
void point_at(Panels& panels,
              const View& view,
              const Image& image,
              ImDrawList& list) {
  panels.pointed.clear();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!ImGui::IsItemHovered() || view.zoom <= 0) {
    return;
  }
  const auto x =
      static_cast<int>(std::floor((mouse.x - view.at.x) / view.zoom));
  const auto y =
      static_cast<int>(std::floor((mouse.y - view.at.y) / view.zoom));
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
    return;
  }
  const uint8_t* rgb = image.at(x, y);
  char text[64];
  std::snprintf(text, sizeof text, "x %d  y %d    %d %d %d", x, y, rgb[0],
                rgb[1], rgb[2]);
  panels.pointed = text;
  if (view.zoom >= kGridZoom) {
    const auto left = static_cast<float>(x);
    const auto top = static_cast<float>(y);
    list.AddRect(view.map({left, top}), view.map({left + 1, top + 1}), kPointed,
                 0, 0, px(1.5f));
  }
}

// Wheel: zooms about the pointer. Drag: pans.
void handle_pointer(Panels& panels, ImVec2 middle) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    panels.pan.x += io.MouseDelta.x;
    panels.pan.y += io.MouseDelta.y;
  }
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0) {
    return;
  }
  const int step = std::max(1, panels.zoom / 6);
  const int zoom = std::clamp(panels.zoom + (io.MouseWheel > 0 ? step : -step),
                              1, kMostZoom);
  const float ratio =
      static_cast<float>(zoom) / static_cast<float>(panels.zoom);
  const ImVec2 from = {io.MousePos.x - middle.x, io.MousePos.y - middle.y};
  panels.pan = {from.x - ratio * (from.x - panels.pan.x),
                from.y - ratio * (from.y - panels.pan.y)};
  panels.simulator.settings.zoom = zoom;
}

}  // namespace

void draw_display_view(Panels& panels) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + room.x, corner.y + room.y}, kDesk);
  const std::shared_ptr<const Frame> frame = panels.simulator.frame();
  if (frame == nullptr || room.x < 1 || room.y < 1) {
    return;
  }
  const Settings& settings = panels.simulator.settings;
  const Image& image = frame->picture;
  const ImVec2 middle = {corner.x + room.x / 2, corner.y + room.y / 2};
  ImGui::InvisibleButton(
      "display", room,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  handle_pointer(panels, middle);
  if (settings.zoom == 0) {
    panels.pan = {0, 0};
  }
  panels.zoom = settings.zoom == 0 ? filling_zoom(room, image) : settings.zoom;
  const auto zoom = static_cast<float>(panels.zoom);
  const ImVec2 size = {zoom * static_cast<float>(image.width),
                       zoom * static_cast<float>(image.height)};
  const View view = {{std::round(middle.x + panels.pan.x - size.x / 2),
                      std::round(middle.y + panels.pan.y - size.y / 2)},
                     zoom};
  const ImVec2 end = {view.at.x + size.x, view.at.y + size.y};
  const float bezel = px(kBezelWidth);
  list.AddRectFilled({view.at.x - bezel, view.at.y - bezel},
                     {end.x + bezel, end.y + bezel}, kBezel, px(6));
  if (const ImTextureID texture = panels.textures.of(frame, &image, image)) {
    list.AddImage(texture, view.at, end);
  }
  list.PushClipRect(view.at, end, true);
  if (settings.has_grid && panels.zoom >= kGridZoom) {
    draw_grid(view, image, list);
  }
  if (settings.has_overlay) {
    draw_overlay(view, frame->overlay, list);
  }
  point_at(panels, view, image, list);
  list.PopClipRect();
}

}  // namespace inkcell::tools
