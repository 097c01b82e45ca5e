#include "text_scene.hpp"

namespace inkcell::scenes {

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

Text TextScene::wider_word(const Font& font, Text text) noexcept {
  const Text first = word_of(text, 0);
  const Text second = word_of(text, 1);
  return measure(font, second).advance > measure(font, first).advance ? second
                                                                      : first;
}

bool TextScene::read_number(int32_t most,
                            Text unit,
                            int32_t& number) const noexcept {
  Text rest = text();
  number = 0;
  for (; rest.size > unit.size && *rest.data >= '0' && *rest.data <= '9';
       rest = {rest.data + 1, rest.size - 1}) {
    const int32_t digit = *rest.data - '0';
    if (number > (most - digit) / 10) {
      return false;
    }
    number = number * 10 + digit;
  }
  bool is_unit = number > 0 && rest.size == unit.size;
  for (size_t i = 0; is_unit && i < unit.size; ++i) {
    is_unit = rest.data[i] == unit.data[i];
  }
  return is_unit;
}

}  // namespace inkcell::scenes
