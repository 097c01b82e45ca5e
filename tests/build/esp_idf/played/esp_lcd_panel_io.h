// What the example uses of ESP-IDF: a panel whose memory the test reads.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

typedef int esp_err_t;
typedef enum {
  GPIO_NUM_8 = 8,
  GPIO_NUM_9,
  GPIO_NUM_10,
  GPIO_NUM_11,
  GPIO_NUM_12
} gpio_num_t;
typedef enum { SPI1_HOST, SPI2_HOST } spi_host_device_t;
typedef enum { SPI_DMA_CH_AUTO = 3 } spi_dma_chan_t;
#define ESP_OK 0
#define ESP_ERROR_CHECK(call) \
  do {                        \
    if ((call) != ESP_OK) {   \
      abort();                \
    }                         \
  } while (0)

typedef struct {
  int mosi_io_num, miso_io_num, sclk_io_num, quadwp_io_num, quadhd_io_num;
  int max_transfer_sz;
} spi_bus_config_t;
typedef struct esp_lcd_panel_io_t* esp_lcd_panel_io_handle_t;
typedef struct esp_lcd_panel_t* esp_lcd_panel_handle_t;
typedef struct {
  int unused;
} esp_lcd_panel_io_event_data_t;
typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(
    esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void*);
typedef struct {
  gpio_num_t cs_gpio_num, dc_gpio_num;
  int spi_mode;
  unsigned pclk_hz;
  size_t trans_queue_depth;
  esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
  void* user_ctx;
  int lcd_cmd_bits, lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;

esp_err_t spi_bus_initialize(spi_host_device_t,
                             const spi_bus_config_t*,
                             spi_dma_chan_t);
esp_err_t esp_lcd_new_panel_io_spi(int,
                                   const esp_lcd_panel_io_spi_config_t*,
                                   esp_lcd_panel_io_handle_t*);
