// Two strips: the order of calls, and that no strip is drawn while it is sent.
#include "inkcell/port/double_buffer.hpp"

#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/ssd1306.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 16;
constexpr int32_t kHeight = 50;

// A display of 8-bit pixels that a transfer fills: its bytes are read when the
// transfer ends, not when it starts.
struct Transfer {
  uint8_t screen[kHeight][kWidth];
  Strip sending;
  bool is_sending = false;
  char calls[256] = {};
  size_t call_count = 0;
  int32_t next_y = 0;
  const uint8_t* drawn = nullptr;

  void note(char call) {
    CHECK(call_count + 1 < sizeof calls);
    calls[call_count++ % sizeof calls] = call;
  }

  static void draw(void* context, const Strip& strip) {
    auto& transfer = *static_cast<Transfer*>(context);
    transfer.note('d');
    CHECK(!transfer.is_sending ||
          strip.pixels.data != transfer.sending.pixels.data);
    CHECK_EQ(strip.y0, transfer.next_y);
    transfer.drawn = strip.pixels.data;
    for (int32_t y = 0; y < strip.height; ++y) {
      for (int32_t x = 0; x < kWidth; ++x) {
        strip.pixels[static_cast<size_t>(y * strip.stride + x)] =
            static_cast<uint8_t>(3 * (strip.y0 + y) + x);
      }
    }
  }

  static void flush(void* context, const Strip& strip) {
    auto& transfer = *static_cast<Transfer*>(context);
    transfer.note('f');
    CHECK(!transfer.is_sending);
    CHECK(strip.pixels.data == transfer.drawn);
    CHECK_EQ(strip.y0, transfer.next_y);
    transfer.next_y += strip.height;
    transfer.sending = strip;
    transfer.is_sending = true;
  }

  static void wait(void* context) {
    auto& transfer = *static_cast<Transfer*>(context);
    transfer.note('w');
    CHECK(transfer.is_sending);
    const Strip& strip = transfer.sending;
    for (int32_t y = 0; y < strip.height; ++y) {
      for (int32_t x = 0; x < kWidth; ++x) {
        transfer.screen[strip.y0 + y][x] =
            strip.pixels[static_cast<size_t>(y * strip.stride + x)];
      }
    }
    transfer.is_sending = false;
  }

  bool made(const char* expected) const {
    size_t i = 0;
    while (expected[i] != '\0' && expected[i] == calls[i]) {
      ++i;
    }
    return expected[i] == calls[i];
  }
};

uint8_t buffers[2][20 * kWidth];

DoubleBuffer make_loop(Transfer& transfer, int32_t height, int32_t rows) {
  DoubleBuffer loop;
  loop.strips.buffer = buffers[0];
  loop.strips.width = kWidth;
  loop.strips.height = height;
  loop.strips.rows = rows;
  loop.strips.stride = kWidth;
  loop.strips.context = &transfer;
  loop.strips.draw = Transfer::draw;
  loop.strips.flush = Transfer::flush;
  loop.second = buffers[1];
  loop.wait = Transfer::wait;
  return loop;
}

TEST(one_strip_is_drawn_while_the_other_is_sent) {
  Transfer transfer;
  CHECK_OK(run_double_buffer(make_loop(transfer, 50, 15)));
  CHECK(transfer.made("dfdwfdwfdwfw"));
  Transfer single;
  CHECK_OK(run_double_buffer(make_loop(single, 9, 20)));
  CHECK(single.made("dfw"));
}

TEST(every_pixel_arrives) {
  for (int32_t rows = 1; rows <= 20; ++rows) {
    for (int32_t height = 1; height <= kHeight; height += 7) {
      Transfer transfer;
      CHECK_OK(run_double_buffer(make_loop(transfer, height, rows)));
      CHECK_EQ(transfer.next_y, height);
      CHECK(!transfer.is_sending);
      for (int32_t y = 0; y < height && !check::failed(); ++y) {
        for (int32_t x = 0; x < kWidth; ++x) {
          CHECK_EQ(transfer.screen[y][x], 3 * y + x);
        }
      }
    }
  }
}

void check_refused(const DoubleBuffer& loop, Status status) {
  const auto& transfer = *static_cast<const Transfer*>(loop.strips.context);
  CHECK_EQ(run_double_buffer(loop), status);
  CHECK_EQ(transfer.call_count, 0);
}

TEST(functions_and_buffers_are_checked) {
  Transfer transfer;
  const DoubleBuffer good = make_loop(transfer, 50, 20);
  DoubleBuffer loop = good;
  loop.strips.draw = nullptr;
  check_refused(loop, Status::bad_argument);
  loop = good;
  loop.strips.flush = nullptr;
  check_refused(loop, Status::bad_argument);
  loop = good;
  loop.wait = nullptr;
  check_refused(loop, Status::bad_argument);
  loop = good;
  loop.strips.rows = 0;
  check_refused(loop, Status::bad_argument);
  loop = good;
  loop.second = loop.strips.buffer;
  check_refused(loop, Status::bad_argument);
  loop = good;
  loop.second.data = loop.strips.buffer.end() - 1;
  check_refused(loop, Status::bad_argument);
  loop = good;
  --loop.second.size;
  check_refused(loop, Status::buffer_small);
  loop = good;
  --loop.strips.buffer.size;
  check_refused(loop, Status::buffer_small);
  CHECK_OK(run_double_buffer(good));
}

// A display bus with DMA: `start` takes a transfer under way, and each function
// first waits for it. Its bytes are read at its end.
struct DmaBus {
  uint8_t memory[64 / 8][128] = {};
  uint8_t window[6] = {};  // of the last command: columns and pages
  const uint8_t* sending = nullptr;
  size_t sending_count = 0;
  int starts = 0, overlapped = 0;

  void finish() {
    const int32_t columns = window[2] - window[1] + 1;
    for (size_t i = 0; i < sending_count; ++i) {
      const auto at = static_cast<int32_t>(i);
      memory[window[4] + at / columns][window[1] + at % columns] = sending[i];
    }
    sending = nullptr;
    sending_count = 0;
  }

  static void command(void* context, const uint8_t* bytes, size_t count) {
    auto& bus = *static_cast<DmaBus*>(context);
    bus.finish();
    for (size_t i = 0; i < count && bytes[0] == 0x21; ++i) {
      bus.window[i] = bytes[i];
    }
  }
  static void data(void*, const uint8_t*, size_t) {
    const bool is_sent_by_start = false;
    CHECK(is_sent_by_start);
  }
  static void start(void* context, const uint8_t* bytes, size_t count) {
    auto& bus = *static_cast<DmaBus*>(context);
    CHECK(bus.sending == nullptr);
    bus.sending = bytes;
    bus.sending_count = count;
    ++bus.starts;
  }
};

// What the loop below gets.
struct DmaScreen {
  DmaBus dma;
  Ssd1306 display;
};

TEST(a_driver_starts_transfers) {
  DmaScreen screen;
  screen.display.bus = {&screen.dma, DmaBus::command, DmaBus::data,
                        DmaBus::start};
  CHECK_OK(init(screen.display));
  static uint8_t strips[2][2 * 128];
  DoubleBuffer loop;
  loop.strips.buffer = strips[0];
  loop.strips.width = 128;
  loop.strips.height = 64;
  loop.strips.rows = 16;
  loop.strips.stride = 128;
  loop.strips.rows_per_stride = 8;
  loop.strips.context = &screen;
  loop.strips.draw = [](void* context, const Strip& strip) {
    DmaBus& dma = static_cast<DmaScreen*>(context)->dma;
    dma.overlapped += dma.sending != nullptr ? 1 : 0;
    display_page::draw_page(MonoPagesCanvas(strip), 0);
  };
  loop.strips.flush = [](void* context, const Strip& strip) {
    CHECK_OK(write(static_cast<DmaScreen*>(context)->display, strip));
  };
  loop.second = strips[1];
  loop.wait = [](void* context) {
    static_cast<DmaScreen*>(context)->dma.finish();
  };
  CHECK_OK(run_double_buffer(loop));
  CHECK_EQ(screen.dma.starts, 4);
  CHECK_EQ(screen.dma.overlapped, 3);
  const Strip picture = display_page::reference(
      MonoPagesCanvas(), PixelFormat::mono_pages, 128, 64, 0);
  for (size_t i = 0; i < picture.pixels.size && !check::failed(); ++i) {
    CHECK_EQ(screen.dma.memory[i / 128][i % 128], picture.pixels[i]);
  }
}

}  // namespace
