// Characters of East Asian standards, by frequency of use.
#pragma once

#include <string_view>

namespace inkcell::gen {

/// A set of code points: bit i % 6 of coded[i / 6] - '0' says whether
/// first + i is in it.
struct CodedSet {
  char32_t first;
  std::string_view coded;
};

extern const CodedSet kGb2312Level1;    // common hanzi of China
extern const CodedSet kJisX0208Level1;  // common kanji of Japan
extern const CodedSet kKsX1001Hangul;   // common syllables of Korea

}  // namespace inkcell::gen
