// Exact areas, a byte a pixel, modulo 256.
#include "rows/area_painter.hpp"

#ifndef INKCELL_ONLY_STRIKES
namespace inkcell::detail {
namespace {

struct ByteRows {
  using Pixel = uint8_t;
};

}  // namespace

void paint_areas(const Band& band,
                 OutlineCursor& cursor,
                 const ScreenPoint* points,
                 const ScreenPoint* end) noexcept {
  AreaPainter<ByteRows>::paint(band, cursor, points, end);
}

}  // namespace inkcell::detail
#endif
