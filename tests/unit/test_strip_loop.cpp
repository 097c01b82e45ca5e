// The loop over strips, with one buffer and with two.
#include "inkcell/port/strip_loop.hpp"

#include "check.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 16;
constexpr int32_t kHeight = 50;
constexpr uint8_t kUnsent = 0xee;

uint8_t buffers[2][20 * kWidth];

// A screen of 8-bit pixels. A transfer's bytes are read at its end, where it
// may be under way; a second buffer may not be drawn into meanwhile.
struct Screen {
  uint8_t pixels[kHeight][kWidth];
  Strip sending;
  bool is_sending = false;
  bool is_double = false;
  char calls[256] = {};
  size_t call_count = 0;
  int32_t next_y = 0;
  int32_t fails_at = -1;  // the call that fails
  const uint8_t* drawn = nullptr;

  Screen() {
    for (auto& row : pixels) {
      for (uint8_t& pixel : row) {
        pixel = kUnsent;
      }
    }
  }

  Status note(char call) {
    CHECK(call_count + 1 < sizeof calls);
    calls[call_count % sizeof calls] = call;
    const auto number = static_cast<int32_t>(call_count++);
    return number == fails_at ? Status::no_glyph : Status::ok;
  }

  static uint8_t pixel_at(int32_t x, int32_t y) {
    return static_cast<uint8_t>(3 * y + x);
  }

  static Status draw(void* context, const Strip& strip) {
    auto& screen = *static_cast<Screen*>(context);
    CHECK(!screen.is_sending ||
          strip.pixels.data != screen.sending.pixels.data);
    CHECK_EQ(strip.y0, screen.next_y);
    CHECK_EQ(strip.stride, strip.width);
    CHECK_EQ(strip.pixels.size, strip.width * strip.height);
    screen.drawn = strip.pixels.data;
    for (const auto [x, y] : pixels_of(strip.width, strip.height)) {
      strip.pixels[static_cast<size_t>(y * strip.stride + x)] =
          pixel_at(strip.x0 + x, strip.y0 + y);
    }
    return screen.note('d');
  }

  static Status flush(void* display, const Strip& strip) {
    auto& screen = *static_cast<Screen*>(display);
    CHECK(!screen.is_sending);
    CHECK(strip.pixels.data == screen.drawn);
    CHECK_EQ(strip.y0, screen.next_y);
    screen.next_y += strip.height;
    screen.sending = strip;
    screen.is_sending = true;
    if (!screen.is_double) {
      screen.finish();
    }
    return screen.note('f');
  }

  static Status wait(void* display) {
    auto& screen = *static_cast<Screen*>(display);
    CHECK(screen.is_sending);
    screen.finish();
    return screen.note('w');
  }

  void finish() {
    const Strip& strip = sending;
    for (const auto [x, y] : pixels_of(strip.width, strip.height)) {
      pixels[strip.y0 + y][strip.x0 + x] =
          strip.pixels[static_cast<size_t>(y * strip.stride + x)];
    }
    is_sending = false;
  }

  StripLoop loop(int32_t height, int32_t rows) {
    StripLoop loop;
    loop.buffer = {buffers[0], static_cast<size_t>(rows * kWidth)};
    loop.format = PixelFormat::grey8;
    loop.width = kWidth;
    loop.height = height;
    loop.context = this;
    loop.draw = draw;
    loop.display = this;
    loop.flush = flush;
    return loop;
  }

  StripLoop double_loop(int32_t height, int32_t rows) {
    is_double = true;
    StripLoop loop = this->loop(height, rows);
    loop.second = {buffers[1], loop.buffer.size};
    loop.wait = wait;
    return loop;
  }

  bool made(const char* expected) const {
    size_t i = 0;
    while (expected[i] != '\0' && expected[i] == calls[i]) {
      ++i;
    }
    return expected[i] == calls[i];
  }

  void check_shown(const Rect& part) const {
    for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
      CHECK_EQ(pixels[y][x], holds(part, x, y) ? pixel_at(x, y) : kUnsent);
    }
  }
};

TEST(strips_cover_the_screen_once) {
  for (int32_t rows = 1; rows <= 20; ++rows) {
    for (int32_t height = 1; height <= kHeight; height += 7) {
      const Rect all = {0, 0, kWidth, height};
      Screen screen;
      CHECK_OK(run_strips(screen.loop(height, rows)));
      CHECK_EQ(screen.call_count, 2 * ((height + rows - 1) / rows));
      screen.check_shown(all);
      Screen twice;
      CHECK_OK(run_strips(twice.double_loop(height, rows)));
      CHECK_EQ(twice.call_count, 3 * ((height + rows - 1) / rows));
      CHECK(!twice.is_sending);
      twice.check_shown(all);
    }
  }
}

TEST(one_strip_is_drawn_while_the_other_is_sent) {
  Screen screen;
  CHECK_OK(run_strips(screen.double_loop(50, 15)));
  CHECK(screen.made("dfdwfdwfdwfw"));
  Screen single;
  CHECK_OK(run_strips(single.double_loop(9, 20)));
  CHECK(single.made("dfw"));
}

TEST(a_transfer_from_one_buffer_ends_before_the_next_strip) {
  Screen screen;
  StripLoop loop = screen.double_loop(50, 15);
  loop.second = {};
  CHECK_OK(run_strips(loop));
  CHECK(screen.made("dfwdfwdfwdfw"));
  screen.check_shown({0, 0, kWidth, 50});
}

TEST(a_part_alone_is_drawn_and_sent) {
  for (int32_t is_double = 0; is_double < 2; ++is_double) {
    Screen screen;
    screen.next_y = 7;
    const Rect part = {3, 7, 12, 31};
    CHECK_OK(run_strips(
        is_double == 0 ? screen.loop(50, 5) : screen.double_loop(50, 5), part));
    screen.check_shown(part);
    // 24 rows of 9 bytes, 8 of them in 80.
    CHECK_EQ(screen.call_count, (is_double == 0 ? 2 : 3) * 3);
  }
}

TEST(a_part_is_cut_to_the_screen) {
  Screen screen;
  screen.next_y = 40;
  CHECK_OK(run_strips(screen.loop(50, 5), {10, 40, 100, INT32_MAX}));
  screen.check_shown({10, 40, kWidth, 50});
  Screen above;
  CHECK_OK(run_strips(above.loop(50, 5), {INT32_MIN, -9, 3, 2}));
  above.check_shown({0, 0, 3, 2});
  Screen none;
  CHECK_OK(run_strips(none.loop(50, 5), {}));
  CHECK_OK(run_strips(none.loop(50, 5), {kWidth, 0, 100, 50}));
  CHECK_OK(run_strips(none.loop(50, 5), {5, 9, 5, 8}));
  CHECK_EQ(none.call_count, 0);
}

// The only strip of a part in a format.
struct Window {
  Strip strip;
  int32_t count = 0;

  static Status draw(void* context, const Strip& strip) {
    auto& window = *static_cast<Window*>(context);
    window.strip = strip;
    ++window.count;
    return Status::ok;
  }
  static Status flush(void*, const Strip&) { return Status::ok; }

  StripLoop loop(PixelFormat format, int32_t width, int32_t height) {
    StripLoop loop;
    loop.buffer = buffers[0];
    loop.format = format;
    loop.width = width;
    loop.height = height;
    loop.context = this;
    loop.draw = draw;
    loop.flush = flush;
    return loop;
  }
};

void check_window(PixelFormat format, const Rect& part, const Rect& expected) {
  Window window;
  StripLoop loop = window.loop(format, 61, 43);
  loop.order = ByteOrder::high_first;
  CHECK_OK(run_strips(loop, part));
  CHECK_EQ(window.count, 1);
  const Strip& strip = window.strip;
  CHECK(is_same(strip.rect(), expected));
  CHECK_EQ(strip.stride, stride_bytes(format, strip.width));
  CHECK_EQ(strip.pixels.size, strip_bytes(format, strip.width, strip.height));
  CHECK(strip.order == ByteOrder::high_first);
}

TEST(a_part_is_widened_to_whole_bytes_and_pages) {
  constexpr Rect kPart = {11, 13, 15, 18};
  check_window(PixelFormat::grey8, kPart, kPart);
  check_window(PixelFormat::rgb565, kPart, kPart);
  check_window(PixelFormat::xrgb8888, kPart, kPart);
  check_window(PixelFormat::grey4, kPart, {10, 13, 16, 18});
  check_window(PixelFormat::grey2, kPart, {8, 13, 16, 18});
  check_window(PixelFormat::mono_rows, kPart, {8, 13, 16, 18});
  check_window(PixelFormat::mono_pages, kPart, {11, 8, 15, 24});
  // The screen ends within a byte, or a page.
  constexpr Rect kEnd = {59, 41, 61, 43};
  check_window(PixelFormat::grey4, kEnd, {58, 41, 61, 43});
  check_window(PixelFormat::mono_rows, kEnd, {56, 41, 61, 43});
  check_window(PixelFormat::mono_pages, kEnd, {59, 40, 61, 43});
}

TEST(nothing_is_sent_after_a_failure) {
  constexpr const char* kSingle[] = {"d", "df", "dfd", "dfdf"};
  for (int32_t at = 0; at < 4; ++at) {
    Screen screen;
    screen.fails_at = at;
    CHECK_EQ(run_strips(screen.loop(50, 15)), Status::no_glyph);
    CHECK(screen.made(kSingle[at]));
  }
  // A transfer that is under way is waited for.
  constexpr const char* kDouble[] = {"d", "df", "dfdw", "dfdw", "dfdwf"};
  for (int32_t at = 0; at < 5; ++at) {
    Screen screen;
    screen.fails_at = at;
    CHECK_EQ(run_strips(screen.double_loop(50, 15)), Status::no_glyph);
    CHECK(screen.made(kDouble[at]));
  }
  Screen last;
  last.fails_at = 2;
  CHECK_EQ(run_strips(last.double_loop(9, 15)), Status::no_glyph);
  CHECK(last.made("dfw"));
}

// Nothing is called unless all is well.
void check_refused(const Screen& screen, const StripLoop& loop, Status status) {
  CHECK_EQ(run_strips(loop), status);
  CHECK_EQ(screen.call_count, 0);
}

TEST(functions_and_sizes_are_checked) {
  Screen screen;
  const StripLoop good = screen.double_loop(50, 20);
  constexpr int32_t kWrong[] = {0, -1, 32768, INT32_MIN};
  for (const int32_t wrong : kWrong) {
    StripLoop loop = good;
    loop.width = wrong;
    check_refused(screen, loop, Status::bad_argument);
    loop = good;
    loop.height = wrong;
    check_refused(screen, loop, Status::bad_argument);
  }
  StripLoop loop = good;
  loop.draw = nullptr;
  check_refused(screen, loop, Status::bad_argument);
  loop = good;
  loop.flush = nullptr;
  check_refused(screen, loop, Status::bad_argument);
  loop = good;
  loop.wait = nullptr;
  check_refused(screen, loop, Status::bad_argument);
  loop = good;
  loop.second = loop.buffer;
  check_refused(screen, loop, Status::bad_argument);
  loop = good;
  loop.second.data = loop.buffer.end() - 1;
  check_refused(screen, loop, Status::bad_argument);
  CHECK_OK(run_strips(good));
}

TEST(a_buffer_holds_a_row_or_a_page) {
  Screen screen;
  StripLoop loop = screen.double_loop(50, 20);
  loop.buffer.size = kWidth - 1;
  check_refused(screen, loop, Status::buffer_small);
  loop = screen.double_loop(50, 20);
  loop.second.size = kWidth - 1;
  check_refused(screen, loop, Status::buffer_small);
  // The smaller one counts.
  loop.second.size = 2 * kWidth;
  loop.height = 4;
  CHECK_OK(run_strips(loop));
  CHECK(screen.made("dfdwfw"));
  // A page of 8 rows takes one stride, also where the screen ends in it.
  Window window;
  StripLoop pages = window.loop(PixelFormat::mono_pages, 24, 10);
  pages.buffer.size = 23;
  CHECK_EQ(run_strips(pages), Status::buffer_small);
  pages.buffer.size = 24;
  CHECK_OK(run_strips(pages));
  CHECK_EQ(window.count, 2);
  CHECK_EQ(window.strip.height, 2);
  pages.buffer.size = 48;
  CHECK_OK(run_strips(pages));
  CHECK_EQ(window.count, 3);
}

TEST(screens_have_up_to_32767_rows_and_columns) {
  Window window;
  StripLoop loop = window.loop(PixelFormat::mono_rows, 32, 32767);
  CHECK_OK(run_strips(loop));
  CHECK_EQ(window.count, 410);
  CHECK_EQ(window.strip.y0 + window.strip.height, 32767);
  static uint8_t row[4096];
  loop.buffer = row;
  loop.width = 32767;
  loop.height = 2;
  CHECK_OK(run_strips(loop));
  CHECK_EQ(window.count, 412);
  CHECK_EQ(window.strip.width, 32767);
}

}  // namespace
