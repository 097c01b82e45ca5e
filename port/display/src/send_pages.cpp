#include "send_pages.hpp"

#include "inkcell/port/pixel.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace {

enum Command : uint8_t {
  kSetColumnLow = 0x00,   // | low nibble of the column
  kSetColumnHigh = 0x10,  // | high nibble of the column
  kSetPage = 0xb0,        // | page
};

}  // namespace

void send_pages(const DisplayBus& bus,
                int32_t first_column,
                const Strip& strip) noexcept {
  const int32_t column = first_column + strip.x0;
  Strip page = strip;
  page.height = 8;
  for (int32_t y = 0; y < strip.height; y += 8) {
    const uint8_t address[] = {
        static_cast<uint8_t>(kSetPage | ((strip.y0 + y) / 8)),
        static_cast<uint8_t>(kSetColumnLow | (column & 15)),
        static_cast<uint8_t>(kSetColumnHigh | (column >> 4)),
    };
    bus.command(bus.context, address, sizeof address);
    send_pixels(bus, page, PixelFormat::mono_pages);
    page.pixels.data += strip.stride;
  }
}

}  // namespace inkcell::port
