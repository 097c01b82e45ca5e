// Two strips: one is drawn while the other is sent by DMA.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The loop of run_strips() with a second buffer. `strips.flush` starts the
/// transfer of a strip and returns; a driver's write() does so with
/// DisplayBus::start.
///
///     draw 0 | draw 1 | wait | draw 2 | wait | ... | wait
///            flush 0         flush 1         flush 2
///            |-- sent -->    |-- sent -->
struct DoubleBuffer {
  /// Its buffer is for the strips 0, 2, 4 ...
  StripLoop strips;
  /// For the strips 1, 3, 5 ...; as large as the first, without overlap.
  Span<uint8_t> second;
  /// Returns when the last transfer has ended, at once if there is none. Called
  /// with `strips.context` before each flush but the first, and at the end.
  void (*wait)(void* context) = nullptr;
};

/// Calls draw, wait and flush for the strips of a screen, from top to bottom. A
/// buffer is never drawn into before its transfer has ended. The picture is
/// that of run_strips().
///
/// bad_argument: as run_strips(); or `wait` is missing, or the buffers overlap.
/// buffer_small: a buffer does not hold `rows` rows. Nothing is called then.
Status run_double_buffer(const DoubleBuffer& loop) noexcept;

}  // namespace port
}  // namespace inkcell
