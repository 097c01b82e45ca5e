// Counts of the paper's quadtrees that can be computed by hand.
#include <gtest/gtest.h>

#include "field/paper_counts.hpp"
#include "glyph_outlines.hpp"

namespace inkcell::gen {
namespace test {
namespace {

Target fixed() {
  Target options;
  options.predicate = Predicate::fixed;
  return options;
}

// Root: 320 u of ink and band, so 512 u from (-96, -96). At a resolution of 16
// cells are 64 u wide, with borders at -96 + 64 k: an edge at 0 or 128 lies
// within one column of them, and each edge is in 3 cells of its column.
TEST(PaperCounts, ThreeColoursOfASquare) {
  const LeafCounts counts =
      count_cells_three_colour(Shape(outline({rectangle(0, 0, 128, 128)})), 16);
  EXPECT_EQ(counts.varying, 8u);
  // 512 u: lower left quarter (256 u) divided, the others outside; in it all
  // four of 128 u hold edges: 3 + 16.
  EXPECT_EQ(counts.all, 19u);
}

// Twice the resolution, twice the edge cells: a slanted line of the length l
// meets about (|dx| + |dy|) / size of them, and a circle 8 radii of it.
TEST(PaperCounts, ThreeColoursFollowTheLengthOfTheEdge) {
  const Shape shape(outline({circle(100.3, 77.7, 200)}));
  for (const int resolution : {128, 256, 512}) {
    const double size = 1024.0 / resolution;
    const double cells = static_cast<double>(
        count_cells_three_colour(shape, resolution).varying);
    EXPECT_NEAR(cells * size / (8 * 200), 1, 0.05);
  }
}

// Distance from a straight edge is linear: both orders hold it exactly in the
// largest cells, and only the corners need small ones.
TEST(PaperCounts, StraightEdgesNeedFewCells) {
  const Shape shape(outline({rectangle(0, 0, 416, 416)}));
  const LeafCounts two = count_cells_biquadratic(shape, fixed());
  const LeafCounts one = count_cells_bilinear(shape, fixed());
  EXPECT_GE(one.varying, two.varying);
  EXPECT_LT(one.varying, 4 * 50u);
}

TEST(PaperCounts, BilinearNeedsFarMoreForGlyphs) {
  for (const Outline& o : load_outlines(kLiberationSerif, 0, {'a', 'D'})) {
    const Shape shape(o);
    const double two =
        static_cast<double>(count_cells_biquadratic(shape, fixed()).varying);
    const double one =
        static_cast<double>(count_cells_bilinear(shape, fixed()).varying);
    const double colours =
        static_cast<double>(count_cells_three_colour(shape).all);
    EXPECT_GT(one, 1.2 * two);
    EXPECT_GT(colours, 5 * two);
    // Quantisation costs little.
    const double coded =
        static_cast<double>(build_sample_tree(shape, fixed()).cells.size());
    EXPECT_NEAR(coded / two, 1, 0.1);
    // In the whole band the difference is the paper's.
    const double band_two =
        static_cast<double>(count_cells_biquadratic(shape, Target()).varying);
    const double band_one =
        static_cast<double>(count_cells_bilinear(shape, Target()).varying);
    EXPECT_GT(band_one, 2 * band_two);
  }
}

TEST(PaperCounts, NothingNeedsNoCells) {
  const Shape nothing{Outline()};
  EXPECT_EQ(count_cells_bilinear(nothing, fixed()).all, 0u);
  EXPECT_EQ(count_cells_biquadratic(nothing, fixed()).all, 0u);
  EXPECT_EQ(count_cells_three_colour(nothing).all, 0u);
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
