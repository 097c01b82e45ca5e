// A sink for 1-bit pixels in pages, as SSD1306 and SSD0303 take them.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// A byte is a column of 8 pixels, bit 0 on top; a page is a row of such bytes.
///
///                 x = 0   1   2
///     y = 0..7   byte 0   1   2 ...      Strip::stride is from one page
///     y = 8..15  stride + 0   1 ...      to the next
///
/// Strip::y0 is the top of the first page; a height that is not a multiple of 8
/// leaves the low pixels of the last page alone. A pixel is drawn when its
/// coverage reaches the threshold.
struct MonoPagesTarget {
  Strip strip;
  uint8_t threshold = 128;  // 1..255: else bad_argument
  uint8_t level = 1;        // 1 sets the bits of drawn pixels, 0 clears them
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(MonoPagesTarget& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
