// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_rgb565_lcd_sink(inkcell_rgb565_target_t* target,
                                         inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_sub_pixels(ref(target), ref(out));
  }
  return code(status);
}

inkcell_status_t inkcell_rgb888_lcd_sink(inkcell_rgb888_target_t* target,
                                         inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_sub_pixels(ref(target), ref(out));
  }
  return code(status);
}

inkcell_status_t inkcell_xrgb8888_lcd_sink(inkcell_xrgb8888_target_t* target,
                                           inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_sub_pixels(ref(target), ref(out));
  }
  return code(status);
}
