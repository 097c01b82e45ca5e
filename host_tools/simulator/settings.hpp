// The settings: scene, display, style of text, view.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "display.hpp"

namespace inkcell::tools {

inline constexpr const char* kTextScene = "text";
inline constexpr const char* kDemoScene = "demo";

struct Settings {
  std::string scene = kTextScene;
  std::string board;  // the owner of the display; may be ""
  Display display = Display::grey4;
  int width = 128;  // [px]
  int height = 64;
  int rows = 8;  // of a strip
  uint32_t frame = 0;

  std::string text = "Hamburgefonts 0123456789";
  std::string coding = "outline";
  double px = 14;  // [px/em]
  std::string filter = "text";
  std::string hint = "display";
  double weight = 0;   // [px]
  double angle = 0;    // counter-clockwise [degrees]
  double shift_x = 0;  // to the right, from the middle [px]
  double shift_y = 0;  // down
  bool is_dark = true;

  int zoom = 0;  // 0: as large as fits the window
  bool has_grid = true;
  bool has_overlay = false;
};

/// Whether both give the same pixels.
bool draws_same(const Settings& a, const Settings& b);

/// All scenes, in the order of their keys.
std::vector<std::string> scene_names();

/// Selects a scene with its text, and a board if the scene needs one. Throws
/// std::runtime_error.
void choose_scene(Settings& settings, const std::string& name);
/// Selects a board's display; "none" for a display without a board.
void choose_board(Settings& settings, const std::string& name);
void choose_display(Settings& settings, Display display);

/// A setting, with its name in options and scripts.
struct SettingInfo {
  const char* name;
  const char* arguments;
  const char* help;
  /// Throws std::runtime_error.
  void (*set)(Settings& settings, const std::string& value);
};

/// All settings; those that change others come first.
const std::vector<SettingInfo>& setting_list();

/// Throws std::runtime_error that lists the names.
void set_option(Settings& settings,
                const std::string& name,
                const std::string& value);

}  // namespace inkcell::tools
