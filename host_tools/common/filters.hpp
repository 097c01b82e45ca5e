// The filter presets by the names that the command line uses.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "inkcell/filter.hpp"

namespace inkcell::tools {

struct NamedFilter {
  std::string_view name;
  const Filter* filter;
};

inline constexpr std::array<NamedFilter, 4> kFilters = {{
    {"text", &kFilterText},
    {"motion", &kFilterMotion},
    {"paper_display", &kFilterPaperDisplay},
    {"paper_body", &kFilterPaperBody},
}};

/// Throws std::runtime_error that lists the names.
inline const Filter& filter_of(std::string_view name) {
  std::string names;
  for (const NamedFilter& entry : kFilters) {
    if (entry.name == name) {
      return *entry.filter;
    }
    names += ' ';
    names += entry.name;
  }
  throw std::runtime_error("filter '" + std::string(name) +
                           "' is unknown; there are:" + names);
}

}  // namespace inkcell::tools
