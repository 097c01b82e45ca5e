// Sinks that dither: of pixel.h.
#include "inkcell/port/dither.hpp"
#include "targets.hpp"

using namespace inkcell;
using c::cpp;

inkcell_status_t inkcell_mono_rows_dithered_sink(
    inkcell_mono_rows_target_t* target, inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_dithered_sink(*cpp(target), *cpp(out)));
}

inkcell_status_t inkcell_mono_pages_dithered_sink(
    inkcell_mono_pages_target_t* target, inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_dithered_sink(*cpp(target), *cpp(out)));
}

inkcell_status_t inkcell_grey2_dithered_sink(inkcell_grey2_target_t* target,
                                             inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_dithered_sink(*cpp(target), *cpp(out)));
}

inkcell_status_t inkcell_grey4_dithered_sink(inkcell_grey4_target_t* target,
                                             inkcell_sink_t* out) {
  *cpp(out) = Sink();
  return c::code(port::make_dithered_sink(*cpp(target), *cpp(out)));
}
