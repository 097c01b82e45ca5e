// What the accuracy table says about errors that are known.
#include "errors.hpp"

#include <gtest/gtest.h>

#include "comparison.hpp"

namespace inkcell::tools {
namespace {

ErrorPlace place(int drawn, double exact, char32_t code_point = U'a') {
  ErrorPlace result;
  result.code_point = code_point;
  result.drawn = drawn;
  result.exact = exact;
  return result;
}

TEST(ErrorStatistics, MeanCountsTheBoxOnly) {
  ErrorStatistics errors;
  errors.add(place(10, 0), true);
  errors.add(place(0, 0), true);
  errors.add(place(100, 0), false);
  EXPECT_DOUBLE_EQ(errors.mean(), 5);
  EXPECT_DOUBLE_EQ(errors.worst(), 100);
  EXPECT_EQ(errors.pixels(), 2);
}

TEST(ErrorStatistics, PercentileCountsPartialPixelsOnly) {
  ErrorStatistics errors;
  for (int i = 0; i < 95; ++i) {
    errors.add(place(101, 100), true);
  }
  for (int i = 0; i < 5; ++i) {
    errors.add(place(140, 100), true);
  }
  for (int i = 0; i < 1000; ++i) {
    errors.add(place(255, 255), true);
  }
  EXPECT_NEAR(errors.percentile(0.95), 1, 1.0 / 16);
  EXPECT_NEAR(errors.percentile(0.96), 40, 1.0 / 16);
}

TEST(ErrorStatistics, SumDoesNotDependOnOrder) {
  ErrorStatistics a;
  ErrorStatistics b;
  a.add(place(7, 0.3, U'a'), true);
  b.add(place(7, 0.3, U'b'), true);
  b.add(place(3, 1.1, U'c'), true);
  ErrorStatistics ab = a;
  ab.add(b);
  ErrorStatistics ba = b;
  ba.add(a);
  EXPECT_EQ(ab.mean(), ba.mean());
  EXPECT_EQ(ab.worst_place().code_point, U'a');
  EXPECT_EQ(ba.worst_place().code_point, U'a');
}

TEST(ExactFilter, AgreesWithTheDeviceTables) {
  for (const NamedFilter& named : kFilters) {
    const ExactFilter exact = exact_filter(named.name);
    for (int q10 = -1200; q10 <= 1200; ++q10) {
      // The table has 256 entries: at exponent 1.1 a step is up to 1.1 levels,
      // its middle half of that away, and rounding adds half a level. Cutoffs
      // are rounded to 1/1024 px.
      EXPECT_NEAR(named.filter->coverage(q10), exact.coverage(q10 / 1024.0),
                  1.5)
          << named.name << " " << q10;
    }
  }
  EXPECT_THROW(exact_filter("none"), std::runtime_error);
}

}  // namespace
}  // namespace inkcell::tools
