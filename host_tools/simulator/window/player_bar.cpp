// Play, step and frame; the status line; keys; and the layout of the panels.
#include <algorithm>
#include <cmath>

#include "paper.hpp"
#include "recording.hpp"
#include "window/panels.hpp"

namespace inkcell::tools {
namespace {

constexpr float kSideWidth = 352;
constexpr float kBarHeight = 46;
constexpr float kStatusHeight = 30;

// Advances by the time since the last frame of the window.
void play(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  panels.frames_due += ImGui::GetIO().DeltaTime * scenes::kFramesPerSecond;
  const float whole = std::floor(panels.frames_due);
  panels.frames_due -= whole;
  // Time that a pause of the window missed is skipped.
  settings.frame += static_cast<uint32_t>(std::min(whole, 3.0f));
}

void step(Settings& settings, int frames) {
  const auto frame = static_cast<int>(settings.frame) + frames;
  settings.frame = static_cast<uint32_t>(std::max(frame, 0));
}

// Names the file after the scene.
void record_scene(Panels& panels) {
  const std::string file = panels.simulator.settings.scene + ".gif";
  panels.is_playing = false;
  try {
    record(panels.simulator, file);
    panels.message = "Wrote " + file;
  } catch (const std::exception& error) {
    panels.message = error.what();
  }
}

// A progress bar while a font is being made.
bool draw_work(const Panels& panels) {
  const auto work =
      panels.worker == nullptr ? std::nullopt : panels.worker->work();
  if (!work) {
    return false;
  }
  const float part = work->count == 0 ? 0
                                      : static_cast<float>(work->done) /
                                            static_cast<float>(work->count);
  ImGui::Text("Making a font of %s", work->coding.c_str());
  ImGui::SameLine(0, px(18));
  const std::string glyphs = std::to_string(work->done) + " of " +
                             std::to_string(work->count) + " glyphs";
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour::guide);
  ImGui::ProgressBar(part, ImVec2(px(260), 0),
                     work->count == 0 ? "" : glyphs.c_str());
  ImGui::PopStyleColor();
  return true;
}

}  // namespace

void handle_key(Panels& panels, const std::string& key) {
  Settings& settings = panels.simulator.settings;
  if (key == "ctrl+q") {
    panels.wants_quit = true;
  } else if (key == "space" && is_moving(settings)) {
    panels.is_playing = !panels.is_playing;
  } else if (key == "left" || key == "right") {
    panels.is_playing = false;
    step(settings, key == "left" ? -1 : 1);
  } else if (key == "g") {
    settings.has_grid = !settings.has_grid;
  } else if (key == "o") {
    settings.has_overlay = !settings.has_overlay;
  } else if (key == "d") {
    settings.is_dark = !settings.is_dark;
  } else if (key == "0") {
    settings.zoom = 0;
  } else if (key == "-" || key == "=" || key == "+" || key == "shift+=") {
    settings.zoom =
        std::clamp(panels.zoom + (key == "-" ? -1 : 1), 1, kMostZoom);
  } else if (key.size() == 1 && key[0] >= '1' && key[0] <= '9') {
    const std::vector<std::string> scenes = scene_names();
    const auto number = static_cast<size_t>(key[0] - '1');
    if (number < scenes.size()) {
      choose_scene(settings, scenes[number]);
      panels.is_playing = is_moving(settings);
    }
  }
}

void draw_player_bar(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  ImGui::BeginDisabled(!is_moving(settings));
  if (ImGui::Button(panels.is_playing ? "Pause" : "Play", {px(64), 0})) {
    panels.is_playing = !panels.is_playing;
  }
  tooltip("30 frames a second", "Space");
  ImGui::SameLine();
  if (ImGui::Button("<")) {
    panels.is_playing = false;
    step(settings, -1);
  }
  tooltip("One frame back", "Left");
  ImGui::SameLine(0, px(3));
  if (ImGui::Button(">")) {
    panels.is_playing = false;
    step(settings, 1);
  }
  tooltip("One frame on", "Right");
  ImGui::SameLine();
  if (ImGui::Button("Record")) {
    record_scene(panels);
  }
  tooltip("Writes the scene's loop as a GIF into the current folder");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  const int loop = loop_frames(settings);
  auto frame = static_cast<int>(settings.frame) % loop;
  if (ImGui::SliderInt("##frame", &frame, 0, loop - 1, "frame %d",
                       ImGuiSliderFlags_AlwaysClamp)) {
    settings.frame = static_cast<uint32_t>(frame);
  }
  ImGui::EndDisabled();
}

void draw_status(Panels& panels) {
  ImGui::SetCursorPosY(px(6));
  if (draw_work(panels)) {
    return;
  }
  const Settings& settings = panels.simulator.settings;
  if (!panels.problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour::corner);
    ImGui::TextUnformatted(panels.problem.c_str());
    ImGui::PopStyleColor();
    return;
  }
  ImGui::Text("%d x %d", settings.width, settings.height);
  ImGui::SameLine(0, px(18));
  ImGui::TextUnformatted(display_info(settings.display).label);
  ImGui::SameLine(0, px(18));
  ImGui::Text("%d x", panels.zoom);
  ImGui::SameLine(0, px(18));
  ImGui::TextDisabled("%s", panels.pointed.empty() ? panels.message.c_str()
                                                   : panels.pointed.c_str());
  if (const auto frame = panels.simulator.frame()) {
    char text[64];
    std::snprintf(text, sizeof text, "drawn in %.2f ms on this machine",
                  frame->milliseconds);
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(text).x -
                    px(14));
    ImGui::TextDisabled("%s", text);
  }
}

void draw_window(Panels& panels) {
  if (panels.is_playing) {
    play(panels);
  }
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float side = px(kSideWidth);
  const float bottom = all.y - px(kStatusHeight);
  const float middle = bottom - px(kBarHeight);
  constexpr ImGuiWindowFlags kStill =
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  panel(
      "Display", {0, 0}, {all.x - side, middle},
      [&] { draw_display_view(panels); }, kStill);
  ImGui::PopStyleVar();
  panel(
      "Player", {0, middle}, {all.x - side, px(kBarHeight)},
      [&] { draw_player_bar(panels); }, kStill);
  panel("Controls", {all.x - side, 0}, {side, bottom},
        [&] { draw_controls(panels); });
  panel(
      "Status", {0, bottom}, {all.x, px(kStatusHeight)},
      [&] { draw_status(panels); }, kStill);
}

}  // namespace inkcell::tools
