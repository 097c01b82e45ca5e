// ImGui on SDL: a window, or a reproducible picture in memory.
#pragma once

#include <SDL.h>
#include <imgui.h>

#include <cfloat>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "window/textures.hpp"

namespace inkcell::tools {

class Screen {
 public:
  /// A window with widgets at `scale`; 0: that of the display, if SDL knows it.
  /// Throws std::runtime_error.
  explicit Screen(const std::string& title, float scale = 0);
  /// A picture of `width` x `height` px at `scale`, without a display server.
  Screen(int width, int height, float scale);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  Textures& textures() { return *textures_; }

  /// Waits for input up to `wait_ms` and passes it to ImGui. `on_key` gets keys
  /// by their SDL names, such as ctrl+shift+z, unless a text field has the
  /// focus. Reads one press or release at a time, so that each gets a frame
  /// even if frames are slow; it does not wait before the frames after it, in
  /// which what it opens is measured and shown. False if the window was closed.
  bool read_input(int wait_ms,
                  const std::function<void(const std::string&)>& on_key);

  /// Draws one frame, whose widgets `panels` submits.
  void draw_frame(const std::function<void()>& panels);

  /// Writes the last frame. Throws std::runtime_error.
  void write_picture(const std::filesystem::path& file);

 private:
  void begin_imgui(float scale);
  void follow_pointer(const SDL_Event& event);
  void render();

  SDL_Window* window_ = nullptr;
  SDL_Surface* surface_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture* font_ = nullptr;
  std::unique_ptr<Textures> textures_;
  // The pointer at the last event that was read, not its current position.
  ImVec2 pointer_ = {-FLT_MAX, -FLT_MAX};
  bool is_down_[3] = {};  // as ImGui counts buttons
  int settling_ = 0;      // frames to come without waiting
};

}  // namespace inkcell::tools
