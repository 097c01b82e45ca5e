// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_a8_sink(inkcell_a8_target_t* target,
                                 inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_grey8_sink(inkcell_grey8_target_t* target,
                                    inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_grey4_sink(inkcell_grey4_target_t* target,
                                    inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_grey2_sink(inkcell_grey2_target_t* target,
                                    inkcell_sink_t* out) {
  return code(make_sink(target, out));
}
