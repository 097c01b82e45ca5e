// Packed glyphs made at random, bit by bit, and what they must expand to.
//
// Knows the stream as docs/FORMAT.md states it, and shares with the decoder
// only the lengths of the codes and expand_field.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "font_builder.hpp"
#include "inkcell/packed.hpp"
#include "inkcell/packed_codes.hpp"
#include "random.hpp"

/// Bits, the first in the highest place of a byte.
class BitWriter {
 public:
  explicit BitWriter(inkcell::Span<uint8_t> out) : out_(out) {}

  void put(uint32_t value, uint32_t width) {
    while (width-- > 0) {
      if (at_ < out_.size) {
        const auto bit = static_cast<uint8_t>((value >> width & 1) << 7);
        out_[at_] =
            static_cast<uint8_t>((used_ == 0 ? 0 : out_[at_]) | bit >> used_);
      }
      used_ = (used_ + 1) % 8;
      at_ += used_ == 0 ? 1 : 0;
    }
  }
  /// Fills the last byte up with zeros.
  void end_byte() {
    if (used_ != 0) {
      put(0, 8 - used_);
    }
  }
  size_t bytes() const { return at_; }
  bool fits() const { return at_ <= out_.size; }

  /// The code of a symbol: canonical, ascending by length, then by symbol.
  void symbol(const uint8_t* lengths, uint32_t count, uint32_t symbol) {
    const uint32_t length = lengths[symbol];
    uint32_t code = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const bool before =
          lengths[i] < length || (lengths[i] == length && i < symbol);
      if (lengths[i] != 0 && before) {
        code += 1u << (length - lengths[i]);
      }
    }
    put(code, length);
  }
  void node(uint32_t log2, uint32_t symbol_number) {
    namespace codes = inkcell::packed_codes;
    symbol(codes::kNodeLengths[log2 > 2 ? 8 - log2 : 6], codes::kNodeSymbols,
           symbol_number);
  }
  void kind(uint32_t place, bool after_new, uint32_t symbol_number) {
    namespace codes = inkcell::packed_codes;
    symbol(codes::kKindLengths[2 * place + (after_new ? 1 : 0)],
           codes::kKindSymbols, symbol_number);
  }
  void rank(bool is_first, uint32_t step) {
    namespace codes = inkcell::packed_codes;
    symbol(codes::kRankLengths[is_first ? 0 : 1], codes::kRankSymbols, step);
  }
  void field(const inkcell::FieldCode& code,
             const inkcell::PackedCoding& coding,
             uint32_t log2) {
    const uint32_t d0_bits = coding.d0_bits(log2);
    put(static_cast<uint32_t>(code.d0) + (1u << (d0_bits - 1)), d0_bits);
    put(code.angle, has_angle(code.kind) ? coding.angle_bits(log2) : 2);
    if (is_bent(code.kind)) {
      const uint32_t low_bits = coding.bend_bits(log2);
      const auto size =
          static_cast<uint32_t>(code.bend < 0 ? -code.bend : code.bend) - 1;
      for (uint32_t i = 0; i < size >> low_bits; ++i) {
        put(1, 1);
      }
      put(0, 1);
      put(size, low_bits);
      put(code.bend < 0 ? 1u : 0u, 1);
    }
  }

 private:
  inkcell::Span<uint8_t> out_;
  size_t at_ = 0;
  uint32_t used_ = 0;
};

/// The coding of a usual font: steps of 1/4 and 3/8 u.
inline inkcell::PackedCoding usual_coding() {
  inkcell::PackedCoding coding;
  coding.d0_step = 16;
  coding.bend_step = 24;
  coding.d0_base = 9;
  coding.d0_log2 = 6;
  coding.angle_base = 8;
  coding.bend_k = 0x2234;
  return coding;
}

/// A packed glyph, and the heap that it expands to.
struct PackedRecord {
  inkcell::PackedCoding coding = usual_coding();
  int16_t x0_u = 0;
  int16_t y0_u = 0;
  uint8_t tiles_x = 1;
  uint8_t tiles_y = 1;
  bool wide_rows = false;
  uint32_t shared_count = 0;
  uint32_t seed = 1;        // of everything else
  uint32_t least_log2 = 4;  // squares are not divided further

  static constexpr uint32_t kMaxUnits = 512;

  uint8_t bytes[700] = {};
  size_t size = 0;
  uint16_t heap[kMaxUnits] = {};
  uint32_t units = 0;

  /// Sets the members up at random, and writes `bytes`. False if the record
  /// or its heap does not fit, or a row its length.
  bool try_to_make(Random& random) {
    tiles_x = static_cast<uint8_t>(1 + random.below(3));
    tiles_y = static_cast<uint8_t>(1 + random.below(3));
    x0_u = static_cast<int16_t>(random.between(-700, 300));
    y0_u = static_cast<int16_t>(random.between(-700, 300));
    wide_rows = random.below(2) != 0;
    shared_count = random.below(4) == 0 ? random.below(16) : random.below(4);
    seed = random.next() | 1;
    least_log2 = random.below(4) == 0 ? 0 : 4 + random.below(3);
    return write();
  }

  bool write();

  void make(Random& random) {
    while (!try_to_make(random)) {
    }
  }

  /// Makes `heap` that of `count` rows of tiles from `first` on.
  void expect(uint32_t first, uint32_t count) {
    Maker maker(*this, nullptr);
    maker.expect(first, count);
  }

  /// Writes a linked record with `heap`: the bytes of it.
  size_t write_linked(uint32_t first, uint32_t count, uint8_t* at) const {
    using font_builder::put_u16;
    at[0] = 2;
    at[1] = 0x80 | 8;
    put_u16(at + 2, static_cast<uint32_t>(x0_u));
    put_u16(at + 4, static_cast<uint32_t>(y0_u) + 256 * first);
    at[6] = tiles_x;
    at[7] = static_cast<uint8_t>(count);
    put_u16(at + 8, units);
    for (uint32_t i = 0; i < units; ++i) {
      put_u16(at + 10 + 2 * i, heap[i]);
    }
    return 10 + 2 * units;
  }

 private:
  // Goes through a glyph with the same random numbers for the same row.
  class Maker {
   public:
    Maker(PackedRecord& record, BitWriter* bits)
        : record_(record), bits_(bits), random_(record.seed) {}

    void expect(uint32_t first, uint32_t count) {
      record_.units = record_.tiles_x * count;
      shared();
      for (uint32_t row = first; row < first + count; ++row) {
        tile_row(row, record_.tiles_x * (row - first));
      }
    }
    void shared();
    void tile_row(uint32_t row, uint32_t slot);

   private:
    void put_at(uint32_t unit, uint32_t value) {
      if (unit < kMaxUnits) {
        record_.heap[unit] = static_cast<uint16_t>(value);
      }
    }
    void put(uint32_t value) { put_at(record_.units++, value); }
    uint32_t add_field(const inkcell::FieldCode& code,
                       uint32_t log2,
                       int32_t x,
                       int32_t y);
    inkcell::FieldCode random_code(inkcell::FieldKind kind, uint32_t log2);
    void square(int32_t x, int32_t y, uint32_t log2, uint32_t slot);
    uint16_t leaf(uint32_t symbol, int32_t x, int32_t y, uint32_t log2);

    PackedRecord& record_;
    BitWriter* bits_;
    Random random_;
    uint16_t list_[20] = {};
    uint32_t listed_ = 0;
    uint16_t shared_[16] = {};
  };
};

inline void PackedRecord::Maker::shared() {
  uint32_t log2 = 8;
  for (uint32_t tiles = 1; tiles < record_.tiles_x || tiles < record_.tiles_y;
       tiles *= 2) {
    ++log2;
  }
  if (bits_ != nullptr) {
    bits_->put(record_.shared_count, 4);
  }
  for (uint32_t i = 0; i < record_.shared_count; ++i) {
    const auto kind = static_cast<inkcell::FieldKind>(random_.below(4));
    const inkcell::FieldCode code = random_code(kind, log2);
    if (bits_ != nullptr) {
      bits_->put(static_cast<uint32_t>(kind), 2);
      bits_->field(code, record_.coding, log2);
    }
    shared_[i] = static_cast<uint16_t>(
        add_field(code, log2, record_.x0_u + 128 * record_.tiles_x,
                  record_.y0_u + 128 * record_.tiles_y));
  }
}

inline void PackedRecord::Maker::tile_row(uint32_t row, uint32_t slot) {
  random_ = Random(record_.seed + 1000 * (row + 1));
  listed_ = record_.shared_count;
  for (uint32_t i = 0; i < listed_; ++i) {
    list_[i] = shared_[i];
  }
  for (uint32_t i = 0; i < record_.tiles_x; ++i) {
    square(record_.x0_u + 256 * static_cast<int32_t>(i),
           record_.y0_u + 256 * static_cast<int32_t>(row), 8, slot + i);
  }
}

inline inkcell::FieldCode PackedRecord::Maker::random_code(
    inkcell::FieldKind kind, uint32_t log2) {
  inkcell::FieldCode code;
  code.kind = kind;
  const uint32_t d0_bits = record_.coding.d0_bits(log2);
  code.d0 =
      static_cast<int32_t>(random_.below(1u << d0_bits)) - (1 << (d0_bits - 1));
  code.angle = random_.below(
      has_angle(kind) ? 1u << record_.coding.angle_bits(log2) : 4);
  if (is_bent(kind)) {
    const uint32_t most = 16u << record_.coding.bend_bits(log2);
    const uint32_t size =
        1 + (random_.below(3) == 0 ? random_.below(most) : random_.below(4));
    code.bend = (random_.next() & 1) != 0 ? static_cast<int32_t>(size)
                                          : -static_cast<int32_t>(size);
  }
  return code;
}

inline uint32_t PackedRecord::Maker::add_field(const inkcell::FieldCode& code,
                                               uint32_t log2,
                                               int32_t x,
                                               int32_t y) {
  const inkcell::FieldNumbers field =
      inkcell::expand_field(code, record_.coding, log2, x, y);
  const uint32_t at = record_.units;
  put(static_cast<uint16_t>(field.nx_q14));
  put(static_cast<uint16_t>(field.ny_q14));
  put(static_cast<uint16_t>(field.c_q4));
  if (field.bend == 0) {
    return at;
  }
  put(static_cast<uint16_t>(field.along_q4));
  put(static_cast<uint16_t>(field.bend));
  return at | 0x8000;
}

inline void PackedRecord::Maker::square(int32_t x,
                                        int32_t y,
                                        uint32_t log2,
                                        uint32_t slot) {
  // A quarter of all squares that may be divided are.
  uint32_t symbol = random_.below(12);
  if (symbol == 0 || symbol >= 10) {
    symbol = log2 > record_.least_log2 ? 0 : 3;
  }
  if (bits_ != nullptr) {
    bits_->node(log2, symbol);
  }
  if (symbol == 0) {
    const uint32_t node = record_.units;
    record_.units += 4;
    put_at(slot, 1 << 13 | node);
    const int32_t half = 1 << (log2 - 1);
    square(x, y, log2 - 1, node);
    square(x + half, y, log2 - 1, node + 1);
    square(x, y + half, log2 - 1, node + 2);
    square(x + half, y + half, log2 - 1, node + 3);
  } else if (symbol < 3) {
    put_at(slot, symbol - 1);
  } else {
    put_at(slot, leaf(symbol, x, y, log2));
  }
}

inline uint16_t PackedRecord::Maker::leaf(uint32_t symbol,
                                          int32_t x,
                                          int32_t y,
                                          uint32_t log2) {
  const bool nested = symbol >= 8;
  const uint32_t count = symbol >= 6 ? 3 : symbol >= 4 ? 2 : 1;
  const int32_t half = (1 << log2) / 2;
  uint16_t units[3] = {};
  uint32_t rank = 0;
  bool after_new = false;
  for (uint32_t i = 0; i < count; ++i) {
    const bool is_first = i == 0 || (nested && i == 1);
    if (is_first) {
      rank = 0;
      after_new = false;
    }
    uint32_t step =
        random_.below(4) == 0 ? random_.below(16) : random_.below(3);
    const bool is_listed = rank + step < listed_;
    const bool is_taken =
        nested && i > 0 && is_listed && list_[rank + step] == units[0];
    if (after_new || !is_listed || is_taken) {
      const uint32_t kind = random_.below(4);
      const inkcell::FieldCode code =
          random_code(static_cast<inkcell::FieldKind>(kind), log2);
      if (bits_ != nullptr) {
        bits_->kind(i, after_new, 1 + kind);
        bits_->field(code, record_.coding, log2);
      }
      units[i] =
          static_cast<uint16_t>(add_field(code, log2, x + half, y + half));
      after_new = true;
    } else {
      if (bits_ != nullptr) {
        bits_->kind(i, false, 0);
        bits_->rank(is_first, step);
      }
      units[i] = list_[rank + step];
      rank += step + 1;
    }
  }
  for (uint32_t i = count; i-- > 0;) {
    uint32_t at = 0;
    while (at < listed_ && list_[at] != units[i]) {
      ++at;
    }
    listed_ += at == listed_ ? 1 : 0;
    for (; at > 0; --at) {
      list_[at] = list_[at - 1];
    }
    list_[0] = units[i];
  }
  listed_ = listed_ > 16 ? 16 : listed_;
  if (count == 1) {
    return static_cast<uint16_t>(
        ((units[0] & 0x8000) != 0 ? 3 << 13 : 2 << 13) | (units[0] & 0x1fff));
  }
  const uint32_t at = record_.units;
  if (count == 3) {
    put(symbol - 6);
  }
  for (uint32_t i = 0; i < count; ++i) {
    put(units[i]);
  }
  return static_cast<uint16_t>((count == 3 ? 6u : symbol) << 13 | at);
}

inline bool PackedRecord::write() {
  bytes[0] = static_cast<uint8_t>(3 | (wide_rows ? 0x80 : 0));
  bytes[1] = static_cast<uint8_t>(tiles_x | tiles_y << 4);
  const uint32_t corner = (static_cast<uint32_t>(x0_u) & 0xfff) |
                          (static_cast<uint32_t>(y0_u) & 0xfff) << 12;
  font_builder::put_u16(bytes + 2, corner);
  bytes[4] = static_cast<uint8_t>(corner >> 16);
  const size_t length_bytes = wide_rows ? 2 : 1;
  size = 5 + length_bytes * (tiles_y - 1u);
  units = 0;
  BitWriter bits({bytes + size, sizeof(bytes) - size});
  Maker maker(*this, &bits);
  maker.shared();
  bits.end_byte();
  size_t begin = bits.bytes();
  bool fits = true;
  for (uint32_t row = 0; row < tiles_y; ++row) {
    // What a row adds to the heap is not of interest, and must fit all the
    // same.
    units = 256;
    maker.tile_row(row, 0);
    bits.end_byte();
    const size_t length = bits.bytes() - begin;
    begin = bits.bytes();
    fits = fits && (row + 1 == tiles_y || wide_rows || length < 256);
    if (row + 1u < tiles_y) {
      uint8_t* at = bytes + 5 + length_bytes * row;
      at[0] = static_cast<uint8_t>(length);
      if (wide_rows) {
        at[1] = static_cast<uint8_t>(length >> 8);
      }
    }
  }
  size += bits.bytes();
  expect(0, tiles_y);
  return fits && bits.fits() && units <= kMaxUnits;
}
