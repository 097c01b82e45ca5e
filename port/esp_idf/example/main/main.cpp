// A label and a temperature on an ST7789 of 240 x 240 px, by esp_lcd: while one
// strip is sent by DMA, the next is drawn, and only the box of a value is sent.
#include <driver/spi_master.h>
#include <esp_attr.h>
#include <esp_lcd_panel_io.h>
#include <esp_lcd_panel_ops.h>
#include <esp_lcd_panel_vendor.h>
#include <freertos/FreeRTOS.h>
#include <freertos/semphr.h>
#include <freertos/task.h>
#include <stdio.h>

#include <fonts/dejavu_sans_latin1.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/strip_loop.hpp>

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kSide = 240;
constexpr uint16_t kInk = rgb565(255, 255, 255);
constexpr uint16_t kPaper = rgb565(0, 50, 90);
constexpr Style kLabel = Style(24_px);
constexpr Style kValue = Style(80_px);
constexpr Point kValueAt = {16, 150};
DMA_ATTR static uint8_t strips[2][2 * kSide * 16];

struct Screen {
  esp_lcd_panel_handle_t panel = nullptr;
  SemaphoreHandle_t sent = nullptr;
  bool is_sending = false;
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

static Status flush(void* display, const Strip& strip) {
  Screen& screen = *static_cast<Screen*>(display);
  screen.is_sending = true;
  const esp_err_t result = esp_lcd_panel_draw_bitmap(
      screen.panel, strip.x0, strip.y0, strip.x0 + strip.width,
      strip.y0 + strip.height, strip.pixels.data);
  return result == ESP_OK ? Status::ok : Status::bad_argument;
}

static Status wait(void* display) {
  Screen& screen = *static_cast<Screen*>(display);
  if (screen.is_sending) {
    xSemaphoreTake(screen.sent, portMAX_DELAY);
    screen.is_sending = false;
  }
  return Status::ok;
}

static bool end_of_transfer(esp_lcd_panel_io_handle_t,
                            esp_lcd_panel_io_event_data_t*,
                            void* context) {
  BaseType_t woken = pdFALSE;
  xSemaphoreGiveFromISR(static_cast<Screen*>(context)->sent, &woken);
  return woken == pdTRUE;
}

static void init(Screen& screen) {
  screen.sent = xSemaphoreCreateBinary();
  spi_bus_config_t bus = {};
  bus.sclk_io_num = GPIO_NUM_12;  // your pins
  bus.mosi_io_num = GPIO_NUM_11;
  bus.miso_io_num = bus.quadwp_io_num = bus.quadhd_io_num = -1;
  bus.max_transfer_sz = sizeof strips[0];
  ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
  esp_lcd_panel_io_spi_config_t wires = {};
  wires.cs_gpio_num = GPIO_NUM_10;
  wires.dc_gpio_num = GPIO_NUM_9;
  wires.pclk_hz = 40 * 1000 * 1000;
  wires.trans_queue_depth = 4;
  wires.on_color_trans_done = end_of_transfer;
  wires.user_ctx = &screen;
  wires.lcd_cmd_bits = wires.lcd_param_bits = 8;
  esp_lcd_panel_io_handle_t io = nullptr;
  ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi(SPI2_HOST, &wires, &io));
  esp_lcd_panel_dev_config_t device = {};
  device.reset_gpio_num = GPIO_NUM_8;
  device.bits_per_pixel = 16;
  ESP_ERROR_CHECK(esp_lcd_new_panel_st7789(io, &device, &screen.panel));
  ESP_ERROR_CHECK(esp_lcd_panel_reset(screen.panel));
  ESP_ERROR_CHECK(esp_lcd_panel_init(screen.panel));
  ESP_ERROR_CHECK(esp_lcd_panel_invert_color(screen.panel, true));
  ESP_ERROR_CHECK(esp_lcd_panel_disp_on_off(screen.panel, true));
}

extern "C" void app_main() {
  static Screen screen;
  init(screen);
  Status status = Font::open(fonts::dejavu_sans_latin1, screen.font);
  StripLoop loop;
  loop.buffer = strips[0];
  loop.second = strips[1];
  loop.order = ByteOrder::high_first;
  loop.width = loop.height = kSide;
  loop.context = loop.display = &screen;
  loop.draw = draw;
  loop.flush = flush;
  loop.wait = wait;
  Rect changed = {0, 0, kSide, kSide};
  while (status == Status::ok) {
    screen.value = read_temperature();
    const Rect box = Painter().box(screen.font, kValue, kValueAt, screen.value);
    status = run_strips(loop, bounding_box(changed, box));
    changed = box;
    vTaskDelay(pdMS_TO_TICKS(1000));
  }
  printf("inkcell: status %d\n", static_cast<int>(status));
}
