// The judge itself: distances of shapes whose distance is known.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "areas.hpp"
#include "sfnt_builder.hpp"
#include "truth.hpp"

namespace inkcell::tools {
namespace {

using Chord = TrueGlyph::Chord;

constexpr double kFar = 1e6;

// Chords of polygons, each edge a curve of its own.
class Polygons {
 public:
  Polygons& add(const std::vector<Vector>& corners) {
    for (size_t i = 0; i < corners.size(); ++i) {
      chords_.push_back({corners[i], corners[(i + 1) % corners.size()]});
      ends_.push_back(chords_.size());
    }
    return *this;
  }
  Polygons& add_box(double x0, double y0, double x1, double y1) {
    return add({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  }
  TrueGlyph glyph() const { return TrueGlyph(chords_, ends_); }

 private:
  std::vector<Chord> chords_;
  std::vector<size_t> ends_;
};

double distance(const TrueGlyph& glyph, double x, double y) {
  return glyph.distance({x, y}, kFar);
}

double box_distance(
    double x0, double y0, double x1, double y1, double x, double y) {
  const double dx = std::max(x0 - x, x - x1);
  const double dy = std::max(y0 - y, y - y1);
  if (dx <= 0 && dy <= 0) {
    return -std::max(dx, dy);
  }
  return -std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
}

TEST(TrueGlyph, BoxHasTheDistanceOfABox) {
  const TrueGlyph glyph = Polygons().add_box(10, 20, 110, 60).glyph();
  for (double y = -20.5; y < 100; y += 7) {
    for (double x = -30.5; x < 150; x += 9) {
      EXPECT_NEAR(distance(glyph, x, y), box_distance(10, 20, 110, 60, x, y),
                  1e-9)
          << x << ", " << y;
    }
  }
}

TEST(TrueGlyph, EdgesInsideAnOverlapDoNotCount) {
  // A cross of two bars: in the middle the nearest border is a corner.
  const TrueGlyph glyph =
      Polygons().add_box(0, 40, 100, 60).add_box(40, 0, 60, 100).glyph();
  EXPECT_NEAR(distance(glyph, 50, 50), std::hypot(10, 10), 1e-9);
  EXPECT_NEAR(distance(glyph, 50, 58), std::hypot(10, 2), 1e-9);
  EXPECT_NEAR(distance(glyph, 30, 50), 10, 1e-9);
  EXPECT_NEAR(distance(glyph, 30, 70), -10, 1e-9);
}

TEST(TrueGlyph, CommonEdgeOfTwoBoxesIsNoBorder) {
  const TrueGlyph glyph =
      Polygons().add_box(0, 0, 50, 40).add_box(50, 0, 100, 40).glyph();
  EXPECT_NEAR(distance(glyph, 50, 20), 20, 1e-9);
  EXPECT_NEAR(distance(glyph, 45, 20), 20, 1e-9);
}

TEST(TrueGlyph, CounterTurnsTheOtherWay) {
  const TrueGlyph glyph = Polygons()
                              .add_box(0, 0, 100, 100)
                              .add({{30, 30}, {30, 70}, {70, 70}, {70, 30}})
                              .glyph();
  EXPECT_NEAR(distance(glyph, 50, 50), -20, 1e-9);
  EXPECT_NEAR(distance(glyph, 15, 50), 15, 1e-9);
}

TEST(TrueGlyph, CrossedContourIsFilledOnBothSides) {
  // A bow tie: windings +1 and -1 are both filled.
  const TrueGlyph glyph =
      Polygons().add({{0, 0}, {100, 100}, {100, 0}, {0, 100}}).glyph();
  EXPECT_GT(distance(glyph, 80, 50), 0);
  EXPECT_GT(distance(glyph, 20, 50), 0);
  EXPECT_LT(distance(glyph, 50, 80), 0);
  EXPECT_NEAR(distance(glyph, 90, 50), 10, 1e-9);
  EXPECT_NEAR(distance(glyph, 50, 80), -30 / std::sqrt(2.0), 1e-9);
}

// Two boxes beside each other, joined below and, if `is_closed`, above.
TrueGlyph gap(double width, bool is_closed) {
  Polygons boxes;
  boxes.add_box(0, 0, 50, 40).add_box(50 + width, 0, 100, 40);
  boxes.add_box(40, 0, 60, 10);
  if (is_closed) {
    boxes.add_box(40, 30, 60, 40);
  }
  return boxes.glyph();
}

TEST(TrueGlyph, HoleOfNextToNoWidthIsFilled) {
  EXPECT_NEAR(distance(gap(0.02, true), 50.01, 20), 20, 0.02);
  EXPECT_NEAR(distance(gap(0.02, true), 45, 20), 20, 1e-9);
  // A hole that is wide enough, and a slit that leads outside.
  EXPECT_NEAR(distance(gap(0.2, true), 50.1, 20), -0.1, 1e-9);
  EXPECT_NEAR(distance(gap(0.02, false), 50.01, 20), -0.01, 1e-9);
}

TEST(TrueGlyph, IslandOfNextToNoWidthIsEmpty) {
  // One at the corner of a box, and one that stands alone.
  const TrueGlyph glyph = Polygons()
                              .add_box(0, 0, 100, 40)
                              .add({{100, 40}, {110, 40}, {110, 40.05}})
                              .add_box(200, 0, 200.1, 20)
                              .glyph();
  EXPECT_NEAR(distance(glyph, 109.9, 40.02), -std::hypot(9.9, 0.02), 1e-9);
  EXPECT_NEAR(distance(glyph, 200.05, 20), -100.05, 1e-9);
  EXPECT_NEAR(distance(glyph, 90, 20), 10, 1e-9);
  const TrueGlyph wide =
      Polygons().add_box(0, 0, 100, 40).add_box(200, 0, 200.2, 20).glyph();
  EXPECT_NEAR(distance(wide, 200.1, 10), 0.1, 1e-9);
}

TEST(TrueGlyph, IslandBesideAHoleLeavesWhatLiesBetween) {
  // A crescent touches the box at two points of its right edge.
  const TrueGlyph glyph =
      Polygons()
          .add_box(0, 0, 100, 40)
          .add({{100, 10}, {100.08, 20}, {100, 30}, {100.04, 20}})
          .glyph();
  EXPECT_NEAR(distance(glyph, 100.02, 20), 0.02, 1e-4);
  EXPECT_NEAR(distance(glyph, 100.06, 20), -0.02, 1e-4);
  EXPECT_NEAR(distance(glyph, 95, 20), 5.04, 0.01);
  EXPECT_NEAR(distance(glyph, -5, 20), -5, 1e-9);
}

TEST(TrueGlyph, LimitClamps) {
  const TrueGlyph glyph = Polygons().add_box(0, 0, 100, 100).glyph();
  EXPECT_EQ(glyph.distance({50, 50}, 8), 8);
  EXPECT_EQ(glyph.distance({500, 50}, 8), -8);
}

TEST(TrueGlyph, NothingIsOutside) {
  const TrueGlyph glyph = Polygons().glyph();
  EXPECT_TRUE(glyph.empty());
  EXPECT_EQ(distance(glyph, 3, 4), -kFar);
}

TEST(TrueTiles, AgreeWithBruteForce) {
  const TrueFont font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0);
  std::mt19937 random(3);
  for (const char32_t letter : {U'a', U'%', U'@', U'.', U' '}) {
    const TrueGlyph glyph = font.glyph(letter);
    for (const double limit : {2.0, 16.0, 128.0}) {
      TrueTiles tiles(glyph, limit);
      const double margin = 1.5 * limit;
      std::uniform_real_distribution<double> x(glyph.low().x - margin,
                                               glyph.high().x + margin);
      std::uniform_real_distribution<double> y(glyph.low().y - margin,
                                               glyph.high().y + margin);
      for (int i = 0; i < 5000; ++i) {
        const Vector p = {x(random), y(random)};
        ASSERT_EQ(tiles.distance(p), glyph.distance(p, limit))
            << p.x << ", " << p.y << " limit " << limit;
      }
    }
  }
}

TEST(TrueFont, ReadsAFace) {
  const TrueFont font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0);
  // A full stop: 254 units square from (219, 0), 2048 units to the em.
  const TrueGlyph stop = font.glyph(U'.');
  EXPECT_DOUBLE_EQ(stop.low().x, 219 / 2.0);
  EXPECT_DOUBLE_EQ(stop.low().y, 0);
  EXPECT_DOUBLE_EQ(stop.high().y, 254 / 2.0);
  EXPECT_TRUE(font.glyph(U' ').empty());
  EXPECT_THROW(font.glyph(0xE123), std::runtime_error);
  EXPECT_THROW(TrueFont("/nowhere.ttf", 0), std::runtime_error);
}

TEST(TrueFont, DistanceGrowsFromAnExtreme) {
  const TrueFont font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0);
  const TrueGlyph o = font.glyph(U'o');
  const double x = (o.low().x + o.high().x) / 2;
  const double y = (o.low().y + o.high().y) / 2;
  EXPECT_LT(distance(o, x, y), 0);
  // At the top, where the curve is level, straight down leads away from it;
  // the chords are off by kChordError.
  EXPECT_NEAR(distance(o, x, o.high().y - 20), 20, 0.01);
}

TEST(TrueFont, IsAtTheAxesThatAreGiven) {
  const gen::test::TestFolder folder;
  gen::test::Sfnt font = gen::test::Sfnt::plain();
  font.wght_shift = 1000;  // the em: 1024 u
  const auto file = folder.write("variable.ttf", font);
  const auto left = [&](const std::vector<std::string>& axes) {
    return TrueFont(file, 0, axes).glyph(U'H').low().x;
  };
  EXPECT_EQ(left({"wght=400"}), left({}));
  EXPECT_NEAR(left({"wght=900"}), left({}) + 1024, 1e-6);
  EXPECT_NEAR(left({"wght=650"}), left({}) + 512, 0.02);
  for (const char* wrong : {"wght", "wght=", "wght=99", "wght=901", "wght=4x",
                            "wdth=400", "=400", "", "wght=nan", "wghtx=400"}) {
    EXPECT_THROW(left({wrong}), std::runtime_error) << wrong;
    EXPECT_THROW(left({"wght=400", wrong}), std::runtime_error) << wrong;
  }
  font.wght_shift = 0;
  const auto rigid = folder.write("rigid.ttf", font);
  EXPECT_THROW(TrueFont(rigid, 0, {"wght=400"}), std::runtime_error);
}

TEST(TrueFont, FindsTheCharactersOfSymbolFonts) {
  const gen::test::TestFolder folder;
  gen::test::Sfnt font = gen::test::Sfnt::plain();
  const auto plain = folder.write("plain.ttf", font);
  for (gen::test::SfntGlyph& glyph : font.glyphs) {
    glyph.code_point += glyph.code_point == 0 ? 0 : 0xf000;
  }
  font.is_symbol = true;
  const auto symbol = folder.write("symbol.ttf", font);
  const Vector high = TrueFont(plain, 0, {}).glyph(U'H').high();
  for (const char32_t c : {U'H', U'\uf048'}) {
    const Vector same = TrueFont(symbol, 0, {}).glyph(c).high();
    EXPECT_EQ(same.x, high.x);
    EXPECT_EQ(same.y, high.y);
  }
}

// y down: the area lies to the right of what goes up.
TEST(PixelAreas, AreThoseOfPolygons) {
  const std::vector<Chord> box = {{{0.5, 1.25}, {0.5, 2}},
                                  {{0.5, 2}, {2.25, 2}},
                                  {{2.25, 2}, {2.25, 1.25}},
                                  {{2.25, 1.25}, {0.5, 1.25}}};
  EXPECT_EQ(pixel_areas(box, 3, 3),
            (std::vector<double>{0, 0, 0, 0.375, 0.75, 0.1875, 0, 0, 0}));
  const std::vector<Chord> triangle = {
      {{0, 0}, {0, 2}}, {{0, 2}, {4, 0}}, {{4, 0}, {0, 0}}};
  const std::vector<double> areas = pixel_areas(triangle, 4, 2);
  const double known[] = {1, 1, 0.75, 0.25, 0.75, 0.25, 0, 0};
  for (size_t i = 0; i < areas.size(); ++i) {
    EXPECT_NEAR(areas[i], known[i], 1e-12) << i;
  }
}

TEST(TrueFont, SaysWhichFileLacksWhichGlyph) {
  const gen::test::TestFolder folder;
  const auto file = folder.write("plain.ttf", gen::test::Sfnt::plain());
  try {
    TrueFont(file, 0, {}).glyph(U'Z');
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.find(file.string() + ": has no glyph for U+005A"), 0u)
        << said;
  }
}

}  // namespace
}  // namespace inkcell::tools
