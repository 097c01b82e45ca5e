// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_run_strips(const inkcell_strip_loop_t* loop,
                                    const inkcell_rect_t* part) {
  inkcell_strip_loop_t copy = *loop;
  port::StripLoop same;
  same.buffer = {copy.buffer, copy.size};
  same.second = {copy.second, copy.second == nullptr ? 0 : copy.size};
  same.format = static_cast<port::PixelFormat>(copy.format);
  same.order = static_cast<ByteOrder>(copy.order);
  same.width = copy.width;
  same.height = copy.height;
  same.context = &copy;
  same.display = &copy;
  same.draw = copy.draw == nullptr ? nullptr : draw_by;
  same.flush = copy.flush == nullptr ? nullptr : flush_by;
  same.wait = copy.wait == nullptr ? nullptr : wait_by;
  return code(part == nullptr ? run_strips(same) : run_strips(same, ref(part)));
}
