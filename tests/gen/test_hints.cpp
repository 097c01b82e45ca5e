// Features for grid fitting found in outlines, and their bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "glyph_outlines.hpp"
#include "hints/face.hpp"
#include "hints/features.hpp"
#include "hints/glyph_hints.hpp"
#include "hints/grid_section.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "judge/hint_trial.hpp"
#include "outline_reader.hpp"
#include "outlines/unite.hpp"
#include "pipeline/font_hints.hpp"
#include "pipeline/generate.hpp"
#include "rom/outline_font.hpp"

namespace inkcell::gen::test {
namespace {

using Kind = Stroke::Kind;
using Height = HeightHint::Kind;

constexpr double kClose = 3;  // [u]

GlyphFeatures features(const std::string& font, char32_t letter) {
  return find_features(unite(load_outlines(font, 0, {letter})[0]));
}

// Letters of a font and the hints of their face.
struct Letters {
  Letters(const std::string& font, const std::u32string& letters) {
    for (const char32_t letter : letters) {
      glyph_of[letter] = static_cast<uint16_t>(glyphs.size());
      glyphs.push_back(features(font, letter));
    }
    face = find_face(glyphs, glyph_of);
  }

  GlyphHints hints(char32_t letter) const {
    const GlyphFeatures& glyph = glyphs[glyph_of.at(letter)];
    return make_glyph_hints(glyph, face, {glyph.box.x0, glyph.box.x1});
  }

  std::map<char32_t, uint16_t> glyph_of;
  std::vector<GlyphFeatures> glyphs;
  FaceHints face;
};

std::u32string printable() {
  std::u32string all;
  for (const uint32_t c : ascii()) {
    all += c;
  }
  return all;
}

size_t count(const GlyphHints& hints, Height kind) {
  return static_cast<size_t>(
      std::count_if(hints.heights.begin(), hints.heights.end(),
                    [kind](const auto& hint) { return hint.kind == kind; }));
}

TEST(Hints, AStemIsSymmetricAndHasTwoLoneEdges) {
  const GlyphFeatures glyph = find_features({{rectangle(100, 0, 190, 700)}});
  ASSERT_EQ(glyph.stems.size(), 1u);
  EXPECT_EQ(glyph.stems[0].low, 100);
  EXPECT_EQ(glyph.stems[0].high, 190);
  EXPECT_TRUE(glyph.bars.empty());
  ASSERT_EQ(glyph.lone_edges.size(), 2u);
  EXPECT_EQ(glyph.lone_edges[0].position, 0);
  EXPECT_TRUE(glyph.lone_edges[0].ink_beyond);
  EXPECT_EQ(glyph.lone_edges[1].position, 700);
  EXPECT_FALSE(glyph.lone_edges[1].ink_beyond);
  EXPECT_TRUE(glyph.is_symmetric);
}

TEST(Hints, ABarIsNoStem) {
  const GlyphFeatures glyph = find_features({{rectangle(50, 200, 450, 280)}});
  ASSERT_EQ(glyph.bars.size(), 1u);
  EXPECT_EQ(glyph.bars[0].low, 200);
  EXPECT_EQ(glyph.bars[0].high, 280);
  EXPECT_EQ(glyph.bars[0].kind, Kind::plain);
  EXPECT_TRUE(glyph.stems.empty());
}

// A stem with a foot of these heights at its tips and at the stem.
GlyphFeatures foot(double tip, double middle) {
  return find_features({{polygon({{0, 0},
                                  {300, 0},
                                  {300, tip},
                                  {195, middle},
                                  {195, 700},
                                  {105, 700},
                                  {105, middle},
                                  {0, tip}})}});
}

TEST(Hints, WingsAtTheEndOfAStemAreASerif) {
  const GlyphFeatures glyph = foot(30, 30);
  ASSERT_EQ(glyph.bars.size(), 1u);
  EXPECT_EQ(glyph.bars[0].kind, Kind::serif);
  EXPECT_EQ(glyph.bars[0].high, 30);
  EXPECT_EQ(glyph.body.low, 105);
  EXPECT_EQ(glyph.body.high, 195);
  // An arm is longer than a serif.
  const GlyphFeatures arm = find_features({{polygon(
      {{0, 0}, {400, 0}, {400, 30}, {90, 30}, {90, 700}, {0, 700}})}});
  ASSERT_EQ(arm.bars.size(), 1u);
  EXPECT_EQ(arm.bars[0].kind, Kind::plain);
}

TEST(Hints, ACuppedFootIsASerif) {
  const GlyphFeatures glyph = foot(12, 60);
  ASSERT_EQ(glyph.bars.size(), 1u);
  EXPECT_EQ(glyph.bars[0].kind, Kind::serif);
  EXPECT_EQ(glyph.bars[0].low, 0);
  EXPECT_LT(glyph.bars[0].high, 60);
}

TEST(Hints, BentStrokesHaveRoundEdgesAtTheirExtremes) {
  Contour counter = circle(300, 250, -180);
  const GlyphFeatures ring = find_features({{circle(300, 250, 260), counter}});
  ASSERT_EQ(ring.bars.size(), 2u);
  EXPECT_TRUE(ring.bars[0].is_round);
  EXPECT_NEAR(ring.bars[0].low, -10, 0.1);
  EXPECT_NEAR(ring.bars[0].high, 70, 0.1);
  ASSERT_EQ(ring.stems.size(), 2u);
  EXPECT_NEAR(ring.stems[1].high, 560, 0.1);
  EXPECT_TRUE(ring.is_symmetric);
}

TEST(Hints, DiagonalsAreNoStems) {
  EXPECT_TRUE(
      find_features({{polygon({{0, 0}, {80, 0}, {180, 700}, {100, 700}})}})
          .stems.empty());
}

TEST(Hints, AnEHasThreeBarsAndAFreeEnd) {
  for (const char* font : {kDejaVuSans, kRoboto}) {
    const GlyphFeatures glyph = features(font, 'e');
    EXPECT_EQ(glyph.bars.size(), 3u) << font;
    EXPECT_TRUE(std::any_of(glyph.ends.begin(), glyph.ends.end(),
                            [](const FreeEnd& end) { return end.rises; }))
        << font;
    EXPECT_FALSE(glyph.is_symmetric);
  }
}

TEST(Hints, AnSHasASpineBetweenTwoFreeEnds) {
  for (const char* font : {kDejaVuSans, kLiberationSerif, kRoboto}) {
    for (const char letter : {'s', 'S'}) {
      const GlyphFeatures glyph = features(font, static_cast<char32_t>(letter));
      ASSERT_EQ(glyph.bars.size(), 3u) << font << letter;
      EXPECT_EQ(glyph.bars[1].kind, Kind::spine) << font << letter;
      const double middle = (glyph.box.y0 + glyph.box.y1) / 2;
      EXPECT_NEAR(glyph.bars[1].middle(), middle, 25) << font << letter;
      ASSERT_EQ(glyph.ends.size(), 2u) << font << letter;
      EXPECT_TRUE(glyph.ends[0].rises);
      EXPECT_FALSE(glyph.ends[1].rises);
    }
  }
}

TEST(Hints, BarsAndStemsOfLetters) {
  struct Expected {
    char32_t letter;
    size_t bars;
    size_t stems;
  };
  for (const char* font : {kDejaVuSans, kRoboto}) {
    const Letters letters(font, printable());
    for (const Expected& expected :
         {Expected{U'n', 1, 2}, Expected{U'm', 1, 3}, Expected{U'h', 1, 2},
          Expected{U'u', 1, 2}, Expected{U'o', 2, 2}, Expected{U'B', 3, 2},
          Expected{U'8', 3, 2}, Expected{U'E', 3, 1}, Expected{U'H', 1, 2},
          Expected{U'z', 2, 0}, Expected{U'T', 1, 1}, Expected{U'v', 0, 0}}) {
      const GlyphHints hints = letters.hints(expected.letter);
      const std::string name =
          font + std::string(" ") + static_cast<char>(expected.letter);
      EXPECT_EQ(count(hints, Height::bar), expected.bars) << name;
      EXPECT_EQ(hints.stems.size(), expected.stems) << name;
      EXPECT_EQ(count(hints, Height::serif), 0u) << name;
    }
  }
}

TEST(Hints, SymmetricLetters) {
  for (const char* font : {kDejaVuSans, kRoboto}) {
    for (const char letter : std::string("AHIMOTUVWXYovwx08")) {
      EXPECT_TRUE(features(font, static_cast<char32_t>(letter)).is_symmetric)
          << font << letter;
    }
    for (const char letter : std::string("BCDEFGJKLPRabcdefghjkpqrty")) {
      EXPECT_FALSE(features(font, static_cast<char32_t>(letter)).is_symmetric)
          << font << letter;
    }
  }
}

TEST(Hints, SerifsOfASerifFace) {
  const Letters letters(kLiberationSerif, printable());
  EXPECT_TRUE(letters.face.has_contrast);
  for (const char32_t letter : {U'l', U'h', U'I', U'H', U'M', U'i'}) {
    EXPECT_EQ(count(letters.hints(letter), Height::serif), 2u)
        << static_cast<char>(letter);
    EXPECT_GT(letters.hints(letter).left_inset_u, 0);
  }
  for (const char32_t letter : {U'o', U'z', U'E', U'[', U'e'}) {
    EXPECT_EQ(count(letters.hints(letter), Height::serif), 0u)
        << static_cast<char>(letter);
  }
}

TEST(Hints, ZonesOfLatinType) {
  const Letters letters(kDejaVuSans, printable());
  const FaceHints& face = letters.face;
  ASSERT_TRUE(face.x_zone.has_value());
  const HintZone& x_height = face.zones[*face.x_zone];
  EXPECT_NEAR(x_height.flat_u, 560, 1);
  EXPECT_NEAR(x_height.overshoot_u, 14, 1);
  EXPECT_TRUE(x_height.is_top);
  for (const double y : {0.0, -14.5}) {
    const std::optional<ZoneEdge> edge = zone_of(face, y, false);
    ASSERT_TRUE(edge.has_value());
    EXPECT_EQ(face.zones[edge->zone].flat_u, 0);
    EXPECT_EQ(edge->is_round, y < 0);
  }
  EXPECT_FALSE(zone_of(face, 300, true).has_value());
  EXPECT_NEAR(face.stem_width_u, 92, kClose);
  EXPECT_NEAR(face.bar_width_u, 77, kClose);
}

TEST(Hints, ZonesOfAnyCharacters) {
  const Letters digits(kRoboto, U"0123456789");
  EXPECT_TRUE(zone_of(digits.face, 728, true).has_value());
  ASSERT_TRUE(zone_of(digits.face, 0, false).has_value());
  EXPECT_TRUE(zone_of(digits.face, -10, false)->is_round);
  const Letters cyrillic(kDejaVuSans, U"нптсо");
  ASSERT_TRUE(cyrillic.face.x_zone.has_value());
  EXPECT_NEAR(cyrillic.face.zones[*cyrillic.face.x_zone].flat_u, 560, 1);
  const Letters hanzi(kNotoSansCjk, U"一二三口日目田中");
  EXPECT_FALSE(hanzi.face.x_zone.has_value());
  const Letters none(kRoboto, U"");
  EXPECT_TRUE(none.face.zones.empty());
}

TEST(Hints, HeightsThatNoLetterNamesAreFoundWhereGlyphsShareThem) {
  std::vector<GlyphFeatures> glyphs;
  for (int i = 0; i < 6; ++i) {
    glyphs.push_back(find_features({{rectangle(100, -90, 190 + 40 * i, 840),
                                     rectangle(0, 300, 90, 340)}}));
  }
  const FaceHints face = find_face(glyphs, {});
  EXPECT_TRUE(zone_of(face, -90, false).has_value());
  EXPECT_TRUE(zone_of(face, 840, true).has_value());
  EXPECT_FALSE(zone_of(face, 840, false).has_value());
}

TEST(Hints, OfBarsSideBySideOneStays) {
  const GlyphFeatures glyph = find_features(
      {{rectangle(0, 300, 200, 360), rectangle(300, 330, 600, 390)}});
  ASSERT_EQ(glyph.bars.size(), 2u);
  const GlyphHints hints = make_glyph_hints(glyph, FaceHints(), {0, 600});
  ASSERT_EQ(hints.heights.size(), 1u);
  EXPECT_EQ(hints.heights[0].edge.position_u, 330);
}

TEST(Hints, MapsHaveFewKnots) {
  const std::vector<uint32_t> hanzi = {0x9f9c, 0x9b31, 0x9f3b, 0x91cf};
  std::vector<GlyphFeatures> glyphs;
  for (const Outline& outline : load_outlines(kNotoSansCjk, 0, hanzi)) {
    glyphs.push_back(find_features(unite(outline)));
  }
  const FaceHints face = find_face(glyphs, {});
  for (const GlyphFeatures& glyph : glyphs) {
    const GlyphHints hints =
        make_glyph_hints(glyph, face, {glyph.box.x0, glyph.box.x1});
    const size_t bars = count(hints, Height::bar) + count(hints, Height::serif);
    EXPECT_LE(hints.heights.size() + bars, format::grid::kMaxKnots);
    EXPECT_LE(2 * hints.stems.size() + 2, format::grid::kMaxKnots);
    EXPECT_GT(bars, 0u);
  }
}

std::string text_of(const HintBits& bits) {
  std::string text;
  for (const bool bit : bits) {
    text += bit ? '1' : '0';
  }
  return text;
}

// One glyph: all of its words take no bits.
TEST(Hints, OfOneGlyphAreInTheTables) {
  FontHints font;
  font.face.zones = {{0, 0, false}, {500, 20, true}};
  font.face.bar_width_u = 80;
  GlyphHints hints;
  hints.is_symmetric = true;
  HeightHint bar;
  bar.edge.zone = ZoneEdge{1, true};
  bar.is_top_edge = true;
  hints.heights.push_back(bar);
  StemHint stem;
  stem.position_u = 100;
  stem.width_u = 90;
  hints.stems.push_back(stem);
  font.glyphs = {hints};
  const HintCode code(font, format::grid::kMaxCodeBits);
  EXPECT_TRUE(code.bits(hints).empty());
  const std::vector<uint8_t> section = code.section();
  ASSERT_EQ(section.size(), 8u + 2 * 4 + 6 * 2);
  EXPECT_EQ(section[5], 0);
  // x from (100 + 512) / 2 on, in steps of 4: 76 * 4, and 2 more.
  EXPECT_EQ(section[7], 76);
  const auto entry = [&section](size_t table) {
    return section[16 + 2 * table] | section[17 + 2 * table] << 8;
  };
  EXPECT_EQ(entry(format::grid::kHeads), (0x100 | 1 << 3 | 1) << 7);
  EXPECT_EQ(entry(format::grid::kHeights), (0x20 | 2 << 1 | 1) << 7);
  EXPECT_EQ(entry(format::grid::kWidthsY), 0);
  EXPECT_EQ(entry(format::grid::kGapsX), 2 << 7);
  EXPECT_EQ(entry(format::grid::kWidthsX), 45 << 7);
}

TEST(Hints, WordsAreAPrefixCodeFromTheLowestBitOn) {
  const NumberCode code({{3, 8}, {20, 2}, {21, 2}, {1000, 1}}, 3);
  HintBits often;
  code.put(3, often);
  EXPECT_EQ(text_of(often), "0");
  HintBits seldom;
  code.put(1000, seldom);
  HintBits lower;
  code.put(20, lower);
  HintBits more;
  code.put(21, more);
  EXPECT_EQ(code.total_bits(), 8 * often.size() + 2 * lower.size() +
                                   2 * more.size() + seldom.size());
  const std::vector<uint16_t> table = code.table();
  ASSERT_EQ(table.size(), 8u);
  // What a reader makes of the bits.
  const auto read = [&table](const HintBits& bits) {
    const auto value = [&bits](size_t from, size_t count) {
      uint32_t number = 0;
      for (size_t i = 0; i < count && from + i < bits.size(); ++i) {
        number |= (bits[from + i] ? 1u : 0u) << i;
      }
      return number;
    };
    const uint32_t entry = table[value(0, 3)];
    return (entry >> 7) + value(entry & 7, entry >> 3 & 15);
  };
  EXPECT_EQ(read(often), 3u);
  EXPECT_EQ(read(lower), 20u);
  EXPECT_EQ(read(more), 21u);
  EXPECT_EQ(read(seldom), 1000u);
}

TEST(Hints, OfAFontTakeAFewBytesAGlyph) {
  struct Expected {
    const char* file;
    double most;  // bytes a glyph
  };
  for (const Expected& expected :
       {Expected{kDejaVuSans, 7}, Expected{kLiberationSerif, 7.6},
        Expected{kRoboto, 7}}) {
    const Letters letters(expected.file, printable());
    FontHints hints;
    hints.face = letters.face;
    for (const uint32_t c : ascii()) {
      hints.glyphs.push_back(letters.hints(c));
    }
    const HintCode code(hints, format::grid::kMaxCodeBits);
    size_t bits = 8 * code.section().size();
    for (const GlyphHints& glyph : hints.glyphs) {
      bits += code.bits(glyph).size();
    }
    const double bytes = static_cast<double>(bits) / 8 /
                         static_cast<double>(hints.glyphs.size());
    EXPECT_LE(bytes, expected.most) << expected.file;
  }
}

// A canvas drawn as text.
Topology topology(const std::vector<std::string>& rows) {
  const auto width = static_cast<int>(rows[0].size());
  Canvas canvas({0, 0, width, static_cast<int>(rows.size())});
  const Sink sink = canvas.sink();
  for (size_t y = 0; y < rows.size(); ++y) {
    for (int x = 0; x < width; ++x) {
      if (rows[y][static_cast<size_t>(x)] == '#') {
        sink.solid(sink.context, x, static_cast<int32_t>(y), 1);
      }
    }
  }
  return topology_of(canvas);
}

TEST(Hints, PartsTouchAtCornersCountersDoNot) {
  const Topology ring = topology({"####", "#..#", "####"});
  EXPECT_EQ(1, ring.parts);
  EXPECT_EQ(1, ring.counters);
  const Topology diagonals = topology({".#.", "#.#", ".#.", "...", "..#"});
  EXPECT_EQ(2, diagonals.parts);
  EXPECT_EQ(1, diagonals.counters);
  EXPECT_EQ(0, topology({"...", "..."}).counters);
}

// A frame of 600 x 420 u around a counter of 400 x 220 u, in a font with a zone
// near the counter's bottom.
RomContent framed(const GlyphHints& hints) {
  RomContent content;
  content.name = "frame";
  content.options.coding = Coding::outline;
  content.metrics.units_per_em = 1024;
  RomGlyph glyph;
  glyph.outline.contours = {{{{0, 0, kCorner},
                              {600, 0, kCorner},
                              {600, 420, kCorner},
                              {0, 420, kCorner}}},
                            {{{100, 100, kCorner},
                              {100, 320, kCorner},
                              {500, 320, kCorner},
                              {500, 100, kCorner}}}};
  glyph.metrics.x_max = 600;
  glyph.metrics.y_max = 420;
  glyph.metrics.advance = 650;
  content.glyphs = {glyph};
  content.hints.face.zones = {HintZone()};
  content.hints.face.zones[0].flat_u = 90;
  content.hints.glyphs = {hints};
  encode_outlines(content);
  return content;
}

TEST(Hints, WhatSpoilsAGlyphIsDropped) {
  // A false serif vanishes, and the counter with it.
  HeightHint serif;
  serif.kind = Height::serif;
  serif.edge.zone = ZoneEdge{0, false};
  serif.width_u = 240;
  GlyphHints hints;
  hints.is_symmetric = true;
  hints.heights = {serif};
  RomContent content = framed(hints);
  drop_harmful_hints(content, 1);
  EXPECT_TRUE(content.hints.glyphs[0].heights.empty());
  EXPECT_TRUE(content.hints.glyphs[0].is_symmetric);

  // With hints for the bars there is no fault.
  HeightHint bar;
  bar.width_u = 100;
  hints.heights = {bar, bar};
  hints.heights[1].edge.position_u = 320;
  content = framed(hints);
  drop_harmful_hints(content, 2);
  EXPECT_EQ(2u, content.hints.glyphs[0].heights.size());
}

TEST(Hints, SmallPartsAreStrokes) {
  const GlyphFeatures colon = features(
      "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Thin.ttf",
      U':');
  EXPECT_EQ(2u, colon.bars.size());
  EXPECT_EQ(1u, colon.stems.size());
}

// Parts one above the other, of what covers half of a pixel.
int bands_of(const Font& font, uint16_t glyph, const Style& style) {
  Canvas canvas({-8, -160, 160, 40});
  Painter(canvas.sink()).glyph(font, style, {}, glyph);
  int bands = 0;
  bool was_ink = false;
  for (int y = canvas.area().y0; y < canvas.area().y1; ++y) {
    bool is_ink = false;
    for (int x = canvas.area().x0; x < canvas.area().x1; ++x) {
      is_ink = is_ink || canvas.at(x, y) >= 128;
    }
    bands += is_ink && !was_ink ? 1 : 0;
    was_ink = is_ink;
  }
  return bands;
}

TEST(Hints, PartsStayApartInOneBit) {
  const std::u32string letters = U"ij:;=\u00C9\u00CA\u00E0\u00E9\u00EE\u00F1";
  for (const char* file :
       {"/usr/share/fonts/truetype/lato/Lato-Regular.ttf",
        "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"}) {
    GenerateRequest request;
    request.font = file;
    request.target.tolerance = 64;
    request.target.max_px = 20;
    request.chars = {"0x20-0x7E"};
    for (const char32_t letter : letters) {
      request.symbols += to_utf8(letter);
    }
    const RomFont made = generate(request);
    Font font;
    ASSERT_EQ(Status::ok,
              Font::open({made.bytes.data(), made.bytes.size()}, font));
    for (const char32_t letter : letters) {
      const uint16_t glyph = font.glyph_or_notdef(letter);
      const int bands =
          bands_of(font, glyph, Style(Q26_6::from_int(128), kFilterArea));
      for (int px = 9; px <= 20; ++px) {
        const Style style = two_level_style(Q26_6::from_int(px));
        EXPECT_EQ(bands, bands_of(font, glyph, style))
            << file << ", " << to_utf8(letter) << ", " << px << " px";
      }
    }
  }
}

TEST(Hints, FontsOfPixelsHaveNone) {
  RomContent content = framed(GlyphHints());
  EXPECT_FALSE(find_hints(content, 1).empty());
  // The same of pixels of 128 u.
  auto& contours = content.glyphs[0].outline.contours;
  for (auto& contour : contours) {
    for (auto& point : contour.points) {
      point.x = (point.x + 60) / 128 * 128;
      point.y = (point.y + 60) / 128 * 128;
    }
  }
  encode_outlines(content);
  EXPECT_TRUE(find_hints(content, 1).empty());
}

}  // namespace
}  // namespace inkcell::gen::test
