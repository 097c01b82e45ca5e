// Steps after alike steps are alike: after a line to the right there comes one
// down or up, rarely one on to the right. So classes of steps are gathered in
// groups, and each group has a table for the steps that follow. Symbols do not
// mix classes, as a word must tell the table of the next one. The sign of the
// first number is part of the symbol: its bit is the last of the word, if the
// tree of words allows it.
#include "outlines/table_code.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "base/code_lengths.hpp"
#include "outlines/outline_steps.hpp"
#include "outlines/symbol_shares.hpp"

namespace inkcell::gen {
namespace {

constexpr size_t kMostTables = 8;

// What a symbol costs in a table besides its steps, so that rare classes are
// gathered. [bits, Q8]
constexpr uint64_t kSymbolCost_q8 = 4 << 8;

// Classes of steps with one table, and what comes after them.
struct Group {
  std::vector<size_t> classes;
  ClassCounts after;

  // Bits of the symbols of what follows, without those of numbers. [Q8]
  uint64_t bits_q8() const {
    uint64_t total = after.ends;
    uint64_t sum_q8 = n_log_n_q8(after.ends);
    for (const auto& symbol : after.points) {
      total += symbol.second;
      sum_q8 += n_log_n_q8(symbol.second);
    }
    return n_log_n_q8(total) - sum_q8 + kSymbolCost_q8 * after.points.size();
  }
};

// Joins the two groups that lose least by it.
void join_groups(std::vector<Group>& groups) {
  int64_t least = std::numeric_limits<int64_t>::max();
  Group best;
  size_t a = 0;
  size_t b = 0;
  for (size_t i = 0; i < groups.size(); ++i) {
    for (size_t j = i + 1; j < groups.size(); ++j) {
      Group both = groups[i];
      both.classes.insert(both.classes.end(), groups[j].classes.begin(),
                          groups[j].classes.end());
      both.after.add(groups[j].after);
      const auto loss = static_cast<int64_t>(both.bits_q8()) -
                        static_cast<int64_t>(groups[i].bits_q8()) -
                        static_cast<int64_t>(groups[j].bits_q8());
      if (loss < least) {
        least = loss;
        best = std::move(both);
        a = i;
        b = j;
      }
    }
  }
  groups[a] = std::move(best);
  groups.erase(groups.begin() + static_cast<ptrdiff_t>(b));
}

// The symbols of one table, and their words' lengths.
struct TablePlan {
  std::vector<CodeSymbol> symbols;
  std::vector<int> lengths;
  uint64_t bits = std::numeric_limits<uint64_t>::max();  // of streams
};

// The plan of a table for each width from kLeastCodeBits on.
class TableSearch {
 public:
  explicit TableSearch(const ClassCounts& counts) {
    SymbolShares shares(counts);
    do {
      try_shares(shares.all(), counts);
    } while (shares.join_two());
  }

  const TablePlan& plan(int code_bits) const {
    return plans_[static_cast<size_t>(code_bits - kLeastCodeBits)];
  }

 private:
  void try_shares(const std::vector<Share>& shares, const ClassCounts& of) {
    TablePlan found;
    std::vector<uint64_t> counts;
    for (const Share& share : shares) {
      found.symbols.push_back(share.symbol);
      counts.push_back(share.count);
    }
    if (of.has_end) {
      found.symbols.push_back({WordKind::end, 0, 0});
      counts.push_back(of.ends);
    }
    for (int bits = kLeastCodeBits; bits <= kMostCodeBits; ++bits) {
      if (counts.size() > size_t{1} << bits) {
        continue;
      }
      found.lengths = limited_lengths(counts, bits);
      found.bits = of.ends;
      for (size_t i = 0; i < counts.size(); ++i) {
        found.bits +=
            counts[i] * static_cast<uint64_t>(found.lengths[i] +
                                              number_bits(found.symbols[i]));
      }
      TablePlan& best = plans_[static_cast<size_t>(bits - kLeastCodeBits)];
      if (found.bits < best.bits) {
        best = found;
      }
    }
  }

  TablePlan plans_[kMostCodeBits - kLeastCodeBits + 1];
};

// A tree of words. At each level nodes go in pairs: those that must be on the
// left, an `end` or words of positive numbers, those that must be on the right,
// of negative ones, and others. A word of a sign that finds no place there does
// without: its number has all of its bits.
class WordTree {
 public:
  WordTree(const TablePlan& plan, int code_bits) : bits_(plan.symbols.size()) {
    for (size_t i = 0; i < plan.symbols.size(); ++i) {
      words_.push_back({plan.symbols[i], plan.lengths[i], 0});
    }
    std::vector<Node> level;
    for (int length = code_bits; length > 0 && words_.size() > 1; --length) {
      for (size_t i = 0; i < words_.size(); ++i) {
        if (words_[i].length == length) {
          level.push_back(leaf(i));
        }
      }
      level = pairs_of(std::move(level));
    }
    std::sort(words_.begin(), words_.end(),
              [code_bits](const CodeWord& a, const CodeWord& b) {
                return a.word << (code_bits - a.length) <
                       b.word << (code_bits - b.length);
              });
  }

  std::vector<CodeWord> take() { return std::move(words_); }

 private:
  enum class Side { left, right, any };

  struct Node {
    std::vector<size_t> words;  // below it
    Side side = Side::any;
    bool has_end = false;
  };

  Node leaf(size_t i) const {
    const CodeWord& word = words_[i];
    if (word.symbol.kind == WordKind::end) {
      return {{i}, Side::left, true};
    }
    // A reader skips a bit at least.
    const int sign = word.length > 1 ? word.symbol.sign : 0;
    return {{i},
            sign > 0   ? Side::left
            : sign < 0 ? Side::right
                       : Side::any,
            false};
  }

  // The nodes above, each with two of this level.
  std::vector<Node> pairs_of(std::vector<Node> level) {
    const size_t half = level.size() / 2;
    std::vector<Node> left;
    std::vector<Node> right;
    std::vector<Node> others;
    std::stable_partition(level.begin(), level.end(),
                          [](const Node& node) { return node.has_end; });
    for (Node& node : level) {
      std::vector<Node>& side = node.side == Side::right ? right : left;
      if (node.side == Side::any || side.size() == half) {
        others.push_back(std::move(node));
        continue;
      }
      if (!node.has_end) {
        words_[node.words.front()].shares_bit = true;
      }
      side.push_back(std::move(node));
    }
    for (Node& node : others) {
      (left.size() < half ? left : right).push_back(std::move(node));
    }
    std::vector<Node> above;
    for (size_t i = 0; i < half; ++i) {
      for (const size_t word : right[i].words) {
        words_[word].word |= 1 << bits_[word];
      }
      Node both = std::move(left[i]);
      both.words.insert(both.words.end(), right[i].words.begin(),
                        right[i].words.end());
      for (const size_t word : both.words) {
        ++bits_[word];
      }
      both.side = both.has_end ? Side::left : Side::any;
      above.push_back(std::move(both));
    }
    return above;
  }

  std::vector<CodeWord> words_;
  std::vector<int> bits_;  // of each word that are known
};

// Records begin with the first group.
OutlineCode code_of(const std::vector<Group>& groups,
                    const std::vector<TableSearch>& searches,
                    int code_bits) {
  std::vector<OutlineCode::Words> tables;
  OutlineCode::TableOfClass table_of_class = {};
  for (size_t i = 0; i < groups.size(); ++i) {
    tables.push_back(WordTree(searches[i].plan(code_bits), code_bits).take());
    for (const size_t step_class : groups[i].classes) {
      table_of_class[step_class] = i;
    }
  }
  return {code_bits, std::move(tables), table_of_class};
}

}  // namespace

std::optional<OutlineCode> make_table_code(const StepCounts& counts,
                                           size_t most_entries) {
  std::vector<Group> groups;
  for (size_t i = 0; i < kStepClasses; ++i) {
    const ClassCounts& after = counts.after()[i];
    if (after.has_end || !after.points.empty()) {
      groups.push_back({{i}, after});
    }
  }
  std::optional<OutlineCode> best;
  uint64_t least = std::numeric_limits<uint64_t>::max();
  for (size_t tables = kMostTables; tables > 1; tables /= 2) {
    if (groups.size() < tables) {
      continue;
    }
    while (groups.size() > tables) {
      join_groups(groups);
    }
    std::vector<TableSearch> searches;
    for (const Group& group : groups) {
      searches.emplace_back(group.after);
    }
    for (int code_bits = kLeastCodeBits;
         code_bits <= kMostCodeBits && tables << code_bits <= most_entries;
         ++code_bits) {
      if (!std::all_of(searches.begin(), searches.end(),
                       [code_bits](const TableSearch& search) {
                         return !search.plan(code_bits).symbols.empty();
                       })) {
        continue;
      }
      OutlineCode code = code_of(groups, searches, code_bits);
      const uint64_t bits =
          stream_bits(counts, code) + kEntryBits * (tables << code_bits);
      if (bits < least) {
        least = bits;
        best = std::move(code);
      }
    }
  }
  return best;
}

}  // namespace inkcell::gen
