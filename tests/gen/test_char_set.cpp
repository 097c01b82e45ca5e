// Lists of characters on the command line.
#include <gtest/gtest.h>

#include "messages.hpp"
#include "sfnt_builder.hpp"
#include "source/char_set.hpp"
#include "source/named_sets.hpp"

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
    EXPECT_TRUE(begins_with(error_of([&] { add_text(text, "notes.txt", set); }),
                            "notes.txt: byte 2 "));
  }
}

TEST(CharSet, ReadsFiles) {
  const TestFolder folder;
  CharSet set;
  add_text_file(folder.write("a.txt", std::vector<uint8_t>{'A', '\n', 'B'}),
                set);
  EXPECT_EQ(set, (CharSet{'A', 'B'}));
  EXPECT_THROW(add_text_file(folder.path() / "none.txt", set), Error);
  EXPECT_EQ(error_of([&] { add_text_file(folder.path(), set); }),
            folder.path().string() + ": is a folder; give --text-file a file");
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

CharSet named(std::string_view list) {
  CharSet set;
  add_named_sets(list, set);
  return set;
}

TEST(NamedSets, HaveWhatTheirStandardsHave) {
  EXPECT_EQ(named("ascii"), ranges(kDefaultChars));
  EXPECT_EQ(named("latin-1").size(), 95u + 96u);
  EXPECT_EQ(named("latin-ext").size(), 128u + 5u + 15u);
  EXPECT_EQ(named("greek").size(), 72u);
  EXPECT_EQ(named("cyrillic").size(), 99u);
  EXPECT_EQ(named("kana").size(), 83u + 4u + 86u + 4u);
  EXPECT_EQ(named("cjk-signs").size(), 115u);
  EXPECT_EQ(named("gb2312-1").size(), 3755u);
  EXPECT_EQ(named("jis-1").size(), 2965u);
  EXPECT_EQ(named("ks-x-1001").size(), 2350u);
  // The first and the last of each table of the East, and one of level 2.
  const CharSet china = named("gb2312-1");
  EXPECT_EQ(china.count(U'\u554a') + china.count(U'\u5ea7'), 2u);
  EXPECT_EQ(china.count(U'\u4e8d'), 0u);
  const CharSet japan = named("jis-1");
  EXPECT_EQ(japan.count(U'\u4e9c') + japan.count(U'\u8155'), 2u);
  EXPECT_EQ(japan.count(U'\u5f0c'), 0u);
  const CharSet korea = named("ks-x-1001");
  EXPECT_EQ(korea.count(U'\uac00') + korea.count(U'\ud79d'), 2u);
  EXPECT_EQ(korea.count(U'\uac02'), 0u);
}

TEST(NamedSets, AddUp) {
  EXPECT_EQ(named("greek, cyrillic").size(), 72u + 99u);
  EXPECT_EQ(named("ascii,latin-1"), named("latin-1"));
  // Finnish, Polish, Romanian, Turkish, German, and the euro.
  const CharSet europe = named("latin-1,latin-ext");
  for (const char32_t c :
       std::u32string(U"\u00e4\u0142\u021b\u0131\u1e9e\u201e\u20ac")) {
    EXPECT_EQ(europe.count(c), 1u) << describe(c);
  }
}

TEST(NamedSets, AreNamedWhereOneIsNotKnown) {
  for (const char* list : {"latin1", "greek,", "", "greek,latin1"}) {
    EXPECT_TRUE(contains(error_of([&] { named(list); }),
                         "is not known; there are ascii, latin-1, latin-ext, "
                         "greek, cyrillic, kana, cjk-signs, gb2312-1, jis-1, "
                         "ks-x-1001"));
  }
}

}  // namespace
}  // namespace inkcell::gen::test
