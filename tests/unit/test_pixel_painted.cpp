// Sinks that take painted rows draw what they draw of the same coverage.
#include "check.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/rgb565.hpp"
#include "random.hpp"

using namespace inkcell;

namespace {

constexpr int32_t kWidth = 40;
constexpr size_t kMargin = 8;
constexpr size_t kMostBytes = 2 * kWidth;

alignas(4) uint8_t pixels[kMargin + kMostBytes + kMargin];
alignas(4) uint8_t expected[sizeof pixels];

// Coverage of painted bytes, pixel by pixel.
struct PlainRamp {
  static constexpr Painted kKind = Painted::ramp;
  static constexpr int32_t kBefore = 1;  // pixels before the first one
  bool is_inside = false;

  uint32_t next(uint32_t byte) {
    is_inside ^= (byte & 1) != 0;
    return is_inside ? 255 - (byte >> 1) : byte >> 1;
  }
};
struct PlainSums {
  static constexpr Painted kKind = Painted::sums;
  static constexpr int32_t kBefore = 0;
  uint32_t sum = 0;

  uint32_t next(uint32_t byte) {
    sum = (sum + byte) & 255;
    const uint32_t full = sum > 247 ? 0 : sum > 240 ? 240 : sum;
    return full + full / 16;
  }
};

template <typename Canvas, int32_t kPixelBytes, typename Plain>
void check_painted() {
  Random random(kPixelBytes);
  const auto strip_in = [](uint8_t* bytes, int32_t width) {
    return Strip{{bytes + kMargin, kMostBytes}, 0, 0, width, 1,
                 kWidth * kPixelBytes};
  };
  Canvas sink(strip_in(pixels, kWidth));
  const Canvas plain(strip_in(expected, kWidth));
  CHECK_OK(sink.status());
  if (sink.painted == nullptr) {
    return;  // built for size: bands come as coverage
  }
  alignas(4) uint8_t painted[kWidth + 8];
  alignas(4) uint8_t coverage[kWidth + 8];
  for (int32_t round = 0; round < 2000; ++round) {
    const uint32_t drawn = random.below(2) * 16;
    for (size_t i = 0; i < sizeof pixels; ++i) {
      const bool is_drawn = drawn != 0 && random.below(drawn) == 0;
      pixels[i] = static_cast<uint8_t>(is_drawn ? random.below(256) : 0);
      expected[i] = pixels[i];
    }
    const uint32_t each = 1 + random.below(6);
    for (uint8_t& byte : painted) {
      byte =
          static_cast<uint8_t>(random.below(each) == 0 ? random.below(256) : 0);
    }
    const int32_t x0 = random.between(0, kWidth - 1);
    const int32_t x1 = random.between(x0 + 1, kWidth);
    // From a multiple of 4 on.
    const int32_t before = ((x0 - Plain::kBefore) & 3) + Plain::kBefore;
    Plain words;
    for (int32_t i = 0; i < before + x1 - x0; ++i) {
      const auto covered = static_cast<uint8_t>(words.next(painted[i]));
      if (i >= before) {
        coverage[(x0 & 3) + i - before] = covered;
      }
    }
    plain.block(plain.context,
                {{x0, 0, x1, 1}, coverage + (x0 & 3), kWidth + 8});
    CHECK(sink.painted(sink.context, {{x0, 0, x1, 1}, painted, kWidth + 8},
                       Plain::kKind));
    for (size_t i = 0; i < sizeof pixels; ++i) {
      CHECK_EQ(pixels[i], expected[i]);
    }
  }
  // Words of which a part lies outside of the strip.
  sink.set_strip(strip_in(pixels, kWidth - 1));
  CHECK(!sink.painted(sink.context, {{36, 0, 39, 1}, painted, kWidth + 8},
                      Plain::kKind));
}

}  // namespace

TEST(ramps_and_sums_into_a8) {
  check_painted<port::A8Canvas, 1, PlainRamp>();
  check_painted<port::A8Canvas, 1, PlainSums>();
}

TEST(ramps_and_sums_into_rgb565) {
  check_painted<port::Rgb565Canvas, 2, PlainRamp>();
  check_painted<port::Rgb565Canvas, 2, PlainSums>();
}
