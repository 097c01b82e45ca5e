#include "outlines/outline_code.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "base/code_lengths.hpp"
#include "outlines/table_code.hpp"

namespace inkcell::gen {
namespace {

constexpr uint64_t kImpossible = std::numeric_limits<uint64_t>::max();

// A kind and widths of points, and their count.
struct Pair {
  CodeSymbol symbol;
  uint64_t count;
  uint64_t n_log_n_q8;  // of the count
};

bool same(const CodeSymbol& a, const CodeSymbol& b) {
  return a.kind == b.kind && a.x_bits == b.x_bits && a.y_bits == b.y_bits;
}

std::vector<Pair> pairs_of(const ClassCounts& counts) {
  std::vector<Pair> pairs;
  for (const auto& [symbol, count] : counts.points) {
    pairs.push_back({symbol, count, n_log_n_q8(count)});
  }
  return pairs;
}

// Searches for the symbols of a code of one table: joins pairs of widths, then
// improves single symbols. Lists of symbols do not contain `end`; it is
// appended when lengths are computed.
class CodeSearch {
 public:
  using Symbols = std::vector<CodeSymbol>;

  CodeSearch(const ClassCounts& counts, int most_bits)
      : pairs_(pairs_of(counts)), ends_(counts.ends), most_bits_(most_bits) {}

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
    counts.back() = ends_;
    bits = ends_ * static_cast<uint64_t>(lengths.back() + 1);
    for (const Pair& pair : pairs_) {
      int least_bits = std::numeric_limits<int>::max();
      size_t least_symbol = 0;
      for (size_t i = 0; i < symbols.size(); ++i) {
        const CodeSymbol& symbol = symbols[i];
        const int total = lengths[i] + symbol.x_bits + symbol.y_bits;
        if (total < least_bits && covers(symbol, pair.symbol)) {
          least_bits = total;
          least_symbol = i;
        }
      }
      if (least_bits == std::numeric_limits<int>::max()) {
        return false;
      }
      counts[least_symbol] += pair.count;
      bits += pair.count * static_cast<uint64_t>(least_bits);
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
  // each with one symbol less than the one before. Joins the two symbols that
  // cost the least entropy.
  std::vector<Symbols> join_pairs() const {
    std::vector<Symbols> lists;
    std::vector<Pair> joined = pairs_;
    for (;;) {
      Symbols symbols;
      for (const Pair& pair : joined) {
        symbols.push_back(pair.symbol);
      }
      lists.push_back(symbols);
      int64_t least_loss = std::numeric_limits<int64_t>::max();
      size_t a = 0;
      size_t b = 0;
      for (size_t i = 0; i < joined.size(); ++i) {
        for (size_t j = i + 1; j < joined.size(); ++j) {
          if (joined[i].symbol.kind != joined[j].symbol.kind) {
            break;  // pairs are in order of their kinds
          }
          const int64_t loss = join_loss_q8(joined[i], joined[j]);
          if (loss < least_loss) {
            least_loss = loss;
            a = i;
            b = j;
          }
        }
      }
      if (b == 0) {
        return lists;
      }
      joined[a] = {join(joined[a].symbol, joined[b].symbol),
                   joined[a].count + joined[b].count,
                   n_log_n_q8(joined[a].count + joined[b].count)};
      joined.erase(joined.begin() + static_cast<long>(b));
    }
  }

  static CodeSymbol join(const CodeSymbol& a, const CodeSymbol& b) {
    return {a.kind, std::max(a.x_bits, b.x_bits), std::max(a.y_bits, b.y_bits)};
  }

  static int64_t join_loss_q8(const Pair& a, const Pair& b) {
    const CodeSymbol both = join(a.symbol, b.symbol);
    const auto wider = [&both](const Pair& pair) {
      const int bits =
          both.x_bits + both.y_bits - pair.symbol.x_bits - pair.symbol.y_bits;
      return pair.count * static_cast<uint64_t>(bits);
    };
    const uint64_t separate = a.n_log_n_q8 + b.n_log_n_q8;
    const uint64_t together = n_log_n_q8(a.count + b.count);
    return static_cast<int64_t>((wider(a) + wider(b)) << 8) +
           static_cast<int64_t>(separate) - static_cast<int64_t>(together);
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
    for (const Pair& pair : pairs_) {
      moves.push_back({std::nullopt, pair.symbol});
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

  std::vector<Pair> pairs_;
  uint64_t ends_;
  int most_bits_;
};

}  // namespace

CodeSymbol symbol_of(const OutlineStep& step) {
  const int first = step.dx != 0 ? step.dx : step.dy;
  return {step.kind, step_bits(step.dx), step_bits(step.dy),
          (first > 0 ? 1 : 0) - (first < 0 ? 1 : 0)};
}

bool covers(const CodeSymbol& wide, const CodeSymbol& narrow) {
  return wide.kind == narrow.kind && wide.x_bits >= narrow.x_bits &&
         wide.y_bits >= narrow.y_bits &&
         (wide.sign == 0 ||
          (wide.sign == narrow.sign && class_of(wide) == class_of(narrow)));
}

size_t class_of(const CodeSymbol& symbol) {
  if (symbol.kind == WordKind::end) {
    return kStartClass;
  }
  size_t direction = 0;
  if (symbol.sign != 0) {
    direction = symbol.y_bits == 0 ? 1 : symbol.x_bits == 0 ? 2 : 3;
    direction += symbol.sign < 0 ? 3 : 0;
  }
  return 1 + 7 * static_cast<size_t>(symbol.kind) + direction;
}

bool ClassCounts::Less::operator()(const CodeSymbol& a,
                                   const CodeSymbol& b) const {
  return std::tie(a.kind, a.x_bits, a.y_bits, a.sign) <
         std::tie(b.kind, b.x_bits, b.y_bits, b.sign);
}

void ClassCounts::add(const ClassCounts& other) {
  for (const auto& [symbol, count] : other.points) {
    points[symbol] += count;
  }
  ends += other.ends;
  has_end = has_end || other.has_end;
}

void StepCounts::add(const std::vector<OutlineStep>& steps) {
  size_t before = kStartClass;
  for (size_t i = 0; i < steps.size(); ++i) {
    const CodeSymbol symbol = symbol_of(steps[i]);
    ClassCounts& counts = after_[before];
    if (symbol.kind == WordKind::end) {
      counts.has_end = true;
      counts.ends += i + 1 < steps.size() ? 1u : 0u;
    } else {
      ++counts.points[symbol];
    }
    before = class_of(symbol);
  }
}

ClassCounts StepCounts::all() const {
  ClassCounts all;
  for (const ClassCounts& counts : after_) {
    for (const auto& [symbol, count] : counts.points) {
      all.points[{symbol.kind, symbol.x_bits, symbol.y_bits}] += count;
    }
    all.ends += counts.ends;
  }
  return all;
}

OutlineCode::OutlineCode(int code_bits,
                         const std::vector<CodeSymbol>& symbols,
                         const std::vector<int>& lengths)
    : code_bits_(code_bits), tables_(1) {
  Words& words = tables_.front();
  for (size_t i = 0; i < symbols.size(); ++i) {
    words.push_back({symbols[i], lengths[i], 0});
  }
  std::stable_sort(words.begin(), words.end(),
                   [](const CodeWord& a, const CodeWord& b) {
                     const bool is_end = a.symbol.kind == WordKind::end;
                     if (is_end || b.symbol.kind == WordKind::end) {
                       return is_end && b.symbol.kind != WordKind::end;
                     }
                     return a.length > b.length;
                   });
  // Table entries in use. Words after `end` may be longer than it. As the code
  // is complete, each word still begins at a multiple of its entries.
  int used = 0;
  for (CodeWord& word : words) {
    word.word = used >> (code_bits - word.length);
    used += 1 << (code_bits - word.length);
  }
}

OutlineCode::OutlineCode(int code_bits,
                         std::vector<Words> tables,
                         const TableOfClass& table_of_class)
    : code_bits_(code_bits),
      tables_(std::move(tables)),
      table_of_class_(table_of_class) {
  for (Words& words : tables_) {
    for (CodeWord& word : words) {
      word.next_table = table_after(class_of(word.symbol));
    }
  }
}

std::vector<uint16_t> OutlineCode::table() const {
  std::vector<uint16_t> entries;
  for (size_t table = 0; table < tables_.size(); ++table) {
    for (const CodeWord& word : tables_[table]) {
      const int skipped = word.length - (word.shares_bit ? 1 : 0);
      const auto change = static_cast<int>(table ^ word.next_table);
      const int entry = skipped | static_cast<int>(word.symbol.kind) << 3 |
                        word.symbol.x_bits << 5 | word.symbol.y_bits << 9 |
                        change << 13;
      entries.insert(entries.end(),
                     size_t{1} << static_cast<size_t>(code_bits_ - word.length),
                     static_cast<uint16_t>(entry));
    }
    // A code of one word.
    entries.resize((table + 1) << code_bits_, entries.back());
  }
  return entries;
}

const CodeWord* OutlineCode::find(const CodeSymbol& symbol,
                                  size_t table) const {
  const CodeWord* best = nullptr;
  for (const CodeWord& word : tables_[table]) {
    if (covers(word.symbol, symbol) &&
        (best == nullptr || word.total_bits() < best->total_bits())) {
      best = &word;
    }
  }
  return best;
}

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

OutlineCode widest_outline_code() {
  constexpr int kWordBits = 2;
  std::vector<CodeSymbol> symbols;
  for (const WordKind kind :
       {WordKind::off_curve, WordKind::smooth, WordKind::corner}) {
    symbols.push_back({kind, kMostStepBits, kMostStepBits});
  }
  symbols.push_back({WordKind::end, 0, 0});
  return {kLeastCodeBits, symbols, std::vector<int>(symbols.size(), kWordBits)};
}

uint64_t stream_bits(const StepCounts& counts, const OutlineCode& code) {
  uint64_t bits = 0;
  for (size_t i = 0; i < kStepClasses; ++i) {
    const ClassCounts& after = counts.after()[i];
    const size_t table = code.table_after(i);
    const auto bits_of = [&](const CodeSymbol& symbol) {
      return static_cast<uint64_t>(code.find(symbol, table)->total_bits());
    };
    for (const auto& [symbol, count] : after.points) {
      bits += count * bits_of(symbol);
    }
    if (after.ends != 0) {
      bits += after.ends * (bits_of({WordKind::end, 0, 0}) + 1);
    }
  }
  return bits;
}

}  // namespace inkcell::gen
