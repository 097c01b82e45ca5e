#include "outlines/symbol_shares.hpp"

#include <algorithm>

#include "base/code_lengths.hpp"

namespace inkcell::gen {
namespace {

Share joined(const Share& a, const Share& b) {
  Share both = a;
  both.symbol.x_bits = std::max(a.symbol.x_bits, b.symbol.x_bits);
  both.symbol.y_bits = std::max(a.symbol.y_bits, b.symbol.y_bits);
  both.count += b.count;
  return both;
}

// What steps take more if two symbols are one. [bits, Q8]
int64_t loss_q8(const Share& a, const Share& b) {
  const Share both = joined(a, b);
  const auto more = [&both](const Share& one) {
    return one.count * static_cast<uint64_t>(number_bits(both.symbol) -
                                             number_bits(one.symbol));
  };
  return static_cast<int64_t>((more(a) + more(b)) << 8) +
         static_cast<int64_t>(n_log_n_q8(a.count) + n_log_n_q8(b.count)) -
         static_cast<int64_t>(n_log_n_q8(both.count));
}

}  // namespace

int number_bits(const CodeSymbol& symbol) {
  return symbol.x_bits + symbol.y_bits - (symbol.sign != 0 ? 1 : 0);
}

SymbolShares::SymbolShares(const ClassCounts& counts) {
  for (const auto& [symbol, count] : counts.points) {
    classes_[class_of(symbol)].shares.push_back({symbol, count});
  }
  for (Class& symbols : classes_) {
    symbols.find_pair();
  }
}

std::vector<Share> SymbolShares::all() const {
  std::vector<Share> all;
  for (const Class& symbols : classes_) {
    all.insert(all.end(), symbols.shares.begin(), symbols.shares.end());
  }
  return all;
}

bool SymbolShares::join_two() {
  Class& least = *std::min_element(classes_.begin(), classes_.end(),
                                   [](const Class& a, const Class& b) {
                                     return a.least_loss < b.least_loss;
                                   });
  if (least.least_loss == kNoPair) {
    return false;
  }
  Share& first = least.shares[least.first];
  first = joined(first, least.shares[least.second]);
  least.shares.erase(least.shares.begin() +
                     static_cast<ptrdiff_t>(least.second));
  least.find_pair();
  return true;
}

void SymbolShares::Class::find_pair() {
  least_loss = kNoPair;
  for (size_t i = 0; i < shares.size(); ++i) {
    for (size_t j = i + 1; j < shares.size(); ++j) {
      const int64_t loss = loss_q8(shares[i], shares[j]);
      if (loss < least_loss) {
        least_loss = loss;
        first = i;
        second = j;
      }
    }
  }
}

}  // namespace inkcell::gen
