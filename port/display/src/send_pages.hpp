// Strips for controllers that are told each page and its first column.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// Sends a strip of PixelFormat::mono_pages page by page. Its column 0 is
/// `first_column` of the controller's memory, at most 255 with its width.
void send_pages(const DisplayBus& bus,
                int32_t first_column,
                const Strip& strip) noexcept;

}  // namespace port
}  // namespace inkcell
