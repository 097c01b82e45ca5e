// Sources written by inkcell-fontgen: they compile, and arrays are in their
// sections.
#include <gtest/gtest.h>

#include "program_run.hpp"

namespace inkcell::gen::test {
namespace {

using ProgramSources = ProgramTest;

// Two headers and two C sources in one program, each array in its section.
TEST_F(ProgramSources, PutsArraysIntoSections) {
  for (const char* options :
       {"--format hpp --name a --section .ext_flash.a --out a.hpp",
        "--format hpp --name b --section .ext_flash.b --out b.hpp",
        "--format c --name c --section .ext_flash --out c.c",
        "--format c --name d --section .ext_flash --out d.c"}) {
    make(std::string("--font plain.ttf --symbols H --quiet ") + options);
  }
  folder_.write(
      "one.cpp",
      "#include \"a.hpp\"\nconst uint8_t* one() { return fonts::a; }\n");
  folder_.write(
      "main.cpp",
      "#include \"a.hpp\"\n#include \"b.hpp\"\n#include <string.h>\n"
      "extern \"C\" const uint8_t c[], d[];\n"
      "const uint8_t* one();\n"
      "int main() {\n"
      "  const size_t size = sizeof fonts::a;\n"
      "  return one() == fonts::a && !memcmp(fonts::a, fonts::b, size) &&\n"
      "         !memcmp(c, d, size) && !memcmp(c, fonts::b, size) ? 0 : 1;\n"
      "}\n");
  const std::string command =
      "cd '" + folder_.path().string() +
      "' && cc -std=c11 -Wall -Wextra -Wpedantic -Werror -c c.c d.c && "
      "c++ " +
      kCxxFlags + " -std=c++17 -Wall -Wextra -Wpedantic -Werror -I" +
      kSourceFolder +
      "/core/include -c one.cpp main.cpp && "
      "c++ " +
      kCxxFlags +
      " one.o main.o c.o d.o -o main && ./main && "
      "objdump -h main >sections";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (const char* section :
       {".ext_flash.a ", ".ext_flash.b ", ".ext_flash "}) {
    EXPECT_TRUE(contains(text_of("sections"), section)) << section;
  }
  EXPECT_EQ(run("--font plain.ttf --out a.bin --section .x").err,
            "error: --section: --format bin has no array; use hpp or c\n");
  for (const char* wrong : {"'a b'", "'a\"'", "'a\\b'", "''"}) {
    EXPECT_EQ(
        run(std::string("--font plain.ttf --out x.c --section ") + wrong).code,
        1)
        << wrong;
  }
}

TEST_F(ProgramSources, WritesSeveralFormsAtOnce) {
  make(
      "--font plain.ttf --symbols H --name plain --out a.hpp --out "
      "a.c --header a.h --out a.bin --depfile a.d --quiet");
  for (const std::string form : {"hpp", "c", "bin"}) {
    make(
        "--font plain.ttf --symbols H --name plain --out "
        "alone." +
        form + " --quiet");
    EXPECT_EQ(bytes_of(("a." + form)), bytes_of(("alone." + form)));
  }
  EXPECT_TRUE(begins_with(text_of("a.d"), "a.hpp a.c a.bin: "));
  const std::string refused =
      run("--font plain.ttf --out b.c --out b.bin --format c --quiet").err;
  EXPECT_TRUE(contains(refused, "leave --format out"));
}

// All supported compilers accept the generated sources.
TEST_F(ProgramSources, WritesSourcesThatCompile) {
  make(
      "--font plain.ttf --symbols H --format hpp --name plain "
      "--out plain.hpp --quiet");
  make(
      "--font plain.ttf --symbols H --format c --name plain_c "
      "--out plain.c --quiet");
  const std::string program =
      "#include \"plain.hpp\"\n#include \"inkcell/font.hpp\"\n"
      "#include <string.h>\n"
      "extern \"C\" const uint8_t plain_c[];\n"
      "extern \"C\" const uint32_t plain_c_size;\n"
      "static_assert(alignof(decltype(fonts::plain)) <= 4, \"\");\n"
      "int main() {\n"
      "  inkcell::Font font;\n"
      "  if (inkcell::Font::open(fonts::plain, font) != inkcell::Status::ok) "
      "return 1;\n"
      "  if (sizeof fonts::plain != plain_c_size) return 2;\n"
      "  return memcmp(fonts::plain, plain_c, plain_c_size) == 0 ? 0 : 3;\n"
      "}\n";
  folder_.write("main.cpp", program);
  const std::string command =
      "cd '" + folder_.path().string() +
      "' && cc -std=c11 -Wall -Wextra -Wpedantic -Werror -c plain.c && "
      "c++ " +
      kCxxFlags + " -std=c++17 -Wall -Wextra -Werror -I" + kSourceFolder +
      "/core/include main.cpp plain.o " + kCoreLibrary + " -o main && ./main";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(ProgramSources, WritesAFontForStorageAndItsNumbers) {
  const std::string font = "--font plain.ttf --paged 512 --name a --quiet ";
  for (const std::string name : {"a.hpp", "a.h", "a.c"}) {
    const Outcome result = run(font + "--out " + name);
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err,
              "error: " + name +
                  ": a font of --paged is read from storage, and no array of a "
                  "program; write the font to --out a.bin and its numbers to "
                  "--header a.hpp, or leave --paged out\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / name));
  }
  make(font + "--out a.bin --header a.hpp");
  const std::string header = text_of("a.hpp");
  for (const std::string& line :
       {std::string("namespace a {"),
        "kFileBytes = " + std::to_string(bytes_of("a.bin").size()) + ";",
        std::string("kBlockBytes = 512;")}) {
    EXPECT_TRUE(contains(header, line));
  }
}

// A header of C++ that is included in C names the remedy.
TEST_F(ProgramSources, TellsAProgramInCWhatToMake) {
  make("--font plain.ttf --symbols H --out plain.h --quiet");
  const std::string line = "#include \"plain.h\"\n";
  folder_.write("main.c", line);
  const std::string command =
      "cd '" + folder_.path().string() +
      "' && ! cc -fsyntax-only main.c 2>said && "
      "grep -q -e '--out plain.c --header plain.h' said";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace inkcell::gen::test
