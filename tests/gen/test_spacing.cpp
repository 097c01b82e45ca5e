// Columns, and lengths of lines, of fitted text in fonts of real faces.
#include <gtest/gtest.h>

#include <string>

#include "inkcell/few_levels.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/text.hpp"
#include "pipeline/generate.hpp"

namespace inkcell::gen::test {
namespace {

Font fast_font(const char* file, RomFont& made) {
  GenerateRequest request;
  request.font = file;
  request.target.tolerance = 64;
  request.target.max_px = 20;
  request.chars = {"0x20-0x7E"};
  made = generate(request);
  Font font;
  EXPECT_EQ(Status::ok,
            Font::open({made.bytes.data(), made.bytes.size()}, font));
  return font;
}

int width_px(const Font& font, const Style& style, const std::string& line) {
  return Painter()
      .measure(font, style, Text(line.data(), line.size()))
      .advance.floor();
}

TEST(Spacing, FacesOfFixedPitchHaveOneAdvance) {
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf"}) {
    RomFont made;
    const Font font = fast_font(file, made);
    for (int px = 8; px < 40; ++px) {
      const Q26_6 size = Q26_6::from_int(px);
      Fit fit;
      ASSERT_EQ(Status::ok, Fit::make(font, Style(size), {true, 0}, fit));
      Style grey(size);
      grey.set_fit(fit);
      for (const Style& style :
           {grey, two_level_style(size), four_level_style(size)}) {
        const int pitch = width_px(font, style, "x");
        EXPECT_EQ(14 * pitch, width_px(font, style, "Temp  21.5 C|x"));
        EXPECT_EQ(14 * pitch, width_px(font, style, "Watt 1111.0 W|"));
        for (char c = ' '; c < 127; ++c) {
          EXPECT_EQ(9 * pitch, width_px(font, style, "i" + std::string(8, c)))
              << file << ", " << c << ", " << px << " px";
        }
      }
    }
  }
}

// Liberation Serif kerns "11".
TEST(Spacing, DigitsStandInColumnsAndLinesKeepTheirLength) {
  const std::string line = "Ethernet Authentication, 1479 Mill Lane: heat";
  for (const char* file :
       {"/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf",
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/"
        "Roboto-Regular.ttf"}) {
    RomFont made;
    const Font font = fast_font(file, made);
    for (int px = 8; px < 40; ++px) {
      const Q26_6 size = Q26_6::from_int(px);
      for (const Style& style :
           {two_level_style(size), four_level_style(size)}) {
        const int width = width_px(font, style, "Volt 0000.0 V|");
        for (char digit = '1'; digit <= '9'; ++digit) {
          EXPECT_EQ(width, width_px(font, style,
                                    "Volt " + std::string(4, digit) + ".0 V|"))
              << file << ", " << digit << ", " << px << " px";
        }
        const double designed =
            to_px(font, style,
                  measure(font, Text(line.data(), line.size())).advance)
                .raw /
            64.0;
        EXPECT_NEAR(designed, width_px(font, style, line), 0.03 * designed)
            << file << ", " << px << " px";
      }
    }
  }
}

}  // namespace
}  // namespace inkcell::gen::test
