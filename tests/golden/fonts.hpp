// The frozen ROM fonts of this folder, linked into the program.
#pragma once

#include "inkcell/span.hpp"

namespace golden {

enum class FontId : uint8_t {
  dejavu_sans,
  dejavu_serif,
  roboto,
  noto_sans_cjk,
  dejavu_sans_samples,
};
inline constexpr int kFontCount = 5;

inkcell::Span<const uint8_t> font_bytes(FontId id);

}  // namespace golden
