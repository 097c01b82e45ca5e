// Decimal numbers in text.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "base/number.hpp"

namespace inkcell::gen::test {
namespace {

struct Case {
  const char* text;
  double value;
  const char* rest;
};

TEST(Number, IsTakenFromTheFront) {
  for (const Case& c :
       {Case{"1.5 2", 1.5, " 2"}, Case{"+3e2,", 300, ","},
        Case{"-.25.5", -0.25, ".5"}, Case{"4.e1x", 40, "x"},
        Case{"7em", 7, "em"}, Case{"8e+", 8, "e+"}, Case{"0x10", 0, "x10"},
        Case{"5-6", 5, "-6"}, Case{"1E-2", 0.01, ""}, Case{"-0", -0.0, ""}}) {
    std::string_view text = c.text;
    EXPECT_EQ(take_number(text), c.value) << c.text;
    EXPECT_EQ(text, c.rest) << c.text;
  }
}

TEST(Number, LeavesWhatIsNone) {
  for (const char* none : {"", "+", "-", ".", "-.", "e5", " 1", "--1", "++1",
                           "inf", "nan", "-inf", "1e999", "-1e999"}) {
    std::string_view text = none;
    EXPECT_FALSE(take_number(text).has_value()) << none;
    EXPECT_EQ(text, none);
  }
}

TEST(Number, IsWhatWasWritten) {
  uint32_t random = 1;
  for (int round = 0; round < 20000; ++round) {
    random = random * 1664525 + 1013904223;
    const double scaled =
        (random >> 8) * 1e-4 * ((random >> 4 & 1) != 0 ? 1 : -1);
    const double written = round % 3 == 0 ? scaled * 1e-30 : scaled;
    char number[48];
    std::snprintf(number, sizeof number, "%.17g", written);
    std::string_view text = number;
    ASSERT_EQ(take_number(text), written) << number;
    ASSERT_TRUE(text.empty());
  }
}

}  // namespace
}  // namespace inkcell::gen::test
