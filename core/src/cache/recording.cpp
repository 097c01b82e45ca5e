#include "cache/recording.hpp"

#include "base/math.hpp"
#include "base/words.hpp"

namespace inkcell {
namespace detail {
namespace {

constexpr int32_t kMostSkipped = 15;
constexpr int32_t kMostPixels = 14;
constexpr int32_t kSolid = 15;
constexpr int32_t kMostSolid = 255;

// Fewer empty or solid pixels stay among the others: a step costs more.
constexpr int32_t kLeastGap = 4;
constexpr int32_t kLeastSolid = 6;

constexpr int32_t kMostEqual = 8;
constexpr int32_t kLongSteps = 31;

// The head of a group.
struct Group {
  int32_t rows;
  int32_t bytes;  // of its steps
  const uint8_t* steps;

  explicit Group(const uint8_t* at) noexcept
      : rows((at[0] >> 5) + 1), bytes(at[0] & kLongSteps), steps(at + 1) {
    if (bytes == kLongSteps) {
      bytes = *steps++;
    }
  }
  const uint8_t* end() const noexcept { return steps + bytes; }
};

bool are_equal(const uint8_t* a, const uint8_t* b, int32_t count) noexcept {
  while (count != 0 && *a == *b) {
    ++a;
    ++b;
    --count;
  }
  return count == 0;
}

// A row whose pixels are told apart as they are kept.
struct Row {
  const uint8_t* coverage;
  int32_t width;
  Packing packing;

  uint32_t level(int32_t value) const noexcept {
    const uint32_t coverage_8 = coverage[value];
    return packing.bits == 4 ? (coverage_8 + 8) / 17 : coverage_8;
  }
  // Whether all channels of a pixel are at a level.
  bool is(int32_t x, uint32_t wanted) const noexcept {
    const int32_t first = x * packing.channels;
    for (int32_t i = 0; i < packing.channels; ++i) {
      if (level(first + i) != wanted) {
        return false;
      }
    }
    return true;
  }
  bool is_empty(int32_t x) const noexcept { return is(x, 0); }
  bool is_solid(int32_t x) const noexcept {
    return is(x, packing.bits == 4 ? 15 : 255);
  }
  // The pixels from `x` on, at most `most`, that are all empty, or solid.
  int32_t count_empty(int32_t x, int32_t most) const noexcept {
    int32_t count = 0;
    while (count < most && x + count < width && is_empty(x + count)) {
      ++count;
    }
    return count;
  }
  int32_t count_solid(int32_t x, int32_t most) const noexcept {
    int32_t count = 0;
    while (count < most && x + count < width && is_solid(x + count)) {
      ++count;
    }
    return count;
  }
  // The pixels from `x` on that one step holds.
  int32_t count_mixed(int32_t x) const noexcept {
    int32_t count = 1;
    while (count < kMostPixels && x + count < width &&
           count_empty(x + count, kLeastGap) < kLeastGap &&
           count_solid(x + count, kLeastSolid) < kLeastSolid) {
      ++count;
    }
    // Nor those at the end of the row.
    while (count > 1 && is_empty(x + count - 1)) {
      --count;
    }
    return count;
  }
};

uint8_t* put_pixels(const Row& row,
                    int32_t x,
                    int32_t count,
                    uint8_t* out) noexcept {
  const int32_t first = x * row.packing.channels;
  const int32_t values = count * row.packing.channels;
  for (int32_t i = 0; i < values; ++i) {
    const uint32_t level = row.level(first + i);
    if (row.packing.bits == 8 || i % 2 == 0) {
      *out++ = static_cast<uint8_t>(level);
    } else {
      out[-1] = static_cast<uint8_t>(out[-1] | level << 4);
    }
  }
  return out;
}

// Writes the steps of a row; returns their end.
uint8_t* put_steps(const Row& row, uint8_t* out) noexcept {
  int32_t at = 0;  // behind what is written
  for (;;) {
    const int32_t x = at + row.count_empty(at, row.width);
    if (x == row.width) {
      return out;
    }
    int32_t skipped = x - at;
    for (; skipped > kMostSkipped; skipped -= kMostSkipped) {
      *out++ = kMostSkipped << 4;
    }
    int32_t count = row.count_solid(x, kMostSolid);
    if (count >= kLeastSolid) {
      *out++ = static_cast<uint8_t>(skipped << 4 | kSolid);
      *out++ = static_cast<uint8_t>(count);
    } else {
      count = row.count_mixed(x);
      *out++ = static_cast<uint8_t>(skipped << 4 | count);
      out = put_pixels(row, x, count, out);
    }
    at = x + count;
  }
}

// Coverage of 8 bits; `to` is a multiple of 4, and up to a word is written
// behind the last value.
void unpack(const uint8_t* from,
            int32_t values,
            uint32_t bits,
            uint8_t* to) noexcept {
  for (; values > 0; values -= 4) {
    if (bits == 8) {
      store_pixels(to, from[0] | uint32_t{from[1]} << 8 |
                           uint32_t{from[2]} << 16 | uint32_t{from[3]} << 24);
      from += 4;
    } else {
      // Four levels, each to the low half of a byte, and then to both.
      uint32_t word = from[0] | uint32_t{from[1]} << 16;
      word = (word | word << 4) & 0x0f0f0f0f;
      store_pixels(to, word | word << 4);
      from += 2;
    }
    to += 4;
  }
}

// One step of equal rows.
class Step {
 public:
  Step(const uint8_t* at, int32_t x, Packing packing) noexcept
      : pixels_(at + 1), x_(x + (at[0] >> 4)), count_(at[0] & 15) {
    if (count_ == kSolid) {
      count_ = at[1];
      bytes_ = 1;
      is_solid_ = true;
      return;
    }
    const int32_t values = count_ * packing.channels;
    bytes_ = packing.bits == 4 ? (values + 1) >> 1 : values;
  }

  const uint8_t* next() const noexcept { return pixels_ + bytes_; }
  int32_t end_x() const noexcept { return x_ + count_; }

  // Into rows `y` to `end_y` of the window, and the columns that it has.
  void draw(const Sink& sink,
            int32_t y,
            int32_t end_y,
            Packing packing) const noexcept {
    const int32_t x = max(x_, sink.window.x0);
    const int32_t count = min(end_x(), sink.window.x1) - x;
    if (count <= 0) {
      return;
    }
    if (is_solid_) {
      for (; y < end_y; ++y) {
        sink.solid(sink.context, x, y, count);
      }
      return;
    }
    alignas(4) uint8_t coverage[kMostPixels * 3 + 6];
    unpack(pixels_, count_ * packing.channels, packing.bits, coverage);
    const auto draw = packing.channels == 1 ? sink.coverage : sink.coverage_rgb;
    const uint8_t* const first = coverage + (x - x_) * packing.channels;
    for (; y < end_y; ++y) {
      draw(sink.context, x, y, first, count);
    }
  }

 private:
  const uint8_t* pixels_;
  int32_t x_;
  int32_t count_;
  int32_t bytes_;
  bool is_solid_ = false;
};

}  // namespace

int32_t most_row_bytes(int32_t width, Packing packing) noexcept {
  // Every step but the last one holds kMostPixels, or ends where it saves
  // bytes; three steps may skip in vain.
  const int32_t values = width * packing.channels;
  const int32_t steps = width / kLeastGap + 4;
  return 2 + 2 * steps + (packing.bits == 4 ? (values + 1) / 2 : values);
}

uint8_t* record_row(const uint8_t* coverage,
                    int32_t width,
                    Packing packing,
                    uint8_t* last,
                    uint8_t* end) noexcept {
  uint8_t* const steps = end + 2;
  uint8_t* const steps_end = put_steps({coverage, width, packing}, steps);
  const auto bytes = static_cast<int32_t>(steps_end - steps);
  if (last != nullptr) {
    const Group group(last);
    if (group.rows < kMostEqual && group.bytes == bytes &&
        are_equal(group.steps, steps, bytes)) {
      *last = static_cast<uint8_t>(*last + (1 << 5));
      return end;
    }
  }
  if (bytes >= kLongSteps) {
    end[0] = kLongSteps;
    end[1] = static_cast<uint8_t>(bytes);
    return steps_end;
  }
  *end++ = static_cast<uint8_t>(bytes);
  for (int32_t i = 0; i != bytes; ++i) {
    end[i] = steps[i];
  }
  return end + bytes;
}

void replay(const uint8_t* at,
            const uint8_t* end,
            Packing packing,
            int32_t x,
            int32_t y,
            const Sink& sink) noexcept {
  while (at != end && y < sink.window.y1) {
    const Group group(at);
    const int32_t first_y = max(y, sink.window.y0);
    y += group.rows;
    const int32_t end_y = min(y, sink.window.y1);
    at = group.end();
    if (first_y >= end_y) {
      continue;
    }
    int32_t step_x = x;
    for (const uint8_t* step_at = group.steps; step_at != at;) {
      const Step step(step_at, step_x, packing);
      step.draw(sink, first_y, end_y, packing);
      step_at = step.next();
      step_x = step.end_x();
    }
  }
}

}  // namespace detail
}  // namespace inkcell
