// Code tables of outlines: lengths, words, and the search for symbols.
#include <gtest/gtest.h>

#include "base/code_lengths.hpp"
#include "outlines/code_search.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace inkcell::gen::test {
namespace {

uint64_t total_bits(const std::vector<uint64_t>& counts,
                    const std::vector<int>& lengths) {
  uint64_t total = 0;
  for (size_t i = 0; i < counts.size(); ++i) {
    total += counts[i] * static_cast<uint64_t>(lengths[i]);
  }
  return total;
}

// The sum of 2^-length of all words, in units of 2^-most.
int kraft_sum(const std::vector<int>& lengths, int most) {
  return std::accumulate(
      lengths.begin(), lengths.end(), 0,
      [most](int sum, int length) { return sum + (1 << (most - length)); });
}

// The least total, by trying all lengths.
uint64_t least_total(const std::vector<uint64_t>& counts, int most) {
  std::vector<int> lengths(counts.size(), 1);
  uint64_t least = std::numeric_limits<uint64_t>::max();
  for (;;) {
    if (kraft_sum(lengths, most) <= 1 << most) {
      least = std::min(least, total_bits(counts, lengths));
    }
    size_t i = 0;
    while (i < lengths.size() && lengths[i] == most) {
      lengths[i++] = 1;
    }
    if (i == lengths.size()) {
      return least;
    }
    ++lengths[i];
  }
}

TEST(OutlineCode, LimitedLengthsAreTheBest) {
  std::mt19937 random(1);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    const int most = 3 + round % 2;
    const size_t size = 2 + random() % (most == 3 ? 7 : 5);
    std::vector<uint64_t> counts(size);
    for (uint64_t& count : counts) {
      count = 1 + (uint64_t{random()} % 1000 >> random() % 10);
    }
    const std::vector<int> lengths = limited_lengths(counts, most);
    EXPECT_EQ(kraft_sum(lengths, most), 1 << most);
    EXPECT_EQ(total_bits(counts, lengths), least_total(counts, most));
  }
}

TEST(OutlineCode, LengthsOfFewAndOfManySymbols) {
  EXPECT_EQ(limited_lengths({5}, 4), std::vector<int>{1});
  EXPECT_EQ(limited_lengths({0, 0}, 4), (std::vector<int>{1, 1}));
  const std::vector<uint64_t> counts(128, 3);
  EXPECT_EQ(limited_lengths(counts, 7), std::vector<int>(128, 7));
}

std::vector<OutlineStep> random_steps(std::mt19937& random, int most_bits) {
  std::vector<OutlineStep> steps;
  const auto number = [&random, most_bits] {
    std::uniform_int_distribution<int> width(-most_bits / 2, most_bits);
    const int reach = (1 << std::max(width(random), 0)) / 2;
    return std::uniform_int_distribution<int>(-reach,
                                              std::max(reach - 1, 0))(random);
  };
  for (int contour = 0; contour < 3; ++contour) {
    const int count = 3 + static_cast<int>(random() % 9);
    for (int i = 0; i < count; ++i) {
      const auto kind =
          i == 0 ? WordKind::corner : static_cast<WordKind>(random() % 3);
      steps.push_back({kind, number(), number()});
    }
    steps.push_back({WordKind::end, 0, 0});
  }
  return steps;
}

TEST(OutlineCode, WordsArePrefixesOfTheirEntries) {
  std::mt19937 random(2);
  for (int round = 0; round < 8; ++round) {
    SCOPED_TRACE(round);
    StepCounts counts;
    for (int glyph = 0; glyph < 1 + 10 * round; ++glyph) {
      counts.add(random_steps(random, 1 + 2 * round));
    }
    const OutlineCode code = make_outline_code(counts);
    const std::vector<uint16_t> table = code.table();
    ASSERT_EQ(table.size(), size_t{1} << code.code_bits());
    EXPECT_EQ(code.words().front().symbol.kind, WordKind::end);
    EXPECT_EQ(code.words().front().word, 0);
    size_t entries = 0;
    for (const CodeWord& word : code.words()) {
      const int free_bits = code.code_bits() - word.length;
      for (int i = 0; i < 1 << free_bits; ++i, ++entries) {
        const auto at = static_cast<size_t>((word.word << free_bits) + i);
        ASSERT_EQ(at, entries);
        EXPECT_EQ(table[at] & 7, word.length);
        EXPECT_EQ(table[at] >> 3 & 3, static_cast<int>(word.symbol.kind));
        EXPECT_EQ(table[at] >> 5 & 15, word.symbol.x_bits);
        EXPECT_EQ(table[at] >> 9, word.symbol.y_bits);
      }
    }
    EXPECT_EQ(entries, table.size());
  }
}

TEST(OutlineCode, FindsTheWordOfFewestBits) {
  const std::vector<CodeSymbol> symbols = {{WordKind::corner, 4, 4},
                                           {WordKind::corner, 0, 6},
                                           {WordKind::off_curve, 3, 3},
                                           {WordKind::end, 0, 0}};
  const OutlineCode code(4, symbols, {1, 2, 3, 3});
  const auto found = [&code](WordKind kind, int dx, int dy) {
    const CodeWord* word = code.find(OutlineStep{kind, dx, dy}, 0);
    return word == nullptr ? -1 : word->total_bits();
  };
  EXPECT_EQ(found(WordKind::corner, 0, 7), 8);
  EXPECT_EQ(found(WordKind::corner, 0, 8), 8);
  EXPECT_EQ(found(WordKind::corner, -8, 7), 9);
  EXPECT_EQ(found(WordKind::corner, 8, 0), -1);
  EXPECT_EQ(found(WordKind::off_curve, -4, 3), 9);
  EXPECT_EQ(found(WordKind::off_curve, 0, 4), -1);
  EXPECT_EQ(found(WordKind::smooth, 0, 0), -1);
  EXPECT_EQ(found(WordKind::end, 0, 0), 3);
}

TEST(OutlineCode, TakesFewerBitsThanFixedWidths) {
  std::mt19937 random(3);
  StepCounts counts;
  for (int glyph = 0; glyph < 100; ++glyph) {
    counts.add(random_steps(random, 9));
  }
  const OutlineCode fixed(4,
                          {{WordKind::off_curve, 9, 9},
                           {WordKind::smooth, 9, 9},
                           {WordKind::corner, 9, 9},
                           {WordKind::end, 0, 0}},
                          {2, 2, 2, 2});
  EXPECT_LT(stream_bits(counts, make_outline_code(counts)),
            stream_bits(counts, fixed) * 8 / 10);
}

TEST(OutlineCode, OfTheSameCountsIsTheSame) {
  std::mt19937 random(4);
  StepCounts counts;
  for (int glyph = 0; glyph < 30; ++glyph) {
    counts.add(random_steps(random, 11));
  }
  EXPECT_EQ(make_outline_code(counts).table(),
            make_outline_code(counts).table());
}

TEST(OutlineCode, OfNoGlyphsHasAWordForTheEnd) {
  const OutlineCode code = make_outline_code(StepCounts());
  EXPECT_EQ(code.table(), std::vector<uint16_t>(16, 1 | 3 << 3));
}

}  // namespace
}  // namespace inkcell::gen::test
