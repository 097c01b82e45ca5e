#include "text/blank.hpp"

namespace inkcell {
namespace detail {
namespace {

struct Range {
  uint16_t first;
  uint8_t more;  // code points after the first
  Shown shown;
};

constexpr Range kRanges[] = {
    {0x0000, 8, Shown::nothing},   // controls
    {0x0009, 0, Shown::space},     // tab
    {0x000a, 21, Shown::nothing},  // line ends, controls
    {0x0020, 0, Shown::space},     //
    {0x007f, 32, Shown::nothing},  // controls
    {0x00a0, 0, Shown::space},     // no-break space
    {0x00ad, 0, Shown::nothing},   // soft hyphen
    {0x034f, 0, Shown::nothing},   // grapheme joiner
    {0x061c, 0, Shown::nothing},   // Arabic letter mark
    {0x115f, 1, Shown::nothing},   // Hangul fillers
    {0x17b4, 1, Shown::nothing},   // Khmer inherent vowels
    {0x180b, 4, Shown::nothing},   // Mongolian selectors
    {0x2000, 10, Shown::space},    // spaces of other widths
    {0x200b, 4, Shown::nothing},   // zero width, joiners, marks
    {0x2028, 6, Shown::nothing},   // separators, embeddings
    {0x202f, 0, Shown::space},     // narrow no-break space
    {0x205f, 0, Shown::space},     // mathematical space
    {0x2060, 15, Shown::nothing},  // word joiner, isolates
    {0x3000, 0, Shown::space},     // ideographic space
    {0x3164, 0, Shown::nothing},   // Hangul filler
    {0xfe00, 15, Shown::nothing},  // variation selectors
    {0xfeff, 0, Shown::nothing},   // byte order mark
    {0xffa0, 0, Shown::nothing},   // Hangul filler
    {0xfff0, 11, Shown::nothing},  // annotations
};

}  // namespace

Shown shown_as(uint32_t code_point) noexcept {
  if (code_point - 0x21 < 0x7f - 0x21) {
    return Shown::glyph;
  }
  if (code_point > 0xffff) {
    const bool is_ignored = code_point - 0xe0000 < 0x1000 ||
                            code_point - 0x1bca0 < 4 ||  // shorthand
                            code_point - 0x1d173 < 8;    // musical beams
    return is_ignored ? Shown::nothing : Shown::glyph;
  }
  for (const Range& range : kRanges) {
    if (code_point - range.first <= range.more) {
      return range.shown;
    }
  }
  return Shown::glyph;
}

}  // namespace detail
}  // namespace inkcell
