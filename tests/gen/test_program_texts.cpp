// inkcell-fontgen with strings and sources: results and errors.
#include <gtest/gtest.h>

#include <filesystem>

#include "program_run.hpp"

namespace inkcell::gen::test {
namespace {

constexpr char kSans[] =
    "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf ";

using ProgramTexts = ProgramTest;

TEST_F(ProgramTexts, TakesCharactersOfSources) {
  folder_.write("src/a.c", "f(\"H\"); // .\n");
  folder_.write("src/sub/b.cpp", "g(u8\"\\x2e\", 'x');");
  folder_.write("src/sub/c.txt", "\"no\"");
  const std::string out = "--font plain.ttf --out a.bin --report a.json ";
  make(out +
       "--strings-from 'src/**/*.c*' --strict --quiet "
       "--depfile a.d");
  EXPECT_EQ(read_report().at("characters"), 3);  // with a space
  const std::string folder = folder_.path().string();
  EXPECT_TRUE(begins_with(text_of("a.d"), "a.bin: " + folder + "/plain.ttf " +
                                              folder + "/src/a.c " + folder +
                                              "/src/sub/b.cpp\n"));
  // A shell expands a pattern to several files.
  make(out + "--strings-from src/a.c src/sub/b.cpp --quiet");
  EXPECT_EQ(read_report().at("characters"), 3);
  make(out + "--strings-from src/a.c --quiet --no-layout-glyphs");
  EXPECT_EQ(read_report().at("characters"), 2);
}

TEST_F(ProgramTexts, TellsWhatNeedsShapingAndIsNot) {
  const std::string out = "--font plain.ttf --out a.hpp --quiet ";
  const auto said = [&](const std::string& options) {
    const std::string err = run(out + options).err;
    const size_t first = err.find(" is drawn unshaped, from ");
    const size_t end = err.find(" on: ", first);
    return first == std::string::npos
               ? std::string()
               : err.substr(err.rfind('\n', first) + 1,
                            end - err.rfind('\n', first) - 1);
  };
  folder_.write("plain.txt", "H\n\n.\n");
  folder_.write("arabic.txt", "H\n\nH \u0633.\n");
  folder_.write("a.c", "f(\"H\");\ng(\"\u0928\u092e\u0938\u094d\");\n");
  folder_.write("ui.txt", "title = \u0633H\n");
  EXPECT_EQ(said("--text-file plain.txt"), "");
  EXPECT_EQ(said("--text-file plain.txt --text-file arabic.txt"),
            "warning: arabic.txt:3: Arabic is drawn unshaped, from U+0633 "
            "'\u0633'");
  EXPECT_EQ(said("--strings-from a.c"),
            "warning: a.c:2: Devanagari is drawn unshaped, from U+094D "
            "'\u25cc\u094d'");
  EXPECT_EQ(said("--symbols H\u0633"),
            "warning: Arabic is drawn unshaped, from U+0633 '\u0633'");
  // What the device shapes, but no other script.
  const std::string arabic =
      std::string(kSans) + "--out a.bin --quiet --min-px 16 --max-px 16 ";
  EXPECT_FALSE(
      contains(run(arabic + "--symbols H\u0633 --shape arab").err, "unshaped"));
  EXPECT_TRUE(contains(run(arabic + "--symbols H\u0633 --shape latn").err,
                       "warning: Arabic is drawn unshaped, from U+0633"));
  EXPECT_TRUE(contains(run(arabic + "--symbols H --shape arab").err,
                       "has no rules of --shape arab for the characters"));
  // What is shaped, and what is a list of characters.
  EXPECT_EQ(said("--strings ui.txt --chars H"), "");
  EXPECT_EQ(said("--chars H,0x633"), "");
}

TEST_F(ProgramTexts, TakesNamedSets) {
  const std::string out = "--font plain.ttf --out a.bin --quiet ";
  make(out + "--set ascii --set greek,cyrillic");
  const std::string strict = run(out + "--set ascii --strict").err;
  EXPECT_TRUE(contains(strict, "\n  --set: U+0021 '!'\n"));
  const std::string unknown = run(out + "--set ascii,latin1").err;
  EXPECT_TRUE(begins_with(unknown,
                          "error: --set: 'latin1' is not known; there are "
                          "ascii, latin-1, "));
}

TEST_F(ProgramTexts, SaysWhatLanguagesCost) {
  folder_.write("po/de.po", "msgid \"x\"\nmsgstr \"Aä\"\n");
  folder_.write("po/pl.po",
                "msgid \"x\"\nmsgstr \"Ał\"\n\nmsgid \"y\"\n"
                "msgstr \"B中\"\n");
  folder_.write("a.c", "f(\"B\");\n");
  const Outcome result =
      make(kSans + std::string("--strings-from 'po/*.po' a.c "
                               "--out a.bin --report a.json"));
  const nlohmann::json json = read_report();
  const auto bytes = [&json](const std::string& glyphs) {
    size_t sum = 0;
    for (const char c : glyphs) {
      const std::string key = c == 'a'   ? "ä"
                              : c == 'l' ? "ł"
                                         : std::string(1, c);
      sum += json.at("bytes_per_glyph").at(key).get<size_t>();
    }
    return sum;
  };
  const nlohmann::json expected = {{"de",
                                    {{"characters", "Aä"},
                                     {"missing", 0},
                                     {"bytes", bytes("Aa")},
                                     {"bytes_alone", bytes("a")}}},
                                   {"pl",
                                    {{"characters", "ABł中"},
                                     {"missing", 1},
                                     {"bytes", bytes("ABl")},
                                     {"bytes_alone", bytes("l")}}}};
  EXPECT_EQ(json.at("languages"), expected);
  EXPECT_TRUE(contains(result.out,
                       "language        de: 2 characters, " +
                           std::to_string(bytes("Aa")) + " bytes of glyphs, " +
                           std::to_string(bytes("a")) + " for it alone\n"));
  EXPECT_TRUE(contains(result.out, "for it alone; 1 missing\n"));
  check_refused(kSans + std::string("--strings-from 'po/*.po' --out b.bin "
                                    "--strict"),
                "  po/pl.po:5: U+4E2D '中'\n");
}

TEST_F(ProgramTexts, TakesTheGlyphsOfStringsAlone) {
  folder_.write("ui.txt", "fi = fi\nlam_alef [ar] = \u0644\u0627\n");
  make(kSans + std::string("--strings ui.txt --name ui "
                           "--out a.hpp --report a.json "
                           "--strict --quiet"));
  // .notdef and two ligatures, which have no character in the text.
  EXPECT_EQ(read_report().at("glyphs"), 3);
  EXPECT_EQ(read_report().at("characters"), 0);
  EXPECT_EQ(read_report().at("bytes").at("kerning"), 0);
  const std::string text = text_of("a.hpp");
  EXPECT_TRUE(contains(text, "namespace ui_strings {"));
  EXPECT_TRUE(contains(text, "ShapedGlyph fi[1] = {"));
  EXPECT_TRUE(
      contains(text, "ShapedRun lam_alef = {\n    ui_glyphs::lam_alef, "));
}

TEST_F(ProgramTexts, KeepsCodePointsOfPlainGlyphs) {
  folder_.write("ui.txt", "a = AV\nb = V fi\n");
  const std::string out = "--strings ui.txt --out a.c --report a.json --quiet ";
  make(kSans + out);
  EXPECT_EQ(read_report().at("characters"), 2);
  EXPECT_EQ(read_report().at("glyphs"), 4);
  EXPECT_EQ(read_report().at("bytes").at("kerning"), 0);
  // Characters that are asked for kern, those of strings alone do not.
  make(kSans + out + "--symbols AV");
  EXPECT_EQ(read_report().at("characters"), 5);
  EXPECT_NE(read_report().at("bytes").at("kerning"), 0);
}

TEST_F(ProgramTexts, IsTheSameEveryTime) {
  folder_.write("ui.txt", "a = Office\nb [ar] = \u0633\u0644\u0627\u0645\n");
  for (const char* threads : {"1", "4"}) {
    make(kSans +
         std::string("--strings ui.txt --quiet "
                     "--name ui --threads ") +
         threads + " --out " + threads + ".hpp");
  }
  EXPECT_EQ(text_of("1.hpp"), text_of("4.hpp"));
}

TEST_F(ProgramTexts, WarnsOrFailsForMissingCharacters) {
  folder_.write("ui.txt", "# one\na = H\nb = H\u4e2d\n");
  folder_.write("m.c", "f(\"H\");\nf(\"H\"\n  \"\u4e00\");\n");
  folder_.write("t.txt", "H.\n\u4e03");
  const struct {
    const char* options;
    const char* place;
  } cases[] = {
      {"--strings ui.txt --format hpp", "  ui.txt:3: U+4E2D '\u4e2d'\n"},
      {"--strings-from m.c", "  m.c:3: U+4E00 '\u4e00'\n"},
      {"--text-file t.txt", "  t.txt:2: U+4E03 '\u4e03'\n"},
      {"--symbols H\u4e09", "  --symbols: U+4E09 '\u4e09'\n"},
      {"--chars 0x48,0x4e5d", "  --chars: U+4E5D '\u4e5d'\n"}};
  for (const auto& wrong : cases) {
    const std::string options =
        std::string("--font plain.ttf --out a --quiet ") + wrong.options;
    check_refused(options + " --strict",
                  "plain.ttf: 1 character is not in the font:\n" +
                      std::string(wrong.place) + "use a font that has them");
    const Outcome result = make(options);
    EXPECT_TRUE(
        begins_with(result.err, "warning: plain.ttf: 1 character is not in"));
    std::filesystem::remove(folder_.path() / "a");
  }
  check_refused("--font plain.ttf --out a --strict", "  ...\nuse a font");
}

TEST_F(ProgramTexts, RefusesWhatCannotBe) {
  folder_.write("ui.txt", "a = H\n");
  folder_.write("empty.txt", "# nothing\n");
  folder_.write("wrong.txt", "a = H\nb\n");
  folder_.write("far.txt", "a = H" + std::string(200, ' ') + "H\n");
  folder_.write("lost.txt", "a = \u4e2d\n");
  folder_.write("latin.c", "f(\"\xfc\");");
  folder_.write("number.c", "int a;");
  folder_.write("a.json", "{");
  const std::string out = "--font plain.ttf --out a.hpp ";
  check_refused(out + "--strings none.txt",
                "none.txt: cannot be read; check the --strings");
  check_refused(out + "--strings .", "is a folder; give --strings a file");
  check_refused(out + "--strings empty.txt", "empty.txt: holds no strings");
  check_refused(out + "--strings wrong.txt", "wrong.txt:2: there is no '='");
  check_refused(out + "--strings ui.txt --strings ui.txt",
                "ui.txt:1: 'a' is defined in ui.txt:1, too");
  check_refused(out + "--strings far.txt", "far.txt:1: two glyphs of 'a' are ");
  check_refused(out + "--strings lost.txt", "holds none of the 1 character");
  check_refused("--font plain.ttf --out a.bin --strings ui.txt",
                "--format bin has no place for runs");
  check_refused(out + "--strings-from '*.rs'", "no file matches '*.rs'");
  check_refused(out + "--strings-from latin.c",
                "latin.c:1: the string is not UTF-8");
  check_refused(out + "--strings-from number.c", "no characters asked for");
  check_refused(out + "--strings-from a.json", "a.json:1: the JSON is wrong");
  check_refused(out + "--header a.h", "--header is for --format c");
  check_refused("--font plain.ttf --out a.c --header ./a.c",
                "would be written twice");
  check_refused("--font plain.ttf --out a.c --header ui.txt --strings ui.txt",
                "is read, too");
  check_refused("--font plain.ttf --out latin.c --strings-from latin.c",
                "is read, too");
}

}  // namespace
}  // namespace inkcell::gen::test
