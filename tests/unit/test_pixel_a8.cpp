// The A8 sink where little was drawn before: whole words are copied there.
#include "check.hpp"
#include "inkcell/port/a8.hpp"
#include "random.hpp"

using namespace inkcell;

namespace {

constexpr int32_t kWidth = 40;
constexpr size_t kMargin = 8;

alignas(4) uint8_t pixels[kMargin + kWidth + 3 + kMargin];
alignas(4) uint8_t expected[sizeof pixels];
alignas(4) uint8_t coverage[3 + kMaxSpan + 4];

uint8_t added(uint32_t above, uint32_t below) {
  const uint32_t twice = 2 * (255 - above) * (255 - below);
  return static_cast<uint8_t>(255 - (twice + 255) / 510);
}

// Draws a span over what is there, and compares all bytes.
void check_span(const uint8_t* from, size_t shift, int32_t x, int32_t count) {
  port::A8Canvas sink(
      {{pixels + kMargin + shift, kWidth}, 0, 0, kWidth, 1, kWidth});
  CHECK_OK(sink.status());
  for (size_t i = 0; i < sizeof pixels; ++i) {
    expected[i] = pixels[i];
  }
  for (int32_t i = 0; i < count; ++i) {
    if (x + i >= 0 && x + i < kWidth) {
      uint8_t& pixel = expected[kMargin + shift + static_cast<size_t>(x + i)];
      pixel = added(from[i], pixel);
    }
  }
  sink.coverage(sink.context, x, 0, from, count);
  for (size_t i = 0; i < sizeof pixels; ++i) {
    CHECK_EQ(pixels[i], expected[i]);
  }
}

// One byte of `each` is drawn, none if that is 0.
void fill(Random& random, uint32_t each) {
  for (uint8_t& pixel : pixels) {
    const bool is_drawn = each != 0 && random.below(each) == 0;
    pixel = static_cast<uint8_t>(is_drawn ? random.between(1, 255) : 0);
  }
}

}  // namespace

// At all ways in which pixels and coverage may lie in words.
TEST(spans_over_little_ink) {
  Random random(1);
  for (size_t at = 0; at < 4; ++at) {
    for (size_t shift = 0; shift < 4; ++shift) {
      for (int32_t count = 1; count <= kMaxSpan; ++count) {
        for (uint32_t each = 0; each <= 16; each += 8) {
          fill(random, each);
          // Also behind the span, which must not be drawn.
          for (uint8_t& byte : coverage) {
            byte = static_cast<uint8_t>(random.between(1, 255));
          }
          check_span(coverage + at, shift, random.between(-3, kWidth - 1),
                     count);
        }
      }
    }
  }
}
