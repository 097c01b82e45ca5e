// Fonts converted in memory: what happens to glyphs that are too complex.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "convert.hpp"
#include "sfnt_builder.hpp"
#include "web_fonts.hpp"

namespace inkcell::tools {
namespace {

using gen::test::Polygon;
using gen::test::Sfnt;
using gen::test::TestFolder;

// A circle of 40 corners, clockwise (ink) or the other way (a hole).
Polygon circle(double radius, bool hole) {
  constexpr int kCorners = 40;
  Polygon polygon;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = (hole ? 2 : -2) * 3.14159265358979 * i / kCorners;
    polygon.emplace_back(std::lround(500 + radius * std::cos(angle)),
                         std::lround(400 + radius * std::sin(angle)));
  }
  return polygon;
}

// 60 rings of equal area as 'Z', and a square H.
Sfnt zone_plate() {
  constexpr int kRings = 60;
  Sfnt font = Sfnt::plain();
  font.units_per_em = 1000;
  gen::test::SfntGlyph plate;
  plate.code_point = U'Z';
  plate.advance = 1000;
  for (int i = 2 * kRings; i > 0; --i) {
    const double radius = 700 * std::sqrt(i / (2.0 * kRings));
    plate.contours.push_back(circle(radius, i % 2 != 0));
  }
  font.glyphs.push_back(plate);
  return font;
}

TEST(Convert, WarnsOfWhatShowsAsNotdef) {
  const TestFolder folder;
  gen::GenerateRequest request;
  request.font = folder.write("plain.ttf", Sfnt::plain());
  request.symbols = "H";
  request.layout_glyphs = false;
  const auto rom = folder.write("plain.bin", gen::generate(request).bytes);
  const auto warning = [&](const std::string& text) {
    testing::internal::CaptureStderr();
    load_font_file(rom, Conversion(), text);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(warning("H\tH\xc2\xad\n"), "");
  EXPECT_EQ(warning("H.\t\n"),
            "warning: plain.bin: not in the font, and drawn as .notdef: U+002E "
            "'.'\n");
}

// Once, whether the font is converted or was.
TEST(Convert, WarnsOfTextThatNeedsShaping) {
  const TestFolder folder;
  gen::GenerateRequest request;
  request.font = folder.write("plain.ttf", Sfnt::plain());
  request.symbols = "H";
  const auto rom = folder.write("plain.bin", gen::generate(request).bytes);
  for (const std::filesystem::path& file : {request.font, rom}) {
    testing::internal::CaptureStderr();
    load_font_file(file, Conversion(), "H\u0633\u0644");
    const std::string said = testing::internal::GetCapturedStderr();
    const std::string_view warning = "warning: Arabic is drawn unshaped, from ";
    EXPECT_NE(said.find(warning), std::string::npos) << file << said;
    EXPECT_EQ(said.find(warning), said.rfind(warning)) << said;
  }
}

// A WOFF2 of a variable font, at an instance: H is 100 units wider at wght 900.
TEST(Convert, TakesWebFontsAndInstances) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.wght_shift = 100;
  source.instances = {{"Regular", 400}, {"Black", 900}};
  const auto file =
      folder.write("plain.woff2", gen::test::pack_woff2(source.build()));
  for (const char* instance : {"", "Black"}) {
    Conversion conversion;
    conversion.request.instance = instance;
    testing::internal::CaptureStderr();
    const RomFile rom = load_font_file(file, conversion, "H");
    const std::string said = testing::internal::GetCapturedStderr();
    const bool is_usual = *instance == '\0';
    EXPECT_EQ(
        said.find("note: plain.woff2: is a variable font") != std::string::npos,
        is_usual)
        << said;
    EXPECT_EQ(rom.font().advance(rom.font().glyph_or_notdef(U'H')),
              is_usual ? 800 : 900);
  }
}

TEST(Convert, HalvesTheLargestSizeForTooComplexGlyphs) {
  const TestFolder folder;
  const auto file = folder.write("plate.ttf", zone_plate());
  Conversion conversion;
  conversion.request.target.coding = gen::Coding::field;
  conversion.request.target.effort = 0;  // for speed
  testing::internal::CaptureStderr();
  const RomFile rom = load_font_file(file, conversion, "ZH");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("U+005A 'Z'"), std::string::npos) << said;
  EXPECT_NE(said.find("at 64 px; the font is converted for 8 to 32 px"),
            std::string::npos)
      << said;
  EXPECT_LT(rom.font().range().max_px, 64);
  GlyphField field;
  for (const uint32_t c : {U'Z', U'H'}) {
    uint16_t glyph = 0;
    ASSERT_EQ(rom.font().glyph_of(c, glyph), Status::ok);
    ASSERT_EQ(read_field(rom.font(), glyph, field), Status::ok);
    EXPECT_GT(field.tiles_x, 0);
  }
}

TEST(Convert, KeepsTheSizesThatWereAskedFor) {
  const TestFolder folder;
  const auto file = folder.write("plate.ttf", zone_plate());
  Conversion conversion;
  conversion.request.target.coding = gen::Coding::field;
  conversion.request.target.effort = 0;  // for speed
  conversion.may_halve = false;
  EXPECT_THROW(load_font_file(file, conversion, "ZH"), gen::TooComplex);
  // Half of 64 would be below the smallest size.
  conversion.may_halve = true;
  conversion.request.target.min_px = 40;
  EXPECT_THROW(load_font_file(file, conversion, "ZH"), gen::TooComplex);
}

}  // namespace
}  // namespace inkcell::tools
