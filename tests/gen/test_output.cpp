// Output files appear whole or not at all; the source forms of a font.
#include <gtest/gtest.h>

#include "app/encode.hpp"
#include "app/output.hpp"

#include <sys/stat.h>

#include "base/error.hpp"
#include "files.hpp"
#include "messages.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {
namespace {

TEST(OutputFile, AppearsWithCommit) {
  const TestFolder folder;
  const std::filesystem::path target = folder.path() / "font.bin";
  OutputFile file(target);
  file.write("whole");
  EXPECT_FALSE(std::filesystem::exists(target));
  file.commit();
  EXPECT_EQ(read_text(target), "whole");
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
  EXPECT_EQ(read_text(target), "old");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"font.bin"}));
}

TEST(OutputFile, RefusesPlacesThatCannotBe) {
  const TestFolder folder;
  EXPECT_THROW(OutputFile(folder.path() / "none" / "font.bin"), Error);
  EXPECT_THROW(OutputFile(folder.path()), Error);
  EXPECT_THROW(OutputFile("-"), Error);
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(OutputFile(folder.path() / "pipe"), Error);
  EXPECT_THROW(OutputFile("/dev/null"), Error);
  std::filesystem::create_symlink("/dev/null", folder.path() / "null");
  EXPECT_THROW(OutputFile(folder.path() / "null"), Error);
  std::filesystem::create_symlink("loop", folder.path() / "loop");
  EXPECT_THROW(OutputFile(folder.path() / "loop"), std::runtime_error);
  std::filesystem::create_symlink("none/font.bin", folder.path() / "lost");
  EXPECT_THROW(OutputFile(folder.path() / "lost"), Error);
}

TEST(OutputFile, WritesWhereALinkPoints) {
  const TestFolder folder;
  const std::filesystem::path there = folder.path() / "there";
  std::filesystem::create_directory(there);
  std::filesystem::create_symlink("there/font.bin", folder.path() / "link");
  std::filesystem::create_symlink("link", folder.path() / "link2");
  // First without an old file, then with one.
  for (const char* content : {"first", "second"}) {
    OutputFile file(folder.path() / "link2");
    file.write(content);
    file.commit();
    EXPECT_EQ(read_text(there / "font.bin"), content);
  }
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link2"));
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"link", "link2", "there"}));
}

TEST(OutputFile, IsNoOtherFile) {
  const TestFolder folder;
  const std::filesystem::path& path = folder.path();
  const std::filesystem::path font =
      folder.write("font.ttf", std::vector<uint8_t>{0});
  std::filesystem::create_symlink("font.ttf", path / "link");
  std::filesystem::create_symlink("new.bin", path / "to_new");
  std::filesystem::create_symlink(".", path / "here");
  const std::filesystem::path out = path / "new.bin";
  EXPECT_NO_THROW(tools::check_apart({out, path / "new.json", ""}, {font, ""}));
  for (const std::filesystem::path& same :
       {font, path / "link", path / "." / "font.ttf",
        path / "here" / "font.ttf"}) {
    EXPECT_THROW(tools::check_apart({out, same}, {font}), std::runtime_error)
        << same;
  }
  for (const std::filesystem::path& same :
       {out, path / "to_new", path / "here" / "new.bin",
        path / "here" / ".." / path.filename() / "new.bin"}) {
    EXPECT_THROW(tools::check_apart({out, "", same}, {font}),
                 std::runtime_error)
        << same;
  }
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
  EXPECT_TRUE(contains(text,
                       "alignas(4) inline constexpr uint8_t odd[4] = {\n"
                       "0,1,200,255,\n};"));
  EXPECT_TRUE(contains(text, "static_assert(inkcell::reads_format("));
  // No text from the font ends the comment.
  EXPECT_EQ(text.find("\n#error"), text.rfind("\n#error \"this font is for"));
  EXPECT_EQ(text.substr(0, 3), "// ");
}

TEST(Encode, WritesC) {
  const std::string text = encode(small_font(), OutputFormat::c, "odd");
  EXPECT_TRUE(contains(text, "const uint8_t odd[4] = {\n0,1,200,255,\n};"));
  EXPECT_TRUE(contains(text, "const uint32_t odd_size = 4;"));
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
  for (const char* name :
       {"", "9a", "a-b", "a b", "a;", "\xc3\xa4", "new", "xor_eq", "alignas",
        "restrict", "reinterpret_cast", "typeof_unqual", "while", "_Bool"}) {
    EXPECT_THROW(check_identifier(name), Error) << name;
  }
}

TEST(Identifier, ComesFromTheFile) {
  EXPECT_EQ(identifier_of("/x/DejaVuSans-Bold.ttf"), "DejaVuSans_Bold");
  EXPECT_EQ(identifier_of("04b_03.ttf"), "font_04b_03");
  EXPECT_EQ(identifier_of("a.b.otf"), "a_b");
  EXPECT_EQ(identifier_of("new.ttf"), "font_new");
  EXPECT_EQ(identifier_of("news.ttf"), "news");
}

}  // namespace
}  // namespace inkcell::gen::test
