// Plays scenes of the boards on the host.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "display.hpp"
#include "image.hpp"
#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "inkcell/status.hpp"
#include "paper.hpp"

namespace inkcell::tools {

/// Figures of bodies in one frame, or the extremes of several.
struct BodyFigures {
  // The deepest overlap of two: as drawn, and without deformation, beyond what
  // the rules allow. [px]
  double drawn = 0;
  double rigid = 0;
  double squash = 0;  // the greatest, of a letter's height
  // Ink as drawn over ink without deformation: of a body, and of all.
  double least_body_ink = 1;
  double greatest_body_ink = 1;
  double least_ink = 1;
  double greatest_ink = 1;
  // Bodies that rest, but not on the floor, in the last frame.
  int off_floor = 0;

  /// Adds a later frame.
  void add(const BodyFigures& frame);
};

/// A scene of any kind. The font and the text must outlive it.
class Player {
 public:
  virtual ~Player() = default;

  virtual Status open() = 0;
  virtual void set_frame(uint32_t frame) = 0;
  /// Draws the frame on a strip.
  virtual void draw(const scenes::Paper& paper) = 0;
  virtual void add_changes(DirtyRects& dirty) const = 0;
  virtual uint32_t next_due() const = 0;
  /// The state that the frame depends on: little-endian numbers.
  virtual std::vector<uint8_t> state() const = 0;
  /// RAM of the scene and its grids, without strips. [bytes]
  virtual size_t state_bytes() const = 0;
  /// Figures of the bodies, by pixels; none if the scene has none.
  virtual std::optional<BodyFigures> figures() const = 0;
};

struct SceneKind {
  std::string_view name;
  std::string_view what;
  std::string_view text;   // the default
  std::string_view takes;  // what may be its text
  std::string_view
      morphs;  // pairs that text is best with, as --morph takes them
  std::unique_ptr<Player> (*make)(const Font& font,
                                  std::string_view text,
                                  int width,
                                  int height,
                                  std::optional<simulation::PrintStyle> print);
};

/// All scenes.
const std::vector<SceneKind>& scene_kinds();

/// Throws std::runtime_error that lists all scenes, and `reel`.
const SceneKind& find_scene(const std::string& name);

/// Draws the player's frame in strips of `rows` rows, and shows it.
Image draw_frame(Player& player, DisplayMemory& memory, int rows);

/// A scene of a kind, open; figure15 may be printed. Throws std::runtime_error
/// that says what the scene takes if the text, the font or the screen does not
/// suit it.
std::unique_ptr<Player> open_scene(
    const SceneKind& kind,
    const Font& font,
    std::string_view text,
    int width,
    int height,
    std::optional<simulation::PrintStyle> print = std::nullopt);

}  // namespace inkcell::tools
