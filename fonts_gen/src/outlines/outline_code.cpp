#include "outlines/outline_code.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace inkcell::gen {

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
