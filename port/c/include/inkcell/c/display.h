// Drivers of display controllers, as in inkcell/port/: functions of the board
// send what they make.
//
// Fill in all members of a display; those that are left out are 0.
// inkcell_<driver>_write() is for the member `flush` of inkcell_strip_loop_t,
// inkcell_display_wait() for `wait`, and the display for `display`. Errors,
// with which nothing is sent:
//
//   BAD_ARGUMENT  a size is out of range, a function that is needed is null, or
//                 a strip is not on the screen, has another byte order or a
//                 stride shorter than a row, or is not at whole bytes or pages
//   BUFFER_SMALL  a strip has fewer bytes than its rows need
//
// Made by port/c/make_api.py from port/display/c_api.txt: edit that instead.
#pragma once

#include "inkcell/c/pixel.h"
#include "inkcell/c/sink.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Functions of the board. `command` and `data` block until the bytes are sent,
/// or copy them: D/C is low for commands, high for data.
typedef struct INKCELL_SHARED inkcell_display_bus_t {
  void* context;  // the first argument of each function
  void (*command)(void* context, const uint8_t* bytes, size_t count);
  void (*data)(void* context, const uint8_t* bytes, size_t count);
  /// Null, or starts to send the pixels of a strip by DMA and returns. The next
  /// call of any function here waits for the end.
  void (*start)(void* context, const uint8_t* bytes, size_t count);
  /// Returns when that transfer has ended; needed with a second buffer.
  void (*wait_sent)(void* context);
  void (*reset)(void* context);  // null: there is no line, or the board resets
  void (*wait_ms)(void* context, uint32_t ms);  // colour panels need it
  void (*wait_idle)(void* context);             // e-paper needs it
} inkcell_display_bus_t;

/// I2C: one function of the board, which writes a transfer of at most 32 bytes.
typedef struct INKCELL_SHARED inkcell_i2c_display_t {
  void* context;
  void (*write)(void* context,
                uint8_t address,
                const uint8_t* bytes,
                size_t count);
  uint8_t address;  // 0x3c, or 0x3d by pin SA0
} inkcell_i2c_display_t;

/// A bus for SSD1306. `i2c` must outlive it.
void inkcell_i2c_bus(inkcell_i2c_display_t* i2c, inkcell_display_bus_t* out);

/// For the member `wait` of inkcell_strip_loop_t, whatever the display is.
inkcell_status_t inkcell_display_wait(void* display);

/// The rotation of the picture on the panel, clockwise.
enum {
  INKCELL_ROTATION_NONE = 0,
  INKCELL_ROTATION_QUARTER = 1,
  INKCELL_ROTATION_HALF = 2,
  INKCELL_ROTATION_THREE_QUARTERS = 3
};

/// A panel of RGB565 with ST7735, ST7789, ILI9341 or GC9A01, as in
/// dcs_panel.hpp. Its strips are INKCELL_RGB565, INKCELL_HIGH_FIRST.
typedef struct INKCELL_SHARED inkcell_dcs_panel_t {
  inkcell_display_bus_t bus;
  uint16_t width;         // without rotation [px]
  uint16_t height;        // likewise
  uint16_t first_column;  // of the controller's memory that the panel shows
  uint16_t first_row;     // likewise
  uint8_t rotation;
  bool mirror_columns;
  bool mirror_rows;
  bool blue_first;
  bool inverted;         // as most IPS panels with ST7789 and GC9A01
  const uint8_t* setup;  // null, or the maker's: command, count, parameters ...
  size_t setup_size;     // [bytes]
} inkcell_dcs_panel_t;

/// Resets the controller and switches the panel on. Takes a quarter of a
/// second.
inkcell_status_t inkcell_st7735_init(const inkcell_dcs_panel_t* display);
inkcell_status_t inkcell_st7789_init(const inkcell_dcs_panel_t* display);
inkcell_status_t inkcell_ili9341_init(const inkcell_dcs_panel_t* display);
inkcell_status_t inkcell_gc9a01_init(const inkcell_dcs_panel_t* display);

/// Sends a strip to its place on the screen. `display` is an
/// inkcell_dcs_panel_t.
inkcell_status_t inkcell_st7735_write(void* display,
                                      const inkcell_strip_t* strip);
inkcell_status_t inkcell_st7789_write(void* display,
                                      const inkcell_strip_t* strip);
inkcell_status_t inkcell_ili9341_write(void* display,
                                       const inkcell_strip_t* strip);
inkcell_status_t inkcell_gc9a01_write(void* display,
                                      const inkcell_strip_t* strip);

/// Switches any of these panels off and puts its controller to sleep, and back.
/// Memory and settings are kept. Each takes an eighth of a second.
inkcell_status_t inkcell_dcs_sleep(const inkcell_dcs_panel_t* display);
inkcell_status_t inkcell_dcs_wake(const inkcell_dcs_panel_t* display);

/// The backlight, 0 to 255; 0 after init. Only of panels whose backlight hangs
/// on the controller, which ST7735 cannot drive; on most modules it is a pin of
/// the board.
void inkcell_dcs_set_brightness(const inkcell_dcs_panel_t* display,
                                uint8_t brightness);

/// An OLED of up to 128 x 64 px. Its strips are INKCELL_MONO_PAGES.
typedef struct INKCELL_SHARED inkcell_ssd1306_t {
  inkcell_display_bus_t bus;
  uint8_t width;   // [px]
  uint8_t height;  // [px], a multiple of 8, 16 to 64
  uint8_t first_column;
  bool turned;           // by 180 degrees
  bool sequential_rows;  // as on panels of 128 x 32
  bool external_supply;  // of the panel, instead of the charge pump
} inkcell_ssd1306_t;

inkcell_status_t inkcell_ssd1306_init(const inkcell_ssd1306_t* display);
inkcell_status_t inkcell_ssd1306_write(void* display,
                                       const inkcell_strip_t* strip);

/// Switches the panel off, and on again. The memory is kept.
void inkcell_ssd1306_sleep(const inkcell_ssd1306_t* display);
void inkcell_ssd1306_wake(const inkcell_ssd1306_t* display);

/// How bright pixels are, 0 to 255; 127 after a reset.
void inkcell_ssd1306_set_contrast(const inkcell_ssd1306_t* display,
                                  uint8_t contrast);

enum { INKCELL_SSD1680 = 0, INKCELL_SSD1681 = 1 };
enum { INKCELL_PLANE_NEXT = 0, INKCELL_PLANE_SHOWN = 1 };
enum { INKCELL_REFRESH_FULL = 0, INKCELL_REFRESH_PARTIAL = 1 };

/// E-paper. Its strips are INKCELL_MONO_ROWS, 1 is white.
typedef struct INKCELL_SHARED inkcell_ssd1680_t {
  inkcell_display_bus_t bus;
  uint8_t controller;  // INKCELL_SSD1680 or INKCELL_SSD1681
  uint16_t width;      // [px], a multiple of 8: the panel's, rounded up
  uint16_t height;     // [px]
  bool from_output_8;
} inkcell_ssd1680_t;

inkcell_status_t inkcell_ssd1680_init(const inkcell_ssd1680_t* display);

/// Sends a strip to a plane: the next picture, or the one that the panel shows.
/// As `flush`, to the next one.
inkcell_status_t inkcell_ssd1680_write(void* display,
                                       const inkcell_strip_t* strip);
inkcell_status_t inkcell_ssd1680_write_plane(const inkcell_ssd1680_t* display,
                                             const inkcell_strip_t* strip,
                                             uint8_t plane);

/// Shows the next picture. Then send the same strips to INKCELL_PLANE_SHOWN.
inkcell_status_t inkcell_ssd1680_refresh(const inkcell_ssd1680_t* display,
                                         uint8_t kind);

/// Only a reset wakes it: inkcell_ssd1680_init().
inkcell_status_t inkcell_ssd1680_sleep(const inkcell_ssd1680_t* display);
#ifdef __cplusplus
}
#endif
