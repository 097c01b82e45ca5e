#include "line_class.hpp"

#include "line_tables.hpp"

namespace inkcell {
namespace detail {

LineClass line_class(uint32_t code_point) noexcept {
  if (code_point < 128) {
    return static_cast<LineClass>(kAsciiLineClasses[code_point]);
  }
  const auto found = static_cast<LineClass>(class_of(kLineClasses, code_point));
  if (found != LineClass::h) {
    return found;
  }
  // Each syllable without a final consonant is followed by 27 that have one.
  constexpr uint32_t kFirst = 0xac00;
  return (code_point - kFirst) % 28 == 0 ? LineClass::h2 : LineClass::h3;
}

}  // namespace detail
}  // namespace inkcell
