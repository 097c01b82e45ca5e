#include "file_blocks.hpp"

namespace inkcell::detail {

bool FileBlocks::begin(const Storage& storage, Span<uint8_t> ram) noexcept {
  const auto count =
      static_cast<uint32_t>(ram.size / (kBlockBytes + sizeof(Slot)));
  storage_ = storage;
  stats_ = {};
  stats_.blocks = count;
  slots_ = reinterpret_cast<Slot*>(ram.data);
  bytes_ = ram.data + count * sizeof(Slot);
  clear();
  return count != 0;
}

void FileBlocks::clear() noexcept {
  for (uint32_t i = 0; i != stats_.blocks; ++i) {
    slots_[i] = {0, 0};
  }
  for (Kept& entry : kept_) {
    entry = {0, 0, 0};
  }
  clock_ = 0;
  last_ = 0;
  status_ = Status::ok;
}

void FileBlocks::fail(Status why) noexcept {
  ++stats_.failures;
  if (status_ == Status::ok) {
    status_ = why;
  }
}

// The bytes of a block; null: the storage fails.
const uint8_t* FileBlocks::load(uint32_t block, bool is_record) noexcept {
  const uint32_t number = block + 1;
  if (slots_[last_].block != number) {
    uint32_t slot = 0;
    uint32_t oldest = 0;
    while (slot != stats_.blocks && slots_[slot].block != number) {
      if (static_cast<int32_t>(slots_[slot].used - slots_[oldest].used) < 0) {
        oldest = slot;
      }
      ++slot;
    }
    uint32_t used = ++clock_;
    if (slot == stats_.blocks) {
      slot = oldest;
      slots_[slot] = {0, 0};
      ++stats_.reads;
      stats_.bytes += kBlockBytes;
      if (!storage_.read(storage_.context, block * kBlockBytes, bytes_of(slot),
                         kBlockBytes)) {
        fail(Status::read_failed);
        return nullptr;
      }
      slots_[slot].block = number;
    } else if (!is_record) {
      used += kBonus;
    }
    slots_[slot].used = used;
    last_ = slot;
  }
  return bytes_of(last_);
}

bool FileBlocks::recall(Kept& entry) noexcept {
  const Kept* const set = set_of(entry);
  for (uint32_t way = 0; way != kWays; ++way) {
    if (set[way].at == entry.at && set[way].key == entry.key) {
      entry = set[way];
      keep(entry, way);
      return true;
    }
  }
  return false;
}

void FileBlocks::keep(const Kept& entry, uint32_t way) noexcept {
  Kept* const set = set_of(entry);
  for (; way != 0; --way) {
    set[way] = set[way - 1];
  }
  set[0] = entry;
}

uint32_t FileBlocks::number(uint32_t at, uint32_t bytes) noexcept {
  uint32_t number = 0;
  for (; bytes != 0; --bytes, ++at) {
    const uint8_t* const from = load(at / kBlockBytes, false);
    if (from == nullptr) {
      return 0;
    }
    number = number << 8 | from[at % kBlockBytes];
  }
  return number;
}

bool FileBlocks::copy(uint32_t at, uint32_t count, uint8_t* to) noexcept {
  for (; count != 0; --count, ++at) {
    const uint8_t* const from = load(at / kBlockBytes, true);
    if (from == nullptr) {
      return false;
    }
    *to++ = from[at % kBlockBytes];
  }
  return true;
}

uint32_t u16_at(const StoredTable& table, uint32_t at) noexcept {
  return at < table.size && table.size - at >= 2
             ? table.blocks->number(table.begin + at, 2)
             : 0;
}

uint32_t u32_at(const StoredTable& table, uint32_t at) noexcept {
  return at < table.size && table.size - at >= 4
             ? table.blocks->number(table.begin + at, 4)
             : 0;
}

StoredTable part_of(const StoredTable& table,
                    uint32_t at,
                    uint32_t length) noexcept {
  if (at >= table.size) {
    return {};
  }
  const uint32_t rest = table.size - at;
  return {table.blocks, table.begin + at, rest < length ? rest : length};
}

uint32_t key_at(const StoredTable& table, uint32_t at, uint32_t left) noexcept {
  const auto read = [&table, at]() noexcept { return u16_at(table, at); };
  return left > FileBlocks::kBlockBytes / 2 && at < table.size
             ? table.blocks->kept(table.begin + at, FileBlocks::kNumber, read)
             : read();
}

}  // namespace inkcell::detail
