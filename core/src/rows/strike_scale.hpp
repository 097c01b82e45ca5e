// Which styles draw fonts of strikes.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/style.hpp"
#include "place/style_parts.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

// Whether glyphs are drawn upright and by the filter of strikes.
inline bool is_plain(const Style& style) noexcept {
  const BandKind* const kind = StyleParts::band_kind(style);
  return style.is_upright() && kind != nullptr &&
         kind->bytes == BandBytes::area;
}

// Pixels of a style to a pixel of a font of strikes; 0: the style does not draw
// it. All strikes of such a font have one size.
inline int32_t strike_scale(const Font& font, const Style& style) noexcept {
  const int32_t px_q6 = load_u16(font.rom().data + format::header::kMinPx) * 64;
  if (!is_plain(style) || px_q6 == 0) {
    return 0;
  }
  const int32_t scale = quotient(style.size().raw, px_q6);
  return scale * px_q6 == style.size().raw ? scale : 0;
}

}  // namespace inkcell::detail
