// Sinks for sub-pixels and sinks that dither, against plain ones.
#include "check.hpp"
#include "inkcell/port/dither.hpp"
#include "inkcell/port/lcd.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 13;
constexpr int32_t kHeight = 8;
constexpr int32_t kX0 = -3;
constexpr int32_t kY0 = 5;

alignas(4) uint8_t bytes[4 * kWidth * kHeight];
uint8_t before[sizeof(bytes)];
uint8_t coverages[3 * kMaxSpan];

Strip strip_of(PixelFormat format) {
  const int32_t stride = stride_bytes(format, kWidth);
  return {{bytes, strip_bytes(format, kWidth, kHeight)},
          kX0,
          kY0,
          kWidth,
          kHeight,
          stride};
}

void fill(Random& random) {
  for (size_t i = 0; i < sizeof(bytes); ++i) {
    bytes[i] = before[i] = random.any();
  }
  for (uint8_t& coverage : coverages) {
    const uint32_t kind = random.below(4);
    coverage = static_cast<uint8_t>(kind < 2 ? random.next() : kind * 85);
    coverage = kind == 3 ? 0 : coverage;
  }
}

// The rational c * f + (255 - c) * b over 255, to the nearest.
uint32_t nearest(uint32_t c, uint32_t f, uint32_t b) {
  return (2 * (c * f + (255 - c) * b) + 255) / 510;
}

// A run that may lie anywhere around the strip.
struct Run {
  int32_t x;
  int32_t y;
  int32_t count;
};

Run any_run(Random& random) {
  return {random.between(kX0 - 8, kX0 + kWidth + 2),
          random.between(kY0 - 2, kY0 + kHeight + 1),
          random.between(1, kMaxSpan)};
}

// What pixel (x, y) of the strip is given by the run: null if nothing.
const uint8_t* given(const Run& run, int32_t x, int32_t y, int32_t channels) {
  const int32_t i = kX0 + x - run.x;
  const bool is_given = run.y == kY0 + y && i >= 0 && i < run.count;
  return is_given ? coverages + channels * i : nullptr;
}

constexpr uint8_t kNothing[3] = {0, 0, 0};

uint32_t bits_at(const uint8_t* data,
                 int32_t stride,
                 int32_t x,
                 int32_t y,
                 int32_t bits,
                 bool high_left) {
  const int32_t bit = x * bits;
  const int32_t shift = high_left ? 8 - bits - bit % 8 : bit % 8;
  return static_cast<uint32_t>(data[y * stride + bit / 8]) >> shift &
         ((1u << bits) - 1);
}

// What must be reached at a place, of 256, in the order of Bayer's matrix.
int32_t bayer(int32_t x, int32_t y) {
  // Bits of the number, most significant first, come from x ^ y and y.
  const int32_t low = ((x ^ y) & 1) * 2 + (y & 1);
  const int32_t high = ((x ^ y) >> 1 & 1) * 2 + (y >> 1 & 1);
  return 16 * (4 * low + high) + 8;
}

template <typename Canvas>
void check_grey(PixelFormat format, uint8_t level, int32_t bits) {
  Rounds rounds(17, 300);
  for (Random& random : rounds) {
    const bool high = rounds.number % 2 == 0;
    fill(random);
    Canvas sink(strip_of(format), level,
                high ? BitOrder::high_left : BitOrder::low_left);
    set_dither(sink);
    CHECK_OK(sink.status());
    const Run run = any_run(random);
    sink.coverage(sink.context, run.x, run.y, coverages, run.count);
    for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
      const uint8_t* c = given(run, x, y, 1);
      const int32_t stride = sink.strip().stride;
      const uint32_t old = bits_at(before, stride, x, y, bits, high);
      uint32_t expected = old;
      if (c != nullptr && *c != 0) {
        // Up if what is over a level reaches the step.
        const uint32_t sum = *c * level + (255u - *c) * old;
        const uint32_t over = sum % 255;
        const auto step = static_cast<uint32_t>(bayer(kX0 + x, kY0 + y));
        expected = sum / 255 + (over >= step ? 1 : 0);
      }
      CHECK_EQ(bits_at(bytes, stride, x, y, bits, high), expected);
    }
  }
}

template <typename Canvas, typename Bit>
void check_mono(PixelFormat format, const Bit& bit) {
  Rounds rounds(18, 300);
  for (Random& random : rounds) {
    const auto level = static_cast<uint8_t>(rounds.number & 1);
    const uint8_t threshold = rounds.number % 3 == 0 ? 100 : 128;
    fill(random);
    Canvas sink(strip_of(format), level);
    sink.set_threshold(threshold);
    set_dither(sink);
    CHECK_OK(sink.status());
    const Run run = any_run(random);
    sink.coverage(sink.context, run.x, run.y, coverages, run.count);
    for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
      const uint8_t* c = given(run, x, y, 1);
      const int32_t step = bayer(kX0 + x, kY0 + y) + threshold - 128;
      const bool is_drawn =
          c != nullptr && *c != 0 && (*c == 255 || *c >= step);
      CHECK_EQ(bit(bytes, x, y), is_drawn ? level : bit(before, x, y));
    }
  }
}

void check_lcd(const Sink& sink,
               int32_t bytes_each,
               const int* place,
               const uint32_t* level,
               const Run& run) {
  sink.coverage_rgb(sink.context, run.x, run.y, coverages, run.count);
  for (int32_t i = 0; i < kWidth * kHeight; ++i) {
    const uint8_t* c = given(run, i % kWidth, i / kWidth, 3);
    c = c == nullptr ? kNothing : c;
    for (int32_t channel = 0; channel < 3; ++channel) {
      const int32_t at = bytes_each * i + place[channel];
      CHECK_EQ(bytes[at], nearest(c[channel], level[channel], before[at]));
    }
    CHECK(bytes_each == 3 || bytes[4 * i + 3] == before[4 * i + 3]);
  }
}

constexpr uint32_t kColour = 0x40c2fe;
constexpr uint32_t kLevels[3] = {0x40, 0xc2, 0xfe};
constexpr int kRedFirst[3] = {0, 1, 2};
constexpr int kBlueFirst[3] = {2, 1, 0};

}  // namespace

TEST(bytes_blend_each_channel_for_itself) {
  Rounds rounds(15, 300);
  for (Random& random : rounds) {
    fill(random);
    const bool red_first = rounds.number % 2 == 0;
    Rgb888Canvas sink(
        strip_of(PixelFormat::rgb888), kColour,
        red_first ? ChannelOrder::red_first : ChannelOrder::blue_first);
    set_sub_pixels(sink);
    check_lcd(sink, 3, red_first ? kRedFirst : kBlueFirst, kLevels,
              any_run(random));
  }
}

TEST(words_blend_each_channel_for_itself) {
  for (Random& random : Rounds(16, 300)) {
    fill(random);
    Xrgb8888Canvas sink(strip_of(PixelFormat::xrgb8888), kColour);
    set_sub_pixels(sink);
    check_lcd(sink, 4, kBlueFirst, kLevels, any_run(random));
  }
}

TEST(rgb565_blends_each_channel_for_itself) {
  Rounds rounds(14, 300);
  for (Random& random : rounds) {
    fill(random);
    const uint16_t colour = rgb565(0x40, 0xc2, 0xfe);
    const int low = rounds.number % 2;
    Strip strip = strip_of(PixelFormat::rgb565);
    strip.order = low == 0 ? ByteOrder::low_first : ByteOrder::high_first;
    Rgb565Canvas sink(strip, colour);
    set_sub_pixels(sink);
    const Run run = any_run(random);
    sink.coverage_rgb(sink.context, run.x, run.y, coverages, run.count);
    for (int32_t i = 0; i < kWidth * kHeight; ++i) {
      const uint8_t* c = given(run, i % kWidth, i / kWidth, 3);
      c = c == nullptr ? kNothing : c;
      const auto pixel = [i, low](const uint8_t* data) {
        return static_cast<uint32_t>(data[2 * i + low] | data[2 * i + 1 - low]
                                                             << 8);
      };
      const uint32_t old = pixel(before);
      const uint32_t now = pixel(bytes);
      CHECK_EQ(now >> 11, nearest(c[0], colour >> 11, old >> 11));
      CHECK_EQ(now >> 5 & 63, nearest(c[1], colour >> 5 & 63, old >> 5 & 63));
      CHECK_EQ(now & 31, nearest(c[2], colour & 31, old & 31));
    }
  }
}

TEST(plain_sinks_know_no_sub_pixels) {
  Rgb565Canvas sink(strip_of(PixelFormat::rgb565));
  CHECK(sink.coverage_rgb == nullptr);
  set_sub_pixels(sink);
  CHECK(sink.coverage_rgb != nullptr);
  sink.set_strip(strip_of(PixelFormat::rgb565));
  CHECK(sink.coverage_rgb != nullptr);
}

TEST(rows_dither) {
  check_mono<MonoRowsCanvas>(
      PixelFormat::mono_rows, [](const uint8_t* data, int32_t x, int32_t y) {
        return bits_at(data, (kWidth + 7) / 8, x, y, 1, true);
      });
}

TEST(pages_dither) {
  check_mono<MonoPagesCanvas>(
      PixelFormat::mono_pages, [](const uint8_t* data, int32_t x, int32_t y) {
        return static_cast<uint32_t>(data[y / 8 * kWidth + x] >> y % 8) & 1;
      });
}

TEST(greys_dither) {
  check_grey<Grey2Canvas>(PixelFormat::grey2, 3, 2);
  check_grey<Grey2Canvas>(PixelFormat::grey2, 1, 2);
  check_grey<Grey4Canvas>(PixelFormat::grey4, 15, 4);
}

// A shade becomes as many pixels of 16 as it says.
TEST(shades_keep_their_weight) {
  for (int32_t shade = 0; shade < 256; ++shade) {
    MonoRowsCanvas sink(strip_of(PixelFormat::mono_rows));
    set_dither(sink);
    for (uint8_t& byte : bytes) {
      byte = 0;
    }
    for (uint8_t& coverage : coverages) {
      coverage = static_cast<uint8_t>(shade);
    }
    int32_t drawn = 0;
    for (int32_t y = 0; y < 4; ++y) {
      sink.coverage(sink.context, kX0, kY0 + y, coverages, 4);
      for (int32_t x = 0; x < 4; ++x) {
        drawn += static_cast<int32_t>(
            bits_at(bytes, sink.strip().stride, x, y, 1, true));
      }
    }
    const int32_t error = 16 * drawn - shade;
    CHECK(error >= -16 && error <= 16);
  }
}

// Whatever the threshold, which moves the steps by up to 127.
TEST(solid_pixels_are_drawn_and_empty_ones_are_not) {
  constexpr uint8_t kThresholds[] = {1, 255};
  for (const uint8_t threshold : kThresholds) {
    uint8_t pixels[4] = {};
    MonoRowsCanvas sink({pixels, 0, 0, 8, 4, 1});
    sink.set_threshold(threshold);
    set_dither(sink);
    const uint8_t coverage[] = {255, 0, 255, 0, 0, 255, 0, 255};
    for (int32_t y = 0; y < 4; ++y) {
      sink.coverage(sink.context, 0, y, coverage, 8);
      CHECK_EQ(pixels[y], 0xa5);
    }
  }
}

TEST(dithered_levels_out_of_range_stay_in_their_pixel) {
  uint8_t byte[1] = {0};
  Grey4Canvas sink({byte, 0, 0, 1, 1, 1}, 255, BitOrder::low_left);
  set_dither(sink);
  const uint8_t coverage[1] = {255};
  sink.coverage(sink.context, 0, 0, coverage, 1);
  CHECK_EQ(byte[0], 0x0f);
}
