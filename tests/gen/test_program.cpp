// inkcell-fontgen: options, exit codes, output files.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <png.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "program_run.hpp"

namespace inkcell::gen::test {
namespace {

using Program = ProgramTest;

TEST_F(Program, WritesFontAndReport) {
  const Outcome result =
      make("--font plain.ttf --symbols .H --out a.bin --report a.json");
  EXPECT_FALSE(contains(result.err, "warning"));
  EXPECT_TRUE(contains(result.out, "total"));
  EXPECT_EQ(folder_.names(), (Names{"a.bin", "a.json", "plain.ttf"}));
  const std::vector<uint8_t> bytes = bytes_of("a.bin");
  const auto report = read_report();
  EXPECT_EQ(report.at("bytes").at("total"), bytes.size());
  EXPECT_EQ(report.at("min_px"), 8);
  EXPECT_EQ(report.at("max_px"), 64);
  EXPECT_EQ(report.at("tolerance"), 16);
}

TEST_F(Program, IsQuietWhenTold) {
  const Outcome result =
      make("--font plain.ttf --symbols H --out a.bin --quiet");
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Program, TellsHowFarItIsFromTheBeginning) {
  const Outcome piped = make("--font plain.ttf --symbols .H --out a.bin");
  EXPECT_TRUE(begins_with(piped.err, "  0 %: 0 of 4 glyphs\n"));
  const Outcome budget =
      run("--font plain.ttf --symbols .H --budget 64K --out a.bin");
  EXPECT_TRUE(
      begins_with(budget.err, "  0 %: 0 of 4 glyphs\ntolerance 64/255: "));
  // script(1) gives the program a terminal, where the machine has any.
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) {
    GTEST_SKIP() << "there are no pseudo-terminals here";
  }
  close(terminal);
  const TestFolder logs;
  const std::string log = (logs.path() / "log").string();
  const std::string command =
      "cd '" + folder_.path().string() + "' && script -qec '" + kFontgen +
      " --font plain.ttf --symbols .H --out a.bin' /dev/null >'" + log + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string shown = read_text(log);
  EXPECT_TRUE(
      begins_with(shown, "\r[" + std::string(40, '.') + "] 0/4 glyphs \033[K"));
  EXPECT_TRUE(contains(shown, "\r\033[K"));
}

TEST_F(Program, GivesTheSameBytesEveryTime) {
  for (const char* threads : {"1", "2", "4"}) {
    make(std::string("--font plain.ttf --quiet --threads ") + threads +
         " --out " + threads + ".bin");
  }
  const std::vector<uint8_t> one = bytes_of("1.bin");
  EXPECT_EQ(bytes_of("2.bin"), one);
  EXPECT_EQ(bytes_of("4.bin"), one);
}

TEST_F(Program, SharesTheGlyphsOfAFont) {
  const std::string font =
      "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols "
      "'aegß.H' --quiet --out ";
  make(font + "whole.bin");
  for (const char* part : {"0/2", "1/2"}) {
    const std::string name(part, 1);
    const Outcome result = make(font + name + ".glyphs --part " + part);
    EXPECT_EQ(result.out + result.err, "");
  }
  const auto merged = [&](const std::string& options) {
    const Outcome result = make(font + "merged.bin " + options);
    return bytes_of("merged.bin");
  };
  const std::vector<uint8_t> whole = bytes_of("whole.bin");
  EXPECT_EQ(merged("--built 0.glyphs --built 1.glyphs"), whole);
  EXPECT_EQ(merged("--built 1.glyphs"), whole);
  // Glyphs of other settings are of no use, and do no harm.
  EXPECT_NE(merged("--built 1.glyphs --max-px 20"), whole);

  folder_.write("bad.glyphs", std::vector<uint8_t>{'I', 'N', 'K'});
  for (const auto& [options, reason] :
       std::vector<std::pair<const char*, const char*>>{
           {"--built bad.glyphs", "bad.glyphs: no glyphs that this version"},
           {"--built none.glyphs", "none.glyphs: cannot be read"},
           {"--part 2/2", "'2/2' is no part"},
           {"--part /2", "'/2' is no part"},
           {"--part 1", "'1' is no part"},
           {"--part 0/2 --coding field", "--part: glyphs of outlines"}}) {
    check_refused(font + "c.bin " + options, reason);
  }
}

TEST_F(Program, TakesEveryOption) {
  const Outcome result = make(
      "--font plain.ttf --face 0 --chars 0x2E --chars 'U+48,0x20' --min-px 10 "
      "--max-px 20 --tolerance 12/255 --coding field "
      "--predicate size --effort 3 --format c --name dot --out a.c --report "
      "a.json");
  const auto report = read_report();
  EXPECT_EQ(report.at("tolerance"), 12);
  EXPECT_EQ(report.at("effort"), 3);
  EXPECT_EQ(report.at("characters"), 3);
}

TEST_F(Program, ListsTakeWhatTheirHelpShows) {
  constexpr std::string_view kIcon =
      "<svg viewBox='0 0 24 24'><path d='M4 4h16v16h-16z'/></svg>";
  for (const char* name : {"a.svg", "b.svg"}) {
    folder_.write(name, std::string(kIcon));
  }
  folder_.write("b.ttf", Sfnt::plain());
  folder_.write("c.ttf", Sfnt::plain());
  const struct {
    const char* options;
    size_t icons;
  } cases[] = {
      {"--svg a.svg=0xE001 b.svg=0xE002", 2},
      {"--svg a.svg=0xE001 --svg b.svg=0xE002", 2},
      {"--svg-dir . --font plain.ttf --merge b.ttf c.ttf --symbols H", 2},
      {"--font plain.ttf --chars 0x2E --chars U+48", 0}};
  for (const auto& list : cases) {
    const Outcome made = run(std::string(list.options) +
                             " --max-px 16 --quiet --out a.bin "
                             "--report a.json");
    ASSERT_EQ(made.code, 0) << list.options << ": " << made.err;
    const auto report = read_report();
    EXPECT_EQ(report.value("icons", nlohmann::json::object()).size(),
              list.icons)
        << list.options;
  }
  const std::string help = run("--help").out;
  EXPECT_TRUE(contains(help, "--svg FILE=CODE ..."));
  EXPECT_TRUE(contains(help, "--chars LIST  "));
  EXPECT_LT(help.find("  --font FILE"), help.find("  --colour"));
}

TEST_F(Program, NamesTheFaceThatItTakes) {
  folder_.write("two.ttc", build_collection({Sfnt::plain(), Sfnt::plain()}));
  const std::string rest = " --symbols H --quiet --out a.bin";
  const std::string said = "warning: two.ttc: holds 2 faces; number 0, ";
  const Outcome first = make("--font two.ttc" + rest);
  EXPECT_TRUE(begins_with(first.err, said));
  EXPECT_TRUE(
      contains(first.err,
               "is taken; --face, or face=N after a file of --merge, takes "
               "another one: 1 "));
  EXPECT_EQ(run("--font two.ttc --face 0" + rest).err, "");
  EXPECT_EQ(run("--font two.ttc --face 1" + rest).err, "");
  EXPECT_EQ(run("--font plain.ttf" + rest).err, "");
  const std::string merging =
      "--font two.ttc --face 1 --chars 0x2E --quiet --out a.bin --merge ";
  EXPECT_TRUE(begins_with(run(merging + "two.ttc=0x48").err, said));
  EXPECT_EQ(run(merging + "two.ttc:face=0=0x48").err, "");
}

TEST_F(Program, EffortIsForCells) {
  const auto report = [&](const std::string& options) {
    const Outcome made = make(
        "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols "
        "a8 --max-px 24 --quiet --out a.bin --report a.json " +
        options);
    return read_report();
  };
  EXPECT_FALSE(report("--effort 9").contains("effort"));
  const auto little = report("--coding field --effort 0");
  const auto much = report("--coding field --effort 9");
  EXPECT_EQ(much.at("effort"), 9);
  EXPECT_GT(little.at("bytes").at("total"), much.at("bytes").at("total"));
  const std::string help = run("--help").out;
  EXPECT_TRUE(contains(help, "(field) How hard"));
}

TEST_F(Program, WidensTheBandAndSaysWhatItCosts) {
  const std::string font =
      "--font plain.ttf --symbols H --coding field --min-px 12 --out a.bin "
      "--report a.json ";
  make(font);
  EXPECT_EQ(read_report().at("band_u"), 768 / 12);
  EXPECT_FALSE(read_report().contains("band_bytes"));
  const int usual = read_report().at("bytes").at("total");
  const Outcome wide = make(font + "--band-px 2");
  EXPECT_EQ(read_report().at("band_u"), 2048 / 12);
  const int bytes = read_report().at("bytes").at("total");
  EXPECT_EQ(read_report().at("band_bytes"), bytes - usual);
  EXPECT_TRUE(contains(wide.out, "band "));
  for (const char* refused : {"0.4", "3", "-1", "nan"}) {
    EXPECT_EQ(run(font + "--band-px " + refused).code, 1) << refused;
  }
  EXPECT_EQ(run(font + "--coding field --predicate fixed --band-px 1").code, 1);
}

TEST_F(Program, MakesEveryKindOfFont) {
  const struct {
    const char* options;
    const char* coding;
  } kinds[] = {{"", "outline"},
               {"--coding outline", "outline"},
               {"--coding field", "field"},
               {"--coding field --predicate fixed", "field"}};
  for (const auto& kind : kinds) {
    const Outcome result =
        make(std::string("--font plain.ttf --out a.bin --report a.json ") +
             kind.options);
    const auto report = read_report();
    EXPECT_EQ(report.at("coding"), kind.coding) << kind.options;
  }
}

TEST_F(Program, SaysWhichInstanceOfAVariableFontItMakes) {
  Sfnt source = Sfnt::plain();
  source.wght_shift = 100;
  source.instances = {{"Regular", 400}, {"Bold", 700}};
  folder_.write("a.ttf", source);
  const std::string font =
      "--font a.ttf --symbols H --out a.bin --report a.json ";
  const Outcome usual = make(font + "--quiet");
  EXPECT_EQ(usual.err,
            "note: a.ttf: is a variable font, taken at its default, wght 400 "
            "of 100..900 (Regular); choose with --instance NAME or --axis "
            "TAG=VALUE, instances: Regular, Bold\n");
  for (const char* chosen :
       {"--instance Regular", "--instance Bold", "--axis wght=700"}) {
    const Outcome result = make(font + "--quiet " + chosen);
    EXPECT_EQ(result.err, "") << chosen;
  }
  const auto face = read_report().at("faces").at(0);
  EXPECT_EQ(face.at("file"), "a.ttf");
  EXPECT_EQ(face.at("instance"), "Bold");
  EXPECT_EQ(face.at("axes").at("wght"),
            nlohmann::json::parse("{\"min\": 100, \"default\": 400, "
                                  "\"max\": 900, \"value\": 700}"));
  EXPECT_TRUE(contains(run(font + "--instance bold").out,
                       "instance        a.ttf: wght 700 of 100..900 (Bold)"));
}

TEST_F(Program, RefusesOptionsThatDoNotGoTogether) {
  const struct {
    const char* options;
    const char* remedy;
  } cases[] = {{"--predicate fixed", "use --coding field"},
               {"--coding edges", "use 'outline' or 'field'"},
               {"--coding bitmaps", "use 'outline' or 'field'"},
               {"--predicate best", "use 'size' or 'fixed'"}};
  for (const auto& wrong : cases) {
    check_refused(std::string("--font plain.ttf --out a.bin ") + wrong.options,
                  wrong.remedy);
  }
  EXPECT_EQ(folder_.names(), (Names{"plain.ttf"}));
}

TEST_F(Program, RefusesWrongOptions) {
  for (const char* options :
       {"",
        "--out a.bin",
        "--font plain.ttf",
        "--font plain.ttf --out x/a.bin",
        "--font plain.ttf --out .",
        "--font plain.ttf --out plain.ttf",
        "--font plain.ttf --out a.bin --report ./a.bin",
        "--font plain.ttf --out a.bin --depfile plain.ttf",
        "--font plain.ttf --out a.bin --text-file .",
        "--font plain.ttf --out a.bin --name new",
        "--font none.ttf --out a.bin",
        "--font plain.ttf --out a.bin --tolerance 0",
        "--font plain.ttf --out a.bin --tolerance 16/256",
        "--font plain.ttf --out a.bin --tolerance x",
        "--font plain.ttf --out a.bin --effort -1",
        "--font plain.ttf --out a.bin --effort 10",
        "--font plain.ttf --out a.bin --min-px 3",
        "--font plain.ttf --out a.bin --max-px 1025",
        "--font plain.ttf --out a.bin --min-px 30 --max-px 20",
        "--font plain.ttf --out a.bin --format svg",
        "--font plain.ttf --out a.bin --name 9",
        "--font plain.ttf --out a.bin --face 1",
        "--font plain.ttf --out a.bin --axis wght=600",
        "--font plain.ttf --out a.bin --chars 0x4E00",
        "--font plain.ttf --out a.bin --chars 0xZZ",
        "--font plain.ttf --out a.bin --text-file none.txt",
        "--font plain.ttf --out a.bin --report x/a.json",
        "--font plain.ttf --out a.bin --nonsense"}) {
    const Outcome result = run(options);
    EXPECT_NE(result.code, 0) << options;
    EXPECT_NE(result.err + result.out, "") << options;
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"})) << options;
  }
}

TEST_F(Program, SaysWhatWouldDo) {
  EXPECT_TRUE(contains(run("--font . --out a.bin").err, "name a file"));
  EXPECT_TRUE(contains(run("--font plain.ttf --out a.bin --chars 0x4E00").err,
                       "none of the 1 character asked for"));
  EXPECT_TRUE(contains(run("--font plain.ttf --out a.bin --format svg").err,
                       "use 'bin', 'hpp' or 'c'"));
}

TEST_F(Program, NamesSizesThatItRefuses) {
  const struct {
    const char* options;
    const char* said;
  } cases[] = {{"--min-px 30 --max-px 20", "--min-px 30 is above --max-px 20"},
               {"--min-px 70", "--min-px 70 is above --max-px 64"},
               {"--min-px 12.5",
                "--min-px 12.5: sizes are whole numbers within 4..1024"},
               {"--max-px 2000", "--max-px 2000: sizes are whole numbers"}};
  for (const auto& wrong : cases) {
    check_refused(std::string("--font plain.ttf --out a.bin ") + wrong.options,
                  wrong.said);
  }
  EXPECT_TRUE(contains(run("--help").out, "--min-px INT=8"));
}

TEST_F(Program, DrawsAPreview) {
  const Outcome result = make(
      "--font plain.ttf --symbols .H --quiet --out a.bin --preview "
      "a.png");
  const std::vector<uint8_t> png = bytes_of("a.png");
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&picture, png.data(), png.size()),
            0);
  picture.format = PNG_FORMAT_GRAY;
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(picture));
  ASSERT_NE(png_image_finish_read(&picture, nullptr, pixels.data(), 0, nullptr),
            0);
  // .notdef, the space, the point and H in a row, each with two numbers below.
  EXPECT_EQ(picture.width, 4u * 80);
  for (uint32_t glyph = 0; glyph < 4; ++glyph) {
    const auto is_drawn = [&](uint32_t top, uint32_t bottom, uint8_t ink) {
      for (uint32_t y = top; y < bottom; ++y) {
        for (uint32_t x = 80 * glyph; x < 80 * (glyph + 1); ++x) {
          if (pixels[y * picture.width + x] == ink) {
            return true;
          }
        }
      }
      return false;
    };
    EXPECT_EQ(is_drawn(0, 74, 0), glyph != 1) << glyph;
    EXPECT_TRUE(is_drawn(76, 86, 96)) << glyph;
    EXPECT_TRUE(is_drawn(89, 99, 96)) << glyph;
  }
  EXPECT_EQ(run("--font plain.ttf --out b.bin --preview b.bin").code, 1);
}

TEST_F(Program, FindsTheFinestFontThatFits) {
  // Refitting needs curves: a few letters of a real face.
  const std::string font =
      "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols SCo "
      "--hints off --min-px 12 --max-px 24 --out a.bin --report a.json ";
  const auto made = [&](const std::string& options) {
    const Outcome result = make(font + options);
    const auto report = read_report();
    return std::pair<int, int>(report.at("tolerance"),
                               report.at("bytes").at("total"));
  };
  const int budget = made("--tolerance 16 --quiet").second;
  const auto [tolerance, bytes] =
      made("--quiet --budget " + std::to_string(budget));
  EXPECT_LE(tolerance, 16);
  EXPECT_LE(bytes, budget);
  const Outcome refused = run(font + "--budget 100");
  EXPECT_EQ(refused.code, 1);
  EXPECT_TRUE(contains(refused.err, "tolerance 64/255: "));
  EXPECT_TRUE(contains(refused.err, "Most bytes: U+"));
  for (const char* wrong :
       {"0", "x", "5G", "24KB", "-1", "9999999M", "24K --tolerance 16"}) {
    EXPECT_EQ(run(font + "--budget " + wrong).code, 1) << wrong;
  }
}

// Samples of corners at these sizes miss 16/255, and more so 1/255.
constexpr const char* kCoarse =
    "--coding field --effort 0 --min-px 1000 --max-px 1024 --quiet --out "
    "a.bin ";

TEST_F(Program, HoldsAToleranceThatIsWritten) {
  const std::string font =
      std::string("--font plain.ttf --symbols . ") + kCoarse + "--tolerance ";
  for (const char* tolerance : {"15", "16"}) {
    check_refused(font + tolerance, "or allow misses with --best-effort");
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"}));
  }
  const Outcome made = make(font + "16 --best-effort");
  EXPECT_TRUE(begins_with(made.err, "warning: plain.ttf: "));
}

TEST_F(Program, AimsAtTheDefaultTolerance) {
  const std::string font = std::string("--font plain.ttf --symbols . ") +
                           kCoarse + "--report a.json ";
  for (const char* options : {"", "--best-effort", "--budget 64K"}) {
    const Outcome made = make(font + options);
    EXPECT_TRUE(begins_with(made.err, "warning: plain.ttf: "));
    EXPECT_TRUE(contains(made.err, "drawn as well as possible"));
    const auto report = read_report();
    EXPECT_EQ(report.at("tolerance"), 16) << options;
    EXPECT_FALSE(report.at("missed").empty());
  }
}

TEST_F(Program, NoIconFailsAFolder) {
  for (const char* icon : {"M4 4h16v16h-16z", "M12 1L22 12 12 23 3 12z"}) {
    const std::string svg =
        std::string("<svg viewBox='0 0 24 24'><path d='") + icon + "'/></svg>";
    folder_.write(icon[1] == '4' ? "a.svg" : "b.svg", svg);
  }
  const Outcome made = make(std::string("--svg-dir . ") + kCoarse);
  EXPECT_TRUE(contains(made.err, "warning: 2 icons: "));
  EXPECT_TRUE(contains(made.err, "b.svg U+E001 "));
}

TEST_F(Program, WritesToNoStream) {
  for (const char* options :
       {"--out -", "--out - --format hpp", "--out a.bin --report -",
        "--out a.bin --depfile -"}) {
    const Outcome result =
        run(std::string("--font plain.ttf --symbols H ") + options);
    EXPECT_EQ(result.code, 1) << options;
    EXPECT_EQ(result.out, "") << options;
    EXPECT_TRUE(
        contains(result.err, "-: is not standard output here; name a file"));
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"})) << options;
  }
  make("--font plain.ttf --symbols H --out ./-");
  EXPECT_EQ(folder_.names(), (Names{"-", "plain.ttf"}));
}

TEST_F(Program, LeavesTheOldFileWhenItFails) {
  folder_.write("a.bin", std::vector<uint8_t>{'o', 'l', 'd'});
  EXPECT_EQ(run("--font plain.ttf --out a.bin --chars 0x4E00").code, 1);
  EXPECT_EQ(bytes_of("a.bin"), (std::vector<uint8_t>{'o', 'l', 'd'}));
  EXPECT_EQ(folder_.names(), (Names{"a.bin", "plain.ttf"}));
}

TEST_F(Program, GoesOnWithoutMissingCharacters) {
  const Outcome result =
      make("--font plain.ttf --chars H,0x4E00 --out a.bin --quiet");
  EXPECT_TRUE(begins_with(result.err, "warning: plain.ttf: 1 character"));
}

TEST_F(Program, MissesNoCharacterThatShowsNothing) {
  // A tab, a soft hyphen, a zero width space, an em space.
  const std::string text = "H\t.\xc2\xad\xe2\x80\x8b\xe2\x80\x83\n";
  folder_.write("a.txt", text);
  folder_.write("b.ttf", Sfnt::plain());
  for (const char* merged : {"", "--merge b.ttf "}) {
    const Outcome result =
        make(std::string("--font plain.ttf --text-file a.txt --strict "
                         "--quiet --out a.bin ") +
             merged);
    EXPECT_FALSE(contains(result.err, "not in the font"));
  }
}

TEST_F(Program, WritesDependencies) {
  folder_.write("t.txt", std::vector<uint8_t>{'H'});
  make(
      "--font plain.ttf --text-file t.txt --out 'a b.hpp' --format hpp "
      "--depfile a.d --quiet");
  const std::string folder = folder_.path().string();
  EXPECT_EQ(text_of("a.d"), "a\\ b.hpp: " + folder + "/plain.ttf " + folder +
                                "/t.txt\n" + folder + "/plain.ttf:\n" + folder +
                                "/t.txt:\n");
}

TEST_F(Program, FollowsTheEndingOfTheFile) {
  for (const char* name : {"a.hpp", "a.c"}) {
    const std::string options =
        std::string("--font plain.ttf --symbols H --quiet --out ") + name;
    make(options);
    const std::vector<uint8_t> source = bytes_of(name);
    make(options + " --format bin");
    const std::vector<uint8_t> bytes = bytes_of(name);
    const std::string_view magic = "INKC";
    EXPECT_TRUE(std::equal(magic.begin(), magic.end(), bytes.begin())) << name;
    EXPECT_FALSE(std::equal(magic.begin(), magic.end(), source.begin()))
        << name;
  }
}

TEST_F(Program, TakesAHeaderForCxx) {
  const std::string options = "--font plain.ttf --symbols H --quiet --out ";
  make(options + "plain.hpp");
  for (const char* name : {"plain.h", "plain.hh", "plain.hxx"}) {
    const Outcome result = make(options + name);
    EXPECT_EQ(bytes_of(name), bytes_of("plain.hpp"));
  }
}

TEST_F(Program, AsksWhichLanguageASourceIsIn) {
  for (const char* name : {"a.cpp", "a.cc", "a.cxx"}) {
    const std::string options =
        std::string("--font plain.ttf --symbols H --quiet --out ") + name;
    const Outcome result = run(options);
    EXPECT_EQ(result.code, 1) << name;
    EXPECT_EQ(result.err, "error: " + std::string(name) +
                              ": add --format hpp, for C++, or --format c\n");
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"}));
    make(options + " --format c");
    std::filesystem::remove(folder_.path() / name);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
