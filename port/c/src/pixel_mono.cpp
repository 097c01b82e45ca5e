// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_mono_rows_sink(inkcell_mono_rows_target_t* target,
                                        inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_mono_pages_sink(inkcell_mono_pages_target_t* target,
                                         inkcell_sink_t* out) {
  return code(make_sink(target, out));
}
