// Two seconds a style. The ink is light on dark paper, so lit places get more
// ink.
#include "print_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/timeline.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;
using namespace simulation;

constexpr uint32_t kBackground = 0x10131c;
constexpr uint32_t kParts = 5;
constexpr uint32_t kPartFrames = kLoopFrames / kParts;
constexpr uint32_t kWipeFrames = 16;  // at the end of a part

struct Part {
  PrintStyle style;
  uint32_t body;  // under the print
  uint32_t ink;
  int32_t screen;  // of lines [degrees]
  int32_t pitch;   // [1/16 of the pitch of relief]
};

constexpr Part kAll[kParts] = {
    {PrintStyle::relief, 0x2b1a12, 0xffd9a0, 0, 16},
    {PrintStyle::engraving, 0x0f2a24, 0xa6f0d0, 20, 16},
    {PrintStyle::rings, 0x2a1a3c, 0xff8fb8, 0, 11},
    {PrintStyle::hatching, 0x1c2233, 0xf2f0e6, 50, 18},
    {PrintStyle::halftone, 0x33180f, 0xff9a52, 30, 20}};

}  // namespace

PrintScene::PrintScene(const SceneSetting& setting) noexcept
    : SceneBase(setting) {
  Span<int8_t> memory = setting.memory.grid;
  grid_ = take_grid(memory, width_, height_, scale_for(width_));
}

Status PrintScene::open() noexcept {
  if (grid_.width() == 0) {
    return Status::buffer_small;
  }
  TextPlace place;
  if (!find_place(font_, text_, width_, height_, 230, 205, place) ||
      !paint_text(font_, text_, place, workspace_, grid_)) {
    return Status::bad_argument;
  }
  now_ = known_pixels(grid_);
  return Status::ok;
}

PrintLook PrintScene::look_of(uint32_t part) const noexcept {
  const Part& of = kAll[part];
  PrintLook look;
  look.style = of.style;
  // The light goes round once in a part, from the upper left.
  const uint32_t turn = frame_ % kPartFrames * 65536 / kPartFrames;
  look.light = Angle::from_raw(
      static_cast<uint16_t>(from_degrees(135 + 180).raw - turn));
  look.screen = from_degrees(of.screen);
  // Finer lines are noise to the eye: each has two pixels, and each gap. Rings
  // are finer, so that two of them are within reach of the grid.
  const int32_t relief = height_ * 64 / 36;
  look.pitch =
      Q26_6::from_raw((relief < 4 * 64 ? 4 * 64 : relief) * of.pitch / 16);
  look.slope = Q26_6::from_raw(height_ * 64 / 27);
  if (of.style == PrintStyle::rings) {
    look.shift.raw = static_cast<int32_t>(frame_ % kLoopFrames) * 8;
  }
  look.tone = of.style == PrintStyle::relief ? 90 : 100;
  look.contrast = of.style == PrintStyle::relief ? 160 : 130;
  return look;
}

void PrintScene::draw_part(const Paper& paper,
                           uint32_t part,
                           const Rect& window) const noexcept {
  Sink body = paper.with(kAll[part].body);
  body.window = intersect(body.window, window);
  if (is_empty(body.window)) {
    return;
  }
  draw_grid(grid_, {}, 0, 0, kFilterMotion, body);
  Sink ink = paper.with(kAll[part].ink);
  ink.window = body.window;
  draw_print(grid_, look_of(part), 0, 0, kFilterMotion, ink);
}

void PrintScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const uint32_t part = frame_ / kPartFrames % kParts;
  const auto since = static_cast<int32_t>(frame_ % kPartFrames);
  const auto begins = static_cast<int32_t>(kPartFrames - kWipeFrames);
  const Q16_16 wiped =
      ease(kEaseInOut, fraction(begins, begins + kWipeFrames, since));
  const int32_t border = lerp(now_.x0, now_.x1, wiped);
  draw_part(paper, (part + 1) % kParts, {now_.x0, 0, border, height_});
  draw_part(paper, part, {border, 0, now_.x1, height_});
}

void PrintScene::tell_state(const StateSink& sink) const noexcept {
  tell_grid(grid_, sink);
}

}  // namespace inkcell::scenes
