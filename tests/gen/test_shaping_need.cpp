// Which texts are wrong unless they are shaped.
#include <gtest/gtest.h>

#include "source/shaping_need.hpp"

namespace inkcell::gen::test {
namespace {

// "Arabic 2, Thai 9": scripts and their first characters.
std::string found(std::u32string_view text) {
  std::string list;
  for (const UnshapedScript& script : unshaped_scripts(text)) {
    list += (list.empty() ? "" : ", ") + script.name + " " +
            std::to_string(script.at);
  }
  return list;
}

TEST(ShapingNeed, IsNoneWhereLettersStandSideBySide) {
  for (const char32_t* text :
       {U"Hello, \u00e4\u0142\u1ea5", U"\u0391\u03ac", U"\u0416\u0439",
        U"\u05e9\u05dc\u05d5\u05dd",  // Hebrew without points
        U"\u4f60\u597d \u3053\u3093\u306b\u3061\u306f \uc548\ub155",
        U"\u0e01\u0e32",                   // Thai without marks
        U"\u0915\u092e\u0932",             // Devanagari likewise
        U"\ufe8d\ufedf\ufeb4",             // forms that someone has shaped
        U"\u2764\ufe0f \U0001f600\u200d",  // emoji, a selector, a joiner
        U"\u00ad\u200b\u2067", U""}) {
    EXPECT_EQ(found(text), "");
  }
}

TEST(ShapingNeed, IsThatOfScripts) {
  EXPECT_EQ(found(U"a \u0633\u0644\u0627\u0645"), "Arabic 2");
  EXPECT_EQ(found(U"\u0928\u092e\u0938\u094d\u0924\u0947"), "Devanagari 3");
  EXPECT_EQ(found(U"\u0e17\u0e35\u0e48"), "Thai 1");
  EXPECT_EQ(found(U"\u05e9\u05bc"), "Hebrew 1");
  EXPECT_EQ(found(U"\u0baa\u0bbf"), "Tamil 1");
  EXPECT_EQ(found(U"\u1780\u17d2\u1780"), "Khmer 1");
  EXPECT_EQ(found(U"\u182e\u1823"), "Mongolian 0");
  EXPECT_EQ(found(U"\u07ca"), "N'Ko 0");
  EXPECT_EQ(found(U"\U0001e900"), "Adlam 0");
  EXPECT_EQ(found(U"\U00011103\U00011127"), "the script Cakm 1");
  EXPECT_EQ(found(U"e\u0301"), "Latin 1");
  EXPECT_EQ(found(U"\u0438\u0306"), "Cyrillic 1");
  EXPECT_EQ(found(U"\u1112\u1161\u11ab"), "Hangul 0");
  EXPECT_EQ(found(U"1\u20e3"), "text 1");
}

// A mark without a script of its own has that of the letters before it.
TEST(ShapingNeed, IsToldOfEachScriptOnce) {
  EXPECT_EQ(found(U"e\u0301 o\u0308 \u0633\u064b \u05e9 \u0633"),
            "Latin 1, Arabic 6");
}

TEST(ShapingNeed, SaysWhatToDo) {
  const std::u32string arabic = U"\u0633";
  EXPECT_EQ(unshaped_message(unshaped_scripts(arabic).at(0), arabic),
            "Arabic is drawn unshaped, from U+0633 '\u0633' on: letters do not "
            "join, or marks miss their places; shape text that is known at "
            "build time with inkcell-fontgen --strings");
  const std::u32string accent = U"e\u0301";
  EXPECT_EQ(unshaped_message(unshaped_scripts(accent).at(0), accent),
            "Latin is drawn unshaped, from U+0301 '\u25cc\u0301' on: marks "
            "miss their places; write each with its letter as one character "
            "(Unicode NFC), or shape text that is known at build time with "
            "inkcell-fontgen --strings");
}

}  // namespace
}  // namespace inkcell::gen::test
