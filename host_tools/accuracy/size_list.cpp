#include "size_list.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace inkcell::tools {
namespace {

constexpr double kLeastPx = 4;
constexpr double kMostPx = 1024;

[[noreturn]] void refuse(const std::string& text) {
  throw std::runtime_error(
      "'" + text +
      "' is no size: give numbers from 4 to 1024, or ranges of whole numbers "
      "such as 8-64");
}

double read_size(const std::string& text, const std::string& whole) {
  char* end = nullptr;
  const double px = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(px >= kLeastPx && px <= kMostPx)) {
    refuse(whole);
  }
  return px;
}

}  // namespace

std::vector<double> read_sizes(const std::vector<std::string>& list) {
  std::vector<double> sizes;
  for (const std::string& text : list) {
    const size_t dash = text.find('-');
    if (dash == std::string::npos) {
      sizes.push_back(std::round(read_size(text, text) * 64) / 64);
      continue;
    }
    const double first = read_size(text.substr(0, dash), text);
    const double last = read_size(text.substr(dash + 1), text);
    if (first != std::floor(first) || last != std::floor(last) ||
        first > last) {
      refuse(text);
    }
    for (double px = first; px <= last; ++px) {
      sizes.push_back(px);
    }
  }
  return sizes;
}

}  // namespace inkcell::tools
