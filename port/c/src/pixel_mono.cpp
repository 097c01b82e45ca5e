// Sinks for 1 bit: of pixel.h.
#include "targets.hpp"

using namespace inkcell;

INKCELL_SAME_PLACE(inkcell_mono_rows_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_mono_rows_target_t, threshold, threshold);
INKCELL_SAME_PLACE(inkcell_mono_rows_target_t, level, level);
INKCELL_SAME_PLACE(inkcell_mono_rows_target_t, order, order);
INKCELL_SAME_PLACE(inkcell_mono_pages_target_t, strip, strip);
INKCELL_SAME_PLACE(inkcell_mono_pages_target_t, threshold, threshold);
INKCELL_SAME_PLACE(inkcell_mono_pages_target_t, level, level);

inkcell_status_t inkcell_mono_rows_sink(inkcell_mono_rows_target_t* target,
                                        inkcell_sink_t* out) {
  return c::make_mono_sink(target, out);
}

inkcell_status_t inkcell_mono_pages_sink(inkcell_mono_pages_target_t* target,
                                         inkcell_sink_t* out) {
  return c::make_mono_sink(target, out);
}
