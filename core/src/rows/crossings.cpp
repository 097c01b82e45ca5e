#include "rows/crossings.hpp"

#include "rows/wide_contours.hpp"

namespace inkcell::detail {
namespace {

struct Crossings {
  static constexpr int32_t kMask = ~7;
  static constexpr bool kHasColumns = true;
  static void cross_row(uint8_t* pixel) noexcept {
    *pixel = static_cast<uint8_t>((*pixel ^ kInsideBit) | kCrossedLeft);
  }
  static void cross_column(uint8_t* pixel) noexcept { *pixel |= kCrossedAbove; }
};

}  // namespace

void paint_crossings(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept {
  wide::paint_points<Crossings>(band, cursor, points, end);
}

}  // namespace inkcell::detail
