// Drawings that are paired point by point, and thorns of morphs.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "messages.hpp"
#include "morph/find_morph.hpp"
#include "morph/morph_thorns.hpp"
#include "morph_font.hpp"
#include "morph_reader.hpp"
#include "sfnt_builder.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen::test {
namespace {

// A drawing of squares at places.
std::string squares(const std::vector<Point>& places) {
  std::string path;
  for (const Point& p : places) {
    path +=
        "M" + std::to_string(p.x) + "," + std::to_string(p.y) + "h10v10h-10z";
  }
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
         "<path d='" +
         path + "'/></svg>";
}

// Two drawings and their morph.
GenerateRequest drawings(const TestFolder& folder,
                         const std::vector<Point>& first,
                         const std::vector<Point>& second,
                         const std::string& morph) {
  GenerateRequest request;
  request.svg_files = {
      folder.write("a.svg", squares(first)).string() + "=0x61",
      folder.write("b.svg", squares(second)).string() + "=0x62"};
  request.morphs = {morph};
  return request;
}

// How wide all contours together are half-way, by their height.
double breadth_half_way(const MorphFont& icons) {
  const std::vector<MorphEntry> pairs =
      read_morphs(bytes_of(icons.font.section(format::section::kMorphs)));
  const Box box =
      box_of(read_morph(pairs.at(0).record, icons.outline_of(pairs[0].first),
                        icons.outline_of(pairs[0].second), 0.5, 4));
  return (box.x1 - box.x0) / (box.y1 - box.y0);
}

// The first square moves by 60, 30, the second by -50, 60; the search takes the
// shorter ways.
TEST(MorphPoints, PathsOfDrawingsSayWhatBecomesWhat) {
  const TestFolder folder;
  const std::vector<Point> first = {{0, 0}, {50, 0}};
  const std::vector<Point> second = {{60, 30}, {0, 60}};
  const MorphFont searched(drawings(folder, first, second, "ab"));
  EXPECT_NEAR(breadth_half_way(searched), 65 / 25.0, 0.02);
  const MorphFont by_points(drawings(folder, first, second, "points:ab"));
  EXPECT_NEAR(breadth_half_way(by_points), 15 / 25.0, 0.02);
}

TEST(MorphPoints, PathsThatDifferAreRefused) {
  const TestFolder folder;
  const auto refusal = [&](const std::string& morph) {
    return error_of([&] {
      generate(drawings(folder, {{0, 0}, {50, 0}}, {{0, 0}}, morph));
    });
  };
  const std::string text = refusal("points:ab");
  EXPECT_TRUE(begins_with(text, "--morph points: ")) << text;
  EXPECT_TRUE(contains(text, "has 8 in 2 contours, ")) << text;
  EXPECT_TRUE(contains(text, "has 4 in 1 contours: both need")) << text;
  EXPECT_TRUE(begins_with(refusal("points:"), "--morph : a glyph"));
}

MorphPolygons box_with(const Point& tip) {
  return {
      {{0, 0}, {400, 0}, {400, 400}, {220, 400}, tip, {180, 400}, {0, 400}}};
}

TEST(MorphThorns, AreWhatTurnsMoreThanBothEnds) {
  const MorphPolygons flat = box_with({200, 400});
  const MorphPolygons spike = box_with({200, 500});
  EXPECT_EQ(thorns_of({flat, flat, flat}), 0);
  EXPECT_EQ(thorns_of({flat, box_with({200, 450}), spike}), 0);
  // A spike between two flat ends, and the two corners at its foot.
  EXPECT_GT(thorns_of({flat, spike, flat}), 150);
  EXPECT_NEAR(thorns_of({flat, spike, flat, flat}),
              thorns_of({flat, spike, flat}) / 2, 1e-9);
}

// A bay in a straight edge opens as a dent, not as a slit with corners.
TEST(MorphThorns, BaysOpenAsDents) {
  const Outline full = outline({rectangle(0, 0, 600, 600)});
  const Outline bay = outline({polygon({{0, 0},
                                        {600, 0},
                                        {600, 600},
                                        {400, 600},
                                        {400, 400},
                                        {200, 400},
                                        {200, 600},
                                        {0, 600}})});
  const std::optional<MorphPair> pair = find_morph(full, bay);
  ASSERT_TRUE(pair);
  EXPECT_LE(thorns_of(*pair), 10);
}

}  // namespace
}  // namespace inkcell::gen::test
