// Files that appear whole or not at all, and the source forms of a font.
#include <gtest/gtest.h>

#include "output.hpp"

#include "error.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {
namespace {

std::string text_of(const std::filesystem::path& file) {
  const std::vector<uint8_t> bytes = read_file(file);
  return {bytes.begin(), bytes.end()};
}

TEST(OutputFile, AppearsWithCommit) {
  const TestFolder folder;
  const std::filesystem::path target = folder.path() / "font.bin";
  OutputFile file(target);
  file.write("whole");
  EXPECT_FALSE(std::filesystem::exists(target));
  file.commit();
  EXPECT_EQ(text_of(target), "whole");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"font.bin"}));
}

TEST(OutputFile, LeavesTheOldFileWithoutCommit) {
  const TestFolder folder;
  const std::filesystem::path target =
      folder.write("font.bin", std::vector<uint8_t>{'o', 'l', 'd'});
  {
    OutputFile file(target);
    file.write("new");
  }
  EXPECT_EQ(text_of(target), "old");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"font.bin"}));
}

TEST(OutputFile, RefusesPlacesThatCannotBe) {
  const TestFolder folder;
  EXPECT_THROW(OutputFile(folder.path() / "none" / "font.bin"), Error);
  EXPECT_THROW(OutputFile(folder.path()), Error);
}

RomFont small_font() {
  RomFont font;
  font.bytes = {0, 1, 200, 255};
  font.report.name = "Odd */ name\n#error\\";
  font.report.file_name = "odd.ttf";
  return font;
}

TEST(Encode, WritesHeaders) {
  const std::string text = encode(small_font(), OutputFormat::hpp, "odd");
  EXPECT_NE(text.find("alignas(4) inline constexpr uint8_t odd[4] = {\n"
                      "0,1,200,255,\n};"),
            std::string::npos);
  EXPECT_NE(text.find("static_assert(inkcell::reads_format("),
            std::string::npos);
  // Nothing that the font says ends the comment.
  EXPECT_EQ(text.find("\n#error"), std::string::npos);
  EXPECT_EQ(text.substr(0, 3), "// ");
}

TEST(Encode, WritesC) {
  const std::string text = encode(small_font(), OutputFormat::c, "odd");
  EXPECT_NE(text.find("const uint8_t odd[4] = {\n0,1,200,255,\n};"),
            std::string::npos);
  EXPECT_NE(text.find("const uint32_t odd_size = 4;"), std::string::npos);
  EXPECT_EQ(text.find("*/"), text.rfind("*/"));
}

TEST(Encode, WritesBinaries) {
  EXPECT_EQ(encode(small_font(), OutputFormat::bin, ""),
            std::string("\0\1\xc8\xff", 4));
}

TEST(Identifier, IsChecked) {
  for (const char* name : {"a", "_a9", "DejaVuSans"}) {
    EXPECT_NO_THROW(check_identifier(name));
  }
  for (const char* name : {"", "9a", "a-b", "a b", "a;", "\xc3\xa4"}) {
    EXPECT_THROW(check_identifier(name), Error) << name;
  }
}

TEST(Identifier, ComesFromTheFile) {
  EXPECT_EQ(identifier_of("/x/DejaVuSans-Bold.ttf"), "DejaVuSans_Bold");
  EXPECT_EQ(identifier_of("04b_03.ttf"), "font_04b_03");
  EXPECT_EQ(identifier_of("a.b.otf"), "a_b");
}

}  // namespace
}  // namespace inkcell::gen::test
