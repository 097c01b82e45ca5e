// A sink for 1-bit pixels in pages, the format of SSD1306 and SSD0303.
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
/// Strip::y0 is the top of the first page. If the height is not a multiple of
/// 8, the lowest pixels of the last page are unchanged. A pixel is drawn if its
/// coverage is at least the threshold.
struct MonoPagesTarget {
  Strip strip;
  uint8_t threshold = 128;  // 1..255; else bad_argument
  uint8_t level = 1;        // 1 sets the bits of drawn pixels, 0 clears them
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(MonoPagesTarget& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
