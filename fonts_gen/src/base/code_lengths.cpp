#include "base/code_lengths.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace inkcell::gen {
namespace {

// A symbol, or a package of two items of the previous list.
struct Item {
  uint64_t weight;
  bool is_symbol;
};

// The symbols, lightest first, merged with packages of pairs of `previous`.
std::vector<Item> package(const std::vector<uint64_t>& sorted,
                          const std::vector<Item>& previous) {
  std::vector<Item> items;
  size_t symbol = 0;
  for (size_t i = 0; i + 1 < previous.size(); i += 2) {
    const uint64_t weight = previous[i].weight + previous[i + 1].weight;
    while (symbol < sorted.size() && sorted[symbol] <= weight) {
      items.push_back({sorted[symbol++], true});
    }
    items.push_back({weight, false});
  }
  while (symbol < sorted.size()) {
    items.push_back({sorted[symbol++], true});
  }
  return items;
}

}  // namespace

std::vector<int> limited_lengths(const std::vector<uint64_t>& counts,
                                 int most) {
  const size_t size = counts.size();
  std::vector<int> lengths(size, size == 1 ? 1 : 0);
  if (size < 2) {
    return lengths;
  }
  std::vector<size_t> order(size);
  std::iota(order.begin(), order.end(), size_t{0});
  const auto weight = [&counts](size_t i) {
    return std::max<uint64_t>(counts[i], 1);
  };
  std::stable_sort(order.begin(), order.end(), [&weight](size_t a, size_t b) {
    return weight(a) < weight(b);
  });
  std::vector<uint64_t> sorted;
  for (const size_t i : order) {
    sorted.push_back(weight(i));
  }
  std::vector<std::vector<Item>> lists = {package(sorted, {})};
  while (lists.size() < static_cast<size_t>(most)) {
    lists.push_back(package(sorted, lists.back()));
  }
  // Takes the 2n - 2 lightest items of the last list, then in each list before
  // the parts of the packages taken. Each symbol taken adds a bit.
  size_t taken = 2 * size - 2;
  for (auto list = lists.rbegin(); list != lists.rend(); ++list) {
    size_t symbols = 0;
    for (size_t i = 0; i < taken; ++i) {
      symbols += (*list)[i].is_symbol ? 1u : 0u;
    }
    for (size_t i = 0; i < symbols; ++i) {
      ++lengths[order[i]];
    }
    taken = 2 * (taken - symbols);
  }
  return lengths;
}

uint64_t n_log_n_q8(uint64_t n) {
  if (n < 2) {
    return 0;
  }
  int whole = 0;
  while (n >> (whole + 1) != 0) {
    ++whole;
  }
  // Squaring the mantissa, 1 to 2, doubles its logarithm.
  uint64_t mantissa_q30 = whole <= 30 ? n << (30 - whole) : n >> (whole - 30);
  uint64_t log_q8 = static_cast<uint64_t>(whole);
  for (int i = 0; i < 8; ++i) {
    mantissa_q30 = mantissa_q30 * mantissa_q30 >> 30;
    log_q8 <<= 1;
    if (mantissa_q30 >> 31 != 0) {
      log_q8 |= 1;
      mantissa_q30 >>= 1;
    }
  }
  return n * log_q8;
}

}  // namespace inkcell::gen
