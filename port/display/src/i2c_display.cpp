// Transfers: a control byte and its data.
#include "inkcell/port/i2c_display.hpp"

namespace inkcell::port {
namespace {

// Co = 0: all bytes up to the stop condition are of one kind.
enum Control : uint8_t { kCommands = 0x00, kPixels = 0x40 };

void send(void* context,
          Control control,
          const uint8_t* bytes,
          size_t count) noexcept {
  const auto& display = *static_cast<const I2cDisplay*>(context);
  uint8_t transfer[kI2cTransfer] = {control};
  while (count != 0) {
    const size_t part = count < kI2cTransfer - 1 ? count : kI2cTransfer - 1;
    __builtin_memcpy(transfer + 1, bytes, part);
    display.write(display.context, display.address, transfer, part + 1);
    bytes += part;
    count -= part;
  }
}

void command(void* context, const uint8_t* bytes, size_t count) noexcept {
  send(context, kCommands, bytes, count);
}

void data(void* context, const uint8_t* bytes, size_t count) noexcept {
  send(context, kPixels, bytes, count);
}

}  // namespace

DisplayBus make_bus(I2cDisplay& display) noexcept {
  DisplayBus bus;
  bus.context = &display;
  bus.command = command;
  bus.data = data;
  return bus;
}

}  // namespace inkcell::port
