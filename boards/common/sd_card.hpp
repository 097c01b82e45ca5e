// An SD card on SPI, from which blocks are read.
//
// Cards of versions 1 and 2, of any capacity. Every wait has an end, and the
// checksum of each block is compared: a card that was pulled out, or whose
// wires fail, is a Status.
#pragma once

#include <stdint.h>

#include "inkcell/status.hpp"

namespace inkcell::board {

/// The wires to a card: SPI mode 0 or 3, high bit first.
struct CardBus {
  /// Sends a byte, and returns the one that was received meanwhile.
  uint8_t (*exchange)(uint8_t sent) = nullptr;
  /// Drives the card's select line low, or high again.
  void (*select)(bool is_selected) = nullptr;
};

/// Holds a copy of the bus and how the card counts addresses.
class SdCard {
 public:
  static constexpr uint32_t kBlockBytes = 512;

  /// Starts the card; the clock is at most 400 kHz until this returns. Until
  /// it is ok, and after another card was inserted, nothing can be read.
  ///
  /// read_failed: no card answers. unsupported: one that is no SD memory card,
  /// or does not work at 3.3 V.
  Status open(const CardBus& bus) noexcept;

  /// Reads a block. read_failed: there is none, or it did not arrive whole.
  Status read_block(uint32_t block, uint8_t* bytes) noexcept;

 private:
  uint8_t exchange(uint8_t sent = 0xff) const noexcept {
    return bus_.exchange(sent);
  }
  uint8_t send_command(uint8_t command, uint32_t argument) const noexcept;
  uint32_t read_word() const noexcept;
  void release() const noexcept;
  Status identify() noexcept;
  Status start(bool is_version_2) const noexcept;
  Status receive(uint8_t* bytes) const noexcept;

  CardBus bus_;
  bool is_open_ = false;
  bool counts_blocks_ = false;  // addresses are blocks, and not bytes
};

}  // namespace inkcell::board
