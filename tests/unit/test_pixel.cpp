// Every pixel sink against a plain one: all coverages, places and clippings.
#include "check.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "pixels.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

// A pixel as up to four channels, and how deep each is.
struct Pixel {
  uint32_t channel[4];
};

// What a format does, written as plainly as possible: where a pixel lies and
// what drawing it must leave.
struct Format {
  PixelFormat format;
  bool high_first;  // left pixel in the high bits, or high byte first
  Pixel (*read)(const Format&, const Strip&, int32_t x, int32_t y);
  uint32_t channels;
  Pixel foreground;
  uint32_t threshold;  // 0 unless 1-bit
  Status (*open)(const Format&, const Strip&, Sink& out);
};

uint32_t pack(const Pixel& p, int bits0, int bits1, int bits2) {
  return p.channel[0] << (bits1 + bits2) | p.channel[1] << bits2 |
         p.channel[2] << (0 * bits0);
}

// The rational c * f + (255 - c) * b over 255, to the nearest, by division.
uint32_t nearest(uint32_t c, uint32_t f, uint32_t b) {
  const uint32_t twice = 2 * (c * f + (255 - c) * b);
  return (twice + 255) / 510;
}

// RGB565 blends in 32 steps: a level from the nearest at the most.
uint32_t in_steps(uint32_t c, uint32_t foreground, uint32_t old) {
  const uint32_t share = (2 * 32 * c + 255) / 510;  // to the nearest
  const uint32_t level = (share * foreground + (32 - share) * old + 16) / 32;
  const uint32_t best = nearest(c, foreground, old);
  CHECK(level <= best + 1 && best <= level + 1);
  return level;
}

uint32_t drawn_channel(const Format& f, uint32_t i, uint32_t c, uint32_t old) {
  if (c == 0) {
    return old;
  }
  if (f.format == PixelFormat::rgb565) {
    return in_steps(c, f.foreground.channel[i], old);
  }
  if (f.threshold == 0) {
    return nearest(c, f.foreground.channel[i], old);
  }
  return c >= f.threshold ? f.foreground.channel[i] : old;
}

Pixel read_bits(const Format& f, const Strip& s, int32_t x, int32_t y) {
  const int32_t bits = bits_per_pixel(f.format);
  const int32_t bit = x * bits;
  const int32_t shift = f.high_first ? 8 - bits - bit % 8 : bit % 8;
  const uint32_t byte = s.pixels[static_cast<size_t>(y * s.stride + bit / 8)];
  return {{byte >> shift & ((1u << bits) - 1)}};
}

Pixel read_page(const Format&, const Strip& s, int32_t x, int32_t y) {
  const uint32_t byte = s.pixels[static_cast<size_t>(y / 8 * s.stride + x)];
  return {{byte >> (y % 8) & 1}};
}

Pixel read_565(const Format& f, const Strip& s, int32_t x, int32_t y) {
  const auto at = static_cast<size_t>(y * s.stride + 2 * x);
  const uint32_t high = s.pixels[f.high_first ? at : at + 1];
  const uint32_t low = s.pixels[f.high_first ? at + 1 : at];
  const uint32_t pixel = high * 256 + low;
  return {{pixel / 2048, pixel / 32 % 64, pixel % 32}};
}

Pixel read_bytes(const Format& f, const Strip& s, int32_t x, int32_t y) {
  const int32_t bytes = bits_per_pixel(f.format) / 8;
  Pixel result = {};
  for (int32_t i = 0; i < bytes; ++i) {
    result.channel[i] =
        s.pixels[static_cast<size_t>(y * s.stride + bytes * x + i)];
  }
  return result;
}

// The sink of a canvas, which lives until the next one of its kind is opened.
template <typename Canvas>
Status open(const Canvas& made, Sink& out) {
  static Canvas canvas;
  canvas = made;
  out = canvas;
  return canvas.status();
}

BitOrder bit_order(const Format& f) {
  return f.high_first ? BitOrder::high_left : BitOrder::low_left;
}

uint8_t level(const Format& f) {
  return static_cast<uint8_t>(f.foreground.channel[0]);
}

Status open_a8(const Format&, const Strip& s, Sink& out) {
  return open(A8Canvas(s), out);
}

Status open_grey8(const Format& f, const Strip& s, Sink& out) {
  return open(Grey8Canvas(s, level(f)), out);
}

Status open_grey4(const Format& f, const Strip& s, Sink& out) {
  return open(Grey4Canvas(s, level(f), bit_order(f)), out);
}

Status open_grey2(const Format& f, const Strip& s, Sink& out) {
  return open(Grey2Canvas(s, level(f), bit_order(f)), out);
}

Status open_mono_rows(const Format& f, const Strip& s, Sink& out) {
  MonoRowsCanvas made(s, level(f), bit_order(f));
  made.set_threshold(static_cast<uint8_t>(f.threshold));
  return open(made, out);
}

Status open_mono_pages(const Format& f, const Strip& s, Sink& out) {
  MonoPagesCanvas made(s, level(f));
  made.set_threshold(static_cast<uint8_t>(f.threshold));
  return open(made, out);
}

Status open_565(const Format& f, const Strip& s, Sink& out) {
  const auto colour = static_cast<uint16_t>(pack(f.foreground, 5, 6, 5));
  Strip strip = s;
  strip.order = f.high_first ? ByteOrder::high_first : ByteOrder::low_first;
  return open(Rgb565Canvas(strip, colour), out);
}

// The channels of Format are in the order of the bytes.
Status open_888(const Format& f, const Strip& s, Sink& out) {
  const Pixel& p = f.foreground;
  const Pixel reversed = {{p.channel[2], p.channel[1], p.channel[0]}};
  return open(
      Rgb888Canvas(
          s, f.high_first ? pack(p, 8, 8, 8) : pack(reversed, 8, 8, 8),
          f.high_first ? ChannelOrder::red_first : ChannelOrder::blue_first),
      out);
}

Status open_xrgb(const Format& f, const Strip& s, Sink& out) {
  const Pixel& p = f.foreground;
  const Pixel reversed = {{p.channel[2], p.channel[1], p.channel[0]}};
  return open(Xrgb8888Canvas(s, p.channel[3] << 24 | pack(reversed, 8, 8, 8)),
              out);
}

using Pf = PixelFormat;
const Format kFormats[] = {
    {Pf::a8, false, read_bytes, 1, {{255}}, 0, open_a8},
    {Pf::grey8, false, read_bytes, 1, {{255}}, 0, open_grey8},
    {Pf::grey8, false, read_bytes, 1, {{77}}, 0, open_grey8},
    {Pf::grey4, true, read_bits, 1, {{15}}, 0, open_grey4},
    {Pf::grey4, false, read_bits, 1, {{6}}, 0, open_grey4},
    {Pf::grey2, true, read_bits, 1, {{3}}, 0, open_grey2},
    {Pf::grey2, false, read_bits, 1, {{1}}, 0, open_grey2},
    {Pf::mono_rows, true, read_bits, 1, {{1}}, 128, open_mono_rows},
    {Pf::mono_rows, false, read_bits, 1, {{0}}, 1, open_mono_rows},
    {Pf::mono_rows, false, read_bits, 1, {{1}}, 255, open_mono_rows},
    {Pf::mono_pages, false, read_page, 1, {{1}}, 128, open_mono_pages},
    {Pf::mono_pages, false, read_page, 1, {{0}}, 200, open_mono_pages},
    {Pf::rgb565, false, read_565, 3, {{31, 63, 31}}, 0, open_565},
    {Pf::rgb565, true, read_565, 3, {{3, 40, 17}}, 0, open_565},
    {Pf::rgb565, true, read_565, 3, {{0, 0, 0}}, 0, open_565},
    {Pf::rgb888, true, read_bytes, 3, {{255, 1, 130}}, 0, open_888},
    {Pf::rgb888, false, read_bytes, 3, {{9, 200, 31}}, 0, open_888},
    {Pf::xrgb8888, false, read_bytes, 4, {{1, 99, 254, 255}}, 0, open_xrgb},
    {Pf::xrgb8888, false, read_bytes, 4, {{255, 255, 255, 0}}, 0, open_xrgb},
};

// Strips of this test: at an odd place of the screen, with room around them
// that nothing may write to.
constexpr int32_t kX0 = -5;
constexpr int32_t kY0 = 16;
constexpr int32_t kMaxWidth = 23;
constexpr int32_t kHeight = 11;  // a page and a part of one
constexpr size_t kMargin = 16;
constexpr size_t kBytes = 2 * kMargin + (4 * kMaxWidth + 8) * kHeight;

Random random(1);

// A strip in memory filled with noise, and that noise once more.
struct Canvas {
  alignas(4) uint8_t before[kBytes];
  alignas(4) uint8_t after[kBytes];
  Strip strip;

  void open(const Format& f, int32_t width, size_t shift) {
    for (size_t i = 0; i < kBytes; ++i) {
      before[i] = after[i] = static_cast<uint8_t>(random.below(256));
    }
    const bool words = f.format == PixelFormat::xrgb8888;
    const int32_t padding = words ? 4 : static_cast<int32_t>(shift % 3);
    strip.stride = stride_bytes(f.format, width) + padding;
    strip.x0 = kX0;
    strip.y0 = kY0;
    strip.width = width;
    strip.height = kHeight;
    const size_t rows = f.format == PixelFormat::mono_pages ? 2 : kHeight;
    const auto stride = static_cast<size_t>(strip.stride);
    strip.pixels = {after + kMargin + (words ? 0 : shift),
                    rows * stride - static_cast<size_t>(padding)};
  }

  Strip old() const {
    Strip result = strip;
    result.pixels.data =
        const_cast<uint8_t*>(before) + (strip.pixels.data - after);
    return result;
  }
};
Canvas canvas;

// A call of a sink in screen coordinates; coverage == nullptr is a solid run.
struct Call {
  int32_t x;
  int32_t y;
  int32_t count;
  const uint8_t* coverage;

  // Coverage of a pixel that the call draws, 0 of one that it does not name.
  uint32_t at(int32_t px, int32_t py) const {
    if (py != y || px < x || px >= x + count) {
      return 0;
    }
    return coverage == nullptr ? 255 : coverage[px - x];
  }
};

// The bytes that hold no pixel are compared by giving every pixel of `after`
// its old value back: then all of memory must be as before.
void check_rest_untouched(const Format& f) {
  const Strip& s = canvas.strip;
  const size_t first = static_cast<size_t>(s.pixels.data - canvas.after);
  const int32_t row_bits = s.width * bits_per_pixel(f.format);
  for (size_t i = 0; i < kBytes; ++i) {
    uint32_t mask = 0xff;  // bits of this byte that no pixel owns
    const auto offset = static_cast<int32_t>(i) - static_cast<int32_t>(first);
    if (offset >= 0 && f.format == PixelFormat::mono_pages) {
      const int32_t rows = s.height - offset / s.stride * 8;
      if (offset % s.stride < s.width && rows > 0) {
        mask = rows >= 8 ? 0 : 0xffu << rows & 0xff;
      }
    } else if (offset >= 0 && offset / s.stride < s.height) {
      const int32_t bits = row_bits - offset % s.stride * 8;
      if (bits >= 8) {
        mask = 0;
      } else if (bits > 0) {
        mask = f.high_first ? 0xffu >> bits : 0xffu << bits & 0xff;
      }
    }
    CHECK_EQ(canvas.after[i] & mask, canvas.before[i] & mask);
  }
}

void check_call(const Format& f, const Call& call) {
  Sink sink;
  CHECK_OK(f.open(f, canvas.strip, sink));
  if (call.coverage == nullptr) {
    sink.solid(sink.context, call.x, call.y, call.count);
  } else {
    sink.coverage(sink.context, call.x, call.y, call.coverage, call.count);
  }
  for (const auto [x, y] : pixels_of(canvas.strip.width, canvas.strip.height)) {
    const Pixel before = f.read(f, canvas.old(), x, y);
    const Pixel after = f.read(f, canvas.strip, x, y);
    const uint32_t c = call.at(kX0 + x, kY0 + y);
    for (uint32_t i = 0; i < f.channels; ++i) {
      CHECK_EQ(after.channel[i], drawn_channel(f, i, c, before.channel[i]));
    }
  }
  check_rest_untouched(f);
}

TEST(divide_by_255_is_exact) {
  for (uint32_t value = 0; value < 65536; ++value) {
    CHECK_EQ(divide_by_255(value), (2 * value + 255) / 510);
  }
}

TEST(blend_ends) {
  for (uint32_t old = 0; old < 256; ++old) {
    CHECK_EQ(blend(0, 200, old), old);
    CHECK_EQ(blend(255, 200, old), 200);
    CHECK_EQ(blend(128, old, old), old);
  }
  static_assert(blend(128, 255, 0) == 128, "");
  static_assert(blend(127, 3, 0) == 1 && blend(128, 3, 0) == 2, "");
}

TEST(strip_sizes) {
  CHECK_EQ(stride_bytes(PixelFormat::a8, 13), 13);
  CHECK_EQ(stride_bytes(PixelFormat::grey4, 13), 7);
  CHECK_EQ(stride_bytes(PixelFormat::grey2, 13), 4);
  CHECK_EQ(stride_bytes(PixelFormat::mono_rows, 13), 2);
  CHECK_EQ(stride_bytes(PixelFormat::mono_rows, 16), 2);
  CHECK_EQ(stride_bytes(PixelFormat::mono_pages, 13), 13);
  CHECK_EQ(stride_bytes(PixelFormat::rgb565, 13), 26);
  CHECK_EQ(stride_bytes(PixelFormat::rgb888, 13), 39);
  CHECK_EQ(stride_bytes(PixelFormat::xrgb8888, 13), 52);
  CHECK_EQ(strip_bytes(PixelFormat::grey8, 128, 8), 1024);
  CHECK_EQ(strip_bytes(PixelFormat::mono_pages, 96, 16), 192);
  CHECK_EQ(strip_bytes(PixelFormat::mono_pages, 96, 9), 192);
  CHECK_EQ(strip_bytes(PixelFormat::rgb565, 320, 0), 0);
}

// Each of the 256 coverages over noise, at places that move with them.
TEST(all_coverages) {
  for (const Format& f : kFormats) {
    for (uint32_t c = 0; c < 256 && !check::failed(); ++c) {
      uint8_t coverage[7];
      for (uint8_t& each : coverage) {
        each = static_cast<uint8_t>(c);
      }
      canvas.open(f, 17, c % 4);
      check_call(f, {kX0 + static_cast<int32_t>(c % 11),
                     kY0 + static_cast<int32_t>(c % kHeight), 7, coverage});
    }
  }
}

// Every first pixel and every length, of spans and of solid runs, in strips of
// odd and even width that begin at any address.
TEST(all_runs) {
  uint8_t coverage[kMaxSpan];
  for (const Format& f : kFormats) {
    for (int32_t x = 0; x < 9 && !check::failed(); ++x) {
      for (int32_t count = 1; count <= kMaxWidth - x; ++count) {
        random.fill(coverage);
        const auto shift = static_cast<size_t>(x + count) % 4;
        canvas.open(f, kMaxWidth - count % 2, shift);
        check_call(f, {kX0 + x, kY0 + count % kHeight, count, coverage});
        canvas.open(f, kMaxWidth - count % 2, shift);
        check_call(f, {kX0 + x, kY0 + count % kHeight, count, nullptr});
      }
    }
  }
}

// Runs that begin or end outside the strip, or lie beside it.
TEST(clipping) {
  const int32_t kRows[] = {-1, 0, kHeight - 1, kHeight};
  uint8_t coverage[kMaxSpan];
  for (uint8_t& each : coverage) {
    each = static_cast<uint8_t>(1 + random.below(255));
  }
  for (const Format& f : kFormats) {
    for (int32_t x = -12; x <= 12 && !check::failed(); ++x) {
      for (const int32_t y : kRows) {
        canvas.open(f, 9, 1);
        check_call(f, {kX0 + x, kY0 + y, 11, coverage});
        canvas.open(f, 9, 2);
        check_call(f, {kX0 + x, kY0 + y, 11, nullptr});
      }
    }
  }
}

TEST(absurd_calls_touch_nothing) {
  const int32_t kFar[] = {INT32_MIN, INT32_MIN + 4, -65536, 65536, INT32_MAX};
  const uint8_t coverage[2] = {255, 255};
  for (const Format& f : kFormats) {
    canvas.open(f, 9, 0);
    Sink sink;
    CHECK_OK(f.open(f, canvas.strip, sink));
    for (int32_t far : kFar) {
      sink.solid(sink.context, far, kY0, 2);
      sink.solid(sink.context, kX0, far, 2);
      sink.solid(sink.context, kX0, kY0, far < 0 ? far : 0);
      sink.coverage(sink.context, far, kY0, coverage, 2);
      sink.coverage(sink.context, kX0, far, coverage, 2);
    }
    for (size_t i = 0; i < kBytes; ++i) {
      CHECK_EQ(canvas.after[i], canvas.before[i]);
    }
  }
}

TEST(a_run_of_any_length_fills_the_row) {
  for (const Format& f : kFormats) {
    canvas.open(f, 9, 0);
    Sink sink;
    CHECK_OK(f.open(f, canvas.strip, sink));
    sink.solid(sink.context, kX0 - 1000, kY0, INT32_MAX);
    for (int32_t x = 0; x < 9; ++x) {
      const Pixel after = f.read(f, canvas.strip, x, 0);
      for (uint32_t i = 0; i < f.channels; ++i) {
        CHECK_EQ(after.channel[i], f.foreground.channel[i]);
      }
    }
    check_rest_untouched(f);
  }
}

// The sanitizers see a single byte read behind the last pixel.
TEST(strip_at_the_end_of_memory) {
  alignas(4) static uint8_t memory[96];
  uint8_t coverage[8] = {1, 255, 255, 255, 255, 255, 255, 255};
  for (const Format& f : kFormats) {
    Strip strip;
    strip.width = 8;
    strip.height = 3;
    strip.stride = stride_bytes(f.format, 8);
    const size_t size = strip_bytes(f.format, 8, 3);
    strip.pixels = {memory + sizeof(memory) - size, size};
    Sink sink;
    CHECK_OK(f.open(f, strip, sink));
    sink.coverage(sink.context, 0, 2, coverage, 8);
    sink.solid(sink.context, 1, 2, 7);
    CHECK_EQ(f.read(f, strip, 7, 2).channel[0], f.foreground.channel[0]);
  }
}

TEST(window_is_the_strip) {
  for (const Format& f : kFormats) {
    canvas.open(f, 9, 0);
    Sink sink;
    CHECK_OK(f.open(f, canvas.strip, sink));
    CHECK_EQ(sink.window.x0, kX0);
    CHECK_EQ(sink.window.y0, kY0);
    CHECK_EQ(sink.window.x1, kX0 + 9);
    CHECK_EQ(sink.window.y1, kY0 + kHeight);
  }
}

// Opens the canvas' strip after a change; of a wrong one the window has the
// rows that the bytes hold, or none, and nothing is drawn elsewhere.
Status open_changed(const Format& f, void (*change)(Strip&)) {
  canvas.open(f, 9, 0);
  Strip strip = canvas.strip;
  change(strip);
  Sink sink;
  const Status status = f.open(f, strip, sink);
  const Rect& window = sink.window;
  const bool is_cut = status == Status::buffer_small;
  CHECK_EQ(is_empty(window),
           strip.height == 0 || status == Status::bad_argument);
  if (is_cut) {
    const int32_t rows = window.y1 - window.y0;
    CHECK(rows >= 8 && rows <= 16 && rows < strip.height);
    CHECK_OK(check_strip(
        {strip.pixels, strip.x0, strip.y0, strip.width, rows, strip.stride},
        f.format));
    CHECK_EQ(check_strip({strip.pixels, strip.x0, strip.y0, strip.width,
                          rows + 1, strip.stride},
                         f.format),
             Status::buffer_small);
  }
  for (int32_t y = kY0; y != kY0 + 2 * kHeight; ++y) {
    sink.solid(sink.context, kX0, y, 9);
  }
  const uint8_t* const end =
      strip.pixels.data + (is_empty(window) ? 0 : strip.pixels.size);
  for (size_t i = 0; i < kBytes; ++i) {
    CHECK(canvas.after[i] == canvas.before[i] || canvas.after + i < end);
  }
  return status;
}

TEST(wrong_strips_are_refused) {
  for (const Format& f : kFormats) {
    CHECK_EQ(open_changed(f, [](Strip& s) { s.width = -1; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.height = -1; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.width = INT32_MAX; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.x0 = 32760; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.y0 = INT32_MIN; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.stride = 0; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.stride = 65536; }),
             Status::bad_argument);
    CHECK_EQ(open_changed(f, [](Strip& s) { s.height = 32000; }),
             Status::buffer_small);
    CHECK_EQ(open_changed(f, [](Strip& s) { --s.pixels.size; }),
             Status::buffer_small);
    CHECK_OK(open_changed(f, [](Strip& s) {
      s.height = 0;
      s.pixels.size = 0;
    }));
  }
}

TEST(bytes_of_absurd_sizes_do_not_overflow) {
  static_assert(stride_bytes(PixelFormat::xrgb8888, INT32_MAX) == 4 * 32767,
                "");
  static_assert(stride_bytes(PixelFormat::mono_rows, INT32_MIN) == 0, "");
  static_assert(strip_bytes(PixelFormat::mono_pages, 3, INT32_MAX) == 3 * 4096,
                "");
  Strip strip = {{nullptr, SIZE_MAX}, -32767, 0, 32768, 1, 65535};
  CHECK_EQ(check_strip(strip, PixelFormat::a8), Status::bad_argument);
  strip.width = 32767;
  CHECK_OK(check_strip(strip, PixelFormat::a8));
  strip.x0 = 0;
  CHECK_OK(check_strip(strip, PixelFormat::a8));
  strip.x0 = 1;
  CHECK_EQ(check_strip(strip, PixelFormat::a8), Status::bad_argument);
}

TEST(short_stride_is_refused) {
  for (const Format& f : kFormats) {
    canvas.open(f, 9, 0);
    Strip strip = canvas.strip;
    strip.stride = stride_bytes(f.format, 9);
    Sink sink;
    CHECK_OK(f.open(f, strip, sink));
    strip.stride -= f.format == PixelFormat::xrgb8888 ? 4 : 1;
    CHECK_EQ(f.open(f, strip, sink), Status::bad_argument);
  }
}

}  // namespace
