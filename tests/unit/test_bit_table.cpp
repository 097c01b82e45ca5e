// Bit tables: every width at every place, and nothing outside.
#include "base/bit_table.hpp"

#include "check.hpp"
#include "inkcell/format/rom.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using detail::BitTable;
using detail::read_any_bits;
using detail::read_bits;

uint8_t bytes[64];

void fill_at_random() {
  Random random(3);
  random.fill(bytes);
}

// Bit by bit.
uint32_t read_bits_ref(uint32_t bit, uint32_t width) {
  uint32_t value = 0;
  for (uint32_t i = 0; i < width; ++i) {
    const uint32_t at = bit + i;
    value |= static_cast<uint32_t>(bytes[at / 8] >> at % 8 & 1) << i;
  }
  return value;
}

void set_bits(uint32_t bit, uint32_t width, uint32_t value) {
  for (uint32_t i = 0; i < width; ++i) {
    const uint32_t at = bit + i;
    const uint32_t mask = 1u << at % 8;
    const bool one = (value >> i & 1) != 0;
    bytes[at / 8] = static_cast<uint8_t>(one ? bytes[at / 8] | mask
                                             : bytes[at / 8] & ~mask);
  }
}

}  // namespace

TEST(reads_every_width_at_every_bit) {
  fill_at_random();
  for (uint32_t width = 0; width <= format::bit_table::kMaxBits; ++width) {
    for (uint32_t bit = 0; bit + width <= 8 * sizeof bytes; ++bit) {
      const uint32_t value = read_bits_ref(bit, width);
      CHECK_EQ(read_bits(bytes, bit, width), value);
      CHECK_EQ(read_any_bits(bytes, bit, width), value);
    }
  }
}

TEST(reads_nothing_outside) {
  for (uint8_t& byte : bytes) {
    byte = 0xff;
  }
  const Span<const uint8_t> view(bytes, 5);
  for (uint32_t width = 1; width <= format::bit_table::kMaxBits; ++width) {
    CHECK_EQ(read_bits(view, 40 - width, width), (1u << width) - 1);
    CHECK_EQ(read_bits(view, 41 - width, width), 0);
    CHECK_EQ(read_bits(view, 40, width), 0);
    CHECK_EQ(read_bits(view, 0xffffffff, width), 0);
    CHECK_EQ(read_bits({}, 0, width), 0);
    CHECK_EQ(read_bits({bytes, 3}, 0, width), 0);
    CHECK_EQ(read_any_bits(view, 41 - width, width), 0);
  }
  CHECK_EQ(read_bits(view, 0, 26), 0);
  CHECK_EQ(read_bits(view, 0, 255), 0);
  CHECK_EQ(read_bits(view, 0, 0xffffffff), 0);
  CHECK_EQ(read_bits({}, 0, 0), 0);
}

TEST(tells_whether_bits_fit) {
  const Span<const uint8_t> view(bytes, 10);
  CHECK(detail::bits_fit(view, 3, 56));
  CHECK(!detail::bits_fit(view, 3, 57));
  CHECK(detail::bits_fit(view, 10, 0));
  CHECK(!detail::bits_fit(view, 10, 1));
  CHECK(!detail::bits_fit(view, 11, 0));
  CHECK(!detail::bits_fit(view, 0, 0xffffffff - 7));
  CHECK(!detail::bits_fit({}, 1, 0));
}

// Keys 3, 6, 9 .. in rows of every width, all numbers of rows.
TEST(finds_rows_by_key) {
  const Span<const uint8_t> all(bytes);
  for (uint32_t key_bits = 6; key_bits <= 25; ++key_bits) {
    for (uint32_t rows = 0; rows <= 16; ++rows) {
      const BitTable table = {&all, rows, key_bits + 4};  // from any bit on
      for (uint32_t i = 0; i < rows; ++i) {
        set_bits(rows + i * table.row_bits, key_bits, 3 * (i + 1));
        set_bits(rows + i * table.row_bits + key_bits, 4, i);
      }
      for (uint32_t key = 0; key < 3 * rows + 5; ++key) {
        const bool known = key != 0 && key % 3 == 0 && key / 3 <= rows;
        const uint32_t row = table.find(0, rows, key_bits, key);
        CHECK_EQ(row, known ? key / 3 - 1 : BitTable::kAbsent);
        if (known) {
          CHECK_EQ(table.get(row, key_bits, 4), row);
        }
      }
      CHECK_EQ(table.find(1, rows, key_bits, 3), BitTable::kAbsent);
      CHECK_EQ(table.find(0, rows / 2, key_bits, 3 * (rows / 2 + 1)),
               BitTable::kAbsent);
      CHECK_EQ(table.find(5, 2, key_bits, 9), BitTable::kAbsent);
    }
  }
}
