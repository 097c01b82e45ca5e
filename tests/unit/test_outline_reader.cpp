// From the bits of a record to points on the screen.
#include "outlines/outline_glyph.hpp"

#include "check.hpp"
#include "inkcell/format/rom.hpp"
#include "outline_record.hpp"

namespace {

using namespace inkcell;
using detail::OutlineCoding;
using detail::OutlineMap;
using detail::OutlineReader;
using detail::ScreenPoint;
using outline_record::BitWriter;
namespace word = format::outline;

// A grid unit is 1/256 px.
constexpr OutlineMap kMap = {{{1 << 10, 0}, {0, -(1 << 10)}}};

uint8_t record[1 << 9];
alignas(2) uint8_t table[2 << word::kMaxCodeBits];  // or smaller ones
ScreenPoint points[96];

void set_entry(uint32_t i,
               uint32_t length,
               uint32_t kind,
               uint32_t x_bits,
               uint32_t y_bits) {
  font_builder::put_u16(table + 2 * i, length | kind << word::kKindShift |
                                           x_bits << word::kXBitsShift |
                                           y_bits << word::kYBitsShift);
}

OutlineCoding coding_of(uint8_t code_bits, uint16_t max_points = 96) {
  OutlineCoding coding;
  coding.tables = table;
  coding.code_bits = code_bits;
  coding.max_points = max_points;
  return coding;
}

// The number of points, read in portions.
int32_t read(const BitWriter& bits,
             const OutlineCoding& coding,
             int32_t portion = 96,
             const OutlineMap& map = kMap) {
  OutlineReader reader;
  reader.set_budget(coding.max_points);
  reader.begin({record, bits.bytes()}, {0, 0});
  ScreenPoint* at = points;
  while (!reader.has_ended() && !reader.is_spent() && at < points + 96) {
    const auto room = static_cast<int32_t>(points + 96 - at);
    ScreenPoint* const end =
        reader.read(coding, map, at, room < portion ? room : portion);
    CHECK(end > at && end - at <= portion);
    at = end;
  }
  return static_cast<int32_t>(at - points);
}

void check_point(int32_t i, int32_t x, int32_t y, detail::PointKind kind) {
  CHECK_EQ(points[i].x_q8, x);
  CHECK_EQ(points[i].y_q8(), -y);
  CHECK_EQ(points[i].kind(), kind);
}

void put_signed(BitWriter& bits, int32_t value, uint32_t width) {
  bits.put(static_cast<uint32_t>(value), width);
}

int32_t least(uint32_t width) {
  return width == 0 ? 0 : -(1 << (width - 1));
}
int32_t most(uint32_t width) {
  return width == 0 ? 0 : (1 << (width - 1)) - 1;
}

}  // namespace

TEST(steps_have_any_width) {
  const OutlineCoding coding = coding_of(1);
  for (uint32_t x_bits = 0; x_bits <= word::kWidthMask; ++x_bits) {
    for (uint32_t y_bits = 0; y_bits <= word::kWidthMask; ++y_bits) {
      set_entry(0, 1, word::kEndOfContour, 0, 0);
      set_entry(1, 1, detail::kCorner, x_bits, y_bits);
      const int32_t dx[] = {least(x_bits), most(x_bits), 0,
                            x_bits == 0 ? 0 : -1};
      const int32_t dy[] = {most(y_bits), y_bits == 0 ? 0 : -1, least(y_bits),
                            0};
      BitWriter bits({record, sizeof(record)});
      bits.put(1, 1);
      for (int32_t i = 0; i < 4; ++i) {
        bits.put(1, 1);
        put_signed(bits, dx[i], x_bits);
        put_signed(bits, dy[i], y_bits);
      }
      bits.put(0, 2);
      CHECK_EQ(read(bits, coding), 5);
      int32_t x = 0;
      int32_t y = 0;
      for (int32_t i = 0; i < 4; ++i) {
        x += dx[i];
        y += dy[i];
        check_point(i, x, y, i == 0 ? detail::kStart : detail::kCorner);
      }
      check_point(4, dx[0], dy[0], detail::kCorner);
    }
  }
}

// Words 0, 10, 110 ... of 1 to 7 bits.
TEST(words_have_any_length) {
  for (uint8_t code_bits = 2; code_bits <= word::kMaxCodeBits; ++code_bits) {
    uint32_t first = 0;
    for (uint32_t length = 1; length <= code_bits; ++length) {
      const uint32_t count = 1u << (code_bits - length);
      for (uint32_t i = 0; i < count; ++i) {
        if (length == 1) {
          set_entry(first + i, length, word::kEndOfContour, 0, 0);
        } else {
          set_entry(first + i, length, detail::kCorner, length, 3);
        }
      }
      first += count;
    }
    set_entry(first, code_bits, detail::kSmooth, 4, 9);
    BitWriter bits({record, sizeof(record)});
    bits.put(1, 1);
    for (uint32_t length = 2; length <= code_bits; ++length) {
      bits.put((1u << length) - 2, length);
      put_signed(bits, 1, length);
      put_signed(bits, -2, 3);
    }
    bits.put((1u << code_bits) - 1, code_bits);
    put_signed(bits, -8, 4);
    put_signed(bits, 255, 9);
    bits.put(0, 2);
    CHECK_EQ(read(bits, coding_of(code_bits)), code_bits + 1);
    for (int32_t i = 1; i < code_bits - 1; ++i) {
      check_point(i, i + 1, -2 * (i + 1), detail::kCorner);
    }
    check_point(code_bits - 1, code_bits - 9, 257 - 2 * code_bits,
                detail::kSmooth);
  }
}

// Three contours with points of all kinds; the second one has a single point.
int32_t write_contours(BitWriter& bits) {
  set_entry(0, 2, word::kEndOfContour, 0, 0);
  set_entry(1, 2, detail::kOffCurve, 5, 5);
  set_entry(2, 2, detail::kSmooth, 5, 5);
  set_entry(3, 2, detail::kCorner, 5, 5);
  const uint32_t kinds[] = {3, 1, 2, 1, 1, 0, 3, 0, 1, 3, 2, 1, 0};
  bits.put(1, 1);
  int32_t step = -16;
  for (uint32_t i = 0; i < 13; ++i) {
    bits.put(kinds[i], 2);
    if (kinds[i] == 0) {
      bits.put(i == 12 ? 0 : 1, 1);
    } else {
      put_signed(bits, step, 5);
      put_signed(bits, 15 - static_cast<int32_t>(i), 5);
      step += 3;
    }
  }
  return 13;
}

TEST(contours_begin_and_end) {
  BitWriter bits({record, sizeof(record)});
  CHECK_EQ(write_contours(bits), read(bits, coding_of(2)));
  using namespace detail;
  const uint8_t kinds[] = {kStart,  kOffCurve, kSmooth, kOffCurve, kOffCurve,
                           kCorner, kStart,    kCorner, kStart,    kCorner,
                           kSmooth, kOffCurve, kCorner};
  for (int32_t i = 0; i < 13; ++i) {
    CHECK_EQ(points[i].kind(), kinds[i]);
  }
  // Where they began; the next one begins at a step from the last point, not
  // from there. The first point of a contour is a corner whatever its kind.
  CHECK_EQ(points[5].x_q8, points[0].x_q8);
  CHECK_EQ(points[5].y_q8(), points[0].y_q8());
  CHECK_EQ(points[6].x_q8, points[4].x_q8 - 1);
  CHECK_EQ(points[7].x_q8, points[6].x_q8);
  CHECK_EQ(points[8].x_q8, points[6].x_q8 + 2);
  CHECK_EQ(points[12].y_q8(), points[8].y_q8());
}

TEST(points_come_in_any_portions) {
  ScreenPoint all[13];
  BitWriter bits({record, sizeof(record)});
  const int32_t count = write_contours(bits);
  CHECK_EQ(read(bits, coding_of(2)), count);
  for (int32_t i = 0; i < count; ++i) {
    all[i] = points[i];
  }
  for (int32_t portion = 1; portion < 14; ++portion) {
    CHECK_EQ(read(bits, coding_of(2), portion), count);
    for (int32_t i = 0; i < count; ++i) {
      CHECK_EQ(points[i].x_q8, all[i].x_q8);
      CHECK_EQ(points[i].y_q8_kind, all[i].y_q8_kind);
    }
  }
}

// Four tables, of a word for lines of 4 bits along x and of one for the end
// each: that of a line changes the table by its number XOR 1, 2 or 3.
void set_tables() {
  for (uint32_t i = 0; i < 4; ++i) {
    set_entry(2 * i, 1, word::kEndOfContour, 0, 0);
    set_entry(2 * i + 1, 1, detail::kCorner, 4 + i, 0);
  }
  const uint32_t changes[] = {1, 3, 0, 2};  // to 1, 2, 2 and 1
  for (uint32_t i = 0; i < 4; ++i) {
    uint8_t* const entry = table + 2 * (2 * i + 1);
    font_builder::put_u16(
        entry, font_builder::get_u16(entry) | changes[i] << word::kTableShift);
  }
}

TEST(a_word_tells_the_table_of_the_next) {
  set_tables();
  BitWriter bits({record, sizeof(record)});
  bits.put(1, 1);
  for (const uint32_t width : each_of({4u, 5u, 6u, 6u})) {
    bits.put(1, 1);
    put_signed(bits, least(width), width);
  }
  bits.put(0, 2);
  for (const int32_t portion : each_of({96, 3, 1})) {
    OutlineCoding coding = coding_of(1);
    coding.last_table = 3;
    CHECK_EQ(read(bits, coding, portion), 5);
    check_point(0, -8, 0, detail::kStart);
    check_point(1, -24, 0, detail::kCorner);
    check_point(2, -56, 0, detail::kCorner);
    check_point(3, -88, 0, detail::kCorner);
  }
}

// Bits of a number that leave the tables are dropped.
TEST(no_table_beyond_the_last_is_read) {
  set_tables();
  BitWriter bits({record, sizeof(record)});
  bits.put(1, 1);
  for (const uint32_t width : each_of({4u, 5u, 5u})) {
    bits.put(1, 1);
    put_signed(bits, least(width), width);
  }
  bits.put(0, 2);
  OutlineCoding coding = coding_of(1);
  coding.last_table = 1;
  // From 1 the change is 3: to 0, and from there to 1.
  set_entry(2, 1, word::kEndOfContour, 0, 0);
  CHECK_EQ(read(bits, coding), 4);
  check_point(2, -8 - 16 - 8, 0, detail::kCorner);
}

// Words 10 and 11 of points along x are told apart by the sign of dx.
TEST(a_words_last_bit_may_be_the_numbers_first) {
  set_entry(0, 1, word::kEndOfContour, 0, 0);
  set_entry(1, 1, word::kEndOfContour, 0, 0);
  set_entry(2, 1, detail::kCorner, 4, 0);
  set_entry(3, 1, detail::kSmooth, 7, 0);
  BitWriter bits({record, sizeof(record)});
  bits.put(1, 1);
  bits.put(1, 1);
  put_signed(bits, 7, 4);
  bits.put(1, 1);
  put_signed(bits, -64, 7);
  bits.put(0, 2);
  CHECK_EQ(read(bits, coding_of(2)), 3);
  check_point(0, 7, 0, detail::kStart);
  check_point(1, 7 - 64, 0, detail::kSmooth);
}

TEST(no_more_than_max_points_come) {
  BitWriter bits({record, sizeof(record)});
  const int32_t count = write_contours(bits);
  for (int32_t limit = 0; limit < 20; ++limit) {
    const OutlineCoding coding = coding_of(2, static_cast<uint16_t>(limit));
    CHECK_EQ(read(bits, coding, 4), limit < count ? limit : count);
  }
  // Zeros are points without end.
  set_entry(0, 1, detail::kSmooth, 0, 0);
  set_entry(1, 1, detail::kCorner, 3, 3);
  CHECK_EQ(read(BitWriter({record, 0}), coding_of(1, 77)), 77);
}

TEST(zeros_follow_the_record) {
  set_entry(0, 1, word::kEndOfContour, 0, 0);
  set_entry(1, 1, detail::kCorner, 15, 15);
  BitWriter bits({record, sizeof(record)});
  bits.put(3, 2);
  put_signed(bits, 12345, 15);
  put_signed(bits, -4096, 15);  // the last twelve bits are zeros
  for (size_t size = (bits.bytes() + 1) / 2; size <= bits.bytes(); ++size) {
    OutlineReader reader;
    const OutlineCoding coding = coding_of(1);
    // In a block of its own: nothing behind the end is read as a number.
    uint8_t part[8];
    for (uint8_t& byte : part) {
      byte = 0xff;
    }
    for (size_t i = 0; i < size; ++i) {
      part[i] = record[i];
    }
    reader.set_budget(coding.max_points);
    reader.begin({part, size}, {0, 0});
    const ScreenPoint* const end = reader.read(coding, kMap, points, 96);
    CHECK_EQ(end - points, 2);
    CHECK(reader.has_ended() || reader.is_spent());
    if (size >= 3) {
      check_point(0, 12345, -4096, detail::kStart);
    }
  }
}

TEST(steps_are_mapped) {
  set_entry(0, 1, word::kEndOfContour, 0, 0);
  set_entry(1, 1, detail::kCorner, 6, 6);
  BitWriter bits({record, sizeof(record)});
  bits.put(3, 2);
  put_signed(bits, 20, 6);
  put_signed(bits, -7, 6);
  bits.put(0, 2);
  const OutlineMap map = {{{3 << 10, 2 << 10}, {-(5 << 10), 11 << 10}}};
  CHECK_EQ(read(bits, coding_of(1), 96, map), 2);
  check_point(0, 20 * 3 - 7 * 2, 20 * 5 + 7 * 11, detail::kStart);
}
