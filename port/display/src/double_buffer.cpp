// run_strips() with two strips in turn.
#include "inkcell/port/double_buffer.hpp"

namespace inkcell {
namespace port {
namespace {

// The state of a running loop.
struct Run {
  const DoubleBuffer& loop;
  bool second = false;   // the strip is in the second buffer
  bool sending = false;  // a transfer may be running
};

Strip in_buffer(const Run& run, const Strip& strip) noexcept {
  Strip result = strip;
  if (run.second) {
    result.pixels = run.loop.second;
  }
  return result;
}

void draw(void* context, const Strip& strip) noexcept {
  const Run& run = *static_cast<const Run*>(context);
  run.loop.strips.draw(run.loop.strips.context, in_buffer(run, strip));
}

void flush(void* context, const Strip& strip) noexcept {
  Run& run = *static_cast<Run*>(context);
  void* const caller = run.loop.strips.context;
  if (run.sending) {
    run.loop.wait(caller);
  }
  run.loop.strips.flush(caller, in_buffer(run, strip));
  run.sending = true;
  run.second = !run.second;
}

bool overlap(Span<uint8_t> a, Span<uint8_t> b) noexcept {
  const auto a_first = reinterpret_cast<uintptr_t>(a.data);
  const auto b_first = reinterpret_cast<uintptr_t>(b.data);
  return a_first < b_first + b.size && b_first < a_first + a.size;
}

}  // namespace

Status run_double_buffer(const DoubleBuffer& loop) noexcept {
  if (loop.strips.draw == nullptr || loop.strips.flush == nullptr ||
      loop.wait == nullptr || overlap(loop.strips.buffer, loop.second)) {
    return Status::bad_argument;
  }
  Run run{loop};
  StripLoop strips = loop.strips;
  strips.context = &run;
  strips.draw = draw;
  strips.flush = flush;
  // The smaller buffer must hold a strip.
  if (loop.second.size < strips.buffer.size) {
    strips.buffer.size = loop.second.size;
  }
  INKCELL_TRY(run_strips(strips));
  loop.wait(loop.strips.context);
  return Status::ok;
}

}  // namespace port
}  // namespace inkcell
