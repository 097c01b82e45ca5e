// The parts of the window. Each draws itself and changes the settings.
#pragma once

#include <imgui.h>

#include <string>

#include "font_worker.hpp"
#include "simulator.hpp"
#include "window/textures.hpp"
#include "window/theme.hpp"
#include "window/widgets.hpp"

namespace inkcell::tools {

constexpr int kMostZoom = 64;

/// Shared state of the panels, beside the simulator.
struct Panels {
  Panels(Simulator& shown, Textures& kept) : simulator(shown), textures(kept) {}

  Simulator& simulator;
  Textures& textures;
  const FontWorker* worker = nullptr;  // of a window; null: none
  bool has_fixed_coding = false;       // the font was made before
  std::string problem;                 // why the last settings draw nothing
  bool is_playing = false;
  float frames_due = 0;  // fraction of a frame since the last one
  bool wants_quit = false;
  ImVec2 pan = {0, 0};  // of the display from the middle of its panel [px]
  int zoom = 1;         // as it is shown
  std::string pointed;  // the pixel under the pointer
  std::string message;  // of the last recording
};

/// Draws the whole window.
void draw_window(Panels& panels);

void draw_controls(Panels& panels);
void draw_display_view(Panels& panels);
void draw_player_bar(Panels& panels);
void draw_status(Panels& panels);

/// Handles a key by its SDL name.
void handle_key(Panels& panels, const std::string& key);

}  // namespace inkcell::tools
