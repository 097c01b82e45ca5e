// The letter rests and is wound up. Its strokes thin, and may break where they
// are thinnest; then the vortex runs back, a little too far, and leaves the
// letter.
#include "vortex_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "inkcell/style.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;
using namespace simulation;

constexpr uint32_t kBackground = 0x0c1018;
constexpr uint32_t kRing = 0x1a3854;
constexpr uint32_t kBody = 0xf2e6cf;
constexpr uint32_t kCore = 0xd9763f;

// The part of its most turn that the vortex has turned by. [ms; Q16]
constexpr uint32_t kBegins = 2;  // [frames]
constexpr uint32_t kRests = 264;
constexpr Keyframe kTurned[] = {{33, 0, cubic_bezier(200, 50, 500, 1000)},
                                {4700, 65536, kEaseInOut},
                                {8000, -65536 / 24, kEaseInOut},
                                {8800, 0, kLinear}};
// Of the centre, for strokes that the grid shows when they are thin. [turns,
// Q16]
constexpr int32_t kMostTurn = 65536 * 3 / 2;
// The part of its ink that the letter keeps where it is wound up most: strokes
// break where they are thinnest. [of 256]
constexpr int32_t kLeastInk = 192;

// The colours of a print, and the angle of its lines at rest.
struct PrintInks {
  uint32_t body;
  uint32_t ink;
  int32_t screen;  // [degrees]
};

// In the order of PrintStyle.
constexpr PrintInks kPrintInks[] = {{0x2a1a3c, 0xff8fb8, 0},
                                    {0x0f2a24, 0xa6f0d0, 20},
                                    {0x1c2233, 0xf2f0e6, 50},
                                    {0x33180f, 0xff9a52, 30},
                                    {0x2b1a12, 0xffd9a0, 0}};

// The length of the curve at a distance inside of the edge, doubled. [samples;
// 1/32 of a sample]
int32_t length_at(const DistanceGrid& grid, int32_t distance) noexcept {
  int32_t count = 0;
  for (int32_t i = 0; i < grid.width() * grid.height(); ++i) {
    const int32_t away = grid.row(0)[i] - distance;
    count += away >= -32 && away < 32 ? 1 : 0;
  }
  return count;
}

}  // namespace

VortexScene::VortexScene(const SceneSetting& setting) noexcept
    : SceneBase(setting) {
  Span<int8_t> memory = setting.memory.grid;
  grid_ = take_grid(memory, width_, height_, scale_for(width_));
  next_ = take_grid(memory, width_, height_, scale_for(width_));
  letter_ = take_grid(memory, letter_side(width_, width_ * 5 / 8),
                      letter_side(width_, height_ / 2), scale_for(width_));
  left_ = (grid_.width() - letter_.width()) / 2;
  top_ = (grid_.height() - letter_.height()) / 2;
}

// Just below half of the height, and 5/8 of the width, in the middle: less if
// the letter would leave the screen when it is turned.
bool VortexScene::paint_letter() noexcept {
  TextPlace place;
  int32_t part_q8 = 256;
  int32_t room = 0;
  for (; room < 1 && part_q8 > 32; part_q8 -= 16) {
    if (!find_place(font_, text_, width_, height_, 160 * part_q8 >> 8,
                    120 * part_q8 >> 8, place)) {
      return false;
    }
    const PixelMeasure ink = Painter().measure(font_, Style(place.size), text_);
    const int32_t across = (ink.right.raw - ink.left.raw) >> 6;
    const int32_t down = (ink.bottom.raw - ink.top.raw) >> 6;
    const int32_t side = (width_ < height_ ? width_ : height_) * 15 / 16;
    room = side * side - across * across - down * down;
  }
  const int32_t side_q6 = 64 << letter_.scale_log2();
  place.origin.x.raw -= left_ * side_q6;
  place.origin.y.raw -= top_ * side_q6;
  return paint_text(font_, text_, place, workspace_, letter_);
}

Status VortexScene::open() noexcept {
  if (letter_.width() == 0) {
    return Status::buffer_small;
  }
  if (!paint_letter()) {
    return Status::bad_argument;
  }
  wind(letter_, left_, top_, Vortex(), grid_);
  area_ = letter_.area();
  // Wound up, strokes thinner than 4 samples would be dotted: the more there
  // are, the less the vortex turns.
  const int32_t edge = length_at(letter_, 0);
  const int32_t inner = length_at(letter_, 2 * 32 - 1);
  const int32_t most = kMostTurn / (edge + 1) * inner;
  most_turn_ = most < kMostTurn / 2 ? kMostTurn / 2
               : most < kMostTurn   ? most
                                    : kMostTurn;
  now_ = known_pixels(grid_);
  return Status::ok;
}

// The letter, wound up: a function of the frame.
void VortexScene::set_frame(uint32_t frame) noexcept {
  const int32_t before = turn_;
  const int32_t turned = value_at(kTurned, time_of(frame));
  frame_ = frame;
  turn_ = lerp(0, most_turn_, Q16_16::from_raw(turned));
  before_ = now_;
  has_changed_ = turn_ != before;
  if (!has_changed_) {
    return;
  }
  Vortex vortex;
  vortex.x.raw = grid_.width() << 15;
  vortex.y.raw = grid_.height() << 15;
  vortex.core = grid_.height() * 3 / 20;
  // 2 pi in Q8 is 1608.
  vortex.strength = static_cast<int32_t>(
      int64_t{vortex.core * vortex.core * 1608} * turn_ >> 16);
  wind(letter_, left_, top_, vortex, turn_ == 0 ? grid_ : next_);
  cutoff_ = {};
  if (turn_ != 0) {
    redistance(next_, grid_);
    const int32_t ink = 256 - ((256 - kLeastInk) * turned >> 16);
    cutoff_ = cutoff_for(grid_, area_ / 256 * ink, scratch_);
  }
  now_ = known_pixels(grid_);
}

void VortexScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  if (is_print_) {
    draw_print(paper);
  } else {
    draw_layers(paper);
  }
}

// A ring outside, the body, and its core: all drawn by distance.
void VortexScene::draw_layers(const Paper& paper) const noexcept {
  struct Layer {
    int32_t offset_q6;  // [px] on screens of 240 rows
    uint32_t ink;
  };
  constexpr Layer kLayers[] = {
      {5 * 64, kRing}, {0, kBody}, {-2 * 64 - 32, kCore}};
  for (const Layer& layer : kLayers) {
    const int32_t offset_q6 = layer.offset_q6 * height_ / 240;
    GridLook look;
    look.cutoff.raw = cutoff_.raw - (offset_q6 * 128 >> grid_.scale_log2());
    draw_grid(grid_, look, 0, 0, kFilterMotion, paper.with(layer.ink));
  }
}

// Lines turn with the vortex, by a third as much as its centre.
void VortexScene::draw_print(const Paper& paper) const noexcept {
  const PrintInks& inks = kPrintInks[static_cast<uint32_t>(print_)];
  PrintLook look;
  look.style = print_;
  look.light = from_degrees(-45);
  look.screen = Angle::from_raw(
      static_cast<uint16_t>(from_degrees(inks.screen).raw + turn_ / 3));
  look.screen_x = static_cast<int16_t>(width_ / 2);
  look.screen_y = static_cast<int16_t>(height_ / 2);
  const int32_t pitch =
      height_ * 64 / (look.style == PrintStyle::rings ? 72 : 40);
  look.pitch = Q26_6::from_raw(pitch < 160 ? 160 : pitch);
  look.slope = Q26_6::from_raw(height_ * 64 / 34);
  look.tone = 100;
  look.contrast = 140;
  look.cutoff = cutoff_;
  GridLook body;
  body.cutoff = look.cutoff;
  draw_grid(grid_, body, 0, 0, kFilterMotion, paper.with(inks.body));
  simulation::draw_print(grid_, look, 0, 0, kFilterMotion,
                         paper.with(inks.ink));
}

void VortexScene::add_changes(DirtyRects& dirty) const noexcept {
  if (has_changed_) {
    SceneBase::add_changes(dirty);
  }
}

uint32_t VortexScene::next_due() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  return frame_ + (phase < kBegins   ? kBegins - phase
                   : phase >= kRests ? kLoopFrames + kBegins - phase
                                     : 1);
}

void VortexScene::tell_state(const StateSink& sink) const noexcept {
  sink.tell(cutoff_.raw);
  tell_grid(grid_, sink);
}

}  // namespace inkcell::scenes
