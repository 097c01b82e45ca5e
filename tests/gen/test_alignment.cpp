// Edges, bars and stems that the generator finds, and the section HINT.
#include "alignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "glyph_outlines.hpp"
#include "inkcell/format.hpp"

namespace inkcell::gen::test {
namespace {

Outline outline_of(std::vector<Contour> contours) {
  Outline outline;
  outline.contours = std::move(contours);
  return outline;
}

// A glyph of these contours for the character `c`.
SourceGlyph glyph_of(char32_t c, std::vector<Contour> contours) {
  SourceGlyph glyph;
  glyph.code_points = {c};
  glyph.outline = outline_of(std::move(contours));
  return glyph;
}

Alignment align_all(const SourceFont& font) {
  std::vector<GlyphEdges> found;
  for (const SourceGlyph& glyph : font.glyphs) {
    found.push_back(find_edges(Shape(glyph.outline)));
  }
  return align(font, found);
}

// The letters E, o, x and l in straight lines and circles: baseline 0, x-height
// 500 with an overshoot of 10, capitals and ascenders at 700.
SourceFont letters() {
  SourceFont font;
  font.metrics.units_per_em = 1024;
  font.glyphs.push_back(glyph_of(
      U'E', {rectangle(80, 0, 170, 700), rectangle(80, 0, 480, 80),
             rectangle(80, 310, 440, 390), rectangle(80, 620, 480, 700)}));
  font.glyphs.push_back(
      glyph_of(U'o', {circle(300, 250, 260), circle(300, 250, -180)}));
  font.glyphs.push_back(glyph_of(U'x', {rectangle(60, 0, 400, 500)}));
  font.glyphs.push_back(glyph_of(U'l', {rectangle(90, 0, 180, 700)}));
  return font;
}

// The heights of a glyph's edges, those where bars begin in steps of a
// thousand.
std::vector<int> heights(const Alignment& alignment, size_t glyph) {
  std::vector<int> found;
  for (const AlignmentEdge& edge : alignment.glyphs[glyph].edges) {
    found.push_back(alignment.levels[static_cast<size_t>(edge.level)].y_u +
                    (edge.is_bar ? 10000 : 0));
  }
  return found;
}

TEST(Alignment, FindsBarsAndStemsOfStraightLetters) {
  const SourceFont font = letters();
  const GlyphEdges e = find_edges(Shape(font.glyphs[0].outline));
  ASSERT_EQ(e.bars.size(), 3u);
  EXPECT_EQ(e.bars[0].low, 0);
  EXPECT_EQ(e.bars[0].high, 80);
  EXPECT_EQ(e.bars[1].low, 310);
  EXPECT_EQ(e.bars[2].high, 700);
  EXPECT_EQ(e.bars[1].length, 270);
  ASSERT_EQ(e.stems.size(), 1u);
  EXPECT_EQ(e.stems[0].low, 80);
  EXPECT_EQ(e.stems[0].high, 170);
}

TEST(Alignment, FindsTheEndsOfBends) {
  const SourceFont font = letters();
  const GlyphEdges o = find_edges(Shape(font.glyphs[1].outline));
  ASSERT_EQ(o.bars.size(), 2u);
  EXPECT_NEAR(o.bars[0].low, -10, 0.1);
  EXPECT_NEAR(o.bars[0].high, 70, 0.1);
  EXPECT_NEAR(o.bars[1].low, 430, 0.1);
  EXPECT_NEAR(o.bars[1].high, 510, 0.1);
  ASSERT_EQ(o.stems.size(), 0u);  // too short a part of them is upright
  for (const FlatEdge& edge : o.edges) {
    EXPECT_FALSE(edge.is_flat);
  }
}

TEST(Alignment, SlopesAreNoEdges) {
  const GlyphEdges slope = find_edges(
      Shape(outline_of({polygon({{0, 0}, {400, 120}, {400, 220}, {0, 100}})})));
  EXPECT_TRUE(slope.edges.empty());
  EXPECT_TRUE(slope.bars.empty());
}

TEST(Alignment, ZonesComeFromLetters) {
  const Alignment alignment = align_all(letters());
  std::vector<std::pair<int, bool>> zones;
  for (const AlignmentZone& zone : alignment.zones) {
    zones.emplace_back(alignment.levels[static_cast<size_t>(zone.level)].y_u,
                       zone.is_bottom);
  }
  const std::vector<std::pair<int, bool>> expected = {
      {0, true}, {500, false}, {700, false}};
  EXPECT_EQ(zones, expected);
  EXPECT_EQ(heights(alignment, 0),
            (std::vector<int>{10000, 80, 10310, 390, 10620, 700}));
  EXPECT_EQ(heights(alignment, 1), (std::vector<int>{9990, 70, 10430, 510}));
  // Blocks are no bars; their ends lie in zones.
  EXPECT_EQ(heights(alignment, 2), (std::vector<int>{0, 500}));
  EXPECT_EQ(heights(alignment, 3), (std::vector<int>{0, 700}));
  // Overshoots belong to the zones that they pass.
  for (const AlignmentLevel& level : alignment.levels) {
    EXPECT_EQ(level.zone >= 0, level.y_u <= 0 || level.y_u == 500 ||
                                   level.y_u == 510 || level.y_u == 700)
        << level.y_u;
  }
  EXPECT_EQ(alignment.stem_width_u, 90);
  EXPECT_EQ(alignment.glyphs[3].stem_u, 135);
  EXPECT_EQ(alignment.glyphs[3].stems, 1);
}

TEST(Alignment, MetricsStandInForLetters) {
  SourceFont font = letters();
  font.metrics.units_per_em = 2048;
  font.metrics.x_height = 1000;
  for (SourceGlyph& glyph : font.glyphs) {
    glyph.code_points = {U'\u4e00'};
  }
  const Alignment alignment = align_all(font);
  ASSERT_EQ(alignment.zones.size(), 2u);
  EXPECT_EQ(alignment.levels[static_cast<size_t>(alignment.zones[1].level)].y_u,
            500);
}

TEST(Alignment, SharesLists) {
  SourceFont font = letters();
  const size_t before = hint_section(align_all(font)).size();
  // A row of the table, 25 bits, but no list.
  font.glyphs.push_back(font.glyphs[0]);
  const size_t after = hint_section(align_all(font)).size();
  EXPECT_LE(after, before + 4);
  EXPECT_TRUE(hint_section(Alignment()).empty());
}

TEST(Alignment, ManyHeightsBecomeFewLevels) {
  SourceFont font;
  font.metrics.units_per_em = 1000;
  for (int i = 0; i < 300; ++i) {
    font.glyphs.push_back(
        glyph_of(0x4e00 + static_cast<char32_t>(i),
                 {rectangle(0, -200.0 + 4 * i, 500, -150.0 + 4 * i)}));
  }
  const Alignment alignment = align_all(font);
  EXPECT_LE(alignment.levels.size(), format::hints::kMaxLevels);
  EXPECT_GT(alignment.levels.size(), 60u);
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    ASSERT_FALSE(alignment.glyphs[i].edges.empty());
    const int last = heights(alignment, i).back() % 10000;
    EXPECT_NEAR(last, -150 + 4 * static_cast<int>(i), 8);
  }
}

TEST(Alignment, NothingFarIsKept) {
  SourceFont font;
  font.metrics.units_per_em = 1000;
  font.glyphs.push_back(glyph_of(U'-', {rectangle(9000, 3000, 9300, 3080)}));
  font.glyphs.push_back(glyph_of(U'|', {rectangle(9000, 0, 9090, 700)}));
  const Alignment alignment = align_all(font);
  EXPECT_TRUE(alignment.glyphs[0].edges.empty());
  EXPECT_EQ(alignment.glyphs[1].stems, 0);
}

}  // namespace
}  // namespace inkcell::gen::test
