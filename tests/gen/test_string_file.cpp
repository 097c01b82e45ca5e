// Files of named strings.
#include "texts/string_file.hpp"

#include <gtest/gtest.h>

#include "messages.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {
namespace {

std::vector<NamedString> parse(const std::string& text) {
  const TestFolder folder;
  std::vector<NamedString> out;
  add_string_file(folder.write("ui.txt", text), out);
  return out;
}

TEST(StringFile, HasNamesAndTexts) {
  const auto found = parse(
      "\xef\xbb\xbf# Comment = none\r\n\r\n title = Say = \"hi\" \r\n"
      "ar_1 [ar] = \u0645\n_x[zh-Hant , rtl]=\" \\u20ac\\xc3\\xa9\\\" \"\n"
      "none = \"\"");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].name, "title");
  EXPECT_EQ(found[0].line.text, U"Say = \"hi\"");
  EXPECT_EQ(found[0].line.language, "");
  EXPECT_EQ(found[0].line.direction, LineDirection::from_text);
  EXPECT_EQ(found[0].line_number, 3);
  EXPECT_EQ(found[1].name, "ar_1");
  EXPECT_EQ(found[1].line.text, U"\u0645");
  EXPECT_EQ(found[1].line.language, "ar");
  EXPECT_EQ(found[2].name, "_x");
  EXPECT_EQ(found[2].line.text, U" \u20ac\u00e9\" ");
  EXPECT_EQ(found[2].line.language, "zh-Hant");
  EXPECT_EQ(found[2].line.direction, LineDirection::right_to_left);
  EXPECT_EQ(found[3].line.text, U"");
  EXPECT_TRUE(parse("# nothing\n").empty());
}

TEST(StringFile, RefusesOtherLines) {
  const struct {
    const char* line;
    const char* said;
  } cases[] = {
      {"title", "there is no '='"},
      {"= a", "'' is not an identifier"},
      {"9a = a", "'9a' is not an identifier"},
      {"a-b = a", "'a-b' is not an identifier"},
      {"new = a", "'new' belongs to C or C++; use another name"},
      {"a [ar = b", "there is no ']'"},
      {"a [] = b", "'' is no language"},
      {"a [de_DE] = b", "'de_DE' is no language"},
      {"a [-de] = b", "'-de' is no language"},
      {"a =  ", "'a' has no text; write \"\" for an empty one"},
      {"a = b\tc", "'a' holds U+0009, a control character"},
      {"a = \"b\\n\"", "'a' holds U+000A, a control character"},
      {"a = \"b", "there is no quotation mark at the end"},
      {"a = \"b\" c", "something follows the last quotation mark"},
      {"a = \"\\q\"", "a backslash is followed by no escape sequence"},
      {"a = \xfc", "the text is not UTF-8"},
      {"b = 2", "'b' is defined in "},
  };
  for (const auto& wrong : cases) {
    const std::string text = std::string("b = 1\n") + wrong.line + "\nc = 3\n";
    EXPECT_TRUE(contains(error_of([&] { parse(text); }),
                         std::string("ui.txt:2: ") + wrong.said));
  }
}

TEST(StringFile, RefusesWhatIsNoFile) {
  const TestFolder folder;
  std::vector<NamedString> out;
  EXPECT_THROW(add_string_file(folder.path(), out), Error);
  EXPECT_THROW(add_string_file(folder.path() / "none", out), Error);
}

}  // namespace
}  // namespace inkcell::gen::test
