#include "inkcell/text_report.hpp"

#include "inkcell/font.hpp"

namespace inkcell {

bool detail::replace_missing(TextReport& report,
                             const Font& font,
                             uint32_t code_point,
                             uint16_t& glyph) noexcept {
  return report.find_instead(code_point, [&](uint32_t other) noexcept {
    return font.glyph_of(other, glyph) == Status::ok;
  });
}

}  // namespace inkcell
