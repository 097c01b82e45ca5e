// Five seconds a word: it stands, bursts and falls; the other one gathers.
#include "particle_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "particle_dots.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;
using namespace simulation;

constexpr uint32_t kBackground = 0x0a0d18;
constexpr uint32_t kInk = 0xf4f1e8;
constexpr uint32_t kRing = 0x2f5fb0;
constexpr uint32_t kSlow = 0xe8b04a;
constexpr uint32_t kFast = 0xff4f6d;
constexpr uint32_t kFly = 0x58d5ff;

// Frames of a word.
constexpr uint32_t kWordFrames = kLoopFrames / 2;
constexpr uint32_t kBurst = 45;   // it falls apart
constexpr uint32_t kNews = 70;    // distances of the other one are painted
constexpr uint32_t kGather = 78;  // its pieces look for the other word
constexpr uint32_t kMeet = 128;   // the plain word comes up
constexpr uint32_t kRings = 146;  // it is there, and no dots are drawn
constexpr uint32_t kSeed = 20;

constexpr int32_t kFlyRadiusQ6 = 84;

// A ramp across a ring, and its slope. [coverage of 255 a pixel, in halves]
struct RingEdge {
  Filter ramp;
  int32_t slope_q1;
};

constexpr RingEdge kWideRing = {
    make_filter({Q6_10::from_raw(-1792), Q6_10::from_raw(1792)}), 7};
constexpr RingEdge kNarrowRing = {
    make_filter({Q6_10::from_raw(-1280), Q6_10::from_raw(1280)}), 5};

// Keeps the middle of a ramp: a ring in one pass.
struct Ring {
  const Sink* ink;
  int32_t slope_q1;

  static void pass(
      void* context, int32_t x, int32_t y, const uint8_t* ramp, int32_t count) {
    const Ring& ring = *static_cast<const Ring*>(context);
    uint8_t coverage[kMaxSpan];
    for (int32_t i = 0; i < count; ++i) {
      const int32_t near = ramp[i] < 128 ? ramp[i] : 255 - ramp[i];
      const int32_t value = near * ring.slope_q1 >> 1;
      coverage[i] = static_cast<uint8_t>(value < 255 ? value : 255);
    }
    ring.ink->coverage(ring.ink->context, x, y, coverage, count);
  }

  Sink sink() noexcept {
    Sink result = *ink;
    result.context = this;
    result.coverage = pass;
    result.solid = [](void*, int32_t, int32_t, int32_t) {};
    return result;
  }
};

// The opacity of the plain word. [of 255]
int32_t word_opacity(uint32_t phase) noexcept {
  const auto at = static_cast<int32_t>(phase);
  if (phase < kGather) {
    return 255 - lerp(0, 255, fraction(kBurst, kBurst + 5, at));
  }
  return lerp(0, 255, fraction(kMeet, kRings, at));
}

}  // namespace

ParticleScene::ParticleScene(const SceneSetting& setting) noexcept
    : SceneBase(setting) {
  Span<int8_t> memory = setting.memory.grid;
  grid_ = take_grid(memory, width_, height_, scale_for(width_));
  const Span<Particle> all = setting.memory.particles;
  const size_t homes = setting.memory.homes.size;
  if (homes <= all.size) {
    homes_ = setting.memory.homes;
    pieces_ = {all.data, homes};
    flies_ = {all.data + homes, all.size - homes};
  }
}

// Places a word in the middle of the screen, and clears the distances.
void ParticleScene::begin_word(size_t index) noexcept {
  const TextMeasure ink = measure(font_, word_of(text_, index));
  origin_ = {Q26_6::from_raw(width_ * 32 - px_q6(ink.x_min + ink.x_max) / 2),
             Q26_6::from_raw(height_ * 32 + px_q6(ink.y_min + ink.y_max) / 2)};
  grid_.clear();
  word_ = index;
}

int32_t ParticleScene::px_q6(int32_t units) const noexcept {
  return static_cast<int32_t>(int64_t{units} * size_.raw /
                              font_.units_per_em());
}

// Paints the distances of every letter of the word whose number is `part`
// modulo `parts`.
bool ParticleScene::paint_letters(uint32_t part, uint32_t parts) noexcept {
  TextCursor cursor(font_, word_of(text_, word_));
  PositionedGlyph glyph;
  bool is_painted = true;
  for (uint32_t i = 0; cursor.next(glyph); ++i) {
    if (i % parts == part) {
      const Point at = {Q26_6::from_raw(origin_.x.raw + px_q6(glyph.x)),
                        origin_.y};
      is_painted = is_painted && grid_.paint(font_, glyph.glyph, size_, at,
                                             workspace_) == Status::ok;
    }
  }
  // The word and its rings: as far as the grid has distances.
  word_box_ = known_pixels(grid_);
  return is_painted;
}

bool ParticleScene::show_word(size_t index) noexcept {
  begin_word(index);
  return paint_letters(0, 1);
}

Status ParticleScene::open() noexcept {
  if (grid_.width() == 0 || pieces_.size == 0) {
    return Status::buffer_small;
  }
  // The longer word takes 5/6 of the width, or 3/5 of the height.
  int32_t longest = 1;
  for (size_t i = 0; i < 2; ++i) {
    const int32_t advance = measure(font_, word_of(text_, i)).advance;
    longest = advance > longest ? advance : longest;
  }
  const auto by_width = static_cast<int32_t>(int64_t{width_} * 64 * 5 / 6 *
                                             font_.units_per_em() / longest);
  const int32_t by_height = height_ * 64 * 3 / 5;
  size_.raw = by_width < by_height ? by_width : by_height;
  for (size_t i = 2; i-- > 0;) {
    if (!show_word(i) || !spread_homes(grid_, 0, 0, kSeed, homes_)) {
      return Status::bad_argument;
    }
  }
  restart();
  return Status::ok;
}

void ParticleScene::restart() noexcept {
  frame_ = 0;
  // open() has tried both words.
  static_cast<void>(show_word(0));
  static_cast<void>(spread_homes(grid_, 0, 0, kSeed, homes_));
  place_particles();
}

// As a loop begins.
void ParticleScene::place_particles() noexcept {
  random_ = RandomNumbers(kSeed);
  for (size_t i = 0; i < pieces_.size; ++i) {
    pieces_[i] = {};
    pieces_[i].x.raw = homes_[i].x_q4 * 4096;
    pieces_[i].y.raw = homes_[i].y_q4 * 4096;
  }
  for (Particle& fly : flies_) {
    fly = {};
    if (!find_edge(grid_, 0, 0, random_, fly)) {
      fly.x = Q16_16::from_int(width_ / 2);
    }
  }
}

// Away from the middle of the word and up, with random variation.
void ParticleScene::burst() noexcept {
  for (Particle& p : pieces_) {
    const int32_t from_middle = (p.x.raw >> 16) - width_ / 2;
    const int32_t right = from_middle * 3072 / width_ +
                          static_cast<int32_t>(random_.below(2400)) - 1200;
    const int32_t up = 900 + static_cast<int32_t>(random_.below(3600));
    p.x_speed_q10 = static_cast<int16_t>(right * height_ / 240);
    p.y_speed_q10 = static_cast<int16_t>(-up * height_ / 240);
  }
}

void ParticleScene::step() noexcept {
  ++frame_;
  if (frame_ % kLoopFrames == 0) {
    place_particles();
    return;
  }
  const uint32_t phase = frame_ % kWordFrames;
  const auto index = size_t{frame_ / kWordFrames % 2};
  if (phase == kBurst) {
    burst();
  }
  // A letter in each frame; then the places of the pieces.
  if (phase == kNews) {
    begin_word(1 - index);
  }
  if (phase >= kNews && phase < kGather) {
    static_cast<void>(paint_letters(phase - kNews, kGather - kNews));
  }
  if (phase == kGather) {
    static_cast<void>(spread_homes(grid_, 0, 0, kSeed, homes_));
  }
  ParticleRules rules;
  rules.walls = {2, 2, width_ - 2, height_ - 2};
  if (phase > kBurst && phase < kGather) {
    rules.gravity_q10 = static_cast<int16_t>(230 * height_ / 240);
    rules.bounce_q8 = 140;
    rules.kept_q16 = 65000;
    simulation::step(pieces_, rules, grid_, 0, 0);
  } else if (phase >= kGather && phase < kRings) {
    // From left to right, one after the other; late ones still fall.
    const uint32_t begun = phase - kGather;
    const size_t called =
        begun >= 26 ? pieces_.size : pieces_.size * size_t{begun + 1} / 26;
    const Span<Particle> early(pieces_.data, called);
    const Span<Particle> late(pieces_.data + called, pieces_.size - called);
    rules.kept_q16 = 52000;
    simulation::pull_home(early, homes_, Q16_16::from_raw(2600),
                          Q26_6::from_int(4));
    simulation::step(early, rules, grid_, 0, 0);
    rules.gravity_q10 = static_cast<int16_t>(230 * height_ / 240);
    rules.bounce_q8 = 140;
    rules.kept_q16 = 65000;
    simulation::step(late, rules, grid_, 0, 0);
  }
  // The others orbit the letters, and never cross them.
  ParticleRules flight;
  flight.walls = rules.walls;
  flight.attraction_q10 = 70;
  flight.orbit_q10 = 60;
  flight.kept_q16 = 62500;
  flight.bounce_q8 = 180;
  flight.side = ParticleSide::outside;
  flight.radius = Q26_6::from_raw(height_ < 120 ? 48 : 2 * kFlyRadiusQ6);
  if (phase >= kGather && phase < kMeet) {
    // To the new word, each to its own place.
    const size_t stride = pieces_.size / (flies_.size + 1) + 1;
    for (size_t i = 0; i < flies_.size; ++i) {
      simulation::pull_home({flies_.data + i, 1},
                            {homes_.data + i * stride % homes_.size, 1},
                            Q16_16::from_raw(1800), Q26_6::from_int(2));
    }
  }
  simulation::step(flies_, flight, grid_, 0, 0);
}

void ParticleScene::set_frame(uint32_t frame) noexcept {
  before_ = now_;
  if (frame < frame_) {
    restart();
  }
  while (frame_ < frame) {
    step();
  }
  now_ = with_dots(with_dots(word_box_, pieces_), flies_);
}

// Offset curves run outwards when the word has appeared, and fade.
void ParticleScene::draw_rings(const Paper& paper) const noexcept {
  const uint32_t phase = frame_ % kWordFrames;
  const auto since = static_cast<int32_t>(
      phase >= kRings ? phase - kRings : phase + kWordFrames - kRings);
  constexpr int32_t kFrames = 40;
  if (since >= kFrames) {
    return;
  }
  const int32_t reach_q6 = 3 * 64 << grid_.scale_log2();
  const Q16_16 gone = ease(kEaseOut, fraction(0, kFrames, since));
  const int32_t offset_q6 = lerp(0, reach_q6, gone);
  const int32_t fading = 256 - lerp(0, 256, gone);
  const RingEdge& edge = height_ < 120 ? kNarrowRing : kWideRing;
  Ring ring = {&paper.with(mix_rgb(kBackground, kRing, fading)), edge.slope_q1};
  draw_offset(grid_, Q26_6::from_raw(offset_q6 - 64), 0, 0, edge.ramp,
              ring.sink());
}

void ParticleScene::draw_word(const Paper& paper) const noexcept {
  const int32_t opacity = word_opacity(frame_ % kWordFrames);
  if (opacity == 0) {
    return;
  }
  const Style style(size_, kFilterArea);
  // It cools down while it appears, below its pieces.
  const bool is_new = frame_ % kWordFrames >= kGather;
  const uint32_t glow = is_new ? mix_rgb(kSlow, kInk, opacity) : kInk;
  Painter(paper.with(mix_rgb(kBackground, glow, opacity + 1)), workspace_)
      .text(font_, style, origin_, word_of(text_, word_));
}

void ParticleScene::draw_particles(const Paper& paper) const noexcept {
  const int32_t hidden = word_opacity(frame_ % kWordFrames);
  const bool is_small = height_ < 120;
  // They grow out of the word, and shrink into it.
  const int32_t shown = 255 - hidden * hidden / 255;
  const Q26_6 radius = Q26_6::from_raw((is_small ? 52 : 84) * shown / 255);
  for (size_t i = 0; i < pieces_.size && hidden < 255; ++i) {
    const Particle& p = pieces_[i];
    if (!is_near(p, paper.window)) {
      continue;
    }
    const uint32_t glow = mix_rgb(kSlow, kFast, heat_of(p));
    draw_dot(p.x, p.y, radius, paper.with(mix_rgb(glow, kInk, hidden)));
  }
  const int32_t flying = shown_at(frame_);
  const Q26_6 fly_radius =
      Q26_6::from_raw((is_small ? 48 : kFlyRadiusQ6) * flying / 256);
  for (const Particle& fly : flies_) {
    if (flying != 0 && is_near(fly, paper.window)) {
      draw_dot(fly.x, fly.y, fly_radius, paper.with(kFly));
    }
  }
}

void ParticleScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  draw_rings(paper);
  draw_word(paper);
  draw_particles(paper);
}

void ParticleScene::tell_state(const StateSink& sink) const noexcept {
  tell_particles(pieces_, sink);
  tell_particles(flies_, sink);
}

}  // namespace inkcell::scenes
