#include "table.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace inkcell::tools {
namespace {

void print_row(const std::string& px,
               const ExactFilter& filter,
               const ErrorSummary& errors) {
  std::printf("| %5s | %-13s | %5.1f | %5.3f | %5.3f %s | ", px.c_str(),
              std::string(filter.device->name).c_str(), errors.worst(),
              errors.mean(), errors.worst_mean(),
              to_utf8(errors.worst_mean_character()).c_str());
  const ErrorPlace& at = errors.worst_place();
  if (errors.worst() > 0) {
    std::printf("%s at (%d, %d), offset (%d, %d) / 64: %d for %.1f",
                to_utf8(at.code_point).c_str(), at.x, at.y, at.offset.x,
                at.offset.y, at.drawn, at.exact);
  }
  std::printf(" |\n");
}

std::string as_text(double px) {
  char text[16];
  std::snprintf(text, sizeof text, "%g", px);
  return text;
}

nlohmann::json as_json(const ExactFilter& filter, const ErrorSummary& errors) {
  const ErrorPlace& at = errors.worst_place();
  return {{"filter", std::string(filter.device->name)},
          {"max", errors.worst()},
          {"mean", errors.mean()},
          {"max_mean", errors.worst_mean()},
          {"max_mean_char", to_utf8(errors.worst_mean_character())},
          {"worst",
           {{"char", to_utf8(at.code_point)},
            {"offset", {at.offset.x, at.offset.y}},
            {"x", at.x},
            {"y", at.y},
            {"drawn", at.drawn},
            {"exact", at.exact}}}};
}

}  // namespace

ErrorSummary ErrorTable::summary(size_t size, size_t filter) const {
  ErrorSummary result;
  for (const std::vector<GlyphErrors>& glyph : errors) {
    result.add(glyph[size * request.filters.size() + filter]);
  }
  return result;
}

ErrorSummary ErrorTable::total(size_t filter) const {
  ErrorSummary result;
  for (size_t size = 0; size < request.sizes.size(); ++size) {
    result.add(summary(size, filter));
  }
  return result;
}

std::vector<WorstOfGlyph> worst_glyphs(const ErrorTable& table, size_t count) {
  const size_t filters = table.request.filters.size();
  std::vector<WorstOfGlyph> worst;
  for (size_t i = 0; i < table.characters.size(); ++i) {
    const std::vector<GlyphErrors>& errors = table.errors[i];
    const auto found =
        std::max_element(errors.begin(), errors.end(),
                         [](const GlyphErrors& a, const GlyphErrors& b) {
                           return a.worst() < b.worst();
                         });
    const auto at = static_cast<size_t>(found - errors.begin());
    worst.push_back({i, at / filters, at % filters, found->worst_place()});
  }
  std::stable_sort(worst.begin(), worst.end(),
                   [](const WorstOfGlyph& a, const WorstOfGlyph& b) {
                     return a.place.error() > b.place.error();
                   });
  worst.resize(std::min(worst.size(), count));
  return worst;
}

void print_table(const ErrorTable& table) {
  const ComparisonRequest& request = table.request;
  std::printf(
      "| px | filter | worst | mean | largest mean | worst pixel |\n"
      "|---|---|---|---|---|---|\n");
  for (size_t f = 0; f < request.filters.size(); ++f) {
    for (size_t s = 0; s < request.sizes.size(); ++s) {
      print_row(as_text(request.sizes[s]), request.filters[f],
                table.summary(s, f));
    }
    print_row("all", request.filters[f], table.total(f));
  }
}

nlohmann::json table_as_json(const ErrorTable& table) {
  const ComparisonRequest& request = table.request;
  nlohmann::json rows = nlohmann::json::array();
  for (size_t f = 0; f < request.filters.size(); ++f) {
    for (size_t s = 0; s < request.sizes.size(); ++s) {
      nlohmann::json row = as_json(request.filters[f], table.summary(s, f));
      row["px"] = request.sizes[s];
      rows.push_back(std::move(row));
    }
    rows.push_back(as_json(request.filters[f], table.total(f)));
  }
  return rows;
}

}  // namespace inkcell::tools
