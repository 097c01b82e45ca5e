// Strips, sinks, and the loop over a screen.
#include "inkcell/c/sink.h"

#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

static_assert(INKCELL_MAX_SPAN == kMaxSpan, "values differ");
static_assert(offsetof(inkcell_strip_t, pixels) == offsetof(Strip, pixels) &&
                  offsetof(inkcell_strip_t, size) ==
                      offsetof(Strip, pixels) + offsetof(Span<uint8_t>, size),
              "members differ");
INKCELL_SAME_PLACE(inkcell_strip_t, x0, x0);
INKCELL_SAME_PLACE(inkcell_strip_t, y0, y0);
INKCELL_SAME_PLACE(inkcell_strip_t, width, width);
INKCELL_SAME_PLACE(inkcell_strip_t, height, height);
INKCELL_SAME_PLACE(inkcell_strip_t, stride, stride);
INKCELL_SAME_PLACE(inkcell_sink_t, window, window);
INKCELL_SAME_PLACE(inkcell_sink_t, context, context);
INKCELL_SAME_PLACE(inkcell_sink_t, coverage, coverage);
INKCELL_SAME_PLACE(inkcell_sink_t, solid, solid);
INKCELL_SAME_PLACE(inkcell_sink_t, block, block);
INKCELL_SAME_PLACE(inkcell_sink_t, coverage_rgb, coverage_rgb);
INKCELL_SAME_PLACE(inkcell_sink_t, ramp, ramp);

namespace {

// A strip by its pointer, as C takes it.
const inkcell_strip_t* c_strip(const Strip& strip) noexcept {
  return reinterpret_cast<const inkcell_strip_t*>(&strip);
}

void draw_strip(void* context, const Strip& strip) noexcept {
  const auto& loop = *static_cast<const inkcell_strip_loop_t*>(context);
  loop.draw(loop.context, c_strip(strip));
}

void flush_strip(void* context, const Strip& strip) noexcept {
  const auto& loop = *static_cast<const inkcell_strip_loop_t*>(context);
  loop.flush(loop.context, c_strip(strip));
}

}  // namespace

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
  same.draw = copy.draw == nullptr ? nullptr : draw_strip;
  same.flush = copy.flush == nullptr ? nullptr : flush_strip;
  return c::code(run_strips(same));
}
