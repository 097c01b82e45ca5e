// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_run_strips(const inkcell_strip_loop_t* loop) {
  inkcell_strip_loop_t copy = *loop;
  StripLoop same;
  same.buffer = {copy.buffer, copy.size};
  same.width = copy.width;
  same.height = copy.height;
  same.rows = copy.rows;
  same.stride = copy.stride;
  same.rows_per_stride = copy.rows_per_stride;
  same.context = &copy;
  same.draw = copy.draw == nullptr ? nullptr :
      call<&inkcell_strip_loop_t::draw>;
  same.flush = copy.flush == nullptr ? nullptr :
      call<&inkcell_strip_loop_t::flush>;
  return code(run_strips(same));
}
