// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_mono_rows_dithered_sink(
    inkcell_mono_rows_target_t* target, inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_dither(ref(target), ref(out));
  }
  return code(status);
}

inkcell_status_t inkcell_mono_pages_dithered_sink(
    inkcell_mono_pages_target_t* target, inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_dither(ref(target), ref(out));
  }
  return code(status);
}

inkcell_status_t inkcell_grey2_dithered_sink(inkcell_grey2_target_t* target,
                                             inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_dither(ref(target), ref(out));
  }
  return code(status);
}

inkcell_status_t inkcell_grey4_dithered_sink(inkcell_grey4_target_t* target,
                                             inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  if (status == Status::ok) {
    port::detail::set_dither(ref(target), ref(out));
  }
  return code(status);
}
