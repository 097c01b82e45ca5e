// Sinks for sub-pixels: of pixel.h.
#include "inkcell/port/lcd.hpp"
#include "targets.hpp"

using namespace inkcell;
using c::cpp;

inkcell_status_t inkcell_rgb565_lcd_sink(inkcell_rgb565_target_t* target,
                                         inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_lcd_sink(*cpp(target), *cpp(out)));
}

inkcell_status_t inkcell_rgb888_lcd_sink(inkcell_rgb888_target_t* target,
                                         inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_lcd_sink(*cpp(target), *cpp(out)));
}

inkcell_status_t inkcell_xrgb8888_lcd_sink(inkcell_xrgb8888_target_t* target,
                                           inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_lcd_sink(*cpp(target), *cpp(out)));
}
