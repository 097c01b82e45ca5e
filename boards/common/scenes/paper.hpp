// The drawing surface of scenes: a strip in any pixel format, with any ink.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::scenes {

/// Frames a second of every scene.
inline constexpr int32_t kFramesPerSecond = 30;

/// Frames until a scene repeats.
inline constexpr uint32_t kLoopFrames = 300;

/// A strip of a display. Formats without colour use the ink's lightness.
struct Paper {
  Rect window;  // on the screen [px]
  void* context = nullptr;
  /// A sink over the window for ink of a colour, 0xRRGGBB; until the next call.
  const Sink& (*ink)(void* context, uint32_t rgb) = nullptr;

  const Sink& with(uint32_t rgb) const noexcept { return ink(context, rgb); }

  void fill(uint32_t rgb) const noexcept { fill(rgb, window); }

  void fill(uint32_t rgb, const Rect& rect) const noexcept {
    const Rect box = intersect(rect, window);
    if (is_empty(box)) {
      return;
    }
    const Sink& sink = with(rgb);
    for (int32_t y = box.y0; y < box.y1; ++y) {
      sink.solid(sink.context, box.x0, y, box.x1 - box.x0);
    }
  }
};

/// Collects the numbers that frames depend on, to compare machines of either
/// byte order.
struct StateSink {
  void* context = nullptr;
  void (*add)(void* context, int32_t value) = nullptr;

  void tell(int32_t value) const noexcept { add(context, value); }
};

/// The RAM that a scene needs on a screen.
struct SceneNeeds {
  size_t grid = 0;  // samples of distances
  size_t particles = 0;
  size_t homes = 0;
};

/// RAM of a scene. It must outlive the scene.
struct SceneMemory {
  Span<int8_t> grid;
  Span<simulation::Particle> particles;
  Span<simulation::ParticleHome> homes;
};

/// The setting of a scene. The font and the text must outlive it.
struct SceneSetting {
  const Font* font = nullptr;
  Text text;
  int32_t width = 0;  // of the screen [px]
  int32_t height = 0;
  SceneMemory memory;  // at least needs() of width and height
  /// Speeds up large glyphs, and saves 1.1 KB of stack.
  Workspace workspace = {};
};

/// A colour between two. [part of 256]
constexpr uint32_t mix_rgb(uint32_t a, uint32_t b, int32_t part_q8) noexcept {
  uint32_t result = 0;
  for (uint32_t shift = 0; shift < 24; shift += 8) {
    const auto from = static_cast<int32_t>(a >> shift & 255);
    const auto to = static_cast<int32_t>(b >> shift & 255);
    const int32_t value = from + (to - from) * part_q8 / 256;
    result |= static_cast<uint32_t>(value) << shift;
  }
  return result;
}

/// The time of a frame in a loop. [ms]
constexpr int32_t time_of(uint32_t frame) noexcept {
  return static_cast<int32_t>(frame % kLoopFrames) * 1000 / kFramesPerSecond;
}

}  // namespace inkcell::scenes
