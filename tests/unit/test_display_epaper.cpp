// SSD1680 and SSD1681 against the model of their commands.
#include "check.hpp"
#include "display_page.hpp"
#include "epaper_model.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/ssd1680.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using epaper_model::EpaperModel;
using epaper_model::kRows;
using epaper_model::kStride;

constexpr PixelFormat kFormat = PixelFormat::mono_rows;

MonoRowsCanvas make_canvas() {
  return MonoRowsCanvas({}, 0);
}

void send_page(const Ssd1680& display,
               EpaperPlane plane,
               const Rect& part,
               int32_t rows,
               int32_t gap) {
  display_page::show_page(make_canvas(), kFormat, part, rows, gap, 0xff,
                          [&display, plane](const Strip& strip) {
                            return write(display, strip, plane);
                          });
}

// `plane` must hold the picture within `part`, and `around` outside.
void check_plane(const uint8_t (&plane)[kRows][kStride],
                 const Strip& picture,
                 const Rect& part,
                 uint8_t around) {
  for (const auto [x, y] : pixels_of(kStride, kRows)) {
    const auto at = static_cast<size_t>(y * picture.stride + x);
    CHECK_EQ(plane[y][x], holds(part, 8 * x, y) ? picture.pixels[at] : around);
  }
}

struct Place {
  EpaperController controller;
  int32_t columns, rows;  // of the memory
  uint16_t width, height;
  int32_t strip_rows, gap;
};

TEST(a_full_refresh_shows_text) {
  constexpr Place kPlaces[] = {
      {EpaperController::ssd1680, 176, 296, 128, 296, 20, 0},
      {EpaperController::ssd1680, 176, 296, 176, 264, 264, 3},
      {EpaperController::ssd1681, 200, 200, 200, 200, 33, 0}};
  for (const Place& p : kPlaces) {
    EpaperModel model(p.columns, p.rows);
    Ssd1680 display = {model.bus(), p.controller, p.width, p.height};
    display.from_output_8 = p.width == 128;
    const Rect all = {0, 0, p.width, p.height};
    const Strip picture = display_page::reference(make_canvas(), kFormat,
                                                  p.width, p.height, 0xff);
    CHECK_OK(init(display));
    CHECK_EQ(model.gates, p.height);
    send_page(display, EpaperPlane::next, all, p.strip_rows, p.gap);
    check_plane(model.planes[0], picture, all, 0x5a);
    check_plane(model.planes[1], picture, {}, 0x5a);
    check_plane(model.glass, picture, {}, 0x5a);
    CHECK_OK(refresh(display, EpaperRefresh::full));
    CHECK_EQ(model.outputs, p.width == 128 ? 0x80 : 0x00);
    check_plane(model.glass, picture, all, 0x5a);
    CHECK_EQ(model.refreshes, 1);
    CHECK(!model.busy);
  }
}

// A white panel, then the words in a part of it.
TEST(a_partial_refresh_changes_its_rectangle_alone) {
  EpaperModel model(200, 200);
  const Ssd1680 display = {model.bus(), EpaperController::ssd1681, 200, 200};
  CHECK_OK(init(display));
  EpaperModel::fill(model.planes[0], 0xff);
  EpaperModel::fill(model.planes[1], 0xff);
  EpaperModel::fill(model.glass, 0xff);
  const Rect part = {16, 21, 120, 57};
  send_page(display, EpaperPlane::next, part, 10, 0);
  CHECK_OK(refresh(display, EpaperRefresh::partial));
  const Strip picture =
      display_page::reference(make_canvas(), kFormat, 200, 200, 0xff);
  check_plane(model.glass, picture, part, 0xff);
  // Now the panel shows the part; the next refresh starts from there.
  send_page(display, EpaperPlane::shown, part, 10, 0);
  check_plane(model.planes[1], picture, part, 0xff);
  for (uint8_t& byte : picture.pixels) {
    byte = 0xff;
  }
  CHECK_OK(write(display,
                 {picture.pixels, part.x0, part.y0, part.x1 - part.x0,
                  part.y1 - part.y0, picture.stride},
                 EpaperPlane::next));
  CHECK_OK(refresh(display, EpaperRefresh::partial));
  check_plane(model.glass, picture, {}, 0xff);
  CHECK_EQ(model.refreshes, 2);
}

TEST(a_reset_wakes_the_controller) {
  EpaperModel model(176, 296);
  Ssd1680 display = {model.bus()};
  CHECK_OK(init(display));
  CHECK_OK(sleep(display));
  CHECK(model.asleep);
  CHECK_OK(init(display));
  CHECK(!model.asleep);
  CHECK_EQ(model.resets, 2);
  // What nothing could wake is not put to sleep.
  display.bus.reset = nullptr;
  CHECK_EQ(sleep(display), Status::bad_argument);
  CHECK(!model.asleep);
}

TEST(displays_outside_the_memory_are_refused) {
  EpaperModel model(176, 296);
  const DisplayBus bus = model.bus();
  DisplayBus no_busy_line = bus;
  no_busy_line.wait_idle = nullptr;
  constexpr auto k1680 = EpaperController::ssd1680;
  constexpr auto k1681 = EpaperController::ssd1681;
  const Ssd1680 wrong[] = {{bus, k1680, 184, 296}, {bus, k1680, 176, 297},
                           {bus, k1680, 122, 250}, {bus, k1680, 0, 296},
                           {bus, k1680, 128, 0},   {bus, k1681, 208, 200},
                           {bus, k1681, 200, 201}, {bus, k1681, 200, 200, true},
                           {no_busy_line, k1680}};
  uint8_t pixels[8] = {};
  for (const Ssd1680& display : wrong) {
    CHECK_EQ(init(display), Status::bad_argument);
    CHECK_EQ(write(display, {pixels, 0, 0, 8, 8, 1}, EpaperPlane::next),
             Status::bad_argument);
    CHECK_EQ(refresh(display, EpaperRefresh::full), Status::bad_argument);
    CHECK_EQ(sleep(display), Status::bad_argument);
  }
  CHECK_EQ(model.transfers + model.resets, 0);
}

TEST(strips_outside_the_screen_are_refused) {
  EpaperModel model(176, 296);
  const Ssd1680 display = {model.bus()};
  uint8_t pixels[32] = {};
  const Strip wrong[] = {{pixels, 4, 0, 8, 8, 1},   {pixels, 0, 0, 12, 8, 2},
                         {pixels, 128, 0, 8, 8, 1}, {pixels, 0, 289, 8, 8, 1},
                         {pixels, -8, 0, 8, 8, 1},  {pixels, 0, 0, 16, 8, 1},
                         {pixels, 0, 0, 0, 8, 1}};
  for (const Strip& strip : wrong) {
    CHECK_EQ(write(display, strip, EpaperPlane::shown), Status::bad_argument);
  }
  CHECK_EQ(write(display, {{pixels, 7}, 0, 0, 8, 8, 1}, EpaperPlane::next),
           Status::buffer_small);
  CHECK_EQ(model.transfers, 0);
}

}  // namespace
