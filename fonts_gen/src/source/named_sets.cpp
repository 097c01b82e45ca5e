#include "source/named_sets.hpp"

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/trimmed.hpp"
#include "source/east_asian_sets.hpp"

namespace inkcell::gen {
namespace {

// A list of add_ranges(), or a coded set.
struct NamedSet {
  std::string_view name;
  std::string_view ranges;
  const CodedSet* coded = nullptr;
};

constexpr NamedSet kSets[] = {
    {"ascii", kDefaultChars},
    {"latin-1", "0x20-0x7E,0xA0-0xFF"},
    // Latin Extended-A, letters of Romanian and German that it lacks, and
    // signs of European texts: dashes, quotation marks, the bullet, the
    // ellipsis, per mille, the euro, the trade mark.
    {"latin-ext",
     "0x100-0x17F,0x218-0x21B,0x1E9E,0x2013-0x2014,0x2018-0x201A,"
     "0x201C-0x201E,0x2022,0x2026,0x2030,0x2039-0x203A,0x20AC,0x2122"},
    // Of one accent, as today's Greek is written.
    {"greek", "0x384-0x38A,0x38C,0x38E-0x3A1,0x3A3-0x3CE"},
    // Of the Slavic languages, with the numero sign.
    {"cyrillic", "0x400-0x45F,0x490-0x491,0x2116"},
    {"kana", "0x3041-0x3093,0x309B-0x309E,0x30A1-0x30F6,0x30FB-0x30FE"},
    // Blank, stops, brackets and marks of Chinese and Japanese, and ASCII of
    // full width.
    {"cjk-signs", "0x3000-0x3003,0x3005-0x3011,0x3014-0x3017,0xFF01-0xFF5E"},
    {"gb2312-1", "", &kGb2312Level1},
    {"jis-1", "", &kJisX0208Level1},
    {"ks-x-1001", "", &kKsX1001Hangul},
};

void add_coded(const CodedSet& set, CharSet& out) {
  constexpr size_t kBits = 6;
  for (size_t i = 0; i < kBits * set.coded.size(); ++i) {
    if (((set.coded[i / kBits] - '0') >> (i % kBits) & 1) != 0) {
      out.insert(out.end(), set.first + static_cast<char32_t>(i));
    }
  }
}

void add_named_set(std::string_view name, CharSet& out) {
  const NamedSet* const set =
      std::find_if(std::begin(kSets), std::end(kSets),
                   [name](const NamedSet& one) { return one.name == name; });
  if (set == std::end(kSets)) {
    throw Error("--set: '" + std::string(name) + "' is not known; there are " +
                known_sets());
  }
  if (set->coded != nullptr) {
    add_coded(*set->coded, out);
  } else {
    add_ranges(set->ranges, out);
  }
}

}  // namespace

void add_named_sets(std::string_view list, CharSet& out) {
  while (true) {
    const size_t comma = list.find(',');
    add_named_set(trimmed(list.substr(0, comma)), out);
    if (comma == std::string_view::npos) {
      return;
    }
    list.remove_prefix(comma + 1);
  }
}

std::string known_sets() {
  std::string names;
  for (const NamedSet& set : kSets) {
    names += (names.empty() ? "" : ", ") + std::string(set.name);
  }
  return names;
}

}  // namespace inkcell::gen
