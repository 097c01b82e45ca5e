// Scene `charge`: a battery fills; its number rises and glows.
#pragma once

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class ChargeScene : public TextScene {
 public:
  static constexpr const char* kText = "72%";

  explicit ChargeScene(const SceneSetting& setting) noexcept
      : TextScene(setting, "100%", 130, 90) {}

  /// bad_argument: the text is not 1% to 100%.
  Status open() noexcept {
    return read_number(100, "%", most_) ? status() : Status::bad_argument;
  }

  void set_frame(uint32_t frame) noexcept {
    next(frame,
         bounding_box(Painter().box(font(), glow(), centred("100%"), "100%"),
                      bounding_box(body(), pole())));
  }

  void draw(const Paper& paper) const noexcept {
    using namespace motion;
    // It begins full, and fills again after it was emptied. It glows when it is
    // full.
    const int32_t now = frame_ms(122, kLoopFrames / 2);
    const Q16_16 filled =
        Q16_16::from_raw(ease(kEaseInOut, fraction(0, 2400, now)).raw -
                         ease(kEaseInOut, fraction(4200, 4800, now)).raw);
    const int32_t level = lerp(0, most_, filled);
    const int32_t breath =
        128 + lerp(0, 128, ease(kEaseInOut, fraction(2000, 2700, now))) -
        lerp(0, 128, ease(kEaseInOut, fraction(2900, 4200, now)));
    paper.fill(0x06100c);
    paper.fill(0x3c5a4c, body());
    paper.fill(0x3c5a4c, pole());
    Rect in = body();
    in = {in.x0 + unit(), in.y0 + unit(), in.x1 - unit(), in.y1 - unit()};
    paper.fill(0x0a1a12, in);
    // The edge is a part of a pixel.
    const int32_t wide = lerp(0, (in.x1 - in.x0) * 256 * most_ / 100, filled);
    const uint32_t ink = mix_rgb(0x124a2c, 0x1c7a46, breath);
    in.x1 = in.x0 + (wide >> 8);
    paper.fill(ink, in);
    paper.fill(mix_rgb(0x0a1a12, ink, wide & 255),
               {in.x1, in.y0, in.x1 + ((wide & 255) != 0 ? 1 : 0), in.y1});
    char digits[] = "000%";
    for (int32_t i = 2, rest = level; i >= 0; --i, rest /= 10) {
      digits[i] = static_cast<char>(digits[i] + rest % 10);
    }
    const Text line = digits + (level < 10 ? 2 : level < 100 ? 1 : 0);
    // The sign stands still.
    Point at = centred(text());
    at.x.raw +=
        to_px(font(), style(),
              measure(font(), text()).advance - measure(font(), line).advance)
            .raw;
    painter(paper, mix_rgb(0x1c6a40, 0x9dffca, breath))
        .text(font(), glow(), at, line);
    painter(paper, 0xf4fff8).text(font(), style(), at, line);
  }

 private:
  Style glow() const noexcept {
    static constexpr Filter kGlow =
        make_filter({Q6_10::from_raw(-4096), Q6_10::from_raw(1024),
                     Fixed<uint16_t, 8>::from_int(2)});
    return Style(style().size(), kGlow);
  }
  // Of the wall. [px]
  int32_t unit() const noexcept { return px(16) + 1; }
  // With the pole in the middle of the screen, twice as wide as high.
  Rect body() const noexcept {
    const int32_t w = screen().x1;
    const int32_t h = screen().y1;
    const int32_t half = (w * 3 < h * 5 ? w * 3 : h * 5) / 16;
    return {w / 2 - 2 * half - unit(), h / 2 - half, w / 2 + 2 * half - unit(),
            h / 2 + half};
  }
  Rect pole() const noexcept {
    const Rect box = body();
    const int32_t third = (box.y1 - box.y0) / 3;
    return {box.x1, box.y0 + third, box.x1 + 2 * unit(), box.y1 - third};
  }

  int32_t most_ = 0;  // [percent]
};

}  // namespace inkcell::scenes
