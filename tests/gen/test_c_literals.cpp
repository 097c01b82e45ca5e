// The characters of string literals.
#include "texts/c_literals.hpp"

#include <gtest/gtest.h>

#include "messages.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen::test {
namespace {

std::string text_of(std::string_view source) {
  std::string out;
  for (const LocatedCharacter& found : literal_characters(source, "a.c")) {
    out += to_utf8(found.value);
  }
  return out;
}

TEST(CLiterals, AreStringsAndNothingElse) {
  EXPECT_EQ(text_of("int a = 'x'; f(\"one\"); /* \"no\" */ // \"no\"\n"
                    "char c = '\"'; g(\"two\"); char d = '\\''; h(\"3\");"),
            "onetwo3");
  EXPECT_EQ(text_of("#include \"no.h\"\n # pragma warning \"no\"\n"
                    "#error \"no\n#define A \"yes\"\n#if 0\nb(\"too\");\n"
                    "#endif\n"),
            "yestoo");
  EXPECT_EQ(text_of("int n = 1'000'000; f(\"a\"); x = 0x1'F; g(\"b\");"), "ab");
  EXPECT_EQ(text_of("f(\"a\\\"b\"); \"not closed\ng(\"c\");"),
            "a\"bnot closedc");
  EXPECT_EQ(text_of(""), "");
}

TEST(CLiterals, HaveAnyPrefix) {
  EXPECT_EQ(text_of("u8\"a\" , u\"b\" , U\"c\" , L\"d\" , x\"e\""), "abcde");
  EXPECT_EQ(text_of("R\"(a\\n\"b)\" , u8R\"x(c)\")x\" , LR\"(d)\""),
            "a\\n\"bc)\"d");
}

TEST(CLiterals, ReadEscapes) {
  EXPECT_EQ(text_of(R"(f("\u00e9\U0001F600\x41\101\\\?\t\n");)"),
            "\u00e9\U0001F600AA\\?");
  EXPECT_EQ(text_of(R"(f(L"\x20ac", u"\xe9");)"), "\u20ac\u00e9");
}

TEST(CLiterals, AreJoined) {
  EXPECT_EQ(text_of("f(\"\\xe2\\x82\" /* half */\n \"\\xac\" \"5\");"),
            "\u20ac5");
  EXPECT_EQ(text_of("f(\"a\\\nb\"); // comment \\\n\"no\"\ng(\"c\");"), "abc");
  // Not adjacent: these two are no character.
  EXPECT_EQ(text_of("f(\"\\xe2\\x82\", \"\\xac\");"), "");
}

TEST(CLiterals, LeaveOutData) {
  EXPECT_EQ(text_of("f(\"\\xae\\xd5\\x80\"); g(\"text\");"), "text");
  EXPECT_EQ(text_of("f(\"\xef\xbb\xbf\\x1b[0m\");"), "[0m");
}

TEST(CLiterals, KnowTheirLines) {
  const auto found = literal_characters(
      "// one\nf(\"a\"\n  \"b\");\n/*\n*/ g(R\"(c\nd)\");\n\"e\\\nf\"", "a.c");
  std::vector<int> lines;
  for (const LocatedCharacter& c : found) {
    lines.push_back(c.line);
  }
  EXPECT_EQ(lines, (std::vector<int>{2, 3, 5, 6, 7, 8}));
}

TEST(CLiterals, RefuseWhatIsNotUtf8) {
  EXPECT_EQ(
      error_of([] { text_of("// M\xfcll\nf(\"ok\");\nf(\"M\xfcll\");"); }),
      "a.c:3: the string is not UTF-8; save the source as UTF-8");
}

// Reading ends for any file.
TEST(CLiterals, TakeAnyPrefixOfASource) {
  const std::string source =
      "#define X u8\"a\\x41\" R\"y(b)y\" 'c' /* d */ 1'0 \\\n\"e\" // f";
  for (size_t size = 0; size <= source.size(); ++size) {
    EXPECT_LE(text_of(source.substr(0, size)).size(), size);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
