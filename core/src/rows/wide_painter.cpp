#include "rows/wide_painter.hpp"

#include "rows/wide_contours.hpp"

namespace inkcell::detail {
namespace {

// The lowest bit toggles from outside to inside and back.
struct Toggles {
  static constexpr int32_t kMask = ~1;
  static constexpr bool kHasColumns = false;
  static void cross_row(uint8_t* pixel) noexcept { *pixel ^= 1; }
  static void cross_column(uint8_t*) noexcept {}
};

}  // namespace

void paint_wide_distances(const Band& band,
                          OutlineCursor& cursor,
                          const ScreenPoint* points,
                          const ScreenPoint* end) noexcept {
  wide::paint_points<Toggles>(band, cursor, points, end);
}

}  // namespace inkcell::detail
