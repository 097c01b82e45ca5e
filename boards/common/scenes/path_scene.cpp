// Ten seconds: letters fly in, the wave swings, weight runs along the line (by
// the second masters of the font, if it has them) and moves letters apart, and
// letters leave, each one shortly before it comes again: the screen is never
// empty.
#include "path_scene.hpp"

#include "inkcell/motion/spring.hpp"
#include "inkcell/motion/timeline.hpp"

namespace inkcell::scenes {
namespace {

using namespace motion;

constexpr uint32_t kBackground = 0x0d1524;
constexpr uint32_t kFirstInk = 0xffc24b;
constexpr uint32_t kMiddleInk = 0xff5c7a;
constexpr uint32_t kLastInk = 0x7a8cff;

constexpr Stagger kArrival = {70, StaggerOrder::forward, 0};
constexpr uint32_t kFirstFrame = 60;  // all letters are there
constexpr int32_t kArrivesMs = 250;
constexpr int32_t kSwingsMs = 1200;  // the wave begins to swing
constexpr int32_t kWeightMs = 4200;
constexpr int32_t kCalmMs = 9200;   // the wave is flat again
constexpr int32_t kStaysMs = 9100;  // a letter, from its arrival on
constexpr int32_t kLeavingMs = 700;
constexpr int32_t kLoopMs = kLoopFrames * 1000 / kFramesPerSecond;
static_assert(kStaysMs + kLeavingMs < kLoopMs, "it is gone before it comes");
constexpr int32_t kWavePeriodMs = 2600;
constexpr Spring kLanding = {420, 90};

int32_t scaled(int32_t value, Q16_16 part) noexcept {
  return lerp(0, value, part);
}

// The size at which the run takes 7/8 of the width, or 1/4 of the height.
Q26_6 size_for(const Font& font, Text text, int32_t width, int32_t height) {
  const int32_t units = measure(font, text).advance;
  const int32_t by_width =
      units <= 0 ? height * 64
                 : static_cast<int32_t>(int64_t{width} * 56 *
                                        font.units_per_em() / units);
  const int32_t by_height = height * 64 / 4;
  const int32_t size = by_width < by_height ? by_width : by_height;
  return Q26_6::from_raw(size < kMinSize.raw ? kMinSize.raw : size);
}

// A wave of weight runs along the line.
Q16_16 bold_at(size_t index, int32_t time_ms) {
  const int32_t pulse = kWeightMs + static_cast<int32_t>(index) * 90;
  const Q16_16 up = fraction(pulse, pulse + 260, time_ms);
  const Q16_16 down = fraction(pulse + 260, pulse + 700, time_ms);
  return Q16_16::from_raw(ease(kEaseOut, up).raw - ease(kEaseInOut, down).raw);
}

// How far edges move outwards at a weight. [px, Q10]
int32_t reach_q10(Q26_6 size, Q16_16 bold) {
  return scaled(size.raw * 16 / 52, bold);
}

}  // namespace

PathScene::PathScene(const SceneSetting& setting) noexcept
    : SceneBase(setting), renderer_(font_, kMinSize), path_(points_) {
  on_path_.overflow = PathOverflow::extend;
}

Status PathScene::open() noexcept {
  INKCELL_TRY(lay_out(font_, text_, Anchor::centre, glyphs_, run_));
  on_path_.size = size_for(font_, text_, width_, height_);
  on_path_.tracking.raw = on_path_.size.raw / 32;  // for valleys
  renderer_.set_size(on_path_.size);
  const bool has_room = OutlineMorph::workspace_bytes(font_) <= workspace_.size;
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    const uint16_t glyph = run_.glyphs[i].glyph;
    letters_[i].morph = OutlineMorph::to_master(font_, glyph);
    if (!has_room) {
      INKCELL_TRY(OutlineMorph::open(font_, glyph, glyph, letters_[i].morph));
    }
  }
  set_frame(0);
  return Status::ok;
}

// Two cubics from edge to edge. They start flat and swing up and down in
// opposite phase.
void PathScene::make_wave(int32_t time_ms) noexcept {
  const int32_t since = time_ms - kSwingsMs;
  const Q16_16 grown =
      ease(kEaseInOut, fraction(kSwingsMs, kSwingsMs + 1500, time_ms));
  const Q16_16 calmed =
      ease(kEaseInOut, fraction(kCalmMs - 1200, kCalmMs, time_ms));
  const int32_t swing_q6 =
      scaled(height_ * 64 * 9 / 32, Q16_16::from_raw(grown.raw - calmed.raw));
  const auto phase = static_cast<uint16_t>(int64_t{since < 0 ? 0 : since} *
                                           65536 / kWavePeriodMs);
  const auto lift = [&](int32_t ahead) {
    const Angle angle = Angle::from_raw(
        static_cast<uint16_t>(phase + static_cast<uint32_t>(ahead)));
    return swing_q6 * sine(angle).raw / 16384;
  };
  const int32_t w = width_ * 64;
  const int32_t middle = height_ * 64 * 9 / 16;
  const auto at = [](int32_t x_q6, int32_t y_q6) {
    return Point{Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
  };
  const int32_t left = lift(0);
  const int32_t right = lift(0x3000);
  const int32_t tilt = (right - left) / 2;
  path_.clear();
  // The buffer holds both.
  static_cast<void>(path_.move_to(at(0, middle)));
  static_cast<void>(path_.cubic_to(at(w / 6, middle - left),
                                   at(w / 3, middle - left - tilt / 2),
                                   at(w / 2, middle + tilt / 3), kPieces));
  static_cast<void>(path_.cubic_to(at(w * 2 / 3, middle + left + tilt),
                                   at(w * 5 / 6, middle + right), at(w, middle),
                                   kPieces));
}

Pose PathScene::pose_of(size_t index, int32_t time_ms) const noexcept {
  const uint32_t count = unit_count(run_, Unit::glyph);
  const auto i = static_cast<uint32_t>(index);
  const int32_t arrives = kArrivesMs + delay_of(kArrival, i, count);
  // Since it came, in this loop or in the one before.
  const int32_t since = time_ms - arrives + (time_ms < arrives ? kLoopMs : 0);
  Pose pose;
  if (since < kStaysMs) {
    // Letters fly in from above, turning, with a spring's swing.
    const Q16_16 there = spring_at(kLanding, since);
    const Q16_16 away = Q16_16::from_raw((1 << 16) - there.raw);
    pose.offset.y.raw = -scaled(height_ * 64 * 3 / 8, away);
    pose.angle.raw = static_cast<uint16_t>(scaled(9000, away));
    const int32_t scale = 1229 + scaled(4096 - 1229, there);
    pose.scale_x.raw = static_cast<int16_t>(scale);
    pose.scale_y.raw = static_cast<int16_t>(scale);
    pose.opacity = static_cast<uint8_t>(scaled(255, fraction(0, 120, since)));
    pose.offset.y.raw -= scaled(on_path_.size.raw / 7, bold_at(index, time_ms));
    return pose;
  }
  // Letters leave at the bottom: a little back first, then down, slanted.
  const Q16_16 gone =
      ease(kAnticipate, fraction(kStaysMs, kStaysMs + kLeavingMs, since));
  pose.offset.y.raw = scaled(height_ * 64 * 5 / 8, gone);
  pose.angle.raw = static_cast<uint16_t>(
      (index & 1) != 0 ? scaled(7000, gone) : -scaled(7000, gone));
  pose.opacity = static_cast<uint8_t>(
      255 - scaled(255, fraction(kStaysMs + kLeavingMs / 2,
                                 kStaysMs + kLeavingMs, since)));
  return pose;
}

// Half of what a letter is wider than in plain text. [px, Q16]
int32_t PathScene::half_growth(const OutlineMorph& morph,
                               Q16_16 bold) const noexcept {
  const Style style(on_path_.size, kFilterMotion);
  return morph.from() == morph.to() ? 64 * reach_q10(on_path_.size, bold)
                                    : (morph.advance(style, bold).raw -
                                       morph.advance(style, Q16_16()).raw) *
                                          (1 << 9);
}

void PathScene::set_frame(uint32_t frame) noexcept {
  frame_ = frame;
  const int32_t time_ms = time_of(frame + kFirstFrame);
  make_wave(time_ms);
  // The line grows to both sides.
  on_path_.start.raw = path_.length().raw / 2;
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    on_path_.start.raw -= half_growth(letters_[i].morph, bold_at(i, time_ms));
  }
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    Letter& letter = letters_[i];
    const Letter before = letter;
    letter.bold = bold_at(i, time_ms);
    const int32_t half = half_growth(letter.morph, letter.bold);
    on_path_.start.raw += half;
    letter.posed = place(font_, run_, i, path_, on_path_, pose_of(i, time_ms));
    on_path_.start.raw += half;
    if (letter.morph.from() != letter.morph.to()) {
      letter.posed.pivot_x.raw += half;
    } else {
      letter.posed.pose.weight.raw =
          static_cast<int16_t>(reach_q10(on_path_.size, letter.bold));
    }
    if (letter.posed.pose.opacity == 0) {
      // All invisible letters are equal.
      letter.bold = {};
      letter.posed = {};
      letter.posed.pose.opacity = 0;
    }
    changed_[i] = {};
    if (letter.posed != before.posed || letter.bold.raw != before.bold.raw) {
      changed_[i] =
          bounding_box(renderer_.box(before.posed, letter.morph, before.bold),
                       renderer_.box(letter.posed, letter.morph, letter.bold));
    }
  }
}

void PathScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  const auto last = static_cast<int32_t>(run_.glyphs.size) - 1;
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    const int32_t part = last <= 0 ? 0 : static_cast<int32_t>(i) * 512 / last;
    const uint32_t ink = part < 256 ? mix_rgb(kFirstInk, kMiddleInk, part)
                                    : mix_rgb(kMiddleInk, kLastInk, part - 256);
    const Letter& letter = letters_[i];
    renderer_.draw(letter.posed, letter.morph, letter.bold,
                   {paper.with(ink), workspace_});
  }
}

void PathScene::add_changes(DirtyRects& dirty) const noexcept {
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    dirty.add(changed_[i], screen());
  }
}

void PathScene::tell_state(const StateSink& sink) const noexcept {
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    const PosedGlyph& glyph = letters_[i].posed;
    sink.tell(glyph.glyph);
    sink.tell(glyph.at.x.raw);
    sink.tell(glyph.at.y.raw);
    sink.tell(glyph.pose.offset.x.raw);
    sink.tell(glyph.pose.offset.y.raw);
    sink.tell(glyph.pose.angle.raw);
    sink.tell(glyph.pose.scale_x.raw);
    sink.tell(glyph.pose.scale_y.raw);
    sink.tell(glyph.pose.weight.raw);
    sink.tell(glyph.pose.opacity);
  }
}

}  // namespace inkcell::scenes
