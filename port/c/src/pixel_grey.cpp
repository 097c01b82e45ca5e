// Sinks for coverage and grey: of pixel.h.
#include "targets.hpp"

using namespace inkcell;

INKCELL_SAME_PLACE(inkcell_a8_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_grey8_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_grey8_target_t, level, level);
INKCELL_SAME_PLACE(inkcell_grey4_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_grey4_target_t, level, level);
INKCELL_SAME_PLACE(inkcell_grey4_target_t, order, order);
INKCELL_SAME_PLACE(inkcell_grey2_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_grey2_target_t, level, level);
INKCELL_SAME_PLACE(inkcell_grey2_target_t, order, order);
INKCELL_SAME_VALUE(INKCELL_HIGH_LEFT, port::BitOrder::high_left);
INKCELL_SAME_VALUE(INKCELL_LOW_LEFT, port::BitOrder::low_left);

inkcell_status_t inkcell_a8_sink(inkcell_a8_target_t* target,
                                 inkcell_sink_t* out) {
  return c::make_sink(target, out);
}

inkcell_status_t inkcell_grey8_sink(inkcell_grey8_target_t* target,
                                    inkcell_sink_t* out) {
  return c::make_sink(target, out);
}

inkcell_status_t inkcell_grey4_sink(inkcell_grey4_target_t* target,
                                    inkcell_sink_t* out) {
  return c::make_grey_sink(target, 15, out);
}

inkcell_status_t inkcell_grey2_sink(inkcell_grey2_target_t* target,
                                    inkcell_sink_t* out) {
  return c::make_grey_sink(target, 3, out);
}
