// A sink for three bytes a pixel.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The channel at the lowest address.
enum class ChannelOrder : uint8_t { red_first, blue_first };

struct Rgb888Target {
  Strip strip;
  uint32_t colour = 0xffffff;  // of the foreground: 0xRRGGBB
  ChannelOrder order = ChannelOrder::red_first;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Rgb888Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
