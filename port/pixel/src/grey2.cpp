// The canvas of 2-bit grey.
#include "inkcell/port/grey2.hpp"

#include "packed_grey.hpp"

namespace inkcell::detail {
// Null in a program that draws no glyphs: few_levels.hpp.
extern __attribute__((weak)) const LevelRule kFourLevelRule;
}  // namespace inkcell::detail

namespace inkcell::port::detail {
namespace {

constexpr SinkKind kind_of_grey2() noexcept {
  SinkKind kind = kPackedGrey<Grey2Pixels, PixelFormat::grey2, 1>;
  kind.levels = &inkcell::detail::kFourLevelRule;
  return kind;
}

}  // namespace

const SinkKind Grey2Pixels::kKind = kind_of_grey2();

}  // namespace inkcell::port::detail
