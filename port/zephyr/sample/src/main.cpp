// A label and a temperature on the display that the devicetree chooses, of
// RGB565 with the high byte first, as panels behind SPI take it. Only the box
// of a value is drawn and sent.
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>
#include <zephyr/kernel.h>
#include <zephyr/sys/printk.h>
#include <fonts/dejavu_sans_latin1.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/strip_loop.hpp>

using namespace inkcell;
using namespace inkcell::port;

constexpr uint16_t kInk = rgb565(255, 255, 255);
constexpr uint16_t kPaper = rgb565(0, 50, 90);
constexpr Style kLabel = Style(24_px);
constexpr Style kValue = Style(80_px);
constexpr Point kValueAt = {16, 150};
alignas(4) static uint8_t pixels[2 * 240 * 16];
static const struct device* const display =
    DEVICE_DT_GET(DT_CHOSEN(zephyr_display));

struct Screen {
  Font font;
  const char* value = "";
};

static const char* read_temperature() {
  return "21.5";  // yours
}

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const Rgb565Canvas canvas(strip, kInk, kPaper);
  const Painter painter(canvas);
  painter.text(screen.font, kLabel, {16, 48}, "Living room");
  painter.text(screen.font, kValue, kValueAt, screen.value);
  return canvas.status();
}

static Status flush(void*, const Strip& strip) {
  struct display_buffer_descriptor rows = {};
  rows.buf_size = static_cast<uint32_t>(strip.stride * strip.height);
  rows.width = static_cast<uint16_t>(strip.width);
  rows.height = static_cast<uint16_t>(strip.height);
  rows.pitch = static_cast<uint16_t>(strip.stride / 2);
  const int result =
      display_write(display, static_cast<uint16_t>(strip.x0),
                    static_cast<uint16_t>(strip.y0), &rows, strip.pixels.data);
  return result == 0 ? Status::ok : Status::bad_argument;
}

static Status run() {
  struct display_capabilities panel;
  display_get_capabilities(display, &panel);
  if (panel.current_pixel_format != PIXEL_FORMAT_RGB_565 &&
      panel.current_pixel_format != PIXEL_FORMAT_BGR_565) {
    return Status::unsupported;  // MONO01 of OLEDs: MonoPagesCanvas
  }
  Screen screen;
  INKCELL_TRY(Font::open(fonts::dejavu_sans_latin1, screen.font));
  StripLoop loop;
  loop.buffer = pixels;
  loop.order = ByteOrder::high_first;
  loop.width = panel.x_resolution;
  loop.height = panel.y_resolution;
  loop.context = &screen;
  loop.draw = draw;
  loop.flush = flush;
  display_blanking_off(display);
  Rect changed = {0, 0, loop.width, loop.height};
  for (;;) {
    screen.value = read_temperature();
    const Rect box = Painter().box(screen.font, kValue, kValueAt, screen.value);
    INKCELL_TRY(run_strips(loop, bounding_box(changed, box)));
    changed = box;
    k_msleep(1000);
  }
}

int main() {
  if (!device_is_ready(display)) {
    return -1;
  }
  const Status status = run();  // returns if something is wrong
  printk("inkcell: status %d\n", static_cast<int>(status));
  return static_cast<int>(status);
}
