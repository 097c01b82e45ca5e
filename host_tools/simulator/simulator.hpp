// The simulator without its window: settings in, frames out.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "display.hpp"
#include "font_worker.hpp"
#include "overlay.hpp"
#include "rom_file.hpp"
#include "settings.hpp"
#include "stage.hpp"

namespace inkcell::tools {

/// A frame and the cost of drawing it.
struct Frame {
  explicit Frame(const DisplayMemory& shown)
      : memory(shown), picture(shown.picture()) {}

  DisplayMemory memory;
  Image picture;  // as the eye sees it
  Overlay overlay;
  DrawStats stats;          // of text and scenes, not of demos
  double milliseconds = 0;  // on this machine
  size_t strip_bytes = 0;
  size_t state_bytes = 0;
  size_t font_bytes = 0;        // 0: the board's own font
  std::optional<Point> origin;  // of text
};

class Simulator {
 public:
  /// Makes a font; none if it is not ready, then it will be asked again. May
  /// throw.
  using FontMaker = std::function<std::optional<RomFile>(const FontWish& wish)>;

  explicit Simulator(FontMaker make_font) : make_font_(std::move(make_font)) {}

  Settings settings;

  /// Draws the settings, unless they are drawn already. The last frame stays
  /// while their font is being made, or if they cannot be drawn, which throws
  /// std::runtime_error.
  void update();

  /// The last frame; null before the first.
  std::shared_ptr<const Frame> frame() const { return frame_; }

 private:
  const Font* font_for(const FontWish& wish);
  bool open_stage();
  void draw();

  FontMaker make_font_;
  struct Made {
    RomFile rom;
    FontWish wish;
  };
  std::map<std::string, Made> fonts_;  // by coding
  std::optional<Font> board_font_;
  const Font* font_ = nullptr;  // of the stage; null: a board's own
  Settings tried_;
  bool is_tried_ = false;
  std::string problem_;  // of the last attempt
  std::unique_ptr<Stage> stage_;
  std::shared_ptr<const Frame> frame_;
};

}  // namespace inkcell::tools
