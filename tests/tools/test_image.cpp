// Pictures and text, as the tools handle them.
#include "image.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

TEST(Image, EnlargesByWholePixels) {
  Image image(2, 1, 3);
  image.at(1, 0)[2] = 9;
  const Image large = enlarge(image, 3);
  EXPECT_EQ(large.width, 6);
  EXPECT_EQ(large.height, 3);
  EXPECT_EQ(large.at(2, 2)[2], 0);
  EXPECT_EQ(large.at(3, 0)[2], 9);
  EXPECT_EQ(large.at(5, 2)[2], 9);
}

TEST(Image, WritesPgm) {
  Image image(2, 2);
  *image.at(1, 0) = 7;
  invert(image);
  const std::string file = testing::TempDir() + "inkcell_image.pgm";
  write_image(file, image);
  std::ifstream in(file, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(content, "P5\n2 2\n255\n\xff\xf8\xff\xff");
}

TEST(Image, RefusesUnknownNamesAndFolders) {
  EXPECT_THROW(write_image("picture.gif", Image(1, 1)), std::runtime_error);
  EXPECT_THROW(write_image("/nowhere/a.png", Image(1, 1)), std::runtime_error);
  EXPECT_THROW(write_image("/nowhere/a.pgm", Image(1, 1)), std::runtime_error);
  EXPECT_THROW(write_image("a.png", Image(0, 1)), std::runtime_error);
}

TEST(Utf8, GoesThereAndBack) {
  for (const char32_t c : {0x41u, 0x7fu, 0x80u, 0x7ffu, 0x800u, 0xfffdu,
                           0xffffu, 0x10000u, 0x10ffffu}) {
    EXPECT_EQ(from_utf8(to_utf8(c)), std::vector<char32_t>{c});
  }
}

TEST(RomFile, RefusesWhatIsNoFont) {
  EXPECT_THROW(RomFile(std::vector<uint8_t>(100), "zeros"), std::runtime_error);
  EXPECT_FALSE(is_rom_font({'I', 'N', 'K'}));
}

}  // namespace
}  // namespace inkcell::tools
