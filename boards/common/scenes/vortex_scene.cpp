// The letter rests and is wound up. Its strokes thin and break where they are
// thinnest; then the letter condenses out of them.
#include "vortex_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/melt.hpp"
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

// Frames of a loop.
constexpr uint32_t kBegins = 2;
constexpr uint32_t kThins = 70;
// Strokes are thick again before condense() lifts deep and far samples so much
// that layers far from the edge would show them.
constexpr uint32_t kHeals = 170;
constexpr uint32_t kEnds = 180;  // the vortex stops, the letter condenses
constexpr uint32_t kHealed = 196;
constexpr uint32_t kFilled = 226;
constexpr uint32_t kGrown = 234;
constexpr uint32_t kSwell = 25;  // until the vortex has full strength
// Every second frame a part of the rows becomes true distances again.
constexpr int32_t kRedistanceParts = 12;
constexpr uint32_t kFirstPart = 5;  // edges are clean when strokes heal

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

Q16_16 strength_at(uint32_t phase) noexcept {
  if (phase < kBegins || phase >= kEnds) {
    return {};
  }
  const uint32_t since = phase - kBegins;
  const uint32_t to_end = kEnds - 1 - phase;
  const uint32_t near = since < to_end ? since : to_end;
  return ease(kEaseInOut, fraction(0, kSwell, static_cast<int32_t>(near)));
}

}  // namespace

VortexScene::VortexScene(const SceneSetting& setting) noexcept
    : SceneBase(setting) {
  Span<int8_t> memory = setting.memory.grid;
  grid_ = take_grid(memory, width_, height_, scale_for(width_));
  next_ = take_grid(memory, width_, height_, scale_for(width_));
}

// 5/8 of the height and 3/4 of the width, in the middle: less if the letter
// would leave the screen when it is turned.
bool VortexScene::paint(DistanceGrid& grid) noexcept {
  TextPlace place;
  int32_t part_q8 = 256;
  int32_t room = 0;
  for (; room < 1 && part_q8 > 32; part_q8 -= 16) {
    if (!find_place(font_, text_, width_, height_, 192 * part_q8 >> 8,
                    160 * part_q8 >> 8, place)) {
      return false;
    }
    const PixelMeasure ink = Painter().measure(font_, Style(place.size), text_);
    const int32_t across = (ink.right.raw - ink.left.raw) >> 6;
    const int32_t down = (ink.bottom.raw - ink.top.raw) >> 6;
    const int32_t side = (width_ < height_ ? width_ : height_) * 15 / 16;
    room = side * side - across * across - down * down;
  }
  return paint_text(font_, text_, place, workspace_, grid);
}

bool VortexScene::restart() noexcept {
  frame_ = 0;
  cutoff_ = {};
  const bool is_painted = paint(grid_);
  area_ = grid_.area();
  return is_painted;
}

// Moves the edge until the shape has the letter's area: by a sample at most, so
// that every layer stays where the grid has distances.
void VortexScene::keep_area() noexcept {
  constexpr int32_t kMost = 1 << 13;
  const int32_t cutoff = cutoff_for(grid_, area_, scratch_).raw;
  cutoff_.raw = cutoff < -kMost ? -kMost : cutoff > kMost ? kMost : cutoff;
  has_changed_ = true;
}

Status VortexScene::open() noexcept {
  if (grid_.width() == 0 || next_.width() == 0) {
    return Status::buffer_small;
  }
  if (!restart()) {
    return Status::bad_argument;
  }
  now_ = known_pixels(grid_);
  return Status::ok;
}

// Edges inside of the letter grow, others shrink; parts that nothing reaches
// appear at last. Alternates as step() does, but with all rows, as those of
// different age would show seams.
void VortexScene::condense(uint32_t phase) noexcept {
  cutoff_.raw = cutoff_.raw * 3 / 4;
  const auto since = static_cast<int32_t>(phase - kEnds);
  if (phase % 2 != 0 && phase < kFilled) {
    redistance(grid_, next_);
    const DistanceGrid swap = grid_;
    grid_ = next_;
    next_ = swap;
    return;
  }
  // open() has tried to paint it.
  if (phase == kGrown) {
    static_cast<void>(paint(grid_));
    return;
  }
  static_cast<void>(paint(next_));
  freeze(grid_, next_, since < 13 ? 2 * since + 2 : 28);
}

void VortexScene::step() noexcept {
  ++frame_;
  const uint32_t phase = frame_ % kLoopFrames;
  if (phase >= kEnds && phase <= kGrown) {
    condense(phase);
  }
  has_changed_ = has_changed_ || (phase >= kThins && phase <= kGrown);
  const Q16_16 blow = strength_at(phase);
  if (blow.raw == 0) {
    return;
  }
  Vortex vortex;
  vortex.x.raw = grid_.width() << 15;
  vortex.y.raw = grid_.height() << 15;
  // At the core's edge a turn takes about 6 s, and nothing moves by more than a
  // sample a step, which is faster to compute.
  vortex.core = grid_.height() / 5;
  vortex.strength = lerp(0, vortex.core * vortex.core * 17, blow);
  Flow flow;
  flow.vortices = {&vortex, 1};
  advect(grid_, flow, next_);
  // Alternates, so that no frame does both.
  if (phase % 2 == 0) {
    const auto part =
        static_cast<int32_t>(phase / 2 + kFirstPart) % kRedistanceParts;
    const int32_t rows = grid_.height();
    redistance(next_, grid_, rows * part / kRedistanceParts,
               rows * (part + 1) / kRedistanceParts);
    has_changed_ = true;
  } else {
    const DistanceGrid swap = grid_;
    grid_ = next_;
    next_ = swap;
    keep_area();
  }
}

void VortexScene::set_frame(uint32_t frame) noexcept {
  before_ = now_;
  has_changed_ = false;
  if (frame < frame_) {
    static_cast<void>(restart());
    has_changed_ = true;
  }
  while (frame_ < frame) {
    step();
  }
  if (has_changed_) {
    now_ = known_pixels(grid_);
  }
}

void VortexScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const auto now = static_cast<int32_t>(frame_ % kLoopFrames);
  const Q16_16 worn = ease(kEaseInOut, fraction(kThins, kEnds, now));
  const Q16_16 healed = ease(kEaseInOut, fraction(kHeals, kHealed, now));
  // By as much as the grid knows, at most.
  const int32_t thinner_q6 =
      lerp(0, 5 * 64, Q16_16::from_raw(worn.raw - healed.raw));
  draw_shape(paper, thinner_q6);
}

// The cutoff that moves the edge outwards. [Q13 of a sample]
int32_t VortexScene::cutoff_of(int32_t offset_q6) const noexcept {
  return cutoff_.raw - (offset_q6 * 128 >> grid_.scale_log2());
}

// A ring outside, the body, and its core: all drawn by distance.
void VortexScene::draw_shape(const Paper& paper,
                             int32_t thinner_q6) const noexcept {
  struct Layer {
    int32_t offset_q6;  // [px] on screens of 240 rows
    uint32_t ink;
  };
  constexpr Layer kLayers[] = {
      {5 * 64, kRing}, {0, kBody}, {-2 * 64 - 32, kCore}};
  if (is_print_) {
    draw_print(paper, thinner_q6 * height_ / 240);
    return;
  }
  for (const Layer& layer : kLayers) {
    const int32_t offset_q6 = (layer.offset_q6 - thinner_q6) * height_ / 240;
    GridLook look;
    look.cutoff.raw = cutoff_of(offset_q6);
    draw_grid(grid_, look, 0, 0, kFilterMotion, paper.with(layer.ink));
  }
}

// Lines turn with the vortex, once in a loop.
void VortexScene::draw_print(const Paper& paper,
                             int32_t thinner_q6) const noexcept {
  const PrintInks& inks = kPrintInks[static_cast<uint32_t>(print_)];
  const auto now = static_cast<int32_t>(frame_ % kLoopFrames);
  const Q16_16 turned = ease(kEaseInOut, fraction(kBegins, kEnds, now));
  PrintLook look;
  look.style = print_;
  look.light = from_degrees(-45);
  look.screen = Angle::from_raw(
      static_cast<uint16_t>(from_degrees(inks.screen).raw + turned.raw));
  look.screen_x = static_cast<int16_t>(width_ / 2);
  look.screen_y = static_cast<int16_t>(height_ / 2);
  const int32_t pitch =
      height_ * 64 / (look.style == PrintStyle::rings ? 72 : 40);
  look.pitch = Q26_6::from_raw(pitch < 160 ? 160 : pitch);
  look.slope = Q26_6::from_raw(height_ * 64 / 34);
  look.tone = 100;
  look.contrast = 140;
  look.cutoff.raw = cutoff_of(-thinner_q6);
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
  if (phase + 1 < kBegins) {
    return frame_ + kBegins - phase;
  }
  return frame_ + (phase <= kGrown ? 1 : kLoopFrames + kBegins - phase);
}

void VortexScene::tell_state(const StateSink& sink) const noexcept {
  sink.tell(cutoff_.raw);
  tell_grid(grid_, sink);
}

}  // namespace inkcell::scenes
