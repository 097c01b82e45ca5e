#include "source/icon_place.hpp"

#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/number.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {
namespace {

std::optional<double> number(const std::string& text,
                             double least,
                             double most) {
  std::string_view rest = text;
  const std::optional<double> value = take_number(rest);
  return value && rest.empty() && *value >= least && *value <= most
             ? value
             : std::nullopt;
}

}  // namespace

void parse_icon_height(const std::string& text, IconPlace& place) {
  const auto em = text == "em" ? 1.0 : number(text, 0.01, 10);
  place.is_cap_high = text == "cap";
  if (!place.is_cap_high && !em) {
    throw Error("'" + text +
                "' is not em, cap or a number of em within 0.01..10, such as "
                "1.2");
  }
  place.height_em = em.value_or(1);
}

void parse_icon_baseline(const std::string& text, IconPlace& place) {
  const auto em = text == "bottom" ? 0.0 : number(text, -10, 10);
  place.is_centred = text == "middle";
  if (!place.is_centred && !em) {
    throw Error("'" + text +
                "' is not middle, bottom or a number of em within -10..10, "
                "such as -0.125");
  }
  place.bottom_em = em.value_or(0);
}

IconBox icon_box(const IconPlace& place, const SourceMetrics& metrics) {
  const double cap = metrics.cap_height * (kUPerEm / metrics.units_per_em);
  const double height = place.is_cap_high ? cap : place.height_em * kUPerEm;
  if (!(height > 0)) {
    throw Error(
        "the font does not say how high its capitals are; give the height as a "
        "number of em");
  }
  return {place.is_centred ? (cap - height) / 2 : place.bottom_em * kUPerEm,
          height};
}

}  // namespace inkcell::gen
