#include "text/blank.hpp"

namespace inkcell::detail {
namespace {

// Three bytes each: what a program keeps of this table, it keeps of every text.
struct Range {
  constexpr Range(uint32_t first, uint32_t more, Shown shown)
      : low(static_cast<uint8_t>(first)),
        high(static_cast<uint8_t>(first >> 8)),
        more_and_shown(
            static_cast<uint8_t>(more << 2 | static_cast<uint32_t>(shown))) {}

  uint8_t low;             // low byte of the first code point
  uint8_t high;            // high byte
  uint8_t more_and_shown;  // code points after the first (at most 63), Shown
};

constexpr Range kRanges[] = {
    {0x0000, 8, Shown::nothing},   // controls
    {0x0009, 0, Shown::space},     // tab
    {0x000a, 21, Shown::nothing},  // line ends, controls
    {0x0020, 0, Shown::space},
    {0x007f, 32, Shown::nothing},  // controls
    {0x00a0, 0, Shown::space},     // no-break space
    {0x00ad, 0, Shown::nothing},   // soft hyphen
    {0x0300, 55, Shown::mark},     // diacritics
    {0x0338, 55, Shown::mark},
    {0x034f, 0, Shown::nothing},  // grapheme joiner
    {0x0483, 6, Shown::mark},     // Cyrillic
    {0x0591, 44, Shown::mark},    // Hebrew points
    {0x05bf, 0, Shown::mark},
    {0x05c1, 1, Shown::mark},
    {0x05c4, 1, Shown::mark},
    {0x05c7, 0, Shown::mark},
    {0x0610, 10, Shown::mark},    // Arabic
    {0x061c, 0, Shown::nothing},  // Arabic letter mark
    {0x064b, 20, Shown::mark},
    {0x0670, 0, Shown::mark},
    {0x06d6, 6, Shown::mark},
    {0x06df, 5, Shown::mark},
    {0x06e7, 1, Shown::mark},
    {0x06ea, 3, Shown::mark},
    {0x0e31, 0, Shown::mark},  // Thai
    {0x0e34, 6, Shown::mark},
    {0x0e47, 7, Shown::mark},
    {0x115f, 1, Shown::nothing},  // Hangul fillers
    {0x17b4, 1, Shown::nothing},  // Khmer inherent vowels
    {0x180b, 4, Shown::nothing},  // Mongolian selectors
    {0x1ab0, 63, Shown::mark},    // diacritics
    {0x1dc0, 63, Shown::mark},
    {0x2000, 10, Shown::space},    // spaces of other widths
    {0x200b, 4, Shown::nothing},   // zero width, joiners, marks
    {0x2028, 6, Shown::nothing},   // separators, embeddings
    {0x202f, 0, Shown::space},     // narrow no-break space
    {0x205f, 0, Shown::space},     // mathematical space
    {0x2060, 15, Shown::nothing},  // word joiner, isolates
    {0x20d0, 32, Shown::mark},     // of symbols
    {0x2de0, 31, Shown::mark},     // Cyrillic
    {0x3000, 0, Shown::space},     // ideographic space
    {0x302a, 3, Shown::mark},      // tones
    {0x3099, 1, Shown::mark},      // voicing
    {0x3164, 0, Shown::nothing},   // Hangul filler
    {0xfe00, 15, Shown::nothing},  // variation selectors
    {0xfe20, 15, Shown::mark},     // half marks
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
    const uint32_t first = range.low | uint32_t{range.high} << 8;
    if (code_point - first <= range.more_and_shown >> 2) {
      return static_cast<Shown>(range.more_and_shown & 3);
    }
  }
  return Shown::glyph;
}

}  // namespace inkcell::detail
