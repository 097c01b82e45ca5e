// From fields back to curves.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "trace/contour_walk.hpp"
#include "trace/corner_census.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design::test {
namespace {

constexpr const char* kFont =
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf";

gen::Target target() {
  gen::Target options;
  options.tolerance = 4;
  return options;
}

TEST(Trace, StaysNearTheSourceWithFewerSegments) {
  size_t segments = 0;
  size_t source_segments = 0;
  EdgeError all;
  for (const gen::SourceGlyph& glyph : letters_of(kFont, "ag4&").glyphs) {
    const gen::Shape source(glyph.outline);
    const ShapeField field(source, target());
    const gen::Outline curves =
        outline_of(field.field(), FieldOutlineOptions());
    const EdgeError error = edge_error(source, gen::Shape(curves), 1);
    EXPECT_LT(error.worst, 1.5) << glyph.name();
    all.add(error);
    segments += segment_count(curves);
    source_segments += segment_count(glyph.outline);
    const CornerCensus corners = count_corners(glyph.outline, curves);
    EXPECT_EQ(corners.found, corners.source) << glyph.name();
    EXPECT_EQ(corners.false_ones, 0u) << glyph.name();
    EXPECT_GT(corners.source, 4u);
  }
  EXPECT_LT(all.rms(), 0.5);
  EXPECT_LT(segments, source_segments);
}

TEST(Trace, EveryLoopIsClosedAndFilledOnTheLeft) {
  const gen::SourceFont font = letters_of(kFont, "B");
  const gen::Shape source(font.glyphs[0].outline);
  const ShapeField field(source, target());
  const std::vector<Loop> loops = walk_contours(field.field());
  ASSERT_EQ(loops.size(), 3u);
  int outer = 0;
  for (const Loop& loop : loops) {
    double area = 0;
    for (size_t i = 0; i < loop.points.size(); ++i) {
      const Point& a = loop.points[i];
      const Point& b = loop.points[(i + 1) % loop.points.size()];
      area += cross(a, b) / 2;
      EXPECT_LT(length(b - a), 2);
      EXPECT_LT(std::fabs(source.distance(a.x, a.y)), 1);
    }
    outer += area > 0 ? 1 : 0;
  }
  EXPECT_EQ(outer, 1);
}

}  // namespace
}  // namespace inkcell::design::test
