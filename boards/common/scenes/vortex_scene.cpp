// The letter rests, is wound up, unwound, and restored.
#include "vortex_scene.hpp"

#include "inkcell/kinetic/advect.hpp"
#include "inkcell/kinetic/easing.hpp"
#include "inkcell/kinetic/grid_draw.hpp"
#include "inkcell/kinetic/redistance.hpp"
#include "inkcell/kinetic/timeline.hpp"
#include "paint_text.hpp"

namespace inkcell {
namespace scenes {
namespace {

using namespace kinetic;

constexpr uint32_t kBackground = 0x0c1018;
constexpr uint32_t kRing = 0x1a3854;
constexpr uint32_t kBody = 0xf2e6cf;
constexpr uint32_t kLine = 0x8a4b32;
constexpr uint32_t kCore = 0xd9763f;

// Frames of a loop: the vortex turns in one direction, then in the other.
constexpr uint32_t kBegins = 20;
constexpr uint32_t kTurns = 143;
constexpr uint32_t kEnds = 2 * kTurns - kBegins;
constexpr uint32_t kSwell = 20;  // until it has full strength
// Every second frame a part of the rows becomes true distances again.
constexpr int32_t kRedistanceParts = 12;
// Then the damage is repaired, a part in each frame.
constexpr uint32_t kHealed = kEnds + 22;
constexpr int32_t kHealsQ8 = 48;

// The strength, symmetric in time, so that the letter unwinds. [Q16]
Q16_16 strength_at(uint32_t phase) noexcept {
  if (phase < kBegins || phase >= kEnds) {
    return {};
  }
  const bool is_back = phase >= kTurns;
  const uint32_t since = is_back ? kEnds - 1 - phase : phase - kBegins;
  const uint32_t half = kTurns - kBegins;
  const uint32_t to_end = half - 1 - since;
  const uint32_t near = since < to_end ? since : to_end;
  const int32_t blow =
      ease(kEaseInOut, fraction(0, kSwell, static_cast<int32_t>(near))).raw;
  return Q16_16::from_raw(is_back ? -blow : blow);
}

}  // namespace

VortexScene::VortexScene(const SceneSetting& setting) noexcept
    : font_(*setting.font),
      text_(setting.text),
      width_(setting.width),
      height_(setting.height),
      workspace_(setting.workspace) {
  const int32_t scale = scale_for(width_);
  const int32_t columns = DistanceGrid::samples_of(width_, scale);
  const int32_t rows = DistanceGrid::samples_of(height_, scale);
  const size_t half = setting.memory.grid.size / 2;
  int8_t* first = setting.memory.grid.data;
  grid_ = DistanceGrid({first, half}, columns, rows, scale);
  next_ = DistanceGrid({first + half, half}, columns, rows, scale);
}

// 5/8 of the height, in the middle; at most 3/4 of the width.
bool VortexScene::paint(DistanceGrid& grid) noexcept {
  TextPlace place;
  return find_place(font_, text_, width_, height_, 192, 160, place) &&
         paint_text(font_, text_, place, workspace_, grid);
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

// Blends towards the letter, whose distances are painted first.
void VortexScene::heal(bool is_first) noexcept {
  if (is_first) {
    static_cast<void>(paint(next_));
  }
  GridBlend to_letter;
  to_letter.part_q8 = kHealsQ8;
  to_letter.depth_a = 255;  // no stroke shrinks: edges only move
  to_letter.depth_b = 255;
  static_cast<void>(blend(grid_, next_, to_letter, grid_, scratch_));
  keep_area();
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

void VortexScene::step() noexcept {
  ++frame_;
  const uint32_t phase = frame_ % kLoopFrames;
  if (phase == 0) {
    // Restores what unwinding lost.
    const uint32_t frame = frame_;
    static_cast<void>(restart());
    frame_ = frame;
    has_changed_ = true;
    return;
  }
  if (phase >= kEnds && phase < kHealed) {
    heal(phase == kEnds);
    return;
  }
  const Q16_16 blow = strength_at(phase);
  if (blow.raw == 0) {
    return;
  }
  Vortex vortex;
  vortex.x.raw = grid_.width() << 15;
  vortex.y.raw = grid_.height() << 15;
  // At the core's edge a turn takes about 5 s, and nothing moves by more than a
  // sample a step, which is faster to compute.
  vortex.core = grid_.height() / 5;
  vortex.strength = lerp(0, vortex.core * vortex.core * 20, blow);
  Flow flow;
  flow.vortices = {&vortex, 1};
  advect(grid_, flow, next_);
  // Alternates, so that no frame does both.
  if (phase % 2 == 0) {
    const auto part = static_cast<int32_t>(phase / 2) % kRedistanceParts;
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

// A ring outside, the body, a line along the inside of the edge, the core: all
// drawn by distance.
void VortexScene::draw(const Paper& paper) noexcept {
  struct Layer {
    int32_t offset_q6;  // [px] on screens of 240 rows
    uint32_t ink;
  };
  constexpr Layer kLayers[] = {
      {5 * 64, kRing}, {0, kBody}, {-2 * 64 - 16, kLine}, {-4 * 64, kCore}};
  paper.fill(kBackground);
  for (const Layer& layer : kLayers) {
    const int32_t offset_q6 = layer.offset_q6 * height_ / 240;
    GridLook look;
    look.cutoff.raw = cutoff_.raw - (offset_q6 * 128 >> grid_.scale_log2());
    draw_grid(grid_, look, 0, 0, kFilterMotion, paper.with(layer.ink));
  }
}

void VortexScene::add_changes(DirtyRects& dirty) const noexcept {
  if (has_changed_) {
    dirty.add(bounding_box(before_, now_), {0, 0, width_, height_});
  }
}

uint32_t VortexScene::next_due() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  if (phase + 1 < kBegins) {
    return frame_ + kBegins - phase;
  }
  return frame_ + (phase + 1 < kHealed ? 1 : kLoopFrames - phase);
}

void VortexScene::tell_state(const StateSink& sink) const noexcept {
  sink.tell(cutoff_.raw);
  for (int32_t y = 0; y < grid_.height(); ++y) {
    const int8_t* row = grid_.row(y);
    for (int32_t x = 0; x < grid_.width(); ++x) {
      sink.tell(row[x]);
    }
  }
}

}  // namespace scenes
}  // namespace inkcell
