// The container of TrueType fonts: big-endian bytes, tables, checksums.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace inkcell::design {

/// Bytes that grow, big endian.
class BigEndian {
 public:
  void u8(unsigned value) { bytes_.push_back(static_cast<uint8_t>(value)); }
  void u16(unsigned value) {
    u8(value >> 8 & 0xff);
    u8(value & 0xff);
  }
  void i16(int value) { u16(static_cast<unsigned>(value) & 0xffff); }
  /// Several numbers of 16 bits, with or without a sign.
  template <typename... Numbers>
  void words(Numbers... numbers) {
    (u16(static_cast<unsigned>(numbers) & 0xffff), ...);
  }
  void u32(uint32_t value) {
    u16(value >> 16);
    u16(value & 0xffff);
  }
  /// Numbers to search a table of `count` entries by halves: the bytes of the
  /// largest power of two of them, its logarithm, the bytes of the others.
  void search(size_t count, unsigned bytes_an_entry) {
    unsigned log2 = 0;
    while (size_t{2} << log2 <= count) {
      ++log2;
    }
    const unsigned searched = bytes_an_entry << log2;
    words(searched, log2, bytes_an_entry * count - searched);
  }
  void u64(uint64_t value) {
    u32(static_cast<uint32_t>(value >> 32));
    u32(static_cast<uint32_t>(value));
  }
  void text(const std::string& value) {
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  void append(const BigEndian& other) {
    bytes_.insert(bytes_.end(), other.bytes_.begin(), other.bytes_.end());
  }
  /// Zeros up to a multiple of `unit`.
  void align(size_t unit) {
    while (bytes_.size() % unit != 0) {
      u8(0);
    }
  }
  void set_u16(size_t at, unsigned value) {
    bytes_[at] = static_cast<uint8_t>(value >> 8);
    bytes_[at + 1] = static_cast<uint8_t>(value);
  }
  void set_u32(size_t at, uint32_t value) {
    set_u16(at, value >> 16);
    set_u16(at + 2, value & 0xffff);
  }

  size_t size() const { return bytes_.size(); }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
};

/// A font file of these tables, by their tags; `head` gets its checksum.
std::vector<uint8_t> write_sfnt(const std::map<std::string, BigEndian>& tables);

}  // namespace inkcell::design
