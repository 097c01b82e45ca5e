#include "text_scene.hpp"

namespace inkcell {
namespace scenes {

TextScene::TextScene(const SceneSetting& setting,
                     Text widest,
                     int32_t width_part_q8,
                     int32_t height_part_q8) noexcept
    : setting_(setting),
      has_ink_(find_place(*setting.font,
                          widest,
                          setting.width,
                          setting.height,
                          width_part_q8,
                          height_part_q8,
                          place_)),
      style_(place_.size, kFilterMotion),
      changed_(screen()) {}

Point TextScene::centred(Text line) const noexcept {
  const PixelMeasure ink = Painter().measure(font(), style_, line);
  return {
      Q26_6::from_raw(setting_.width * 32 - (ink.left.raw + ink.right.raw) / 2),
      place_.origin.y};
}

}  // namespace scenes
}  // namespace inkcell
