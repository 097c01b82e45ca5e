// Shaped lines against HarfBuzz alone, and known results of some scripts.
#include "source/line_shaper.hpp"

#include <gtest/gtest.h>
#include <hb.h>

#include <memory>
#include <string>

namespace inkcell::gen::test {
namespace {

constexpr char kSans[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr char kDevanagari[] =
    "/usr/share/fonts/truetype/lohit-devanagari/Lohit-Devanagari.ttf";
constexpr char kThai[] = "/usr/share/fonts/truetype/tlwg/Loma.ttf";

FontFile open(const char* file) {
  return FontFile(file, 0, {});
}

LineText line(const std::u32string& text) {
  LineText out;
  out.text = text;
  return out;
}

std::vector<std::string> names_of(const FontFile& font,
                                  const ShapedLine& shaped) {
  std::vector<std::string> names;
  for (const LineGlyph& glyph : shaped.glyphs) {
    char name[64] = "";
    hb_font_get_glyph_name(font.hb(), glyph.source, name, sizeof name);
    names.push_back(name);
  }
  return names;
}

using Names = std::vector<std::string>;

bool has_ink(const FontFile& font, uint32_t glyph) {
  hb_glyph_extents_t box = {};
  hb_font_get_glyph_extents(font.hb(), glyph, &box);
  return box.width != 0;
}

// The same text by HarfBuzz alone: correct if all of it has one direction and
// one script.
ShapedLine by_harfbuzz(const FontFile& font, const std::u32string& text) {
  const std::unique_ptr<hb_buffer_t, void (*)(hb_buffer_t*)> buffer(
      hb_buffer_create(), hb_buffer_destroy);
  const std::vector<uint32_t> codes(text.begin(), text.end());
  hb_buffer_add_utf32(buffer.get(), codes.data(),
                      static_cast<int>(codes.size()), 0, -1);
  hb_buffer_set_language(buffer.get(), hb_language_from_string("und", -1));
  hb_buffer_guess_segment_properties(buffer.get());
  hb_shape(font.hb(), buffer.get(), nullptr, 0);
  unsigned count = 0;
  const auto* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const auto* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
  ShapedLine out;
  for (unsigned i = 0; i < count; ++i) {
    if (has_ink(font, infos[i].codepoint)) {
      out.glyphs.push_back({0, infos[i].codepoint,
                            out.advance + places[i].x_offset,
                            places[i].y_offset});
    }
    out.advance += places[i].x_advance;
  }
  return out;
}

void check_like_harfbuzz(const char* file, const std::u32string& text) {
  const FontFile font = open(file);
  const ShapedLine shaped = shape_line({&font}, line(text));
  const ShapedLine expected = by_harfbuzz(font, text);
  EXPECT_TRUE(shaped.missing.empty());
  EXPECT_EQ(shaped.advance, expected.advance);
  ASSERT_EQ(shaped.glyphs.size(), expected.glyphs.size());
  for (size_t i = 0; i < shaped.glyphs.size(); ++i) {
    EXPECT_EQ(shaped.glyphs[i].source, expected.glyphs[i].source) << i;
    EXPECT_EQ(shaped.glyphs[i].x, expected.glyphs[i].x) << i;
    EXPECT_EQ(shaped.glyphs[i].y, expected.glyphs[i].y) << i;
  }
}

TEST(LineShaper, IsHarfBuzzForOneScript) {
  check_like_harfbuzz(kSans, U"AVATAR office affluent");
  check_like_harfbuzz(kSans, U"السلام عليكم");
  check_like_harfbuzz(kSans, U"لَا إِلٰهَ");
  check_like_harfbuzz(kSans, U"שָׁלוֹם");
  check_like_harfbuzz(kSans, U"a\u0301e\u0302\u0323");
  check_like_harfbuzz(kDevanagari, U"क्षत्रिय हिन्दी किं श्रीमान्");
  check_like_harfbuzz(kThai, U"ที่นี่ น้ำ ปู่ กุ้ง");
}

TEST(LineShaper, JoinsLatinLigatures) {
  const FontFile font = open(kSans);
  EXPECT_EQ(names_of(font, shape_line({&font}, line(U"fi"))), (Names{"fi"}));
}

TEST(LineShaper, JoinsArabicLetters) {
  const FontFile font = open(kSans);
  // Lam and alef are one glyph. Meem is isolated: alef does not join the next
  // letter.
  EXPECT_EQ(names_of(font, shape_line({&font}, line(U"لا"))),
            (Names{"uniFEFB"}));
  EXPECT_EQ(names_of(font, shape_line({&font}, line(U"سلام"))),
            (Names{"uni0645", "uniFEFC", "uniFEB3"}));
}

TEST(LineShaper, OrdersIndicSyllables) {
  const FontFile font = open(kDevanagari);
  const ShapedLine ki = shape_line({&font}, line(U"कि"));
  // The vowel sign i is before the letter that it follows in the text.
  ASSERT_EQ(ki.glyphs.size(), 2u);
  EXPECT_EQ(ki.glyphs[1].source, font.glyph_of(U'क'));
  // Ka, virama and ssa are one glyph.
  EXPECT_EQ(shape_line({&font}, line(U"क्ष")).glyphs.size(), 1u);
}

TEST(LineShaper, PlacesThaiMarks) {
  const FontFile font = open(kThai);
  const ShapedLine shaped = shape_line({&font}, line(U"ที่"));
  ASSERT_EQ(shaped.glyphs.size(), 3u);
  // Both marks are above the letter and take no space.
  EXPECT_LE(shaped.glyphs[1].x, shaped.advance);
  EXPECT_LE(shaped.glyphs[2].x, shaped.advance);
  EXPECT_EQ(shaped.advance,
            hb_font_get_glyph_h_advance(font.hb(), font.glyph_of(U'ท')));
}

TEST(LineShaper, OrdersMixedLines) {
  const FontFile font = open(kSans);
  const auto ids = [&](const LineText& text) {
    std::vector<uint32_t> out;
    for (const LineGlyph& glyph : shape_line({&font}, text).glyphs) {
      out.push_back(glyph.source);
    }
    return out;
  };
  const auto expected = [&](const std::u32string& visual) {
    std::vector<uint32_t> out;
    for (const char32_t c : visual) {
      out.push_back(font.glyph_of(c));
    }
    return out;
  };
  EXPECT_EQ(ids(line(U"ab \u05d0\u05d1 12 cd")),
            expected(U"ab12\u05d1\u05d0cd"));
  // Its first letter makes it run from right to left.
  EXPECT_EQ(ids(line(U"\u05d0\u05d1 (ab) 5")), expected(U"5(ab)\u05d1\u05d0"));
  LineText stated = line(U"ab \u05d0\u05d1");
  stated.direction = LineDirection::right_to_left;
  EXPECT_EQ(ids(stated), expected(U"\u05d1\u05d0ab"));
  stated = line(U"\u05d0 a");
  stated.direction = LineDirection::left_to_right;
  EXPECT_EQ(ids(stated), expected(U"\u05d0a"));
}

// Controls of direction do not separate joined letters.
TEST(LineShaper, ShowsNothingForControlsOfDirection) {
  const FontFile font = open(kSans);
  const ShapedLine plain = shape_line({&font}, line(U"ab"));
  const ShapedLine marked = shape_line({&font}, line(U"\u200ea\u200db\u00ad"));
  EXPECT_EQ(names_of(font, marked), names_of(font, plain));
  EXPECT_EQ(marked.advance, plain.advance);
  EXPECT_TRUE(marked.missing.empty());
}

// Only Loma has Thai; both have digits, blanks and Latin.
TEST(LineShaper, TakesRunsFromSeveralFaces) {
  const FontFile sans = open(kSans);
  const FontFile thai = open(kThai);
  const ShapedLine mixed =
      shape_line({&sans, &thai}, line(U"fi \u0e17\u0e35\u0e48 12"));
  ASSERT_EQ(mixed.glyphs.size(), 6u);
  EXPECT_TRUE(mixed.missing.empty());
  const std::vector<size_t> faces = {0, 1, 1, 1, 0, 0};
  for (size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(mixed.glyphs[i].face, faces[i]) << i;
  }
  // Each run is as its face shapes it alone. Both have 2048 units per em.
  const ShapedLine head = shape_line({&sans}, line(U"fi "));
  const ShapedLine body = shape_line({&thai}, line(U"\u0e17\u0e35\u0e48"));
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mixed.glyphs[1 + i].source, body.glyphs[i].source) << i;
    EXPECT_EQ(mixed.glyphs[1 + i].x, head.advance + body.glyphs[i].x);
    EXPECT_EQ(mixed.glyphs[1 + i].y, body.glyphs[i].y) << i;
  }
  EXPECT_EQ(mixed.advance, head.advance + body.advance +
                               shape_line({&sans}, line(U" 12")).advance);
}

// Loma has x, but no U+0302.
TEST(LineShaper, KeepsMarksInTheFaceOfTheirLetter) {
  const FontFile sans = open(kSans);
  const FontFile thai = open(kThai);
  const ShapedLine shaped =
      shape_line({&thai, &sans}, line(U"xx\u0302x\u200d"));
  ASSERT_EQ(shaped.glyphs.size(), 4u);
  const std::vector<size_t> faces = {0, 1, 1, 0};
  for (size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(shaped.glyphs[i].face, faces[i]) << i;
  }
  EXPECT_TRUE(shaped.missing.empty());
  // The letter stays in its face if no face has the mark.
  const ShapedLine other = shape_line({&thai, &sans}, line(U"x\U0001e8d0"));
  EXPECT_EQ(other.glyphs.front().face, 0u);
  EXPECT_EQ(other.missing, (std::vector<char32_t>{0x1e8d0}));
}

TEST(LineShaper, TellsWhatIsMissing) {
  const FontFile font = open(kSans);
  const ShapedLine shaped = shape_line({&font}, line(U"a\u4e2d\u4e00\u4e2db"));
  EXPECT_EQ(shaped.missing, (std::vector<char32_t>{0x4e00, 0x4e2d}));
  EXPECT_EQ(names_of(font, shaped),
            (Names{"a", ".notdef", ".notdef", ".notdef", "b"}));
}

TEST(LineShaper, TakesEmptyLinesAndBlanks) {
  const FontFile font = open(kSans);
  EXPECT_TRUE(shape_line({&font}, line(U"")).glyphs.empty());
  EXPECT_EQ(shape_line({&font}, line(U"")).advance, 0);
  const ShapedLine blank = shape_line({&font}, line(U"  "));
  EXPECT_TRUE(blank.glyphs.empty());
  EXPECT_EQ(blank.advance,
            2 * hb_font_get_glyph_h_advance(font.hb(), font.glyph_of(U' ')));
}

}  // namespace
}  // namespace inkcell::gen::test
