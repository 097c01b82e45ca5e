// The blocks of a file in storage that are in RAM, numbers of tables there, and
// what searches in them found.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/storage.hpp"

namespace inkcell::detail {

class FileBlocks {
 public:
  static constexpr uint32_t kBlockBytes = 512;

  // RAM of a block.
  struct __attribute__((may_alias)) Slot {
    uint32_t block;  // its number in the file, and 1; 0: none
    uint32_t used;   // when, see kBonus
  };

  // `ram` is a multiple of 8, and outlives it. False: it has no room for one.
  bool begin(const Storage& storage, Span<uint8_t> ram) noexcept;
  void clear() noexcept;

  // Big endian, of 1 to 4 bytes; 0 where the storage fails.
  uint32_t number(uint32_t at, uint32_t bytes) noexcept;
  // Copies a record. False: the storage fails.
  bool copy(uint32_t at, uint32_t count, uint8_t* to) noexcept;

  // What find() says of a place and a key, or what is kept of that.
  template <typename Find>
  uint32_t kept(uint32_t at, uint32_t key, const Find& find) noexcept {
    Kept entry = {at, static_cast<uint16_t>(key), 0};
    if (!recall(entry)) {
      const uint32_t failures = stats_.failures;
      entry.found = static_cast<uint16_t>(find());
      if (failures == stats_.failures) {
        keep(entry, kWays - 1);
      }
    }
    return entry.found;
  }
  // A key of a number itself: no glyph has it.
  static constexpr uint32_t kNumber = 0xffff;

  void fail(Status why) noexcept;
  Status status() const noexcept { return status_; }
  const StoredStats& stats() const noexcept { return stats_; }

 private:
  // At offset 0 a file has its own kind, and no table.
  struct Kept {
    uint32_t at;
    uint16_t key;
    uint16_t found;
  };
  // Entries of a set, which that used last is the first of.
  static constexpr uint32_t kWays = 8;
  static constexpr uint32_t kSets = 8;

  // How much longer a block stays that was asked for again: as if it had been
  // used so many times later. Those of records and of pairs come once.
  static constexpr uint32_t kBonus = 64;

  Kept* set_of(const Kept& entry) noexcept {
    return kept_ + ((entry.at >> 1) + entry.key) % kSets * kWays;
  }
  bool recall(Kept& entry) noexcept;
  // As the first of its set, in place of the entry `way`.
  void keep(const Kept& entry, uint32_t way) noexcept;

  const uint8_t* load(uint32_t block, bool is_record) noexcept;
  uint8_t* bytes_of(uint32_t slot) const noexcept {
    return bytes_ + slot * kBlockBytes;
  }

  Storage storage_;
  StoredStats stats_;
  uint8_t* bytes_;
  Slot* slots_;
  uint32_t clock_;  // changes from block to block
  uint32_t last_;   // slot that was used last
  Status status_;
  Kept kept_[kSets * kWays];
};

// As Table, in storage.
struct StoredTable {
  FileBlocks* blocks = nullptr;
  uint32_t begin = 0;
  uint32_t size = 0;
};

uint32_t u16_at(const StoredTable& table, uint32_t at) noexcept;
uint32_t u32_at(const StoredTable& table, uint32_t at) noexcept;
StoredTable part_of(const StoredTable& table,
                    uint32_t at,
                    uint32_t length = UINT32_MAX) noexcept;

// The upper levels of a search, which lead to other blocks, are kept.
uint32_t key_at(const StoredTable& table, uint32_t at, uint32_t left) noexcept;
inline uint32_t wide_key_at(const StoredTable& table,
                            uint32_t at,
                            uint32_t left) noexcept {
  return key_at(table, at, left) << 16 | key_at(table, at + 2, left);
}
template <typename Find>
uint32_t found_in(const StoredTable& table,
                  uint32_t key,
                  const Find& find) noexcept {
  return table.size == 0 ? find() : table.blocks->kept(table.begin, key, find);
}

}  // namespace inkcell::detail
