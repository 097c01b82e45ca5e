// Kerning against HarfBuzz, pair by pair, and the joining of classes.
#include <gtest/gtest.h>

#include "source/kerning.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <random>

#include "sfnt_builder.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen::test {
namespace {

constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"};

// The position of the second character in HarfBuzz less the first one's
// advance, with substitutions off.
int kerning_of_text(hb_font_t* font, char32_t left, char32_t right) {
  const uint32_t text[2] = {left, right};
  hb_buffer_t* buffer = hb_buffer_create();
  hb_buffer_add_utf32(buffer, text, 2, 0, 2);
  hb_buffer_guess_segment_properties(buffer);
  std::vector<hb_feature_t> features;
  for (const char* name : {"ccmp", "locl", "rlig", "liga", "clig", "calt"}) {
    features.push_back({hb_tag_from_string(name, 4), 0, 0, UINT_MAX});
  }
  hb_shape(font, buffer, features.data(), unsigned(features.size()));
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* at = hb_buffer_get_glyph_positions(buffer, &count);
  int kerning = 0;
  if (count == 2) {
    kerning = at[0].x_advance + at[1].x_offset - at[0].x_offset -
              hb_font_get_glyph_h_advance(font, infos[0].codepoint);
  } else {
    ADD_FAILURE() << describe(left) << describe(right);
  }
  hb_buffer_destroy(buffer);
  return kerning;
}

SourceFont load(const std::filesystem::path& file,
                std::string_view chars,
                bool with_components = false) {
  FontRequest request;
  request.file = file;
  request.with_components = with_components;
  add_ranges(chars, request.characters);
  Warnings ignored;
  return load_font(request, 2, ignored);
}

// The number of pairs of characters that differ from HarfBuzz; `kerned` counts
// the pairs that kern. Glyphs without a character are components.
int differences(const std::filesystem::path& file,
                const SourceFont& font,
                int& kerned) {
  const FontFile opened(file, 0, {});
  int wrong = 0;
  kerned = 0;
  for (size_t l = 1; l < font.glyphs.size(); ++l) {
    for (size_t r = 1; r < font.glyphs.size(); ++r) {
      if (font.glyphs[l].code_points.empty() ||
          font.glyphs[r].code_points.empty()) {
        continue;
      }
      const char32_t left = font.glyphs[l].code_points[0];
      const char32_t right = font.glyphs[r].code_points[0];
      const int expected = kerning_of_text(opened.hb(), left, right);
      const int found = font.kerning.value(l, r);
      kerned += expected != 0 ? 1 : 0;
      if (found != expected) {
        ++wrong;
        EXPECT_LT(wrong, 5) << file << describe(left) << describe(right)
                            << found << " is not " << expected;
      }
    }
  }
  return wrong;
}

TEST(Kerning, EqualsHarfBuzzForAllPairsOfAscii) {
  for (const char* file : kFonts) {
    const SourceFont font = load(file, "0x20-0x7E");
    int kerned = 0;
    EXPECT_EQ(differences(file, font, kerned), 0) << file;
    EXPECT_GT(kerned, 100) << file;
  }
}

TEST(Kerning, EqualsHarfBuzzAcrossScripts) {
  const SourceFont font =
      load(kFonts[0], "A-C,T-Z,a-e,0x2C-0x2E,0x410-0x42F,0x391-0x39F");
  int kerned = 0;
  EXPECT_EQ(differences(kFonts[0], font, kerned), 0);
  EXPECT_GT(kerned, 20);
}

TEST(Kerning, EqualsHarfBuzzBesideComponents) {
  for (const char* file : kFonts) {
    const SourceFont font = load(file, "0x41,0x56,0xC0-0xE5", true);
    const auto components = std::count_if(
        font.glyphs.begin() + 1, font.glyphs.end(),
        [](const SourceGlyph& glyph) { return glyph.code_points.empty(); });
    EXPECT_GT(components, 0) << file;
    int kerned = 0;
    EXPECT_EQ(differences(file, font, kerned), 0) << file;
    EXPECT_GT(kerned, 0) << file;
  }
}

TEST(Kerning, ReadsTheKernTable) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.kern_pairs = {{{3, 2}, -71}, {{2, 3}, 30}, {{3, 3}, -5}};
  const SourceFont font = load(folder.write("a.ttf", source), "0x20-0x7E");
  EXPECT_EQ(font.kerning.value(3, 2), -71);
  EXPECT_EQ(font.kerning.value(2, 3), 30);
  EXPECT_EQ(font.kerning.value(3, 3), -5);
  EXPECT_EQ(font.kerning.value(2, 2), 0);
  EXPECT_EQ(font.kerning.value(1, 2), 0);
  EXPECT_EQ(font.kerning.value(0, 3), 0);
}

TEST(Kerning, IsEmptyWhereTheFontHasNone) {
  const TestFolder folder;
  const SourceFont font =
      load(folder.write("a.ttf", Sfnt::plain()), "0x20-0x7E");
  EXPECT_TRUE(font.kerning.empty());
  EXPECT_EQ(font.kerning.left_classes, 0);
  EXPECT_EQ(font.kerning.right_classes, 0);
}

TEST(Kerning, DoesNotDependOnThreads) {
  const FontFile font(kFonts[2], 0, {});
  std::vector<KerningGlyph> glyphs;
  for (char32_t c = 0x20; c < 0x7f; ++c) {
    glyphs.push_back({font.glyph_of(c), HB_SCRIPT_LATIN});
  }
  const KerningMatrix one = read_kerning(font, glyphs, 1);
  const KerningMatrix four = read_kerning(font, glyphs, 4);
  EXPECT_EQ(one.left_class, four.left_class);
  EXPECT_EQ(one.right_class, four.right_class);
  EXPECT_EQ(one.values, four.values);
}

TEST(Kerning, JoinsEqualRowsAndColumns) {
  // Rows 1 and 3 are equal, 2 is zero; columns 0 and 2 are equal, 1 is zero.
  const KerningMatrix matrix = join_classes(
      4, {1, 2, 3}, {{-5, 0, -5, 7}, {0, 0, 0, 0}, {-5, 0, -5, 7}});
  EXPECT_EQ(matrix.left_classes, 1);
  EXPECT_EQ(matrix.right_classes, 2);
  EXPECT_EQ(matrix.left_class, (std::vector<uint16_t>{0, 1, 0, 1}));
  EXPECT_EQ(matrix.right_class, (std::vector<uint16_t>{1, 0, 1, 2}));
  EXPECT_EQ(matrix.values, (std::vector<int16_t>{-5, 7}));
}

TEST(Kerning, JoinedClassesKeepEveryValue) {
  std::mt19937 random(7);
  constexpr size_t kGlyphs = 40;
  std::vector<size_t> rows_of;
  std::vector<std::vector<int16_t>> rows;
  for (size_t i = 0; i < kGlyphs; i += 2) {
    rows_of.push_back(i);
    std::vector<int16_t> row(kGlyphs);
    for (int16_t& value : row) {
      value = static_cast<int16_t>(random() % 3 == 0 ? random() % 3 : 0);
    }
    rows.push_back(row);
  }
  const KerningMatrix matrix = join_classes(kGlyphs, rows_of, rows);
  for (size_t l = 0; l < kGlyphs; ++l) {
    for (size_t r = 0; r < kGlyphs; ++r) {
      const int expected = l % 2 == 0 ? rows[l / 2][r] : 0;
      ASSERT_EQ(matrix.value(l, r), expected) << l << " " << r;
    }
  }
}

}  // namespace
}  // namespace inkcell::gen::test
