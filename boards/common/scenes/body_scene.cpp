// Letters fall one after the other; the floor kicks them; then it opens, and
// closes below the last one.
#include "body_scene.hpp"

#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/simulation/body_draw.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;
using namespace simulation;

constexpr uint32_t kBackground = 0x10131f;
constexpr uint32_t kInks[] = {0xffb347, 0xff6b6b, 0x6bd5ff, 0xb78bff,
                              0x7ee08a, 0xffe66d, 0xff8fd0, 0x9fb4ff};
constexpr int32_t kInkCount = 8;

constexpr int32_t kStepsPerFrame = 2;
// Frames.
constexpr uint32_t kFallEach = 10;
constexpr uint32_t kKicks = 165;
constexpr uint32_t kOpens = 272;
constexpr uint32_t kCloses = 292;  // the last letter has left
constexpr uint32_t kFloorInk = 0x2c3350;

// The part of the floor that is open. [of 8]
int32_t gap_at(uint32_t phase) noexcept {
  const auto at = static_cast<int32_t>(phase);
  constexpr auto kOpen = static_cast<int32_t>(kOpens);
  constexpr auto kClose = static_cast<int32_t>(kCloses);
  constexpr auto kEnd = static_cast<int32_t>(kLoopFrames);
  return lerp(0, 8, fraction(kOpen - 1, kOpen + 3, at)) -
         lerp(0, 8, fraction(kClose, kEnd, at));
}

// How far the kick lifts the floor. [of 8]
int32_t lift_at(uint32_t phase) noexcept {
  const uint32_t since = phase - kKicks;
  return since < 8 ? 8 - static_cast<int32_t>(since) : 0;
}

using Touches = BodyTouch[Body::kMostTouches];

// The samples of a letter's grid, from its origin. Empty without ink.
Rect samples_of(const Font& font, uint16_t glyph, int32_t height) noexcept {
  GlyphMetrics metrics;
  if (font.glyph_metrics(glyph, metrics) != Status::ok ||
      metrics.x_max <= metrics.x_min) {
    return {};
  }
  constexpr int32_t kMargin = BodyScene::kMarginSamples;
  const auto samples = [&](int32_t units) {  // rounded down
    const int32_t px =
        units * BodyScene::size_for(height) / font.units_per_em();
    return px >> BodyScene::scale_for(height);
  };
  return {samples(metrics.x_min) - kMargin, samples(-metrics.y_max) - kMargin,
          samples(metrics.x_max) + kMargin + 1,
          samples(-metrics.y_min) + kMargin + 1};
}

bool are_equal(const Touches& a, const Touches& b) noexcept {
  for (size_t i = 0; i < Body::kMostTouches; ++i) {
    if (a[i].with != b[i].with || a[i].bulge_q6 != b[i].bulge_q6 ||
        a[i].swell_q8 != b[i].swell_q8) {
      return false;
    }
  }
  return true;
}

}  // namespace

BodyScene::BodyScene(const SceneSetting& setting) noexcept
    : SceneBase(setting), memory_(setting.memory.grid) {}

SceneNeeds BodyScene::needs(const Font& font,
                            Text text,
                            int32_t height) noexcept {
  SceneNeeds needs;
  TextCursor cursor(font, text);
  PositionedGlyph letter;
  while (cursor.next(letter)) {
    const Rect box = samples_of(font, letter.glyph, height);
    needs.grid += static_cast<size_t>((box.x1 - box.x0) * (box.y1 - box.y0));
  }
  return needs;
}

// Takes the memory for the letter's box from the front of `memory`.
Status BodyScene::add_shape(uint16_t glyph,
                            const Rect& box,
                            Span<int8_t>& memory) noexcept {
  const int32_t scale = scale_for(height_);
  const int32_t side = 1 << scale;
  const int32_t width = box.x1 - box.x0;
  const int32_t height = box.y1 - box.y0;
  DistanceGrid grid(memory, width, height, scale);
  if (grid.width() == 0) {
    return Status::buffer_small;
  }
  grid.clear();
  INKCELL_TRY(grid.paint(
      font_, glyph, Q26_6::from_int(size_for(height_)),
      {Q26_6::from_int(-box.x0 * side), Q26_6::from_int(-box.y0 * side)},
      workspace_));
  INKCELL_TRY(shapes_[shape_count_].make(grid, points_[shape_count_]));
  glyphs_[shape_count_++] = glyph;
  const auto taken = static_cast<size_t>(width * height);
  memory = {memory.data + taken, memory.size - taken};
  return Status::ok;
}

Status BodyScene::open() noexcept {
  shape_count_ = 0;
  count_ = 0;
  Span<int8_t> memory = memory_;
  TextCursor cursor(font_, text_);
  PositionedGlyph letter;
  while (cursor.next(letter)) {
    const Rect box = samples_of(font_, letter.glyph, height_);
    if (is_empty(box)) {
      continue;
    }
    if (count_ == kMostLetters) {
      return Status::buffer_small;
    }
    int32_t shape = 0;
    while (shape < shape_count_ && glyphs_[shape] != letter.glyph) {
      ++shape;
    }
    if (shape == shape_count_) {
      INKCELL_TRY(add_shape(letter.glyph, box, memory));
    }
    shape_of_[count_++] = static_cast<uint8_t>(shape);
  }
  if (count_ == 0) {
    return Status::bad_argument;
  }
  restart();
  return Status::ok;
}

void BodyScene::restart() noexcept {
  frame_ = 0;
  for (Body& body : bodies_) {
    body = Body();
  }
  let_fall(0);
}

// The floor opens at the end. Letters fall in from above.
BodyRules BodyScene::rules() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  BodyRules rules;
  const int32_t floor = phase >= kOpens ? 3 * height_ : floor_top();
  rules.walls = {0, -height_, width_, floor};
  rules.gravity.raw = 16000 * height_ / 240;
  rules.bounce_q8 = 60;
  rules.friction_q8 = 240;
  rules.overlap.raw = static_cast<int16_t>(3072 * height_ / 240);
  rules.stiffness_q16 = 16000;
  rules.damping_q16 = 16000;
  rules.squash_q14 = static_cast<uint16_t>(160 * 240 / height_);
  rules.pieces = 6;
  return rules;
}

void BodyScene::let_fall(int32_t index) noexcept {
  constexpr uint32_t kSeed = 7;
  const uint32_t random = hash(kSeed, static_cast<uint32_t>(index));
  Body& body = bodies_[index];
  body = Body();
  body.shape = &shapes_[shape_of_[index]];
  // Over the middle, beside the letter before.
  const auto along = static_cast<int32_t>(random & 127) + 198;  // [em / 1024]
  body.x = Q16_16::from_int(width_ / 2 + (index % 2 == 0 ? -along : along) *
                                             size_for(height_) / 1024);
  // The first one is seen at once, others begin above the screen, and above the
  // one before.
  int32_t y = 0;
  if (index > 0) {
    const Rect before = box_of(bodies_[index - 1]);
    y = (before.y0 < 0 ? before.y0 : 0) - body.shape->radius();
  }
  body.y = Q16_16::from_int(y);
  body.y_speed.raw = (3 << 16) * height_ / 240;  // clear of the next one
  body.turn_q32 = random << 7;
  body.spin_q20 = (static_cast<int32_t>(random >> 16 & 127) - 64) * 1024;
}

// The floor throws all letters up and together, or it lets them fall.
void BodyScene::wake(bool is_kick) noexcept {
  for (int32_t i = 0; i < count_; ++i) {
    Body& body = bodies_[i];
    body.still_steps = 0;
    if (is_kick) {
      const uint32_t random = hash(34, static_cast<uint32_t>(i));
      const auto more = static_cast<int32_t>(random & 1023);
      body.x_speed.raw = (Q16_16::from_int(width_ / 2).raw - body.x.raw) / 50;
      body.y_speed.raw = -(5 << 16) * height_ / 240 - more * 128;
      body.spin_q20 = (static_cast<int32_t>(random >> 16 & 127) - 64) * 2048;
    }
  }
}

void BodyScene::step() noexcept {
  ++frame_;
  const uint32_t phase = frame_ % kLoopFrames;
  if (phase == 0) {
    const uint32_t frame = frame_;
    restart();
    frame_ = frame;
    return;
  }
  if (phase % kFallEach == 0 &&
      phase / kFallEach < static_cast<uint32_t>(count_)) {
    let_fall(static_cast<int32_t>(phase / kFallEach));
  }
  if (phase == kKicks || phase == kOpens) {
    wake(phase == kKicks);
  }
  BodyRules now = rules();
  for (int32_t i = 1; i <= kStepsPerFrame; ++i) {
    now.is_drawn = i == kStepsPerFrame;
    simulation::step({bodies_, static_cast<size_t>(count_)}, now, contacts_);
  }
  // Removes bodies that have left the screen at the bottom.
  for (Body& body : bodies_) {
    if (box_of(body).y0 > height_) {
      body.shape = nullptr;
    }
  }
}

void BodyScene::set_frame(uint32_t frame) noexcept {
  frame_before_ = frame_;
  for (int32_t i = 0; i < count_; ++i) {
    before_[i] = bodies_[i];
  }
  if (frame < frame_) {
    restart();
  }
  while (frame_ < frame) {
    step();
  }
  // Letters that touch a moving letter are deformed by it.
  for (int32_t i = 0; i < count_; ++i) {
    has_moved_[i] = false;
    for (int32_t k = 0; k < count_; ++k) {
      const Rect moved = swept_box(k);
      has_moved_[i] =
          has_moved_[i] ||
          (has_changed(k) &&
           (k == i || !is_empty(intersect(box_of(bodies_[i]), moved))));
    }
  }
}

bool BodyScene::has_changed(int32_t index) const noexcept {
  const Body& now = bodies_[index];
  const Body& then = before_[index];
  return now.shape != then.shape || now.x.raw != then.x.raw ||
         now.y.raw != then.y.raw || now.turn_q32 != then.turn_q32 ||
         now.squash.raw != then.squash.raw ||
         !are_equal(now.touches, then.touches);
}

// The box of a letter's old and new position.
Rect BodyScene::swept_box(int32_t index) const noexcept {
  return bounding_box(box_of(before_[index]), box_of(bodies_[index]));
}

void BodyScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const uint32_t phase = frame_ % kLoopFrames;
  const int32_t half = width_ * (8 - gap_at(phase)) / 16;
  const int32_t top = floor_top() - lift_at(phase) * height_ / 320;
  paper.fill(kFloorInk, {0, top, half, height_});
  paper.fill(kFloorInk, {width_ - half, top, width_, height_});
  const BodyRules now = rules();
  for (int32_t i = 0; i < count_; ++i) {
    draw_body(bodies(), static_cast<size_t>(i), now, kFilterMotion,
              paper.with(kInks[i % kInkCount]));
  }
}

// Deformations are inside of a letter's box.
void BodyScene::add_changes(DirtyRects& dirty) const noexcept {
  for (int32_t i = 0; i < count_; ++i) {
    if (has_moved_[i]) {
      dirty.add(swept_box(i), screen());
    }
  }
  const uint32_t then = frame_before_ % kLoopFrames;
  const uint32_t now = frame_ % kLoopFrames;
  if (gap_at(then) != gap_at(now) || lift_at(then) != lift_at(now)) {
    dirty.add({0, floor_top() - height_ / 40, width_, height_}, screen());
  }
}

uint32_t BodyScene::next_due() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  if (!are_asleep(bodies()) || phase >= kOpens) {
    return frame_ + 1;
  }
  const uint32_t last_fall = kFallEach * static_cast<uint32_t>(count_ - 1);
  uint32_t next = kOpens;
  if (phase < last_fall) {
    next = (phase / kFallEach + 1) * kFallEach;
  } else if (phase < kKicks) {
    next = kKicks;
  }
  return frame_ + next - phase;
}

void BodyScene::tell_state(const StateSink& sink) const noexcept {
  for (const Body& body : bodies()) {
    sink.tell(body.x.raw);
    sink.tell(body.y.raw);
    sink.tell(body.x_speed.raw);
    sink.tell(body.y_speed.raw);
    sink.tell(static_cast<int32_t>(body.turn_q32));
    sink.tell(body.spin_q20);
    sink.tell(body.squash.raw);
    for (const BodyTouch& touch : body.touches) {
      sink.tell((touch.with << 16) + (touch.bulge_q6 << 8) + touch.swell_q8);
    }
  }
}

}  // namespace inkcell::scenes
