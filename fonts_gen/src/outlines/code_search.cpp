#include "outlines/code_search.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/code_lengths.hpp"
#include "outlines/symbol_shares.hpp"
#include "outlines/table_code.hpp"

namespace inkcell::gen {
namespace {

constexpr uint64_t kImpossible = std::numeric_limits<uint64_t>::max();

bool same(const CodeSymbol& a, const CodeSymbol& b) {
  return a.kind == b.kind && a.x_bits == b.x_bits && a.y_bits == b.y_bits;
}

// Searches for the symbols of a code of one table: joins pairs of widths, then
// improves single symbols. Lists of symbols do not contain `end`; it is
// appended when lengths are computed.
class CodeSearch {
 public:
  using Symbols = std::vector<CodeSymbol>;

  // `counts`: without signs.
  CodeSearch(ClassCounts counts, int most_bits)
      : counts_(std::move(counts)), most_bits_(most_bits) {}

  OutlineCode run() const {
    uint64_t best_bits = kImpossible;
    std::optional<OutlineCode> best;
    const std::vector<Symbols> joined = join_pairs();
    for (int code_bits = kLeastCodeBits; code_bits <= most_bits_; ++code_bits) {
      const Symbols symbols = improve(least(joined, code_bits), code_bits);
      const uint64_t bits =
          cost(symbols, code_bits, nullptr) + table_bits(code_bits);
      if (bits < best_bits) {
        best_bits = bits;
        best = code(symbols, code_bits);
      }
    }
    return *best;
  }

 private:
  static uint64_t table_bits(int code_bits) { return kEntryBits << code_bits; }

  OutlineCode code(Symbols symbols, int code_bits) const {
    std::vector<int> lengths;
    cost(symbols, code_bits, &lengths);
    symbols.push_back({WordKind::end, 0, 0});
    return {code_bits, symbols, lengths};
  }

  // Counts the points of each symbol. Each pair goes to the symbol with the
  // fewest bits; false if a pair fits none.
  bool distribute(const Symbols& symbols,
                  const std::vector<int>& lengths,
                  std::vector<uint64_t>& counts,
                  uint64_t& bits) const {
    counts.assign(symbols.size() + 1, 0);
    counts.back() = counts_.ends;
    bits = counts_.ends * static_cast<uint64_t>(lengths.back() + 1);
    for (const auto& [widths, count] : counts_.points) {
      int least_bits = std::numeric_limits<int>::max();
      size_t least_symbol = 0;
      for (size_t i = 0; i < symbols.size(); ++i) {
        const CodeSymbol& symbol = symbols[i];
        const int total = lengths[i] + symbol.x_bits + symbol.y_bits;
        if (total < least_bits && covers(symbol, widths)) {
          least_bits = total;
          least_symbol = i;
        }
      }
      if (least_bits == std::numeric_limits<int>::max()) {
        return false;
      }
      counts[least_symbol] += count;
      bits += count * static_cast<uint64_t>(least_bits);
    }
    return true;
  }

  // Bits of the streams with a code of `symbols`; kImpossible if there is none.
  // Lengths and the choice of symbols depend on each other, so this takes a few
  // rounds.
  uint64_t cost(const Symbols& symbols,
                int code_bits,
                std::vector<int>* best_lengths) const {
    constexpr int kSolveRounds = 3;
    if (symbols.size() + 1 > size_t{1} << code_bits) {
      return kImpossible;
    }
    uint64_t best = kImpossible;
    std::vector<int> lengths(symbols.size() + 1, code_bits);
    std::vector<uint64_t> counts;
    for (int round = 0; round <= kSolveRounds; ++round) {
      uint64_t bits = 0;
      if (!distribute(symbols, lengths, counts, bits)) {
        return kImpossible;
      }
      if (round > 0 && bits < best) {
        best = bits;
        if (best_lengths != nullptr) {
          *best_lengths = lengths;
        }
      }
      lengths = limited_lengths(counts, code_bits);
    }
    return best;
  }

  // Lists from one symbol for each pair of widths down to one for each kind,
  // each with one symbol less than the one before.
  std::vector<Symbols> join_pairs() const {
    SymbolShares shares(counts_);
    std::vector<Symbols> lists;
    do {
      lists.emplace_back();
      for (const Share& share : shares.all()) {
        lists.back().push_back(share.symbol);
      }
    } while (shares.join_two());
    return lists;
  }

  // The list that takes the fewest bits.
  Symbols least(const std::vector<Symbols>& lists, int code_bits) const {
    uint64_t best_bits = kImpossible;
    Symbols best;
    for (const Symbols& symbols : lists) {
      const uint64_t bits = cost(symbols, code_bits, nullptr);
      if (bits < best_bits) {
        best_bits = bits;
        best = symbols;
      }
    }
    return best;
  }

  // Removes, adds and changes single symbols as long as that saves bits.
  Symbols improve(Symbols symbols, int code_bits) const {
    uint64_t best = cost(symbols, code_bits, nullptr);
    bool is_better = true;
    while (is_better) {
      is_better = false;
      for (const Move& move : moves_from(symbols)) {
        Symbols moved = symbols;
        if (!apply(move, moved)) {
          continue;
        }
        const uint64_t bits = cost(moved, code_bits, nullptr);
        if (bits < best) {
          best = bits;
          symbols = std::move(moved);
          is_better = true;
        }
      }
    }
    return symbols;
  }

  // A symbol to remove, one to add, or both.
  struct Move {
    std::optional<CodeSymbol> from;
    std::optional<CodeSymbol> to;
  };

  std::vector<Move> moves_from(const Symbols& symbols) const {
    std::vector<Move> moves;
    for (const CodeSymbol& symbol : symbols) {
      moves.push_back({symbol, std::nullopt});
      for (const int step : {-1, 1}) {
        CodeSymbol x = symbol;
        x.x_bits += step;
        CodeSymbol y = symbol;
        y.y_bits += step;
        moves.push_back({symbol, x});
        moves.push_back({symbol, y});
      }
    }
    for (const auto& point : counts_.points) {
      moves.push_back({std::nullopt, point.first});
    }
    return moves;
  }

  // False if `symbols` does not allow the move.
  static bool apply(const Move& move, Symbols& symbols) {
    if (move.from) {
      const auto at = find(symbols, *move.from);
      if (at == symbols.end()) {
        return false;
      }
      symbols.erase(at);
    }
    if (move.to) {
      if (!is_valid(*move.to) || find(symbols, *move.to) != symbols.end()) {
        return false;
      }
      symbols.push_back(*move.to);
    }
    return true;
  }

  static bool is_valid(const CodeSymbol& symbol) {
    return symbol.x_bits >= 0 && symbol.x_bits <= kMostStepBits &&
           symbol.y_bits >= 0 && symbol.y_bits <= kMostStepBits;
  }

  static Symbols::iterator find(Symbols& symbols, const CodeSymbol& symbol) {
    return std::find_if(
        symbols.begin(), symbols.end(),
        [&symbol](const CodeSymbol& other) { return same(other, symbol); });
  }

  ClassCounts counts_;
  int most_bits_;
};

}  // namespace

OutlineCode make_outline_code(const StepCounts& counts, size_t most_entries) {
  int most_bits = kLeastCodeBits;
  while (most_bits < kMostCodeBits && size_t{2} << most_bits <= most_entries) {
    ++most_bits;
  }
  const OutlineCode single = CodeSearch(counts.all(), most_bits).run();
  const std::optional<OutlineCode> several =
      make_table_code(counts, most_entries);
  const auto bits = [&counts](const OutlineCode& code) {
    return stream_bits(counts, code) + kEntryBits * code.table().size();
  };
  return several && bits(*several) * 20 <= bits(single) * 19 ? *several
                                                             : single;
}

}  // namespace inkcell::gen
