// inkcell-fontgen: options, exit codes, output files.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <png.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "program_run.hpp"

namespace inkcell::gen::test {
namespace {

using Names = std::vector<std::string>;

// Most tests use a font of a few rectangles: fast, and nothing to install.
class Program : public testing::Test {
 protected:
  Program() { folder_.write("plain.ttf", Sfnt::plain()); }

  TestFolder folder_;
};

TEST_F(Program, WritesFontAndReport) {
  const Outcome result =
      run(folder_, "--font plain.ttf --symbols .H --out a.bin --report a.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err.find("warning"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("total"), std::string::npos);
  EXPECT_EQ(folder_.names(), (Names{"a.bin", "a.json", "plain.ttf"}));
  const std::vector<uint8_t> bytes = read_file(folder_.path() / "a.bin");
  const auto report =
      nlohmann::json::parse(read_file(folder_.path() / "a.json"));
  EXPECT_EQ(report.at("bytes").at("total"), bytes.size());
  EXPECT_EQ(report.at("min_px"), 8);
  EXPECT_EQ(report.at("max_px"), 64);
  EXPECT_EQ(report.at("tolerance"), 16);
}

TEST_F(Program, IsQuietWhenTold) {
  const Outcome result =
      run(folder_, "--font plain.ttf --symbols H --out a.bin --quiet");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Program, TellsHowFarItIsFromTheBeginning) {
  const Outcome piped =
      run(folder_, "--font plain.ttf --symbols .H --out a.bin");
  EXPECT_EQ(piped.code, 0);
  EXPECT_EQ(piped.err.find("  0 %: 0 of 4 glyphs\n"), 0u) << piped.err;
  const Outcome budget =
      run(folder_, "--font plain.ttf --symbols .H --budget 64K --out a.bin");
  EXPECT_EQ(budget.err.find("  0 %: 0 of 4 glyphs\ntolerance 64/255: "), 0u)
      << budget.err;
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
  const std::vector<uint8_t> bytes = read_file(log);
  const std::string shown(bytes.begin(), bytes.end());
  EXPECT_EQ(shown.find("\r[" + std::string(40, '.') + "] 0/4 glyphs \033[K"),
            0u)
      << shown;
  EXPECT_NE(shown.find("\r\033[K"), std::string::npos) << shown;
}

TEST_F(Program, GivesTheSameBytesEveryTime) {
  for (const char* threads : {"1", "2", "4"}) {
    ASSERT_EQ(run(folder_, std::string("--font plain.ttf --quiet --threads ") +
                               threads + " --out " + threads + ".bin")
                  .code,
              0);
  }
  const std::vector<uint8_t> one = read_file(folder_.path() / "1.bin");
  EXPECT_EQ(read_file(folder_.path() / "2.bin"), one);
  EXPECT_EQ(read_file(folder_.path() / "4.bin"), one);
}

TEST_F(Program, SharesTheGlyphsOfAFont) {
  const std::string font =
      "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols "
      "'aegß.H' --quiet --out ";
  ASSERT_EQ(run(folder_, font + "whole.bin").code, 0);
  for (const char* part : {"0/2", "1/2"}) {
    const std::string name(part, 1);
    const Outcome result = run(folder_, font + name + ".glyphs --part " + part);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
  }
  const auto merged = [&](const std::string& options) {
    const Outcome result = run(folder_, font + "merged.bin " + options);
    EXPECT_EQ(result.code, 0) << result.err;
    return read_file(folder_.path() / "merged.bin");
  };
  const std::vector<uint8_t> whole = read_file(folder_.path() / "whole.bin");
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
    const Outcome result = run(folder_, font + "c.bin " + options);
    EXPECT_EQ(result.code, 1) << options;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
  }
}

TEST_F(Program, TakesEveryOption) {
  const Outcome result = run(
      folder_,
      "--font plain.ttf --face 0 --chars 0x2E --chars 'U+48,0x20' --min-px 10 "
      "--max-px 20 --tolerance 12/255 --coding field "
      "--predicate size --effort 3 --format c --name dot --out a.c --report "
      "a.json");
  EXPECT_EQ(result.code, 0) << result.err;
  const auto report =
      nlohmann::json::parse(read_file(folder_.path() / "a.json"));
  EXPECT_EQ(report.at("tolerance"), 12);
  EXPECT_EQ(report.at("effort"), 3);
  EXPECT_EQ(report.at("characters"), 3);
}

TEST_F(Program, ListsTakeWhatTheirHelpShows) {
  constexpr std::string_view kIcon =
      "<svg viewBox='0 0 24 24'><path d='M4 4h16v16h-16z'/></svg>";
  for (const char* name : {"a.svg", "b.svg"}) {
    folder_.write(name, std::vector<uint8_t>(kIcon.begin(), kIcon.end()));
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
    const Outcome made = run(folder_, std::string(list.options) +
                                          " --quiet --out a.bin "
                                          "--report a.json");
    ASSERT_EQ(made.code, 0) << list.options << ": " << made.err;
    const auto report =
        nlohmann::json::parse(read_file(folder_.path() / "a.json"));
    EXPECT_EQ(report.value("icons", nlohmann::json::object()).size(),
              list.icons)
        << list.options;
  }
  const std::string help = run(folder_, "--help").out;
  EXPECT_NE(help.find("--svg FILE=CODE ..."), std::string::npos);
  EXPECT_NE(help.find("--chars LIST  "), std::string::npos) << help;
}

TEST_F(Program, NamesTheFaceThatItTakes) {
  folder_.write("two.ttc", build_collection({Sfnt::plain(), Sfnt::plain()}));
  const std::string rest = " --symbols H --quiet --out a.bin";
  const std::string said = "warning: two.ttc: holds 2 faces; number 0, ";
  const Outcome first = run(folder_, "--font two.ttc" + rest);
  EXPECT_EQ(first.code, 0);
  EXPECT_EQ(first.err.find(said), 0u) << first.err;
  EXPECT_NE(first.err.find(
                "is taken; --face, or face=N after a file of --merge, takes "
                "another one: 1 "),
            std::string::npos);
  EXPECT_EQ(run(folder_, "--font two.ttc --face 0" + rest).err, "");
  EXPECT_EQ(run(folder_, "--font two.ttc --face 1" + rest).err, "");
  EXPECT_EQ(run(folder_, "--font plain.ttf" + rest).err, "");
  const std::string merging =
      "--font two.ttc --face 1 --chars 0x2E --quiet --out a.bin --merge ";
  EXPECT_EQ(run(folder_, merging + "two.ttc=0x48").err.find(said), 0u);
  EXPECT_EQ(run(folder_, merging + "two.ttc:face=0=0x48").err, "");
}

TEST_F(Program, EffortIsForCells) {
  const auto report = [&](const std::string& options) {
    const Outcome made =
        run(folder_,
            "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols "
            "a8 --max-px 24 --quiet --out a.bin --report a.json " +
                options);
    EXPECT_EQ(made.code, 0) << made.err;
    return nlohmann::json::parse(read_file(folder_.path() / "a.json"));
  };
  EXPECT_FALSE(report("--effort 9").contains("effort"));
  const auto little = report("--coding field --effort 0");
  const auto much = report("--coding field --effort 9");
  EXPECT_EQ(much.at("effort"), 9);
  EXPECT_GT(little.at("bytes").at("total"), much.at("bytes").at("total"));
  const std::string help = run(folder_, "--help").out;
  EXPECT_NE(help.find("(field) How hard"), std::string::npos);
}

TEST_F(Program, WidensTheBandAndSaysWhatItCosts) {
  const std::string font =
      "--font plain.ttf --symbols H --coding field --min-px 12 --out a.bin "
      "--report a.json ";
  const auto report = [&] {
    return nlohmann::json::parse(read_file(folder_.path() / "a.json"));
  };
  ASSERT_EQ(run(folder_, font).code, 0);
  EXPECT_EQ(report().at("band_u"), 768 / 12);
  EXPECT_FALSE(report().contains("band_bytes"));
  const int usual = report().at("bytes").at("total");
  const Outcome wide = run(folder_, font + "--band-px 2");
  ASSERT_EQ(wide.code, 0) << wide.err;
  EXPECT_EQ(report().at("band_u"), 2048 / 12);
  const int bytes = report().at("bytes").at("total");
  EXPECT_EQ(report().at("band_bytes"), bytes - usual);
  EXPECT_NE(wide.out.find("band "), std::string::npos);
  for (const char* refused : {"0.4", "3", "-1", "nan"}) {
    EXPECT_EQ(run(folder_, font + "--band-px " + refused).code, 1) << refused;
  }
  EXPECT_EQ(
      run(folder_, font + "--coding field --predicate fixed --band-px 1").code,
      1);
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
    const Outcome result = run(
        folder_, std::string("--font plain.ttf --out a.bin --report a.json ") +
                     kind.options);
    EXPECT_EQ(result.code, 0) << kind.options << result.err;
    const auto report =
        nlohmann::json::parse(read_file(folder_.path() / "a.json"));
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
  const Outcome usual = run(folder_, font + "--quiet");
  EXPECT_EQ(usual.code, 0);
  EXPECT_EQ(usual.err,
            "note: a.ttf: is a variable font, taken at its default, wght 400 "
            "of 100..900 (Regular); choose with --instance NAME or --axis "
            "TAG=VALUE, instances: Regular, Bold\n");
  for (const char* chosen :
       {"--instance Regular", "--instance Bold", "--axis wght=700"}) {
    const Outcome result = run(folder_, font + "--quiet " + chosen);
    EXPECT_EQ(result.code, 0) << chosen;
    EXPECT_EQ(result.err, "") << chosen;
  }
  const auto face = nlohmann::json::parse(read_file(folder_.path() / "a.json"))
                        .at("faces")
                        .at(0);
  EXPECT_EQ(face.at("file"), "a.ttf");
  EXPECT_EQ(face.at("instance"), "Bold");
  EXPECT_EQ(face.at("axes").at("wght"),
            nlohmann::json::parse("{\"min\": 100, \"default\": 400, "
                                  "\"max\": 900, \"value\": 700}"));
  EXPECT_NE(run(folder_, font + "--instance bold")
                .out.find("instance        a.ttf: wght 700 of 100..900 (Bold)"),
            std::string::npos);
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
    const Outcome result = run(
        folder_, std::string("--font plain.ttf --out a.bin ") + wrong.options);
    EXPECT_NE(result.code, 0) << wrong.options;
    EXPECT_NE(result.err.find(wrong.remedy), std::string::npos) << result.err;
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
    const Outcome result = run(folder_, options);
    EXPECT_NE(result.code, 0) << options;
    EXPECT_NE(result.err + result.out, "") << options;
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"})) << options;
  }
}

TEST_F(Program, SaysWhatWouldDo) {
  EXPECT_NE(run(folder_, "--font . --out a.bin").err.find("name a file"),
            std::string::npos);
  EXPECT_NE(run(folder_, "--font plain.ttf --out a.bin --chars 0x4E00")
                .err.find("none of the 1 character asked for"),
            std::string::npos);
  EXPECT_NE(run(folder_, "--font plain.ttf --out a.bin --format svg")
                .err.find("use 'bin', 'hpp' or 'c'"),
            std::string::npos);
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
    const Outcome result = run(
        folder_, std::string("--font plain.ttf --out a.bin ") + wrong.options);
    EXPECT_EQ(result.code, 1) << wrong.options;
    EXPECT_NE(result.err.find(wrong.said), std::string::npos) << result.err;
  }
  EXPECT_NE(run(folder_, "--help").out.find("--min-px INT=8"),
            std::string::npos);
}

TEST_F(Program, DrawsAPreview) {
  const Outcome result =
      run(folder_,
          "--font plain.ttf --symbols .H --quiet --out a.bin --preview "
          "a.png");
  ASSERT_EQ(result.code, 0) << result.err;
  const std::vector<uint8_t> png = read_file(folder_.path() / "a.png");
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
  EXPECT_EQ(run(folder_, "--font plain.ttf --out b.bin --preview b.bin").code,
            1);
}

TEST_F(Program, FindsTheFinestFontThatFits) {
  // Refitting needs curves: a few letters of a real face.
  const std::string font =
      "--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --symbols SCo "
      "--hints off --min-px 12 --max-px 24 --out a.bin --report a.json ";
  const auto made = [&](const std::string& options) {
    const Outcome result = run(folder_, font + options);
    EXPECT_EQ(result.code, 0) << result.err;
    const auto report =
        nlohmann::json::parse(read_file(folder_.path() / "a.json"));
    return std::pair<int, int>(report.at("tolerance"),
                               report.at("bytes").at("total"));
  };
  const int budget = made("--tolerance 16 --quiet").second;
  const auto [tolerance, bytes] =
      made("--quiet --budget " + std::to_string(budget));
  EXPECT_LE(tolerance, 16);
  EXPECT_LE(bytes, budget);
  const Outcome refused = run(folder_, font + "--budget 100");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("tolerance 64/255: "), std::string::npos);
  EXPECT_NE(refused.err.find("Most bytes: U+"), std::string::npos)
      << refused.err;
  for (const char* wrong :
       {"0", "x", "5G", "24KB", "-1", "9999999M", "24K --tolerance 16"}) {
    EXPECT_EQ(run(folder_, font + "--budget " + wrong).code, 1) << wrong;
  }
}

// Samples of corners at these sizes miss 16/255, and more so 1/255.
constexpr const char* kCoarse =
    "--coding field --effort 0 --min-px 1000 --max-px 1024 --quiet --out "
    "a.bin ";

TEST_F(Program, HoldsAToleranceThatIsWritten) {
  const std::string font =
      std::string("--font plain.ttf --symbols . ") + kCoarse + "--tolerance ";
  for (const char* tolerance : {"1", "16"}) {
    const Outcome refused = run(folder_, font + tolerance);
    EXPECT_EQ(refused.code, 1);
    EXPECT_NE(refused.err.find("or allow misses with --best-effort"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"}));
  }
  const Outcome made = run(folder_, font + "16 --best-effort");
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.err.find("warning: plain.ttf: "), 0u) << made.err;
}

TEST_F(Program, AimsAtTheDefaultTolerance) {
  const std::string font = std::string("--font plain.ttf --symbols . ") +
                           kCoarse + "--report a.json ";
  for (const char* options : {"", "--best-effort", "--budget 64K"}) {
    const Outcome made = run(folder_, font + options);
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.err.find("warning: plain.ttf: "), 0u) << made.err;
    EXPECT_NE(made.err.find("drawn as well as possible"), std::string::npos);
    const auto report =
        nlohmann::json::parse(read_file(folder_.path() / "a.json"));
    EXPECT_EQ(report.at("tolerance"), 16) << options;
    EXPECT_FALSE(report.at("missed").empty());
  }
}

TEST_F(Program, NoIconFailsAFolder) {
  for (const char* icon : {"M4 4h16v16h-16z", "M12 1L22 12 12 23 3 12z"}) {
    const std::string svg =
        std::string("<svg viewBox='0 0 24 24'><path d='") + icon + "'/></svg>";
    folder_.write(icon[1] == '4' ? "a.svg" : "b.svg",
                  std::vector<uint8_t>(svg.begin(), svg.end()));
  }
  const Outcome made = run(folder_, std::string("--svg-dir . ") + kCoarse);
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("warning: 2 icons: "), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("b.svg U+E001 "), std::string::npos) << made.err;
}

TEST_F(Program, WritesToNoStream) {
  for (const char* options :
       {"--out -", "--out - --format hpp", "--out a.bin --report -",
        "--out a.bin --depfile -"}) {
    const Outcome result =
        run(folder_, std::string("--font plain.ttf --symbols H ") + options);
    EXPECT_EQ(result.code, 1) << options;
    EXPECT_EQ(result.out, "") << options;
    EXPECT_NE(result.err.find("-: is not standard output here; name a file"),
              std::string::npos)
        << result.err;
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"})) << options;
  }
  EXPECT_EQ(run(folder_, "--font plain.ttf --symbols H --out ./-").code, 0);
  EXPECT_EQ(folder_.names(), (Names{"-", "plain.ttf"}));
}

TEST_F(Program, LeavesTheOldFileWhenItFails) {
  folder_.write("a.bin", std::vector<uint8_t>{'o', 'l', 'd'});
  EXPECT_EQ(run(folder_, "--font plain.ttf --out a.bin --chars 0x4E00").code,
            1);
  EXPECT_EQ(read_file(folder_.path() / "a.bin"),
            (std::vector<uint8_t>{'o', 'l', 'd'}));
  EXPECT_EQ(folder_.names(), (Names{"a.bin", "plain.ttf"}));
}

TEST_F(Program, GoesOnWithoutMissingCharacters) {
  const Outcome result =
      run(folder_, "--font plain.ttf --chars H,0x4E00 --out a.bin --quiet");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err.find("warning: plain.ttf: 1 character"), 0u)
      << result.err;
}

TEST_F(Program, MissesNoCharacterThatShowsNothing) {
  // A tab, a soft hyphen, a zero width space, an em space.
  const std::string text = "H\t.\xc2\xad\xe2\x80\x8b\xe2\x80\x83\n";
  folder_.write("a.txt", std::vector<uint8_t>(text.begin(), text.end()));
  folder_.write("b.ttf", Sfnt::plain());
  for (const char* merged : {"", "--merge b.ttf "}) {
    const Outcome result =
        run(folder_, std::string("--font plain.ttf --text-file a.txt --strict "
                                 "--quiet --out a.bin ") +
                         merged);
    EXPECT_EQ(result.code, 0) << merged;
    EXPECT_EQ(result.err.find("not in the font"), std::string::npos)
        << result.err;
  }
}

TEST_F(Program, WritesDependencies) {
  folder_.write("t.txt", std::vector<uint8_t>{'H'});
  ASSERT_EQ(
      run(folder_,
          "--font plain.ttf --text-file t.txt --out 'a b.hpp' --format hpp "
          "--depfile a.d --quiet")
          .code,
      0);
  const std::vector<uint8_t> bytes = read_file(folder_.path() / "a.d");
  const std::string folder = folder_.path().string();
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()),
            "a\\ b.hpp: " + folder + "/plain.ttf " + folder + "/t.txt\n" +
                folder + "/plain.ttf:\n" + folder + "/t.txt:\n");
}

TEST_F(Program, FollowsTheEndingOfTheFile) {
  for (const char* name : {"a.hpp", "a.c"}) {
    const std::string options =
        std::string("--font plain.ttf --symbols H --quiet --out ") + name;
    ASSERT_EQ(run(folder_, options).code, 0) << name;
    const std::vector<uint8_t> source = read_file(folder_.path() / name);
    ASSERT_EQ(run(folder_, options + " --format bin").code, 0) << name;
    const std::vector<uint8_t> bytes = read_file(folder_.path() / name);
    const std::string_view magic = "INKC";
    EXPECT_TRUE(std::equal(magic.begin(), magic.end(), bytes.begin())) << name;
    EXPECT_FALSE(std::equal(magic.begin(), magic.end(), source.begin()))
        << name;
  }
}

TEST_F(Program, TakesAHeaderForCxx) {
  const std::string options = "--font plain.ttf --symbols H --quiet --out ";
  ASSERT_EQ(run(folder_, options + "plain.hpp").code, 0);
  for (const char* name : {"plain.h", "plain.hh", "plain.hxx"}) {
    const Outcome result = run(folder_, options + name);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(read_file(folder_.path() / name),
              read_file(folder_.path() / "plain.hpp"));
  }
}

TEST_F(Program, AsksWhichLanguageASourceIsIn) {
  for (const char* name : {"a.cpp", "a.cc", "a.cxx"}) {
    const std::string options =
        std::string("--font plain.ttf --symbols H --quiet --out ") + name;
    const Outcome result = run(folder_, options);
    EXPECT_EQ(result.code, 1) << name;
    EXPECT_EQ(result.err, "error: " + std::string(name) +
                              ": add --format hpp, for C++, or --format c\n");
    EXPECT_EQ(folder_.names(), (Names{"plain.ttf"}));
    EXPECT_EQ(run(folder_, options + " --format c").code, 0) << name;
    std::filesystem::remove(folder_.path() / name);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
