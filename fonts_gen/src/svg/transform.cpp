#include "svg/transform.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/trimmed.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr std::string_view kSeparators = " \t\r\n,";

// `v`: as many numbers as are written.
std::optional<Affine> one_transform(std::string_view name,
                                    std::vector<double> v) {
  const size_t count = v.size();
  v.resize(6);  // what is left out is 0
  if (name == "matrix" && count == 6) {
    return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  }
  if (name == "translate" && (count == 1 || count == 2)) {
    return Affine{1, 0, 0, 1, v[0], v[1]};
  }
  if (name == "scale" && (count == 1 || count == 2)) {
    return Affine{v[0], 0, 0, count == 1 ? v[0] : v[1], 0, 0};
  }
  if (name == "rotate" && (count == 1 || count == 3)) {
    const double c = std::cos(v[0] * kDegree);
    const double s = std::sin(v[0] * kDegree);
    return Affine{
        c, s, -s, c, v[1] - c * v[1] + s * v[2], v[2] - s * v[1] - c * v[2]};
  }
  if (name == "skewX" && count == 1) {
    return Affine{1, 0, std::tan(v[0] * kDegree), 1, 0, 0};
  }
  if (name == "skewY" && count == 1) {
    return Affine{1, std::tan(v[0] * kDegree), 0, 1, 0, 0};
  }
  return std::nullopt;
}

}  // namespace

Affine parse_transform(std::string_view text) {
  const std::string whole(text);
  Affine result;
  for (text = trimmed(text, kSeparators); !text.empty();
       text = trimmed(text, kSeparators)) {
    const size_t open = text.find('(');
    const size_t close = text.find(')');
    std::optional<Affine> next;
    if (open < close && close != std::string_view::npos) {
      const auto numbers = numbers_in(text.substr(open + 1, close - open - 1));
      next = numbers ? one_transform(trimmed(text.substr(0, open), kSeparators),
                                     *numbers)
                     : std::nullopt;
    }
    if (!next) {
      throw Error("transform '" + whole + "' is not one of SVG 1.1");
    }
    result = product(result, *next);
    text.remove_prefix(close + 1);
  }
  return result;
}

}  // namespace inkcell::gen
