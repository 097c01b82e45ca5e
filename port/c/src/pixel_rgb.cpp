// Sinks for colour: of pixel.h.
#include "targets.hpp"

using namespace inkcell;

INKCELL_SAME_PLACE(inkcell_rgb565_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_rgb565_target_t, colour, colour);
INKCELL_SAME_PLACE(inkcell_rgb565_target_t, order, order);
INKCELL_SAME_PLACE(inkcell_rgb888_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_rgb888_target_t, colour, colour);
INKCELL_SAME_PLACE(inkcell_rgb888_target_t, order, order);
INKCELL_SAME_PLACE(inkcell_xrgb8888_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_xrgb8888_target_t, colour, colour);
INKCELL_SAME_VALUE(INKCELL_LOW_FIRST, port::ByteOrder::low_first);
INKCELL_SAME_VALUE(INKCELL_HIGH_FIRST, port::ByteOrder::high_first);
INKCELL_SAME_VALUE(INKCELL_RED_FIRST, port::ChannelOrder::red_first);
INKCELL_SAME_VALUE(INKCELL_BLUE_FIRST, port::ChannelOrder::blue_first);
INKCELL_SAME_VALUE(INKCELL_A8, port::PixelFormat::a8);
INKCELL_SAME_VALUE(INKCELL_GREY8, port::PixelFormat::grey8);
INKCELL_SAME_VALUE(INKCELL_GREY4, port::PixelFormat::grey4);
INKCELL_SAME_VALUE(INKCELL_GREY2, port::PixelFormat::grey2);
INKCELL_SAME_VALUE(INKCELL_MONO_ROWS, port::PixelFormat::mono_rows);
INKCELL_SAME_VALUE(INKCELL_MONO_PAGES, port::PixelFormat::mono_pages);
INKCELL_SAME_VALUE(INKCELL_RGB565, port::PixelFormat::rgb565);
INKCELL_SAME_VALUE(INKCELL_RGB888, port::PixelFormat::rgb888);
INKCELL_SAME_VALUE(INKCELL_XRGB8888, port::PixelFormat::xrgb8888);

inkcell_status_t inkcell_rgb565_sink(inkcell_rgb565_target_t* target,
                                     inkcell_sink_t* out) {
  return c::make_sink(target, out);
}

inkcell_status_t inkcell_rgb888_sink(inkcell_rgb888_target_t* target,
                                     inkcell_sink_t* out) {
  return c::make_sink(target, out);
}

inkcell_status_t inkcell_xrgb8888_sink(inkcell_xrgb8888_target_t* target,
                                       inkcell_sink_t* out) {
  return c::make_sink(target, out);
}
