// Drivers in the loop over strips: windows of a part, and transfers by DMA.
#include "inkcell/port/display_loop.hpp"

#include "check.hpp"
#include "dcs_model.hpp"
#include "display_page.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/ssd1306.hpp"
#include "inkcell/port/st7789.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

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

TEST(a_driver_starts_transfers) {
  DmaBus dma;
  Ssd1306 display;
  display.bus = {&dma, DmaBus::command, DmaBus::data, DmaBus::start};
  display.bus.wait_sent = [](void* context) {
    static_cast<DmaBus*>(context)->finish();
  };
  CHECK_OK(init(display));
  static uint8_t strips[2][2 * 128];
  StripLoop loop = loop_over(display, strips[0], strips[1]);
  CHECK_EQ(loop.width, 128);
  CHECK_EQ(loop.height, 64);
  loop.context = &dma;
  loop.draw = [](void* context, const Strip& strip) {
    auto& bus = *static_cast<DmaBus*>(context);
    bus.overlapped += bus.sending != nullptr ? 1 : 0;
    display_page::draw_page(MonoPagesCanvas(strip), 0);
    return Status::ok;
  };
  CHECK_OK(run_strips(loop));
  CHECK_EQ(dma.starts, 4);
  CHECK_EQ(dma.overlapped, 3);
  const Strip picture = display_page::reference(
      MonoPagesCanvas(), PixelFormat::mono_pages, 128, 64, 0);
  for (size_t i = 0; i < picture.pixels.size && !check::failed(); ++i) {
    CHECK_EQ(dma.memory[i / 128][i % 128], picture.pixels[i]);
  }
}

TEST(a_loop_without_wait_sent_has_one_buffer) {
  DmaBus dma;
  Ssd1306 display;
  display.bus = {&dma, DmaBus::command, DmaBus::data, DmaBus::start};
  static uint8_t strips[2][2 * 128];
  StripLoop loop = loop_over(display, strips[0], strips[1]);
  loop.draw = [](void*, const Strip&) { return Status::ok; };
  CHECK_EQ(run_strips(loop), Status::bad_argument);
  CHECK_EQ(dma.starts, 0);
}

TEST(a_part_of_a_turned_colour_panel_is_sent_alone) {
  dcs_model::DcsModel model(240, 320);
  auto display = dcs_model::make_display<St7789>(model, 135, 240, 52, 40);
  display.rotation = Rotation::quarter;
  CHECK_OK(init(display));
  static uint8_t strip[2 * 240 * 8];
  StripLoop loop = loop_over(display, strip);
  CHECK_EQ(loop.width, 240);
  CHECK_EQ(loop.height, 135);
  loop.draw = [](void*, const Strip& piece) {
    Rgb565Canvas canvas = dcs_model::make_canvas();
    canvas.set_strip(piece);
    display_page::draw_page(canvas, 0x10);
    return Status::ok;
  };
  const Rect part = {30, 20, 130, 90};
  CHECK_OK(run_strips(loop, part));
  CHECK_EQ(model.pixels, 100 * 70);
  const Strip picture = display_page::reference(
      dcs_model::make_canvas(), PixelFormat::rgb565, 240, 135, 0x10);
  dcs_model::check_shown(model, display, picture, part);
}

}  // namespace
