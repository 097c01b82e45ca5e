// clang-format off
// Made by port/c/make_api.py from port/display/c_api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_i2c_bus(inkcell_i2c_display_t* i2c, inkcell_display_bus_t* out) {
  ref(out) = port::make_bus(ref(i2c));
}

inkcell_status_t inkcell_display_wait(void* display) {
  const auto& bus = *static_cast<const port::DisplayBus*>(display);
  bus.wait_sent(bus.context);
  return INKCELL_OK;
}

inkcell_status_t inkcell_st7735_init(const inkcell_dcs_panel_t* display) {
  return code(init(*reinterpret_cast<const port::St7735*>(display)));
}

inkcell_status_t inkcell_st7789_init(const inkcell_dcs_panel_t* display) {
  return code(init(*reinterpret_cast<const port::St7789*>(display)));
}

inkcell_status_t inkcell_ili9341_init(const inkcell_dcs_panel_t* display) {
  return code(init(*reinterpret_cast<const port::Ili9341*>(display)));
}

inkcell_status_t inkcell_gc9a01_init(const inkcell_dcs_panel_t* display) {
  return code(init(*reinterpret_cast<const port::Gc9a01*>(display)));
}

inkcell_status_t inkcell_st7735_write(void* display,
                                      const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::St7735*>(display), ref(strip)));
}

inkcell_status_t inkcell_st7789_write(void* display,
                                      const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::St7789*>(display), ref(strip)));
}

inkcell_status_t inkcell_ili9341_write(void* display,
                                       const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::Ili9341*>(display), ref(strip)));
}

inkcell_status_t inkcell_gc9a01_write(void* display,
                                      const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::Gc9a01*>(display), ref(strip)));
}

inkcell_status_t inkcell_dcs_sleep(const inkcell_dcs_panel_t* display) {
  return code(sleep(ref(display)));
}

inkcell_status_t inkcell_dcs_wake(const inkcell_dcs_panel_t* display) {
  return code(wake(ref(display)));
}

void inkcell_dcs_set_brightness(const inkcell_dcs_panel_t* display,
                                uint8_t brightness) {
  set_brightness(ref(display), brightness);
}

inkcell_status_t inkcell_ssd1306_init(const inkcell_ssd1306_t* display) {
  return code(init(ref(display)));
}

inkcell_status_t inkcell_ssd1306_write(void* display,
                                       const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::Ssd1306*>(display), ref(strip)));
}

void inkcell_ssd1306_sleep(const inkcell_ssd1306_t* display) {
  sleep(ref(display));
}

void inkcell_ssd1306_wake(const inkcell_ssd1306_t* display) {
  wake(ref(display));
}

void inkcell_ssd1306_set_contrast(const inkcell_ssd1306_t* display,
                                  uint8_t contrast) {
  set_contrast(ref(display), contrast);
}

inkcell_status_t inkcell_ssd1680_init(const inkcell_ssd1680_t* display) {
  return code(init(ref(display)));
}

inkcell_status_t inkcell_ssd1680_write(void* display,
                                       const inkcell_strip_t* strip) {
  return code(write(*static_cast<const port::Ssd1680*>(display), ref(strip)));
}

inkcell_status_t inkcell_ssd1680_write_plane(const inkcell_ssd1680_t* display,
                                             const inkcell_strip_t* strip,
                                             uint8_t plane) {
  return code(write(ref(display), ref(strip),
      static_cast<port::EpaperPlane>(plane)));
}

inkcell_status_t inkcell_ssd1680_refresh(const inkcell_ssd1680_t* display,
                                         uint8_t kind) {
  return code(refresh(ref(display), static_cast<port::EpaperRefresh>(kind)));
}

inkcell_status_t inkcell_ssd1680_sleep(const inkcell_ssd1680_t* display) {
  return code(sleep(ref(display)));
}
