// TrueType files of a folder, at 24 px: glyphs against FreeType at 1x, and
// ASCII, whose contours may overlap, against FreeType at 8x8 samples a pixel.
//
//   many_faces FOLDER GLYPHS
//
// At most so many glyphs of a file, from all of it. Fails if more than one in
// 1,000 has a pixel that is off by more than 64/255, or if in ASCII of all
// files more pixels are off by more than 16 than FreeType has without
// oversampling.
#include <stdint.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "glyph_pictures.hpp"

namespace {

using namespace inkcell;
using namespace glyph_pictures;

constexpr int32_t kPx = 24;
constexpr double kFar = 64;

struct Totals {
  int32_t files = 0;
  int64_t glyphs = 0;
  int64_t far = 0;    // glyphs with a pixel beyond kFar
  int32_t worse = 0;  // files that have more pixels off than FreeType
  Error own;
  Error freetype;
};

// A glyph that does not fit the picture is left out.
bool fits(FT_Face face, uint32_t glyph) {
  FT_Set_Pixel_Sizes(face, 0, kPx);
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) {
    return false;
  }
  FT_BBox box;
  FT_Outline_Get_CBox(&face->glyph->outline, &box);
  return box.xMin > -64 * kX && box.xMax < 64 * (kSide - kX) &&
         box.yMin > -64 * (kSide - kY) && box.yMax < 64 * kY;
}

void compare(const std::string& name,
             FT_Library library,
             uint32_t most,
             Totals& totals) {
  std::vector<char> file(std::filesystem::file_size(name));
  std::ifstream(name, std::ios::binary)
      .read(file.data(), static_cast<std::streamsize>(file.size()));
  TrueTypeFont opened;
  FT_Face face = nullptr;
  if (opened.open({reinterpret_cast<const uint8_t*>(file.data()),
                   file.size()}) != Status::ok ||
      FT_New_Face(library, name.c_str(), 0, &face) != 0) {
    return;
  }
  ++totals.files;
  alignas(8) static uint8_t ram[2560];
  const Font& font = opened.font();
  const uint32_t count = opened.glyph_count();
  int32_t far = 0;
  for (uint32_t i = 0; i < std::min(count, most); ++i) {
    const auto glyph =
        static_cast<uint16_t>(uint64_t{i} * count / std::min(count, most));
    if (!fits(face, glyph)) {
      continue;
    }
    Error error;
    error.add(freetype_picture(face, glyph, kPx, 1),
              own_picture(font, glyph, kPx, ram));
    ++totals.glyphs;
    far += error.worst > kFar ? 1 : 0;
  }
  Error own;
  Error freetype;
  for (uint32_t code = 0x21; code < 0x7f; ++code) {
    uint16_t glyph = 0;
    if (font.glyph_of(code, glyph) == Status::ok && fits(face, glyph)) {
      const Picture truth = freetype_picture(face, glyph, kPx, kSamples);
      own.add(truth, own_picture(font, glyph, kPx, ram));
      freetype.add(truth, freetype_picture(face, glyph, kPx, 1));
    }
  }
  FT_Done_Face(face);
  if (far != 0 || own.off > freetype.off) {
    printf(
        "%s: %d glyphs are off by more than 64; pixels of ASCII off by more "
        "than 16: %lld, FreeType %lld\n",
        name.c_str(), far, static_cast<long long>(own.off),
        static_cast<long long>(freetype.off));
  }
  totals.far += far;
  totals.worse += own.off > freetype.off ? 1 : 0;
  totals.own.off += own.off;
  totals.freetype.off += freetype.off;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "usage: many_faces FOLDER GLYPHS\n");
    return 2;
  }
  FT_Library library = nullptr;
  require(FT_Init_FreeType(&library) == 0, "FreeType starts");
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(argv[1])) {
    if (entry.path().extension() == ".ttf") {
      names.push_back(entry.path());
    }
  }
  std::sort(names.begin(), names.end());
  Totals totals;
  for (const std::string& name : names) {
    compare(name, library, static_cast<uint32_t>(atoi(argv[2])), totals);
  }
  printf(
      "%d files, %lld glyphs, %lld off by more than 64; pixels of ASCII off "
      "by more than 16: %lld, FreeType %lld; %d files have more than it\n",
      totals.files, static_cast<long long>(totals.glyphs),
      static_cast<long long>(totals.far),
      static_cast<long long>(totals.own.off),
      static_cast<long long>(totals.freetype.off), totals.worse);
  FT_Done_FreeType(library);
  return totals.glyphs > 0 && 1000 * totals.far <= totals.glyphs &&
                 totals.own.off <= totals.freetype.off
             ? 0
             : 1;
}
