// Checks that a scene has one SHA-256 of states and frames: played, and sought
// to, and in strips of any height.
#pragma once

#include <stdint.h>

#include "check_hash.hpp"
#include "expected_motion.hpp"
#include "fonts.hpp"
#include "inkcell/font.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "paper.hpp"

namespace golden {

using namespace inkcell;

inline constexpr int32_t kWidth = 80;
inline constexpr int32_t kHeight = 40;
inline constexpr int32_t kRows = 4;
inline constexpr uint32_t kFrames = scenes::kLoopFrames;

alignas(4) inline uint8_t buffer[kWidth * kRows * 4];

inline Font& golden_font() {
  static Font font;
  CHECK_OK(Font::open(golden::font_bytes(golden::FontId::dejavu_sans_outline),
                      font));
  return font;
}

// A strip and its ink.
struct Sheet {
  port::Xrgb8888Canvas canvas;

  scenes::Paper paper(int32_t y, int32_t rows) {
    const size_t bytes = static_cast<size_t>(kWidth * rows) * 4;
    canvas.set_strip({{buffer, bytes}, 0, y, kWidth, rows, kWidth * 4});
    CHECK_OK(canvas.status());
    return {canvas.window, this,
            [](void* context, uint32_t rgb) -> const Sink& {
              Sheet& sheet = *static_cast<Sheet*>(context);
              sheet.canvas.set_colour(0xff000000 | rgb);
              return sheet.canvas;
            }};
  }
};

template <typename Scene>
void add_frame(Scene& scene, int32_t rows, Sha256& sha) {
  const scenes::StateSink state = {
      &sha, [](void* context, int32_t value) {
        const auto bits = static_cast<uint32_t>(value);
        const uint8_t bytes[] = {
            static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
            static_cast<uint8_t>(bits >> 16), static_cast<uint8_t>(bits >> 24)};
        static_cast<Sha256*>(context)->add(bytes);
      }};
  scene.tell_state(state);
  Sheet sheet;
  for (int32_t y = 0; y < kHeight; y += rows) {
    scene.draw(sheet.paper(y, rows));
    sha.add(sheet.canvas.strip().pixels);
  }
}

template <typename Scene>
void check_played(const char* name, Scene& scene, const char* expected) {
  CHECK_OK(scene.open());
  Sha256 sha;
  for (uint32_t i = 0; i < kFrames; ++i) {
    scene.set_frame(i);
    add_frame(scene, kRows, sha);
  }
  check_hash(name, sha, expected);
}

// Some frames on the way, and the same ones in another order, from a scene that
// has been elsewhere, in other strips.
template <typename Scene>
void check_sought(Scene& scene) {
  const uint32_t kSome[] = {60, 170, 90, 25};
  char first[4][65];
  CHECK_OK(scene.open());
  uint32_t frame = 0;
  const uint32_t kAscending[] = {kSome[3], kSome[0], kSome[2], kSome[1]};
  for (const uint32_t target : kAscending) {
    while (frame <= target) {
      scene.set_frame(frame++);
    }
    Sha256 sha;
    add_frame(scene, kRows, sha);
    for (int i = 0; i < 4; ++i) {
      if (kSome[i] == target) {
        sha.finish().to_hex(first[i]);
        break;
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    scene.set_frame(kSome[i]);
    Sha256 sha;
    add_frame(scene, 1, sha);
    char hex[65];
    sha.finish().to_hex(hex);
    CHECK(equal(hex, first[i]));
  }
}

// Plays a scene.
template <typename Scene>
void check_played_scene(const char* name, Text text, const char* expected) {
  static Scene scene({&golden_font(), text, kWidth, kHeight, {}});
  check_played(name, scene, expected);
}

// Plays a scene, and seeks in it.
template <typename Scene>
void check_scene(const char* name,
                 Text text,
                 const char* expected,
                 const scenes::SceneMemory& memory = {}) {
  static Scene scene({&golden_font(), text, kWidth, kHeight, memory});
  check_played(name, scene, expected);
  check_sought(scene);
}

}  // namespace golden
