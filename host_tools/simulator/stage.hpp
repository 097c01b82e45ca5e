// The content of a display: text, a board's demo, or an animated scene.
#pragma once

#include <cstdint>
#include <memory>

#include "boards.hpp"
#include "display.hpp"
#include "inkcell/font.hpp"
#include "overlay.hpp"
#include "player.hpp"
#include "settings.hpp"

namespace inkcell::tools {

class Stage {
 public:
  virtual ~Stage() = default;

  virtual void set_frame(uint32_t frame) = 0;
  /// Draws a whole strip; adds to `stats` if it can count.
  virtual void draw(const Strip& strip, DrawStats& stats) = 0;
  /// RAM of the scene, without strips; 0: unknown. [bytes]
  virtual size_t state_bytes() const = 0;
  /// The start of the first line of text; null without text.
  virtual const Point* origin() const { return nullptr; }
  virtual Overlay overlay() const { return {}; }
};

/// Text as inkcell-render draws it, in the middle of the display. The font must
/// outlive the result. Throws std::runtime_error.
std::unique_ptr<Stage> make_text_stage(const Settings& settings,
                                       const Font& font);

/// A scene of the boards, as inkcell-animate plays it.
std::unique_ptr<Stage> make_player_stage(const Settings& settings,
                                         const SceneKind& kind,
                                         const Font& font);

/// The demo of a board; one at a time for each board.
std::unique_ptr<Stage> make_demo_stage(const BoardDisplay& board);

}  // namespace inkcell::tools
