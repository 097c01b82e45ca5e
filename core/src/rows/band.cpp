// What filters and mixers name.
//
// A painter of outlines is linked into programs that name a filter which takes
// it, and that also open a font of outlines. Neither of the two is enough:
//
//   filter         --> BandKind          - weak -> painter
//   kOutlineCoding --> outline_source.cpp ----------> the painter's object
//
// What makes coverage of areas, which all styles name, is linked likewise.
// A weak reference takes no object from an archive, but keeps a function of one
// that is there. The linker drops the functions that no filter keeps. Where all
// lies in one object, INKCELL_ONLY_STRIKES leaves out what weak names find.
#include "rows/band.hpp"

namespace inkcell::detail {

__attribute__((weak)) PaintPoints paint_areas;
__attribute__((weak)) PaintPoints paint_crossings;
__attribute__((weak)) PaintPoints paint_distances;
__attribute__((weak)) PaintPoints paint_wide_distances;
__attribute__((weak)) decltype(cover_areas) cover_areas;

const BandKind kPixelRampBand = {paint_distances, cover_linear,
                                 BandBytes::distance, Painted::ramp, 128};
const BandKind kDistanceBand = {paint_distances, cover_filtered,
                                BandBytes::distance, Painted::other, 128};
const BandKind kWideDistanceBand = {paint_wide_distances, cover_filtered,
                                    BandBytes::distance, Painted::other, 0};
const BandKind kAreaBand = {paint_areas, cover_areas, BandBytes::area,
                            Painted::sums, 128};
const BandKind kCrossingBand = {paint_crossings, nullptr, BandBytes::crossings,
                                Painted::other, 0};

const ScreenPoint* skip_outside(const Band& band,
                                const ScreenPoint* at,
                                const ScreenPoint* end) noexcept {
  // Heights and kinds are compared as they lie in RAM.
  const int32_t above = (band.y_q8 - kAboveBand) * 4;
  const int32_t below = (band.y_q8 + band.rows * 256 + kBelowBand) * 4 + 3;
  const ScreenPoint* last = at;
  if (at->y_q8_kind < above) {
    while (++at != end && at->y_q8_kind < above) {
      last = at->kind() == kOffCurve ? last : at;
    }
  } else if (at->y_q8_kind > below) {
    while (++at != end && at->y_q8_kind > below) {
      last = at->kind() == kOffCurve ? last : at;
    }
  }
  return last;
}

}  // namespace inkcell::detail
