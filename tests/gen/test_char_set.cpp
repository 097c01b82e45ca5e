// Lists of characters on the command line.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "sfnt_builder.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen::test {
namespace {

CharSet ranges(std::string_view list) {
  CharSet set;
  add_ranges(list, set);
  return set;
}

TEST(CharSet, ReadsEveryNotation) {
  EXPECT_EQ(ranges("0x41"), (CharSet{0x41}));
  EXPECT_EQ(ranges("U+41,u+0042"), (CharSet{0x41, 0x42}));
  EXPECT_EQ(ranges("65-67"), (CharSet{65, 66, 67}));
  EXPECT_EQ(ranges("A-C,x"), (CharSet{'A', 'B', 'C', 'x'}));
  EXPECT_EQ(ranges("0-9").size(), 10u);
  EXPECT_EQ(ranges("0-3,7,-"), (CharSet{'-', '0', '1', '2', '3', '7'}));
  EXPECT_EQ(ranges("0-A").size(), 18u);
  EXPECT_EQ(ranges("\xc3\xa4, 0xB0"), (CharSet{0xe4, 0xb0}));
  EXPECT_EQ(ranges("0x2C-U+2E"), (CharSet{0x2c, 0x2d, 0x2e}));
  EXPECT_EQ(ranges(kDefaultChars).size(), 95u);
  EXPECT_EQ(ranges("0x10FFFF"), (CharSet{0x10ffff}));
}

TEST(CharSet, LeavesSurrogatesOut) {
  EXPECT_EQ(ranges("0xD7FF-0xE000"), (CharSet{0xd7ff, 0xe000}));
  EXPECT_THROW(ranges("0xD800"), Error);
}

TEST(CharSet, RefusesWhatItCannotRead) {
  for (const char* list :
       {"", ",", "0x41,", "0x", "0xZZ", "AB", "0x41-", "0x42-0x41", "0x110000",
        "99999999999", "9-0", "0-90", "10-9", "10", "\xff", "0x41-0x42-0x43"}) {
    EXPECT_THROW(ranges(list), Error) << list;
  }
}

TEST(CharSet, TakesTextWithoutItsControls) {
  CharSet set;
  add_text("\xef\xbb\xbfOne\r\n\ttwo \xe5\xad\x97 \xf0\x9f\x98\x80", "text",
           set);
  EXPECT_EQ(set, (CharSet{' ', 'O', 'n', 'e', 't', 'w', 'o', 0x5b57, 0x1f600}));
}

TEST(CharSet, SaysWhereTextIsNotUtf8) {
  CharSet set;
  // A lone continuation, a cut sequence, an overlong form, a surrogate, a code
  // point beyond Unicode.
  for (const char* text : {"ab\x80", "ab\xc3", "ab\xc0\xaf", "ab\xed\xa0\x80",
                           "ab\xf4\x90\x80\x80"}) {
    try {
      add_text(text, "notes.txt", set);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find("notes.txt: byte 2 "), 0u);
    }
  }
}

TEST(CharSet, ReadsFiles) {
  const TestFolder folder;
  CharSet set;
  add_text_file(folder.write("a.txt", std::vector<uint8_t>{'A', '\n', 'B'}),
                set);
  EXPECT_EQ(set, (CharSet{'A', 'B'}));
  EXPECT_THROW(add_text_file(folder.path() / "none.txt", set), Error);
  try {
    add_text_file(folder.path(), set);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), folder.path().string() +
                                ": is a folder; give --text-file a file");
  }
}

TEST(CharSet, WritesUtf8) {
  EXPECT_EQ(to_utf8(0x41), "A");
  EXPECT_EQ(to_utf8(0xe4), "\xc3\xa4");
  EXPECT_EQ(to_utf8(0x5b57), "\xe5\xad\x97");
  EXPECT_EQ(to_utf8(0x1f600), "\xf0\x9f\x98\x80");
  EXPECT_EQ(describe(0x41), "U+0041 'A'");
  EXPECT_EQ(describe(0x0a), "U+000A");
  EXPECT_EQ(describe(0xe001), "U+E001");
  EXPECT_EQ(describe(0xf0001), "U+F0001");
}

}  // namespace
}  // namespace inkcell::gen::test
