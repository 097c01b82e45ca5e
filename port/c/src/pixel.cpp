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

inkcell_status_t inkcell_mono_rows_sink(inkcell_mono_rows_target_t* target,
                                        inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

inkcell_status_t inkcell_mono_pages_sink(inkcell_mono_pages_target_t* target,
                                         inkcell_sink_t* out) {
  return code(make_sink(target, out));
}

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

inkcell_status_t inkcell_rgb565_lcd_sink(inkcell_rgb565_target_t* target,
                                         inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_sub_pixels(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_rgb888_lcd_sink(inkcell_rgb888_target_t* target,
                                         inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_sub_pixels(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_xrgb8888_lcd_sink(inkcell_xrgb8888_target_t* target,
                                           inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_sub_pixels(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_mono_rows_dithered_sink(
    inkcell_mono_rows_target_t* target, inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_dither(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_mono_pages_dithered_sink(
    inkcell_mono_pages_target_t* target, inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_dither(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_grey2_dithered_sink(inkcell_grey2_target_t* target,
                                             inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_dither(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_grey4_dithered_sink(inkcell_grey4_target_t* target,
                                             inkcell_sink_t* out) {
  const Status status = make_sink(target, out);
  port::detail::set_dither(ref(target), ref(out));
  return code(status);
}

inkcell_status_t inkcell_run_strips(const inkcell_strip_loop_t* loop,
                                    const inkcell_rect_t* part) {
  using Loop = inkcell_strip_loop_t;
  Loop copy = *loop;
  port::StripLoop same;
  same.buffer = {copy.buffer, copy.size};
  same.second = {copy.second, copy.second == nullptr ? 0 : copy.size};
  same.format = static_cast<port::PixelFormat>(copy.format);
  same.order = static_cast<ByteOrder>(copy.order);
  same.width = copy.width;
  same.height = copy.height;
  same.context = &copy;
  same.display = &copy;
  same.draw = copy.draw == nullptr ? nullptr : strip_by<&Loop::draw,
      &Loop::context>;
  same.flush = copy.flush == nullptr ? nullptr : strip_by<&Loop::flush,
      &Loop::display>;
  same.wait = copy.wait == nullptr ? nullptr : wait_by;
  return code(part == nullptr ? run_strips(same) : run_strips(same, ref(part)));
}
