// Letters fall one after the other; the floor kicks them; then it opens.
#include "body_scene.hpp"

#include "inkcell/kinetic/body_draw.hpp"
#include "inkcell/kinetic/numbers.hpp"

namespace inkcell {
namespace scenes {
namespace {

using namespace kinetic;

constexpr uint32_t kBackground = 0x10131f;
constexpr uint32_t kInks[] = {0xffb347, 0xff6b6b, 0x6bd5ff, 0xb78bff,
                              0x7ee08a, 0xffe66d, 0xff8fd0, 0x9fb4ff};
constexpr int32_t kInkCount = 8;

constexpr int32_t kStepsPerFrame = 2;
// Frames.
constexpr uint32_t kFallEach = 10;
constexpr uint32_t kKicks = 165;
constexpr uint32_t kOpens = 262;

}  // namespace

BodyScene::BodyScene(const SceneSetting& setting) noexcept
    : font_(*setting.font),
      text_(setting.text),
      width_(setting.width),
      height_(setting.height),
      memory_(setting.memory.grid),
      workspace_(setting.workspace) {}

// Takes what the letter's box needs off the memory.
Status BodyScene::add_shape(uint16_t glyph, Span<int8_t>& memory) noexcept {
  const Q26_6 size = Q26_6::from_int(size_for(height_));
  GlyphMetrics metrics;
  INKCELL_TRY(font_.glyph_metrics(glyph, metrics));
  const auto px = [&](int32_t units) {
    return units * (size.raw >> 6) / font_.units_per_em();
  };
  const int32_t left = px(metrics.x_min) - kMargin;
  const int32_t top = -px(metrics.y_max) - kMargin;
  const int32_t width = px(metrics.x_max) + kMargin + 1 - left;
  const int32_t height = -px(metrics.y_min) + kMargin + 1 - top;
  DistanceGrid grid(memory, width, height, 0);
  if (grid.width() == 0) {
    return Status::buffer_small;
  }
  grid.clear();
  INKCELL_TRY(grid.paint(font_, glyph, size,
                         {Q26_6::from_int(-left), Q26_6::from_int(-top)},
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
  while (count_ < kMostLetters && cursor.next(letter)) {
    GlyphMetrics metrics;
    if (font_.glyph_metrics(letter.glyph, metrics) != Status::ok ||
        metrics.x_max <= metrics.x_min) {
      continue;
    }
    int32_t shape = 0;
    while (shape < shape_count_ && glyphs_[shape] != letter.glyph) {
      ++shape;
    }
    if (shape == shape_count_) {
      INKCELL_TRY(add_shape(letter.glyph, memory));
    }
    shape_of_[count_++] = static_cast<uint8_t>(shape);
  }
  restart();
  return count_ == 0 ? Status::bad_argument : Status::ok;
}

void BodyScene::restart() noexcept {
  frame_ = 0;
  for (Body& body : bodies_) {
    body = Body();
  }
}

// The floor opens at the end. Letters come from above.
BodyRules BodyScene::rules() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  BodyRules rules;
  const int32_t floor = phase >= kOpens ? 3 * height_ : height_;
  rules.walls = {0, -height_, width_, floor};
  rules.gravity.raw = 16000 * height_ / 240;
  rules.bounce_q8 = 90;
  rules.friction_q8 = 60;
  rules.overlap.raw = static_cast<int16_t>(3072 * height_ / 240);
  rules.stiffness_q16 = 12000;
  rules.damping_q16 = 7000;
  return rules;
}

void BodyScene::let_fall(int32_t index) noexcept {
  constexpr uint32_t kSeed = 7;
  const uint32_t random = hash(kSeed, static_cast<uint32_t>(index));
  Body& body = bodies_[index];
  body = Body();
  body.shape = &shapes_[shape_of_[index]];
  // Over the middle half, one far from the one before.
  const auto along = static_cast<int32_t>(random & 511) + 512 * (index % 2);
  body.x = Q16_16::from_int(width_ / 4 + width_ * along / 2048);
  body.y = Q16_16::from_int(-body.shape->radius());
  body.turn_q32 = random << 7;
  body.spin_q20 = (static_cast<int32_t>(random >> 16 & 127) - 64) * 1024;
  body.x_speed.raw = (512 - along) * 60 * width_ / 320;
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
      phase / kFallEach <= static_cast<uint32_t>(count_)) {
    let_fall(static_cast<int32_t>(phase / kFallEach) - 1);
  }
  for (int32_t i = 0; i < count_; ++i) {
    Body& body = bodies_[i];
    if (phase == kKicks || phase == kOpens) {
      body.still_steps = 0;
    }
    if (phase == kKicks) {
      const uint32_t random = hash(3, static_cast<uint32_t>(i));
      const auto more = static_cast<int32_t>(random & 1023);
      body.y_speed.raw = -(5 << 16) * height_ / 240 - more * 128;
      body.spin_q20 = (static_cast<int32_t>(random >> 16 & 127) - 64) * 2048;
    }
  }
  for (int32_t i = 0; i < kStepsPerFrame; ++i) {
    kinetic::step({bodies_, static_cast<size_t>(count_)}, rules(), contacts_);
  }
}

void BodyScene::set_frame(uint32_t frame) noexcept {
  Body then[kMostLetters];
  for (int32_t i = 0; i < count_; ++i) {
    then[i] = bodies_[i];
    before_[i] = box_of(bodies_[i]);
  }
  if (frame < frame_) {
    restart();
  }
  while (frame_ < frame) {
    step();
  }
  for (int32_t i = 0; i < count_; ++i) {
    const Body& now = bodies_[i];
    has_moved_[i] = now.shape != then[i].shape || now.x.raw != then[i].x.raw ||
                    now.y.raw != then[i].y.raw ||
                    now.turn_q32 != then[i].turn_q32 ||
                    now.squeeze.raw != then[i].squeeze.raw;
  }
  // What touches a letter that moved is deformed by it.
  bool is_near[kMostLetters] = {};
  for (int32_t i = 0; i < count_; ++i) {
    for (int32_t k = 0; k < count_; ++k) {
      const Rect moved = bounding_box(before_[k], box_of(bodies_[k]));
      is_near[i] = is_near[i] ||
                   (has_moved_[k] && !is_empty(intersect(before_[i], moved)));
    }
  }
  for (int32_t i = 0; i < count_; ++i) {
    has_moved_[i] = has_moved_[i] || is_near[i];
  }
}

void BodyScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const BodyRules now = rules();
  for (int32_t i = 0; i < count_; ++i) {
    draw_body(bodies(), static_cast<size_t>(i), now, kFilterMotion,
              paper.with(kInks[i % kInkCount]));
  }
}

// What a letter deforms lies in its box.
void BodyScene::add_changes(DirtyRects& dirty) const noexcept {
  const Rect screen = {0, 0, width_, height_};
  for (int32_t i = 0; i < count_; ++i) {
    if (has_moved_[i]) {
      dirty.add(bounding_box(before_[i], box_of(bodies_[i])), screen);
    }
  }
}

uint32_t BodyScene::next_due() const noexcept {
  const uint32_t phase = frame_ % kLoopFrames;
  if (!are_asleep(bodies())) {
    return frame_ + 1;
  }
  const uint32_t last_fall = kFallEach * static_cast<uint32_t>(count_);
  uint32_t next = kLoopFrames;
  if (phase < last_fall) {
    next = (phase / kFallEach + 1) * kFallEach;
  } else if (phase < kKicks) {
    next = kKicks;
  } else if (phase < kOpens) {
    next = kOpens;
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
    sink.tell(body.squeeze.raw);
  }
}

}  // namespace scenes
}  // namespace inkcell
