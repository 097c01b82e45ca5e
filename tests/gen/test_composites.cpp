// Glyphs stored as references: from the font file, and by a search.
#include <gtest/gtest.h>

#include "outlines/composites.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "outline_reader.hpp"
#include "sfnt_builder.hpp"
#include "source/composites.hpp"

namespace inkcell::gen::test {
namespace {

MinimalContour square(int x, int y, int size) {
  return {{{x, y, kCorner},
           {x + size, y, kCorner},
           {x + size, y + size, kCorner},
           {x, y + size, kCorner}}};
}

MinimalContour hole(int x, int y, int size) {
  return {{{x, y, kCorner},
           {x, y + size, kCorner},
           {x + size, y + size, kCorner},
           {x + size, y, kCorner}}};
}

// A glyph whose simple record is longer than any composite one here.
CompositeCandidate glyph(std::vector<MinimalContour> contours,
                         OutlineReferences source = {}) {
  return {{std::move(contours)}, 100, std::move(source)};
}

OutlineReference at(size_t glyph, int dx, int dy) {
  OutlineReference reference;
  reference.glyph = glyph;
  reference.dx = dx;
  reference.dy = dy;
  return reference;
}

using Listed = std::multiset<std::array<int, 3>>;

Listed listed(const OutlineReferences& references) {
  Listed list;
  for (const OutlineReference& reference : references) {
    EXPECT_FALSE(reference.has_matrix());
    list.insert(
        {static_cast<int>(reference.glyph), reference.dx, reference.dy});
  }
  return list;
}

TEST(Composites, AGlyphOfTwoOthers) {
  // 'e' with a hole, an accent, and the accented letter in another order.
  const auto found = find_composites(
      {glyph({square(0, 0, 400), hole(100, 100, 200)}),
       glyph({square(90, 500, 80)}),
       glyph({square(120, 600, 80), square(10, 0, 400), hole(110, 100, 200)})},
      0);
  EXPECT_TRUE(found[0].empty());
  EXPECT_TRUE(found[1].empty());
  EXPECT_EQ(listed(found[2]), (Listed{{0, 10, 0}, {1, 30, 100}}));
}

TEST(Composites, ContoursMayBeginAtAnyOfTheirPoints) {
  MinimalContour turned = square(7, 9, 50);
  std::rotate(turned.points.begin(), turned.points.begin() + 2,
              turned.points.end());
  const auto found =
      find_composites({glyph({square(0, 0, 50)}), glyph({turned})}, 0);
  EXPECT_TRUE(found[0].empty());
  EXPECT_EQ(listed(found[1]), (Listed{{0, 7, 9}}));
}

TEST(Composites, OnePointThatDiffersIsAnotherContour) {
  MinimalContour other = square(0, 0, 50);
  ++other.points[2].y;
  MinimalContour smooth = square(0, 0, 50);
  smooth.points[2].kind = PointKind::smooth;
  const auto found = find_composites(
      {glyph({square(0, 0, 50)}), glyph({other}), glyph({smooth})}, 0);
  EXPECT_TRUE(found[1].empty());
  EXPECT_TRUE(found[2].empty());
}

TEST(Composites, ComponentsAreSimpleGlyphs) {
  // A dot, a colon of two, and an ellipsis of the dot and the colon.
  const auto found = find_composites(
      {glyph({square(0, 0, 50)}), glyph({square(0, 0, 50), square(0, 100, 50)}),
       glyph({square(0, 0, 50), square(0, 100, 50), square(0, 200, 50)})},
      0);
  EXPECT_EQ(listed(found[1]), (Listed{{0, 0, 0}, {0, 0, 100}}));
  EXPECT_EQ(listed(found[2]), (Listed{{0, 0, 0}, {0, 0, 100}, {0, 0, 200}}));
}

TEST(Composites, OnlyWhereItSavesBytes) {
  std::vector<CompositeCandidate> glyphs = {glyph({square(0, 0, 50)}),
                                            glyph({square(0, 9, 50)})};
  const size_t bytes = composite_record({at(0, 0, 9)}).size();
  glyphs[1].simple_bytes = bytes;
  EXPECT_TRUE(find_composites(glyphs, 0)[1].empty());
  glyphs[1].simple_bytes = bytes + 1;
  EXPECT_EQ(listed(find_composites(glyphs, 0)[1]), (Listed{{0, 0, 9}}));
}

TEST(Composites, GlyphsWithoutInkAreLeftAlone) {
  const CompositeCandidate blank;
  const auto found =
      find_composites({blank, blank, glyph({square(0, 0, 9)})}, 0);
  for (const OutlineReferences& references : found) {
    EXPECT_TRUE(references.empty());
  }
}

TEST(Composites, OffsetsAreInFontUnits) {
  const std::vector<CompositeCandidate> glyphs = {glyph({square(0, 0, 50)}),
                                                  glyph({square(6, 8, 50)})};
  EXPECT_EQ(listed(find_composites(glyphs, 2)[1]), (Listed{{0, 24, 32}}));
  EXPECT_EQ(listed(find_composites(glyphs, -1)[1]), (Listed{{0, 3, 4}}));
  EXPECT_TRUE(find_composites(glyphs, -2)[1].empty());
}

TEST(Composites, ComponentsThatOverlapOrTouch) {
  const std::vector<CompositeCandidate> glyphs = {
      glyph({square(0, 0, 400), hole(100, 100, 200)}),
      glyph({square(0, 0, 80)})};
  const auto overlap = [&glyphs](int dx, int dy) {
    EXPECT_EQ(components_overlap(glyphs, at(0, 0, 0), at(1, dx, dy), 0),
              components_overlap(glyphs, at(1, dx, dy), at(0, 0, 0), 0));
    return components_overlap(glyphs, at(0, 0, 0), at(1, dx, dy), 0);
  };
  EXPECT_FALSE(overlap(0, 500));
  EXPECT_FALSE(overlap(0, 403));
  EXPECT_TRUE(overlap(0, 401));
  EXPECT_TRUE(overlap(0, 390));
  EXPECT_TRUE(overlap(10, 10));     // inside the ink
  EXPECT_FALSE(overlap(160, 160));  // in the counter
  EXPECT_TRUE(overlap(219, 160));
  EXPECT_TRUE(overlap(250, 160));  // across the border of the counter
}

TEST(Composites, TheSourcesComponentsAreTakenUnlessTheyOverlap) {
  // The outlines of the composites differ from those of the components, as
  // after a refit.
  const auto found = find_composites(
      {glyph({square(0, 0, 400)}), glyph({square(0, 500, 80)}),
       glyph({square(1, 0, 401), square(99, 500, 79)},
             {at(0, 0, 0), at(1, 100, 0)}),
       glyph({square(1, 0, 402)}, {at(0, 0, 0), at(1, 100, -200)})},
      0);
  EXPECT_EQ(listed(found[2]), (Listed{{0, 0, 0}, {1, 100, 0}}));
  EXPECT_TRUE(found[3].empty());
}

TEST(Composites, CompositesOfCompositesAreFlattened) {
  OutlineReference turned = at(2, 10, 20);
  turned.matrix_q14 = {0, -OutlineReference::kOne_q14,
                       OutlineReference::kOne_q14, 0};
  const auto found =
      find_composites({glyph({square(0, 0, 400)}), glyph({square(0, 500, 80)}),
                       glyph({square(1, 0, 401), square(99, 500, 79)},
                             {at(0, 0, 0), at(1, 100, 0)}),
                       glyph({square(0, 0, 1)}, {turned})},
                      0);
  ASSERT_EQ(found[3].size(), 2u);
  EXPECT_EQ(found[3][1].glyph, 1u);
  EXPECT_EQ(found[3][1].dx, 10);
  EXPECT_EQ(found[3][1].dy, 120);
  EXPECT_EQ(found[3][1].matrix_q14, turned.matrix_q14);
}

TEST(Composites, CyclesOfTheSourceAreBroken) {
  const auto found =
      find_composites({glyph({square(0, 0, 400)}, {at(1, 0, 0)}),
                       glyph({square(0, 0, 300)}, {at(0, 0, 0)})},
                      0);
  EXPECT_TRUE(found[0].empty() || found[1].empty());
}

// 1: a letter, 2: an accent, 3: both, 4: a composite of 3 and a turned 2.
Sfnt accented_font() {
  Sfnt font;
  font.glyphs.resize(5);
  font.glyphs[1] = {U'a', 500, {sfnt_rectangle(0, 0, 400, 400)}, {}};
  font.glyphs[2] = {U'b', 500, {sfnt_rectangle(0, 500, 80, 560)}, {}};
  font.glyphs[3] = {U'c', 500, {}, {{1, 0, 0, {}}, {2, 100, 30, {}}}};
  font.glyphs[4] = {
      U'd', 500, {}, {{3, 5, 0, {}}, {2, 700, 0, {0, 16384, -16384, 0}}}};
  return font;
}

TEST(SourceComposites, AreReadFromTheFile) {
  const TestFolder folder;
  const FontFile file(folder.write("accented.ttf", accented_font()), 0, {});
  const auto found = source_composites(file, {0, 1, 2, 3, 4});
  EXPECT_TRUE(found[0].empty() && found[1].empty() && found[2].empty());
  EXPECT_EQ(listed(found[3]), (Listed{{1, 0, 0}, {2, 100, 30}}));
  ASSERT_EQ(found[4].size(), 2u);
  EXPECT_EQ(listed({found[4][0]}), (Listed{{3, 5, 0}}));
  EXPECT_EQ(found[4][1].glyph, 2u);
  EXPECT_EQ(found[4][1].dx, 700);
  EXPECT_EQ(found[4][1].matrix_q14, (std::array<int, 4>{0, -16384, 16384, 0}));
}

TEST(SourceComposites, OfGlyphsThatTheFontDoesNotHave) {
  const TestFolder folder;
  const FontFile file(folder.write("accented.ttf", accented_font()), 0, {});
  // Without 3, its own components replace it.
  const auto found = source_composites(file, {4, 2, 1});
  ASSERT_EQ(found[0].size(), 3u);
  EXPECT_EQ(listed({found[0][0], found[0][1]}),
            (Listed{{2, 5, 0}, {1, 105, 30}}));
  EXPECT_TRUE(source_composites(file, {4, 1})[0].empty());
  EXPECT_EQ(missing_components(file, {4, 1}), std::vector<uint32_t>{2});
  EXPECT_EQ(missing_components(file, {3}), (std::vector<uint32_t>{1, 2}));
  EXPECT_TRUE(missing_components(file, {1, 2, 3, 4}).empty());
}

}  // namespace
}  // namespace inkcell::gen::test
