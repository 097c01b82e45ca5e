#include "sd_card.hpp"

namespace inkcell::board {
namespace {

// Commands of the SD specification, part 1, chapter 7.
constexpr uint8_t kGoIdle = 0;
constexpr uint8_t kSendCondition = 8;
constexpr uint8_t kSetBlockLength = 16;
constexpr uint8_t kReadBlock = 17;
constexpr uint8_t kStart = 41;  // an application command
constexpr uint8_t kApplication = 55;
constexpr uint8_t kReadRegister = 58;

// Bits of a response. The highest one is set until a response comes.
constexpr uint8_t kIdle = 1;
constexpr uint8_t kIllegalCommand = 4;
constexpr uint8_t kNoResponse = 0x80;

constexpr uint8_t kDataToken = 0xfe;

// 2.7 to 3.6 V, and a pattern that the card sends back.
constexpr uint32_t kCondition = 0x1aa;
constexpr uint32_t kHighCapacity = 1u << 30;

// Ends of waiting: bytes before a response, tries to start, 1 s at 400 kHz, and
// bytes before a block, 100 ms at 25 MHz.
constexpr uint32_t kResponseBytes = 8;
constexpr uint32_t kResetTries = 16;
constexpr uint32_t kStartTries = 3000;
constexpr uint32_t kTokenBytes = 312500;

// With polynomial x^7 + x^3 + 1, and the bit that ends a command.
uint8_t crc7(const uint8_t* bytes, uint32_t count) noexcept {
  uint32_t crc = 0;
  for (uint32_t i = 0; i != count; ++i) {
    crc ^= bytes[i];
    for (uint32_t bit = 0; bit != 8; ++bit) {
      crc = (crc & 0x80) != 0 ? (crc << 1) ^ 0x12 : crc << 1;
    }
  }
  return static_cast<uint8_t>(crc | 1);
}

// With polynomial x^16 + x^12 + x^5 + 1.
uint16_t add_to_crc16(uint32_t crc, uint8_t byte) noexcept {
  crc = (crc >> 8 | crc << 8) ^ byte;
  crc ^= (crc & 0xff) >> 4;
  crc ^= crc << 12;
  crc ^= (crc & 0xff) << 5;
  return static_cast<uint16_t>(crc);
}

}  // namespace

// Selects the card until release(). The response; kNoResponse is set if none
// came.
uint8_t SdCard::send_command(uint8_t command,
                             uint32_t argument) const noexcept {
  uint8_t frame[6] = {static_cast<uint8_t>(0x40 | command),
                      static_cast<uint8_t>(argument >> 24),
                      static_cast<uint8_t>(argument >> 16),
                      static_cast<uint8_t>(argument >> 8),
                      static_cast<uint8_t>(argument)};
  frame[5] = crc7(frame, 5);
  bus_.select(true);
  static_cast<void>(exchange());
  for (const uint8_t byte : frame) {
    static_cast<void>(exchange(byte));
  }
  uint8_t response = exchange();
  for (uint32_t i = 1; i != kResponseBytes && (response & kNoResponse) != 0;
       ++i) {
    response = exchange();
  }
  return response;
}

uint32_t SdCard::read_word() const noexcept {
  uint32_t word = 0;
  for (uint32_t i = 0; i != 4; ++i) {
    word = word << 8 | exchange();
  }
  return word;
}

// The card lets go of its line with the clock that follows.
void SdCard::release() const noexcept {
  bus_.select(false);
  static_cast<void>(exchange());
}

Status SdCard::open(const CardBus& bus) noexcept {
  bus_ = bus;
  is_open_ = false;
  // 74 clocks, unselected: the card takes commands then.
  bus_.select(false);
  for (uint32_t i = 0; i != 10; ++i) {
    static_cast<void>(exchange());
  }
  const Status status = identify();
  release();
  is_open_ = status == Status::ok;
  return status;
}

Status SdCard::identify() noexcept {
  uint8_t response = send_command(kGoIdle, 0);
  for (uint32_t i = 1; i != kResetTries && response != kIdle; ++i) {
    release();
    response = send_command(kGoIdle, 0);
  }
  if (response != kIdle) {
    return Status::read_failed;
  }
  response = send_command(kSendCondition, kCondition);
  if ((response & kNoResponse) != 0) {
    return Status::read_failed;
  }
  const bool is_version_2 = (response & kIllegalCommand) == 0;
  if (is_version_2 && (read_word() & 0xfff) != kCondition) {
    return Status::unsupported;
  }
  INKCELL_TRY(start(is_version_2));
  // QEMU's card says that it is idle in this one.
  if ((send_command(kReadRegister, 0) & ~kIdle) != 0) {
    return Status::read_failed;
  }
  counts_blocks_ = (read_word() & kHighCapacity) != 0;
  return counts_blocks_ || send_command(kSetBlockLength, kBlockBytes) == 0
             ? Status::ok
             : Status::unsupported;
}

Status SdCard::start(bool is_version_2) const noexcept {
  for (uint32_t i = 0; i != kStartTries; ++i) {
    const uint8_t heard = send_command(kApplication, 0);
    const uint8_t response =
        send_command(kStart, is_version_2 ? kHighCapacity : 0);
    if (((heard | response) & kNoResponse) != 0) {
      return Status::read_failed;
    }
    if ((response & kIllegalCommand) != 0) {
      return Status::unsupported;
    }
    if (response == 0) {
      return Status::ok;
    }
  }
  return Status::read_failed;
}

Status SdCard::read_block(uint32_t block, uint8_t* bytes) noexcept {
  // Cards that count bytes have 2 GB at most.
  if (!is_open_ || (!counts_blocks_ && block >= 1u << 22)) {
    return Status::read_failed;
  }
  const uint32_t address = counts_blocks_ ? block : block * kBlockBytes;
  const Status status = send_command(kReadBlock, address) == 0
                            ? receive(bytes)
                            : Status::read_failed;
  release();
  return status;
}

Status SdCard::receive(uint8_t* bytes) const noexcept {
  uint8_t token = exchange();
  for (uint32_t i = 1; i != kTokenBytes && token == 0xff; ++i) {
    token = exchange();
  }
  if (token != kDataToken) {
    return Status::read_failed;
  }
  uint16_t crc = 0;
  for (uint32_t i = 0; i != kBlockBytes; ++i) {
    bytes[i] = exchange();
    crc = add_to_crc16(crc, bytes[i]);
  }
  // The checksum of a block and its checksum is 0.
  crc = add_to_crc16(crc, exchange());
  crc = add_to_crc16(crc, exchange());
  return crc == 0 ? Status::ok : Status::read_failed;
}

}  // namespace inkcell::board
