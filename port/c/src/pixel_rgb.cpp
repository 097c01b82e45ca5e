// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_rgb565_sink(inkcell_rgb565_target_t* target,
                                     inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_rgb888_sink(inkcell_rgb888_target_t* target,
                                     inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_xrgb8888_sink(inkcell_xrgb8888_target_t* target,
                                       inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

void inkcell_fill(const inkcell_sink_t* sink) {
  port::detail::fill(ref(sink));
}
