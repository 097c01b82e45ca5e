// Scenes of the boards, played on this machine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inkcell/font.hpp"
#include "inkcell/kinetic/dirty_rects.hpp"
#include "paper.hpp"

namespace inkcell::tools {

/// How deep the edges of two shapes are in each other. [px]
struct Penetration {
  double drawn = 0;  // after deformation
  double rigid = 0;  // as if nothing deformed
};

/// A scene of any kind. The font and the text must outlive it.
class Player {
 public:
  virtual ~Player() = default;

  /// Throws std::runtime_error if the font or the text does not suit the scene.
  virtual void open() = 0;
  virtual void set_frame(uint32_t frame) = 0;
  /// Draws what the frame has on a strip.
  virtual void draw(const scenes::Paper& paper) = 0;
  virtual void add_changes(kinetic::DirtyRects& dirty) const = 0;
  virtual uint32_t next_due() const = 0;
  /// What the frame depends on: numbers in little-endian order.
  virtual std::vector<uint8_t> state() const = 0;
  /// RAM of the scene and its grids, without strips. [bytes]
  virtual size_t state_bytes() const = 0;
  /// How deep bodies are in each other, pixel by pixel; none if the scene has
  /// no bodies.
  virtual std::optional<Penetration> penetration() const = 0;
};

struct SceneKind {
  std::string_view name;
  std::string_view what;
  std::string_view text;  // unless the person gives another
  std::unique_ptr<Player> (*make)(const Font& font,
                                  std::string_view text,
                                  int width,
                                  int height);
};

/// All there are.
const std::vector<SceneKind>& scene_kinds();

}  // namespace inkcell::tools
