// Strikes: their bytes, and that they show what outlines show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/encode.hpp"
#include "app/options.hpp"
#include "glyph_outlines.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "messages.hpp"
#include "pipeline/built_glyphs.hpp"
#include "pipeline/generate.hpp"

namespace inkcell::gen::test {
namespace {

using format::StrikeFit;
using Bytes = std::vector<uint8_t>;

constexpr int32_t kWidth = 256;
constexpr int32_t kHeight = 64;
// Its letters do not overlap, where errors would add up.
constexpr char kText[] = "Q u i c k 0123 A V A N T W o l f ; j e e z .";

RomFont font_with(const std::vector<StrikeTarget>& strikes,
                  bool is_alone = false,
                  const std::string& chars = "0x20-0x7E") {
  GenerateRequest request;
  request.font = kDejaVuSans;
  request.chars = {chars};
  request.strikes = strikes;
  request.strike_only = is_alone;
  static BuiltGlyphs outlines;
  request.built_glyphs = &outlines;
  return generate(request);
}

// ASCII of DejaVu Sans with a strike of each kind.
const std::vector<StrikeTarget>& targets() {
  static const std::vector<StrikeTarget> kTargets = {
      {12, 1, StrikeFit::both}, {12, 1, StrikeFit::none},
      {12, 2, StrikeFit::both}, {17, 2, StrikeFit::both},
      {12, 4, StrikeFit::both}, {12, 4, StrikeFit::heights},
      {24, 4, StrikeFit::both}, {12, 4, StrikeFit::none},
      {45, 1, StrikeFit::both}, {45, 4, StrikeFit::both}};
  return kTargets;
}
const RomFont& with_all() {
  static const RomFont kFont = font_with(targets());
  return kFont;
}

Font open(const Bytes& bytes, const inkcell::Coding& coding) {
  Font font;
  EXPECT_EQ(Font::open({bytes.data(), bytes.size()}, coding, font), Status::ok);
  return font;
}

// Bytes of a canvas on which a font draws the text.
template <typename Canvas>
Bytes drawn(const Font& font,
            const Style& style,
            const std::string& text = kText) {
  alignas(4) static uint8_t pixels[kWidth * kHeight];
  std::fill_n(pixels, sizeof pixels, uint8_t{0});
  Canvas canvas({{pixels, sizeof pixels}, 0, 0, kWidth, kHeight, kWidth});
  Painter(canvas).text(font, style, {Q26_6::from_int(3), Q26_6::from_int(48)},
                       {text.data(), text.size()});
  return {pixels, pixels + sizeof pixels};
}

int difference(const Bytes& a, const Bytes& b) {
  int most = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

// The same font, all of whose pictures are other ones.
Bytes with_other_pictures(Bytes bytes) {
  Font font = open(bytes, kOutlineCoding);
  const Span<const uint8_t> strikes = font.section(format::section::kStrikes);
  EXPECT_NE(strikes.size, 0u);
  uint8_t* const begin = bytes.data() + (strikes.data - font.rom().data);
  uint32_t end = static_cast<uint32_t>(strikes.size) - 3;
  for (size_t i = targets().size(); i-- > 0;) {
    uint8_t* const entry = begin + 4 + 32 * i;
    const auto word = [entry](int at) {
      return entry[at] | uint32_t{entry[at + 1]} << 8 |
             uint32_t{entry[at + 2]} << 16 | uint32_t{entry[at + 3]} << 24;
    };
    // The boxes begin there; pictures follow their table.
    uint32_t bits = 0;
    for (int column = 0; column < 5; ++column) {
      bits += entry[9 + column];
    }
    const uint32_t glyphs = entry[6] | uint32_t{entry[7]} << 8;
    for (uint32_t at = word(24) + (bits * (glyphs + 1) + 7) / 8; at < end;
         ++at) {
      begin[at] = static_cast<uint8_t>(~begin[at]);
    }
    end = word(24);
  }
  return bytes;
}

// Strikes of a style show the same within `most`, and are what is drawn.
template <typename Canvas>
void check_served(const Style& style, int most) {
  static const Bytes kOthers = with_other_pictures(with_all().bytes);
  const Bytes wanted =
      drawn<Canvas>(open(with_all().bytes, kOutlineCoding), style);
  const Bytes found =
      drawn<Canvas>(open(with_all().bytes, kOutlineStrikeCoding), style);
  EXPECT_GT(difference(wanted, Bytes(wanted.size())), 0);
  EXPECT_LE(difference(wanted, found), most) << style.size().raw;
  EXPECT_GT(difference(wanted, drawn<Canvas>(
                                   open(kOthers, kOutlineStrikeCoding), style)),
            most)
      << style.size().raw;
}

TEST(Strikes, AreBitsOfOutlines) {
  check_served<port::MonoPagesCanvas>(Style(12_px), 0);
  check_served<port::MonoPagesCanvas>(Style(45_px), 0);
  check_served<port::Grey2Canvas>(Style(12_px), 0);
  check_served<port::Grey2Canvas>(Style(17_px), 0);
}

TEST(Strikes, AreGreysOfOutlinesWithinHalfALevel) {
  check_served<port::A8Canvas>(strike_style(12_px), 8);
  check_served<port::A8Canvas>(strike_style(24_px), 8);
  check_served<port::A8Canvas>(strike_height_style(12_px), 8);
  check_served<port::A8Canvas>(strike_style(45_px), 8);
}

TEST(Strikes, LeaveOtherSizesToOutlines) {
  for (const Style& style : {Style(13_px), Style(24_px)}) {
    EXPECT_EQ(drawn<port::MonoPagesCanvas>(
                  open(with_all().bytes, kOutlineStrikeCoding), style),
              drawn<port::MonoPagesCanvas>(
                  open(with_all().bytes, kOutlineCoding), style));
  }
}

// What it takes beside LVGL's compressed bitmaps: 3,060 and 7,123 bytes.
TEST(Strikes, TakeFewBytes) {
  const auto bytes = [](const StrikeTarget& target) {
    return font_with({target}, true).report.bytes.strikes;
  };
  EXPECT_LE(bytes({12, 1, StrikeFit::both}), 800u);
  EXPECT_LE(bytes({12, 4, StrikeFit::both}), 2300u);
  EXPECT_LE(bytes({24, 4, StrikeFit::both}), 5600u);
}

// A strike alone has the advances and the kerning of fitted text, too.
TEST(Strikes, AloneDrawTheSameText) {
  const RomFont alone = font_with({{12, 1, StrikeFit::both}}, true);
  EXPECT_EQ(alone.report.options.coding, Coding::strike);
  const Font font = open(alone.bytes, kBitStrikeCoding);
  const Font outlines = open(with_all().bytes, kOutlineCoding);
  for (const char* text : {"12:34", "AVA", "LTD", "Wolf", "P.S."}) {
    EXPECT_EQ(drawn<port::MonoPagesCanvas>(font, Style(12_px), text),
              drawn<port::MonoPagesCanvas>(outlines, Style(12_px), text))
        << text;
  }
  Font refused;
  EXPECT_EQ(Font::open({alone.bytes.data(), alone.bytes.size()}, refused),
            Status::unsupported);
  EXPECT_EQ(font.check(Style(13_px)), Status::unsupported);
  EXPECT_EQ(font.check(Style(24_px)), Status::ok);
}

// The width of a line on a canvas of 1 bit. [px]
int width_of_line(const Font& font, const std::string& text) {
  alignas(4) static uint8_t pixels[kWidth * kHeight];
  const port::MonoPagesCanvas canvas(
      {{pixels, sizeof pixels}, 0, 0, kWidth, kHeight, kWidth});
  return Painter(canvas)
             .measure(font, Style(12_px), {text.data(), text.size()})
             .advance.raw /
         64;
}

// Whole advances are off the design by parts of a pixel, which add up. Outlines
// bring a line back between its words; a strike alone cannot.
TEST(Strikes, AloneDoNotBringLinesBack) {
  const RomFont alone = font_with({{12, 1, StrikeFit::both}}, true);
  const Font font = open(alone.bytes, kBitStrikeCoding);
  const Font outlines = open(with_all().bytes, kOutlineCoding);
  int most = 0;
  for (const char* text :
       {"The quick brown fox jumps over the lazy dog.",
        "Kitchen 21.5 C, outside 4.0 C, wind from the west",
        "PRESS ANY KEY TO CONTINUE, OR WAIT FOR 30 SECONDS",
        "illimitable little lilies, still filling a tiny till",
        "Battery low: 12 % left, 00:34 to go, charger missing"}) {
    const int wanted = width_of_line(outlines, text);
    const int found = width_of_line(font, text);
    const std::string line = text;
    most = std::max(most, std::abs(wanted - found));
    EXPECT_LE(std::abs(wanted - found) * 40, wanted) << text;
    // Each word by itself is as wide.
    size_t begin = 0;
    while (begin < line.size()) {
      const size_t end = std::min(line.find(' ', begin), line.size());
      const std::string word = line.substr(begin, end - begin);
      EXPECT_LE(
          std::abs(width_of_line(font, word) - width_of_line(outlines, word)),
          1)
          << word;
      begin = end + 1;
    }
  }
  // Else the document is wrong.
  EXPECT_EQ(most, 5);
}

// As designed, with advances in halves of a pixel.
TEST(Strikes, AloneMayStayAsDesigned) {
  const RomFont alone = font_with({{24, 4, StrikeFit::none}}, true, "A-Z");
  const Font font = open(alone.bytes, kStrikeCoding);
  EXPECT_EQ(font.units_per_em(), 48);
  uint16_t glyph = 0;
  ASSERT_EQ(font.glyph_of('A', glyph), Status::ok);
  // 1401 of 2048 units.
  EXPECT_EQ(font.advance(glyph), 33);
  const Bytes wanted = drawn<port::A8Canvas>(
      open(font_with({}, false, "A-Z").bytes, kOutlineCoding),
      Style(24_px).clear_fit(), "H");
  EXPECT_LE(difference(drawn<port::A8Canvas>(font, Style(24_px), "H"), wanted),
            8);
}

std::string refusal(const std::vector<StrikeTarget>& strikes, bool is_alone) {
  return error_of([&] { font_with(strikes, is_alone, "A"); });
}

TEST(Strikes, AreRefusedWithARemedy) {
  EXPECT_TRUE(begins_with(refusal({}, true), "--strike-only makes a font of"));
  EXPECT_TRUE(contains(refusal({{8, 1}, {9, 1}}, true), "give one --strike"));
  EXPECT_EQ(refusal({{255, 1, StrikeFit::both}}, true),
            "DejaVuSans.ttf: .notdef: its picture at 255 px is larger than 255 "
            "px or begins further than 128 px from its origin; take a smaller "
            "--strike");
  GenerateRequest request;
  request.font = kDejaVuSans;
  request.strikes = {{12, 1, StrikeFit::both}};
  request.target.coding = Coding::field;
  EXPECT_TRUE(contains(error_of([&] { generate(request); }), "--strike is of"));
  request.target.coding = Coding::outline;
  request.paged = 512;
  EXPECT_TRUE(contains(error_of([&] { generate(request); }), "mapped memory"));
}

TEST(Strikes, AreNamedBySizeAndBits) {
  const StrikeTarget plain = parse_strike("12:1");
  EXPECT_EQ(plain.px, 12);
  EXPECT_EQ(plain.bits, 1);
  EXPECT_EQ(plain.fit, StrikeFit::both);
  EXPECT_EQ(parse_strike("255:4:vertical").fit, StrikeFit::heights);
  EXPECT_EQ(parse_strike("4:2:none").fit, StrikeFit::none);
  for (const char* wrong : {"", "12", "12:", "12:3", "3:1", "256:1", "12:1:",
                            "12:1:left", "12:1:vertical", ":1", "12:4x"}) {
    EXPECT_THROW(parse_strike(wrong), CLI::ValidationError) << wrong;
  }
}

// The header names the coding that opens the font.
TEST(Strikes, AreOpenedByTheCodingInTheHeader) {
  const auto header = [](const std::vector<StrikeTarget>& strikes, bool alone) {
    return encode(font_with(strikes, alone, "A"), OutputFormat::hpp, "a");
  };
  const StrikeTarget bits = {12, 1, StrikeFit::both};
  const StrikeTarget greys = {12, 4, StrikeFit::both};
  EXPECT_TRUE(contains(header({bits}, true), " inkcell::kBitStrikeCoding;"));
  EXPECT_TRUE(contains(header({greys}, true), " inkcell::kStrikeCoding;"));
  EXPECT_TRUE(
      contains(header({bits}, false), " inkcell::kOutlineBitStrikeCoding;"));
  const std::string both = header({bits, greys}, false);
  EXPECT_TRUE(contains(both, " inkcell::kOutlineStrikeCoding;"));
  EXPECT_TRUE(contains(both, "\"inkcell/strike/outline_strike.hpp\""));
  EXPECT_EQ(header({}, false).find("oding"), std::string::npos);
}

// Beside outlines glyphs that are too large for pictures are drawn from them.
TEST(Strikes, LeaveLargeGlyphsToOutlines) {
  const RomFont rom = font_with({{200, 1, StrikeFit::both}}, false, "A");
  EXPECT_EQ(drawn<port::MonoPagesCanvas>(open(rom.bytes, kOutlineStrikeCoding),
                                         Style(200_px), "A"),
            drawn<port::MonoPagesCanvas>(open(rom.bytes, kOutlineCoding),
                                         Style(200_px), "A"));
}

}  // namespace
}  // namespace inkcell::gen::test
