// Two breaths of five seconds: offset curves swell and throw particles off,
// shrink, and particles gather on them.
#include "offset_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "particle_dots.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;
using namespace simulation;

constexpr uint32_t kBackground = 0x090a12;
constexpr uint32_t kBody = 0xfff0d8;
constexpr uint32_t kSlow = 0x62d8ff;
constexpr uint32_t kFast = 0xffffff;
// From the outermost band on. Each fades into the next one.
constexpr uint32_t kBands[] = {0x3a1c68, 0xa82c6c, 0xf58a3c};
constexpr int32_t kBandCount = sizeof kBands / sizeof *kBands;

// Frames of a breath.
constexpr uint32_t kBreath = kLoopFrames / 2;
constexpr uint32_t kSwells = 84;
constexpr uint32_t kSwollen = 98;
constexpr uint32_t kShrunk = 150;
constexpr uint32_t kSeed = 14;

// A ramp as wide as a band, so that bands leave no edges between them.
Filter soft_filter(int32_t band_q6) noexcept {
  constexpr int32_t kLeastQ10 = 640;
  constexpr int32_t kMostQ10 = 4 << 10;
  const int32_t half = band_q6 * 8;
  const int32_t reach = half < kLeastQ10  ? kLeastQ10
                        : half > kMostQ10 ? kMostQ10
                                          : half;
  // Of the same table as any other straight line: to make it takes 0.1 M
  // instructions.
  Filter filter = kFilterText;
  filter.set_cutoffs(-reach, reach);
  filter.scale = static_cast<uint16_t>((Filter::kEntries << 14) / (2 * reach));
  return filter;
}

int16_t speed(int32_t value) noexcept {
  return static_cast<int16_t>(value < -kMostSpeedQ10  ? -kMostSpeedQ10
                              : value > kMostSpeedQ10 ? kMostSpeedQ10
                                                      : value);
}

}  // namespace

OffsetScene::OffsetScene(const SceneSetting& setting) noexcept
    : SceneBase(setting), particles_(setting.memory.particles) {
  const int32_t scale = scale_for(width_);
  Span<int8_t> left = setting.memory.grid;
  grid_ = take_grid(left, width_, height_, scale);
  far_grid_ = take_grid(left, width_, height_, scale + 1);
  guide_ = take_grid(left, guide_columns(width_, height_), kGuideRows, 0);
}

Status OffsetScene::open() noexcept {
  if (guide_.width() == 0 || particles_.size == 0) {
    return Status::buffer_small;
  }
  if (!find_place(font_, text_, width_, height_, 205, 140, place_) ||
      !paint_text(font_, text_, place_, workspace_, grid_) ||
      !paint_text(font_, text_, place_, workspace_, far_grid_)) {
    return Status::bad_argument;
  }
  // A text too small for it has no guide.
  TextPlace place;
  if (!find_place(font_, text_, guide_.width(), kGuideRows, 205, 140, place) ||
      !paint_text(font_, text_, place, workspace_, guide_)) {
    guide_.clear();
  }
  frame_ = 0;
  place_particles();
  prepare();
  return Status::ok;
}

void OffsetScene::place_particles() noexcept {
  RandomNumbers random(kSeed);
  for (Particle& p : particles_) {
    p = {};
    // Beside the letters.
    for (int i = 0; i < 16; ++i) {
      p.x.raw = static_cast<int32_t>(
          random.below(static_cast<uint32_t>(width_) << 16));
      p.y.raw = static_cast<int32_t>(
          random.below(static_cast<uint32_t>(height_) << 16));
      if (probe(grid_, p.x, p.y).distance_q10 < -(4 << 10)) {
        break;
      }
    }
  }
}

// The distance of the outermost offset curve from the letters. [px, Q6]
int32_t OffsetScene::offset_q6() const noexcept {
  const auto at = static_cast<int32_t>(frame_ % kBreath);
  const int32_t most = 5 * 32 << far_grid_.scale_log2();
  const int32_t least = most / 5;
  const Q16_16 grown =
      ease(kEaseOut, fraction(static_cast<int32_t>(kSwells),
                              static_cast<int32_t>(kSwollen), at));
  const Q16_16 shrunk =
      ease(kEaseInOut, fraction(static_cast<int32_t>(kSwollen),
                                static_cast<int32_t>(kShrunk), at));
  // It trembles while it is small.
  const int32_t calm = (1 << 16) - grown.raw;
  const auto beat = Angle::from_raw(static_cast<uint16_t>(at * 2185));
  const int32_t trembles =
      lerp(0, sine(beat).raw * least / 16384 / 2, Q16_16::from_raw(calm));
  return least + trembles +
         lerp(0, most - least, Q16_16::from_raw(grown.raw - shrunk.raw));
}

// The fine grid, if its distances reach so far outside.
const DistanceGrid& OffsetScene::grid_for(int32_t offset_q6) const noexcept {
  return offset_q6 < 3 * 64 << grid_.scale_log2() ? grid_ : far_grid_;
}

// Where the fine grid has no slope, uses the guide; farther out the direction
// to the middle of the screen.
void OffsetScene::pull_from_afar(int32_t strength_q10) noexcept {
  const int32_t known_q10 = -((15 << 8) << grid_.scale_log2());
  // From px to samples of the guide.
  const auto on_guide = [](Q16_16 at, int32_t samples, int32_t px) {
    return Q16_16::from_raw(
        static_cast<int32_t>(int64_t{at.raw} * samples / px));
  };
  for (Particle& p : particles_) {
    const GridPoint near = probe(grid_, p.x, p.y);
    if (near.distance_q10 > known_q10) {
      continue;
    }
    const GridPoint far = probe(guide_, on_guide(p.x, guide_.width(), width_),
                                on_guide(p.y, kGuideRows, height_));
    int32_t x = far.x_slope_q13;
    int32_t y = far.y_slope_q13;
    if (magnitude(x) + magnitude(y) < 1024) {
      x = (width_ * 32768 - p.x.raw) / width_ / 4;
      y = (height_ * 32768 - p.y.raw) / height_ / 4;
    }
    p.x_speed_q10 = speed(p.x_speed_q10 + strength_q10 * x / 8192);
    p.y_speed_q10 = speed(p.y_speed_q10 + strength_q10 * y / 8192);
  }
}

// Particles that leave a straight edge do not fly in a row.
void OffsetScene::scatter(int32_t most_q10) noexcept {
  for (size_t i = 0; i < particles_.size; ++i) {
    Particle& p = particles_[i];
    const uint32_t random =
        hash(frame_ % kLoopFrames, static_cast<uint32_t>(i));
    const auto part = [&](uint32_t shift) {
      return (static_cast<int32_t>(random >> shift & 255) - 128) * most_q10 /
             128;
    };
    p.x_speed_q10 = speed(p.x_speed_q10 + part(0));
    p.y_speed_q10 = speed(p.y_speed_q10 + part(8));
  }
}

void OffsetScene::step() noexcept {
  ++frame_;
  if (frame_ % kLoopFrames == 0) {
    place_particles();
    return;
  }
  const uint32_t phase = frame_ % kBreath;
  const bool is_thrown = phase >= kSwells && phase < kSwollen - 4;
  // Scales offsets of a large screen, in px.
  const auto px = [this](int32_t q10) { return q10 * (height_ + 60) / 300; };
  ParticleRules rules;
  rules.walls = {1, 1, width_ - 1, height_ - 1};
  rules.side = ParticleSide::outside;
  rules.radius = Q26_6::from_raw(offset_q6() + 64);
  rules.bounce_q8 = 150;
  rules.kept_q16 = 62500;
  rules.attraction_q10 = static_cast<int16_t>(px(is_thrown ? -900 : 110));
  rules.orbit_q10 = static_cast<int16_t>(px(is_thrown ? 0 : 75));
  if (is_thrown) {
    scatter(px(900));
  } else {
    scatter(px(60));
    pull_from_afar(px(phase < kSwells ? 90 : 20));
  }
  simulation::step(particles_, rules, grid_for(rules.radius.raw), 0, 0);
}

void OffsetScene::set_frame(uint32_t frame) noexcept {
  before_ = now_;
  if (frame < frame_) {
    frame_ = 0;
    place_particles();
  }
  while (frame_ < frame) {
    step();
  }
  prepare();
}

// What all strips of a frame need.
void OffsetScene::prepare() noexcept {
  soft_ = soft_filter(offset_q6() / kBandCount);
  now_ = with_dots(known_pixels(far_grid_), particles_);
}

void OffsetScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const int32_t most_q6 = offset_q6();
  for (int32_t i = 0; i < kBandCount; ++i) {
    const int32_t offset = most_q6 * (kBandCount - i) / kBandCount;
    draw_offset(grid_for(offset), Q26_6::from_raw(offset), 0, 0, soft_,
                paper.with(kBands[i]));
  }
  const Style style(place_.size, kFilterArea);
  Painter(paper.with(kBody), workspace_)
      .text(font_, style, place_.origin, text_);
  const int32_t shown = shown_at(frame_);
  const Q26_6 radius = Q26_6::from_raw((height_ < 120 ? 46 : 80) * shown / 256);
  for (const Particle& p : particles_) {
    if (shown != 0 && is_near(p, paper.window)) {
      draw_dot(p.x, p.y, radius, paper.with(mix_rgb(kSlow, kFast, heat_of(p))));
    }
  }
}

void OffsetScene::tell_state(const StateSink& sink) const noexcept {
  tell_particles(particles_, sink);
}

}  // namespace inkcell::scenes
