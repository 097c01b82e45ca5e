// Sinks for sub-pixels: of pixel.h.
#include "inkcell/port/lcd.hpp"
#include "targets.hpp"

using namespace inkcell;
using c::cpp;

inkcell_status_t inkcell_rgb565_lcd_sink(inkcell_rgb565_target_t* target,
                                         inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_sink(target, out);
  if (status == INKCELL_OK) {
    port::detail::set_sub_pixels(*cpp(target), *cpp(out));
  }
  return status;
}

inkcell_status_t inkcell_rgb888_lcd_sink(inkcell_rgb888_target_t* target,
                                         inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_sink(target, out);
  if (status == INKCELL_OK) {
    port::detail::set_sub_pixels(*cpp(target), *cpp(out));
  }
  return status;
}

inkcell_status_t inkcell_xrgb8888_lcd_sink(inkcell_xrgb8888_target_t* target,
                                           inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_sink(target, out);
  if (status == INKCELL_OK) {
    port::detail::set_sub_pixels(*cpp(target), *cpp(out));
  }
  return status;
}
