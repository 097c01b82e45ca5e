// Sinks that dither: of pixel.h.
#include "inkcell/port/dither.hpp"
#include "targets.hpp"

using namespace inkcell;
using c::cpp;

inkcell_status_t inkcell_mono_rows_dithered_sink(
    inkcell_mono_rows_target_t* target, inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_mono_sink(target, out);
  if (status == INKCELL_OK) {
    port::detail::set_dither(*cpp(target), *cpp(out));
  }
  return status;
}

inkcell_status_t inkcell_mono_pages_dithered_sink(
    inkcell_mono_pages_target_t* target, inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_mono_sink(target, out);
  if (status == INKCELL_OK) {
    port::detail::set_dither(*cpp(target), *cpp(out));
  }
  return status;
}

inkcell_status_t inkcell_grey2_dithered_sink(inkcell_grey2_target_t* target,
                                             inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_grey_sink(target, 3, out);
  if (status == INKCELL_OK) {
    port::detail::set_dither(*cpp(target), *cpp(out));
  }
  return status;
}

inkcell_status_t inkcell_grey4_dithered_sink(inkcell_grey4_target_t* target,
                                             inkcell_sink_t* out) {
  const inkcell_status_t status = c::make_grey_sink(target, 15, out);
  if (status == INKCELL_OK) {
    port::detail::set_dither(*cpp(target), *cpp(out));
  }
  return status;
}
