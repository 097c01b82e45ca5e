// Glyphs refitted in the closed loop: tolerances, and the number of trials.
#include <gtest/gtest.h>

#include <cmath>

#include "glyph_outlines.hpp"
#include "judge/outline_glyph.hpp"
#include "shape/points.hpp"

namespace inkcell::gen::test {
namespace {

constexpr int kUnitsPerEm = 1024;

RefittedGlyph refit(const Outline& source) {
  const Shape shape(source);
  Target target;
  target.coding = Coding::outline;
  GlyphMetrics metrics;
  metrics.x_min = static_cast<int16_t>(std::floor(shape.box().x0));
  metrics.y_min = static_cast<int16_t>(std::floor(shape.box().y0));
  metrics.x_max = static_cast<int16_t>(std::ceil(shape.box().x1));
  metrics.y_max = static_cast<int16_t>(std::ceil(shape.box().y1));
  return refit_glyph(source, shape, metrics,
                     refit_options(target, kUnitsPerEm, kUnitsPerEm, false),
                     LoopOptions());
}

size_t points_of(const MinimalOutline& outline) {
  size_t sum = 0;
  for (const MinimalContour& contour : outline.contours) {
    sum += contour.points.size();
  }
  return sum;
}

Segment curve(const Point& a, const Point& control, const Point& b) {
  Segment segment;
  segment.kind = Segment::Kind::quadratic;
  segment.p[0] = a;
  segment.p[1] = control;
  segment.p[2] = b;
  return segment;
}

TEST(RefitGlyph, WhatHoldsAtOnceIsDrawnOnce) {
  const RefittedGlyph glyph = refit(outline({rectangle(100, 0, 200, 700)}));
  EXPECT_EQ(glyph.trials, 1);
  EXPECT_EQ(points_of(glyph.outline), 4u);
  EXPECT_LE(glyph.errors.promised.worst, 16);
}

// At 64 px half a unit of 1000 is finer than the tolerance needs.
TEST(RefitGlyph, GridsAreThoseOfTheSource) {
  const Target target;
  EXPECT_EQ(refit_options(target, 1000, 1000, true).grid_shift, 0);
  EXPECT_EQ(refit_options(target, 1000, 1000, false).grid_shift, -1);
}

// A counter that a variable font turned inside out, except for a sliver.
TEST(RefitGlyph, SliversOfACounterCostNothing) {
  const RefittedGlyph glyph = refit(outline(
      {circle(300, 300, 250), circle(300, 300, -40), circle(300.03, 300, 40)}));
  EXPECT_EQ(glyph.outline.contours.size(), 1u);
  EXPECT_LE(glyph.errors.promised.worst, 16);
  EXPECT_EQ(glyph.trials, 1);
}

// A ragged border of tight turns: each trial keeps what is good.
TEST(RefitGlyph, TightTurnsTakeFewTrials) {
  constexpr int kTeeth = 24;
  Contour ragged;
  const auto at = [](int i, double radius) {
    const double angle = i * kPi / kTeeth;
    return Point{350 + radius * std::cos(angle),
                 350 + radius * std::sin(angle)};
  };
  for (int i = 0; i < kTeeth; ++i) {
    const double out = 300 + 11 * (i % 3);
    ragged.segments.push_back(
        curve(at(2 * i, 270), at(2 * i + 1, out), at(2 * i + 2, 270)));
  }
  ragged.segments.back().p[2] = ragged.segments.front().p[0];
  const RefittedGlyph glyph = refit(outline({ragged}));
  EXPECT_LE(glyph.errors.promised.worst, 16);
  EXPECT_LE(glyph.trials, 12);
}

TEST(RefitGlyph, OfSerifsTakesFewTrials) {
  for (const Outline& source : load_outlines(kLiberationSerif, 0, ascii())) {
    const RefittedGlyph glyph = refit(source);
    EXPECT_LE(glyph.errors.promised.worst, 16);
    EXPECT_LE(glyph.trials, 14);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
