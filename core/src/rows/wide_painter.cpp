// Outlines to rows of distances, up to 4 px from the edge.
#include "rows/band_kind.hpp"
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

struct Crossings {
  static constexpr int32_t kMask = ~7;
  static constexpr bool kHasColumns = true;
  static void cross_row(uint8_t* pixel) noexcept {
    *pixel = static_cast<uint8_t>((*pixel ^ kInsideBit) | kCrossedLeft);
  }
  static void cross_column(uint8_t* pixel) noexcept { *pixel |= kCrossedAbove; }
};

}  // namespace

void paint_wide_distances(const Band& band,
                          OutlineCursor& cursor,
                          const ScreenPoint* points,
                          const ScreenPoint* end) noexcept {
  wide::paint_points<Toggles>(band, cursor, points, end);
}

void paint_crossings(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept {
  wide::paint_points<Crossings>(band, cursor, points, end);
}

}  // namespace inkcell::detail
