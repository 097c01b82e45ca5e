// Strips for controllers that need the page and first column of each transfer.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// Sends a strip of PixelFormat::mono_pages page by page. Column 0 of the strip
/// is `first_column` of the controller's memory; the last column is at most
/// 255.
void send_pages(const DisplayBus& bus,
                int32_t first_column,
                const Strip& strip) noexcept;

}  // namespace inkcell::port
