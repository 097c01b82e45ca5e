// Files by a pattern.
#include "texts/file_pattern.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {
namespace {

class FilePattern : public testing::Test {
 protected:
  FilePattern() {
    for (const char* name :
         {"a.c", "b.cpp", "x/c.c", "x/y/d.c", "x/.git/e.c", ".f.c"}) {
      folder_.write(name, "");
    }
    // A cycle of links.
    std::filesystem::create_directory_symlink("..", folder_.path() / "x/up");
  }

  // Names below the folder, joined by blanks.
  std::string match(const std::string& pattern) const {
    std::string out;
    for (const auto& file :
         matching_files((folder_.path() / pattern).string(), "--o")) {
      out += (out.empty() ? "" : " ") +
             file.lexically_relative(folder_.path()).string();
    }
    return out;
  }

  TestFolder folder_;
};

TEST_F(FilePattern, Matches) {
  EXPECT_EQ(match("*.c"), "a.c");
  EXPECT_EQ(match("*"), "a.c b.cpp");
  EXPECT_EQ(match("**/*.c"), "a.c x/c.c x/y/d.c");
  EXPECT_EQ(match("**/**/*.c"), "a.c x/c.c x/y/d.c");
  EXPECT_EQ(match("x/**/d.c"), "x/y/d.c");
  EXPECT_EQ(match("x/*/*.c"), "x/up/a.c x/y/d.c");
  EXPECT_EQ(match("[ab].*"), "a.c b.cpp");
  EXPECT_EQ(match("[!b].*"), "a.c");
  EXPECT_EQ(match("[^a].*"), "b.cpp");
  EXPECT_EQ(match("[a-c].c*"), "a.c b.cpp");
  EXPECT_EQ(match("[].a].c"), "a.c");
  EXPECT_EQ(match("*.*p*"), "b.cpp");
  EXPECT_EQ(match("?.c"), "a.c");
  EXPECT_EQ(match("a.c"), "a.c");
  EXPECT_EQ(match("./x/../a.c"), "a.c");
  EXPECT_EQ(match(".?.c"), ".f.c");
  EXPECT_EQ(match("x/.git/*"), "x/.git/e.c");
}

TEST_F(FilePattern, RefusesWhatMatchesNothing) {
  for (const char* pattern :
       {"none.c", "*.rs", "[a", "[c-z].*", "**/none", "x", "**", ""}) {
    EXPECT_THROW(match(pattern), Error) << pattern;
  }
}

}  // namespace
}  // namespace inkcell::gen::test
