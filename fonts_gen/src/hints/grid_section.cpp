#include "hints/grid_section.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/code_lengths.hpp"

namespace inkcell::gen {
namespace {

namespace grid = format::grid;

using Counts = std::array<std::map<uint32_t, uint64_t>, grid::kTables>;

constexpr int64_t kImpossible = std::numeric_limits<int64_t>::max();

// The lists of words with the least entropy.
class WordSearch {
 public:
  WordSearch(const std::map<uint32_t, uint64_t>& counts, size_t most_words)
      : steps_(std::min(most_words, counts.size()) + 1,
               std::vector<Step>(counts.size() + 1)) {
    for (const auto& [value, count] : counts) {
      values_.push_back(value);
      before_.push_back(before_.back() + count);
    }
    steps_[0][0].bits_q8 = 0;
    for (size_t i = 0; i < values_.size(); ++i) {
      const uint32_t base = base_of(i);
      size_t end = i;
      for (unsigned extra = 0; end != values_.size(); ++extra) {
        end =
            static_cast<size_t>(std::lower_bound(values_.begin(), values_.end(),
                                                 base + (1u << extra)) -
                                values_.begin());
        if (end > i) {
          add_word(i, end, extra);
        }
      }
    }
  }

  size_t most_words() const { return steps_.size() - 1; }

  /// So many words by ascending bases, and the numbers that each writes; none
  /// if there is no such list.
  std::vector<NumberWord> words(size_t count,
                                std::vector<uint64_t>& weights) const {
    std::vector<NumberWord> words;
    if (steps_[count].back().bits_q8 == kImpossible) {
      return words;
    }
    for (size_t i = values_.size(); i != 0; --count) {
      const Step& step = steps_[count][i];
      words.push_back(
          {base_of(step.from), step.extra, 0, 0, values_[i - 1] + 1});
      weights.push_back(before_[i] - before_[step.from]);
      i = step.from;
    }
    std::reverse(words.begin(), words.end());
    std::reverse(weights.begin(), weights.end());
    return words;
  }

 private:
  // The last word of a list up to a number.
  struct Step {
    int64_t bits_q8 = kImpossible;
    size_t from = 0;
    unsigned extra = 0;
  };

  uint32_t base_of(size_t i) const {
    return std::min(values_[i], grid::kMaxBase);
  }

  void add_word(size_t from, size_t end, unsigned extra) {
    const uint64_t count = before_[end] - before_[from];
    const int64_t bits_q8 = static_cast<int64_t>(count * extra << 8) -
                            static_cast<int64_t>(n_log_n_q8(count));
    for (size_t k = 0; k + 1 < steps_.size(); ++k) {
      const int64_t all_q8 = steps_[k][from].bits_q8;
      Step& to = steps_[k + 1][end];
      if (all_q8 != kImpossible &&
          (to.bits_q8 == kImpossible || all_q8 + bits_q8 < to.bits_q8)) {
        to = {all_q8 + bits_q8, from, extra};
      }
    }
  }

  std::vector<uint32_t> values_;        // ascending
  std::vector<uint64_t> before_ = {0};  // how often those before each occur
  // steps_[k][i]: the first i values in k words.
  std::vector<std::vector<Step>> steps_;
};

// A number that a table of words writes, or one of so many plain bits.
struct Number {
  uint32_t value;
  uint32_t table;
  unsigned plain_bits = 0;
};

uint32_t kind_of(HeightHint::Kind kind) {
  switch (kind) {
    case HeightHint::Kind::bar:
      return grid::kBar;
    case HeightHint::Kind::serif:
      return grid::kSerif;
    case HeightHint::Kind::lone_edge:
      return grid::kLoneEdge;
    case HeightHint::Kind::free_end:
      break;
  }
  return grid::kFreeEnd;
}

uint32_t height_word(const HeightHint& hint) {
  uint32_t word = kind_of(hint.kind) << grid::kKindShift;
  word |= hint.is_top_edge || hint.rises ? grid::kTop : 0;
  if (hint.edge.zone) {
    word |= static_cast<uint32_t>(hint.edge.zone->zone + 1) << grid::kZoneShift;
    word |= hint.edge.zone->is_round ? grid::kRound : 0;
  }
  return word;
}

uint32_t width_of_hint(const std::optional<int>& width_u) {
  return static_cast<uint32_t>(width_u.value_or(0)) / grid::kPositionStep;
}

// [u -> 2 u]
uint32_t position_of(int at_u) {
  return static_cast<uint32_t>((at_u - grid::kPositionBase) >> 1) &
         grid::kPositionMask;
}

bool is_stroke(const HeightHint& hint) {
  return hint.kind == HeightHint::Kind::bar ||
         hint.kind == HeightHint::Kind::serif;
}

int low_of(const HeightHint& hint, const FaceHints& face) {
  return is_stroke(hint) ? edges_of(hint, face)[0] : height_of(hint.edge, face);
}

// What a reader takes, number by number. Gaps are counted from `first_y` and
// `first_x`.
std::vector<Number> numbers_of(const GlyphHints& hints,
                               const FaceHints& face,
                               uint32_t first_y,
                               uint32_t first_x) {
  std::vector<Number> numbers;
  const bool has_insets = hints.left_inset_u != 0 || hints.right_inset_u != 0;
  numbers.push_back({static_cast<uint32_t>(hints.stems.size()) |
                         static_cast<uint32_t>(hints.heights.size())
                             << grid::kHeightCountShift |
                         (has_insets ? grid::kHasInsets : 0) |
                         (hints.is_symmetric ? grid::kSymmetric : 0),
                     grid::kHeads});
  if (has_insets) {
    for (const int inset_u : {hints.left_inset_u, hints.right_inset_u}) {
      numbers.push_back({static_cast<uint32_t>(inset_u / grid::kPositionStep),
                         0, static_cast<unsigned>(grid::kInsetBits)});
    }
  }
  const auto gap_to = [](uint32_t at, uint32_t from) {
    return (at - from) & grid::kPositionMask;
  };
  uint32_t at = first_y;
  for (const HeightHint& hint : hints.heights) {
    numbers.push_back({height_word(hint), grid::kHeights});
    if (!hint.edge.zone) {
      numbers.push_back(
          {gap_to(position_of(hint.edge.position_u), at), grid::kGapsY});
    }
    if (is_stroke(hint)) {
      numbers.push_back({width_of_hint(hint.width_u), grid::kWidthsY});
    }
    at = position_of(low_of(hint, face));
  }
  at = first_x;
  for (const StemHint& stem : hints.stems) {
    numbers.push_back({gap_to(position_of(stem.position_u), at), grid::kGapsX});
    numbers.push_back({width_of_hint(stem.width_u), grid::kWidthsX});
    at =
        position_of(stem.position_u + stem.width_u.value_or(face.stem_width_u));
  }
  return numbers;
}

// The least position that a first hint of most glyphs is not below, in the
// steps of the section.
uint32_t first_of(std::vector<uint32_t> positions) {
  if (positions.empty()) {
    return 0;
  }
  const auto low =
      positions.begin() + static_cast<ptrdiff_t>(positions.size() / 64);
  std::nth_element(positions.begin(), low, positions.end());
  return *low >> grid::kFirstShift;
}

}  // namespace

// Joins neighbours into words: for each count of words those that take the
// least entropy, and of these lists the one that takes the fewest bits with
// words of `code_bits` bits at most.
NumberCode::NumberCode(const std::map<uint32_t, uint64_t>& counts,
                       unsigned code_bits)
    : code_bits_(code_bits) {
  if (counts.empty()) {
    return;
  }
  const WordSearch search(counts, size_t{1} << code_bits);
  total_bits_ = std::numeric_limits<uint64_t>::max();
  for (size_t count = 1; count <= search.most_words(); ++count) {
    std::vector<uint64_t> weights;
    std::vector<NumberWord> words = search.words(count, weights);
    if (words.empty()) {
      continue;
    }
    if (count > 1) {
      const std::vector<int> lengths =
          limited_lengths(weights, static_cast<int>(code_bits));
      for (size_t i = 0; i < count; ++i) {
        words[i].length = static_cast<unsigned>(lengths[i]);
      }
    }
    uint64_t bits = 0;
    for (size_t i = 0; i < words.size(); ++i) {
      bits += weights[i] * (words[i].length + words[i].extra);
    }
    if (bits < total_bits_) {
      total_bits_ = bits;
      words_ = std::move(words);
    }
  }
  // Words in order of their lengths, counted from the highest bit on, which a
  // reader takes first.
  uint32_t next = 0;
  for (unsigned length = 0; length <= code_bits; ++length) {
    for (NumberWord& word : words_) {
      if (word.length == length) {
        for (unsigned bit = 0; bit < length; ++bit) {
          word.word |= (next >> (code_bits - 1 - bit) & 1) << bit;
        }
        next += 1u << (code_bits - length);
      }
    }
  }
}

void NumberCode::put(uint32_t number, HintBits& bits) const {
  const auto word = std::find_if(
      words_.begin(), words_.end(),
      [number](const NumberWord& each) { return number < each.end; });
  const auto append = [&bits](uint32_t value, unsigned count) {
    for (unsigned bit = 0; bit < count; ++bit) {
      bits.push_back((value >> bit & 1) != 0);
    }
  };
  append(word->word, word->length);
  append(number - word->base, word->extra);
}

std::vector<uint16_t> NumberCode::table() const {
  std::vector<uint16_t> entries(size_t{1} << code_bits_);
  for (const NumberWord& word : words_) {
    for (size_t i = word.word; i < entries.size();
         i += size_t{1} << word.length) {
      entries[i] =
          static_cast<uint16_t>(word.length | word.extra << grid::kExtraShift |
                                word.base << grid::kBaseShift);
    }
  }
  return entries;
}

HintCode::HintCode(const FontHints& hints, unsigned most_code_bits)
    : face_(hints.face), is_empty_(hints.empty()) {
  if (is_empty_) {
    return;
  }
  std::vector<uint32_t> heights;
  std::vector<uint32_t> stems;
  for (const GlyphHints& glyph : hints.glyphs) {
    if (!glyph.heights.empty() && !glyph.heights.front().edge.zone) {
      heights.push_back(position_of(glyph.heights.front().edge.position_u));
    }
    if (!glyph.stems.empty()) {
      stems.push_back(position_of(glyph.stems.front().position_u));
    }
  }
  first_y_ = first_of(heights);
  first_x_ = first_of(stems);
  Counts counts;
  for (const GlyphHints& glyph : hints.glyphs) {
    for (const Number& number :
         numbers_of(glyph, face_, first_y_ << grid::kFirstShift,
                    first_x_ << grid::kFirstShift)) {
      if (number.plain_bits == 0) {
        ++counts[number.table][number.value];
      }
    }
  }
  uint64_t least = std::numeric_limits<uint64_t>::max();
  for (unsigned code_bits = 0; code_bits <= most_code_bits; ++code_bits) {
    std::vector<NumberCode> codes;
    uint64_t bits = uint64_t{16} * grid::kTables << code_bits;
    for (const auto& numbers : counts) {
      codes.emplace_back(numbers, code_bits);
      bits += codes.back().total_bits();
    }
    if (bits < least) {
      least = bits;
      code_bits_ = code_bits;
      codes_ = std::move(codes);
    }
  }
}

HintBits HintCode::bits(const GlyphHints& hints) const {
  HintBits bits;
  if (is_empty_) {
    return bits;
  }
  for (const Number& number :
       numbers_of(hints, face_, first_y_ << grid::kFirstShift,
                  first_x_ << grid::kFirstShift)) {
    if (number.plain_bits == 0) {
      codes_[number.table].put(number.value, bits);
    }
    for (unsigned bit = 0; bit < number.plain_bits; ++bit) {
      bits.push_back((number.value >> bit & 1) != 0);
    }
  }
  return bits;
}

std::vector<uint8_t> HintCode::section() const {
  std::vector<uint8_t> out;
  if (is_empty_) {
    return out;
  }
  const auto put = [&out](int byte) {
    out.push_back(static_cast<uint8_t>(byte));
  };
  const auto put_u16 = [&put](int value) {
    put(value & 0xff);
    put(value >> 8 & 0xff);
  };
  const auto width = [](int width_u) { return std::min(width_u, 255); };
  put(static_cast<int>(face_.zones.size()));
  put(static_cast<int>((face_.has_contrast ? grid::kContrast : 0) |
                       (face_.has_few_bars ? grid::kFewBars : 0)));
  put(width(face_.stem_width_u));
  put(width(face_.bar_width_u));
  put(static_cast<int>(face_.x_zone.value_or(grid::kNoZone)));
  put(static_cast<int>(code_bits_));
  put(static_cast<int>(first_y_));
  put(static_cast<int>(first_x_));
  for (const HintZone& zone : face_.zones) {
    put_u16(zone.flat_u);
    put(zone.overshoot_u & 0xff);
    put(zone.is_top ? static_cast<int>(grid::kTopZone) : 0);
  }
  for (const NumberCode& code : codes_) {
    for (const uint16_t entry : code.table()) {
      put_u16(entry);
    }
  }
  return out;
}

}  // namespace inkcell::gen
