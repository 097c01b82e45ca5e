// The frozen ROM fonts of this folder, linked into the program.
#pragma once

#include "inkcell/span.hpp"

namespace golden {

enum class FontId : uint8_t {
  dejavu_sans_field,
  dejavu_sans_outline,
  dejavu_serif_outline,
  roboto_outline,
  noto_sans_cjk_outline,
};
inline constexpr int kFontCount = 5;

inkcell::Span<const uint8_t> font_bytes(FontId id);

}  // namespace golden
