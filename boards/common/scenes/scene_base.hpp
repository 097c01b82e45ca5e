// The base of scenes other than TextScene.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// The setting, the frame, and what it draws over.
class SceneBase {
 public:
  SceneBase(const SceneBase&) = delete;
  SceneBase& operator=(const SceneBase&) = delete;

  /// Adds the areas in which the frame differs from the one before.
  void add_changes(DirtyRects& dirty) const noexcept {
    dirty.add(bounding_box(before_, now_), screen());
  }
  /// The next frame that looks different.
  uint32_t next_due() const noexcept { return frame_ + 1; }

 protected:
  explicit SceneBase(const SceneSetting& setting) noexcept
      : font_(*setting.font),
        text_(setting.text),
        width_(setting.width),
        height_(setting.height),
        workspace_(setting.workspace) {}

  Rect screen() const noexcept { return {0, 0, width_, height_}; }

  const Font& font_;
  Text text_;
  int32_t width_;
  int32_t height_;
  Workspace workspace_;
  uint32_t frame_ = 0;
  Rect before_;  // drawn by the last two frames
  Rect now_;
};

}  // namespace inkcell::scenes
