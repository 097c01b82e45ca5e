#include "clock_scene.hpp"

namespace inkcell::scenes {
namespace {

using motion::Clock;

constexpr uint32_t kBackground = 0x0b0f16;
constexpr uint32_t kInk = 0xffd9a0;
constexpr uint32_t kColonInk = 0xff8f3c;

constexpr uint32_t kMinutes = 4;  // then the first one again
constexpr uint32_t kMinuteFrames = kLoopFrames / kMinutes;
constexpr uint32_t kRestFrames = 3;  // before a change

// Takes up to two digits off a text.
bool read_number(Text& text, size_t least, uint32_t& out) noexcept {
  out = 0;
  size_t count = 0;
  while (count < 2 && text.size != 0 && *text.data >= '0' &&
         *text.data <= '9') {
    out = out * 10 + static_cast<uint32_t>(*text.data - '0');
    text = {text.data + 1, text.size - 1};
    ++count;
  }
  return count >= least;
}

bool read_time(Text text, uint32_t& minute) noexcept {
  uint32_t hour;
  if (!read_number(text, 1, hour) || text.size == 0 || *text.data != ':') {
    return false;
  }
  text = {text.data + 1, text.size - 1};
  if (!read_number(text, 2, minute) || text.size != 0 || hour > 23 ||
      minute > 59) {
    return false;
  }
  minute += hour * 60;
  return true;
}

}  // namespace

ClockScene::ClockScene(const SceneSetting& setting) noexcept
    : TextScene(setting, "00:00", 236, 190),
      clock_(font(), style(), origin()) {}

Status ClockScene::open() noexcept {
  const bool is_time = read_time(text(), first_minute_);
  set_frame(0);
  return is_time ? Status::ok : Status::bad_argument;
}

void ClockScene::set_frame(uint32_t frame) noexcept {
  const uint32_t passed = frame / kMinuteFrames;
  const int32_t since = time_of(frame % kMinuteFrames) - time_of(kRestFrames);
  next(frame, clock_.at(first_minute_ + passed % kMinutes,
                        first_minute_ + (passed + 1) % kMinutes, since));
}

void ClockScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  clock_.draw_colons(painter(paper, kColonInk));
  for (int32_t i = 0; i < clock_.digits(); ++i) {
    clock_.draw_digit(painter(paper, kInk), style(), i);
  }
}

uint32_t ClockScene::next_due() const noexcept {
  constexpr uint32_t kEnd =
      kRestFrames + Clock::kEndMs * kFramesPerSecond / 1000 + 1;
  const uint32_t in_minute = frame() % kMinuteFrames;
  return frame() + (in_minute < kRestFrames ? kRestFrames - in_minute
                    : in_minute >= kEnd
                        ? kMinuteFrames + kRestFrames - in_minute
                        : 1);
}

void ClockScene::tell_state(const StateSink& sink) const noexcept {
  for (int32_t i = 0; i < clock_.digits(); ++i) {
    sink.tell(clock_.progress(i).raw);
  }
}

}  // namespace inkcell::scenes
