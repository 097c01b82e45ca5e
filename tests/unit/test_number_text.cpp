// Numbers as text.
#include "inkcell/number_text.hpp"

#include "check.hpp"

namespace {

using namespace inkcell;

bool reads(const NumberText& number, const char* expected) {
  const Text text = number;
  const Text wanted = expected;
  bool is_equal = text.size == wanted.size;
  for (size_t i = 0; is_equal && i < text.size; ++i) {
    is_equal = text.data[i] == wanted.data[i];
  }
  if (!is_equal) {
    check::write(text.data, text.size);
    check::write(" is not ");
    check::write(expected);
    check::write("\n");
  }
  return is_equal;
}

TEST(integers_have_a_sign_and_the_fewest_digits) {
  CHECK(reads(NumberText(0), "0"));
  CHECK(reads(NumberText(7), "7"));
  CHECK(reads(NumberText(-10), "-10"));
  CHECK(reads(NumberText(INT32_MAX), "2147483647"));
  CHECK(reads(NumberText(INT32_MIN), "-2147483648"));
  CHECK(reads(NumberText(7, 0, 2), "07"));
  CHECK(reads(NumberText(-7, 0, 3), "-007"));
  CHECK(reads(NumberText(1234, 0, 2), "1234"));
}

TEST(units_of_the_last_decimal_have_a_point) {
  CHECK(reads(NumberText(235, 1), "23.5"));
  CHECK(reads(NumberText(-5, 2), "-0.05"));
  CHECK(reads(NumberText(0, 1), "0.0"));
  CHECK(reads(NumberText(1005, 2, 3), "010.05"));
  CHECK(reads(NumberText(2150, 2, 1, ','), "21,50"));
  CHECK(reads(NumberText(INT32_MIN, 9), "-2.147483648"));
}

TEST(fixed_point_is_rounded) {
  CHECK(reads(NumberText(21_px, 1), "21.0"));
  CHECK(reads(NumberText(Q26_6::from_raw(21 * 64 + 32), 1), "21.5"));
  CHECK(reads(NumberText(Q26_6::from_raw(21 * 64 + 32)), "22"));
  CHECK(reads(NumberText(Q26_6::from_raw(-21 * 64 - 32)), "-22"));
  CHECK(reads(NumberText(Q26_6::from_raw(63), 1), "1.0"));
  CHECK(reads(NumberText(Q26_6::from_raw(1), 6), "0.015625"));
  CHECK(reads(NumberText(Q26_6::from_raw(-1), 1), "0.0"));  // and no sign
  CHECK(reads(NumberText(Q26_6::from_raw(-4), 1), "-0.1"));
  CHECK(reads(NumberText(Q6_10::from_raw(INT16_MIN), 3, 2), "-32.000"));
  CHECK(reads(NumberText(Q16_16::from_raw(INT32_MIN), 9), "-32768.000000000"));
  CHECK(reads(NumberText(Q16_16::from_raw(0x7fffffff), 4), "32768.0000"));
}

TEST(options_out_of_range_are_clamped) {
  CHECK(reads(NumberText(5, -1, -1), "5"));
  CHECK(reads(NumberText(5, 99, 99), "0000000000.000000005"));
  CHECK(reads(NumberText(-5, INT32_MAX, INT32_MAX), "-0000000000.000000005"));
  CHECK(reads(NumberText(0, INT32_MIN, INT32_MIN), "0"));
}

TEST(a_unit_follows_its_number) {
  CHECK(reads(NumberText(215, 1).with_unit(" \u00b0C"), "21.5 \u00b0C"));
  CHECK(reads(NumberText(-5).with_unit("%"), "-5%"));
  NumberText number(7);
  CHECK(reads(number.with_unit(""), "7"));
  CHECK(reads(number.with_unit({}), "7"));
  CHECK(reads(number.with_unit(" kWh"), "7 kWh"));
  CHECK(reads(number.with_unit(" V"), "7 V"));
  // The longest of both, and longer ones, which are cut.
  CHECK(reads(NumberText(INT32_MIN, 9, 10).with_unit(" 1234567890"),
              "-0000000002.147483648 1234567890"));
  CHECK(reads(number.with_unit(" 1234567890x"), "7 1234567890"));
  CHECK(reads(number.with_unit(" 12345678\u00b0C"), "7 12345678\u00b0"));
  CHECK(reads(number.with_unit(" 123456789\u00b0C"), "7 123456789"));
}

}  // namespace
