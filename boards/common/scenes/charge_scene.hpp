// Scene `charge`: a battery that is charged; its number glows.
#pragma once

#include "inkcell/kinetic/numbers.hpp"
#include "text_scene.hpp"

namespace inkcell {
namespace scenes {

/// A frame depends only on its number.
class ChargeScene : public TextScene {
 public:
  static constexpr const char* kText = "72%";

  explicit ChargeScene(const SceneSetting& setting) noexcept
      : TextScene(setting, setting.text, 110, 80) {}

  /// bad_argument: the text has no ink.
  Status open() noexcept { return status(); }

  void set_frame(uint32_t frame) noexcept { next(frame, screen()); }

  void draw(const Paper& paper) const noexcept {
    // A breath of 2.5 s, 0..256.
    const uint32_t turn = frame() % 75 * 65536 / 75;
    const int32_t breath =
        128 - kinetic::cosine(Angle::from_raw(uint16_t(turn))).raw / 128;
    paper.fill(0x06100c);
    const int32_t unit = px(24) + 1;
    const int32_t w = screen().x1;
    const int32_t h = screen().y1;
    const Rect body = {w / 2 - h * 5 / 8, h / 5, w / 2 + h * 5 / 8, h * 4 / 5};
    paper.fill(0x3c5a4c, body);
    paper.fill(0x3c5a4c, {body.x1, h * 2 / 5, body.x1 + 2 * unit, h * 3 / 5});
    const Rect in = {body.x0 + unit, body.y0 + unit, body.x1 - unit,
                     body.y1 - unit};
    paper.fill(0x0a1a12, in);
    paper.fill(mix_rgb(0x124a2c, 0x1c7a46, breath),
               {in.x0, in.y0, in.x0 + (in.x1 - in.x0) * 72 / 100, in.y1});
    const Painter glow = painter(paper, mix_rgb(0x1c6a40, 0x9dffca, breath));
    glow.text(font(), Style(style().size(), kGlowFilter), origin(), text());
    painter(paper, 0xf4fff8).text(font(), style(), origin(), text());
  }

 private:
  using Angle = kinetic::Angle;
  static constexpr Filter kGlowFilter =
      make_filter({Q6_10::from_raw(-4096), Q6_10::from_raw(1024),
                   Fixed<uint16_t, 8>::from_int(2)});
};

}  // namespace scenes
}  // namespace inkcell
